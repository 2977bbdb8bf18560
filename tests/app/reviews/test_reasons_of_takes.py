"""Why takes stand as they do, in the lists that the desk and the page of a cue read."""

from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import update
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.deliveries.take_states import start_recheck
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World

MIGRATION = Path(__file__).parents[3] / "migrations/versions/0077_verdict_reasons_of_takes.py"


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def listed(stage: Stage, cue_id: UUID, client: Any = None) -> dict[str, list[str]]:
    """Return the reasons that stand beside the versions of a cue."""
    answer = (client or stage.world.designer).get(
        f"/v1/projects/{stage.world.project_id}/takes", params={"cue_id": str(cue_id)}
    )
    return {take["id"]: take["verdict_reasons"] for take in body_of(answer)["items"]}


def reasons(stage: Stage, cue_id: UUID, take_id: UUID) -> list[str]:
    return listed(stage, cue_id)[str(take_id)]


@pytest.mark.slow
def test_a_designer_reads_why_a_version_was_approved_wherever_versions_are_listed(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    assert reasons(stage, cue_id, take_id) == []
    stage.approve(take_id, reasons=["Fits the scene", "Best timing"])
    said = ["Fits the scene", "Best timing"]
    for client in (stage.world.designer, stage.world.reviewer, stage.world.producer):
        assert listed(stage, cue_id, client) == {str(take_id): said}
    assert body_of(stage.world.designer.get(f"/v1/takes/{take_id}"))["verdict_reasons"] == said
    delivery = body_of(stage.world.designer.get(f"/v1/deliveries/{stage.delivery_id}"))
    assert [take["verdict_reasons"] for take in delivery["takes"]] == [said]


@pytest.mark.slow
def test_another_designer_reads_none_of_it(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    stage.approve(take_id, reasons=["Fits the scene"])
    assert stage.world.other_designer.get(f"/v1/takes/{take_id}").status_code == 404
    answer = stage.world.other_designer.get(f"/v1/projects/{stage.world.project_id}/takes")
    assert "Fits the scene" not in answer.text
    assert stage.world.stranger.get(f"/v1/takes/{take_id}").status_code == 404


@pytest.mark.slow
def test_what_gives_way_loses_its_reasons_and_has_them_again_after_undo(stage: Stage) -> None:
    cue_id = stage.cue()
    first = stage.take(cue_id)
    stage.approve(first, reasons=["Cleanest"])
    second = stage.take(cue_id)
    stage.approve(second, reasons=["Best weight"])
    assert listed(stage, cue_id) == {str(first): [], str(second): ["Best weight"]}
    body_of(stage.undo(second))
    assert stage.states(first, second) == ["approved", "conforming"]
    assert listed(stage, cue_id) == {str(first): ["Cleanest"], str(second): []}
    body_of(stage.undo(first))
    assert listed(stage, cue_id) == {str(first): [], str(second): []}


@pytest.mark.slow
def test_of_two_approvals_of_one_version_the_last_counts(stage: Stage) -> None:
    cue_id = stage.cue()
    first = stage.take(cue_id)
    stage.approve(first, reasons=["Cleanest"])
    second = stage.take(cue_id)
    stage.approve(second)
    stage.approve(first, reasons=["Best timing"], seen_state="set_aside")
    stage.approve(second, seen_state="set_aside")
    body_of(stage.undo(second))
    assert listed(stage, cue_id) == {str(first): ["Best timing"], str(second): []}


@pytest.mark.slow
def test_a_change_that_was_sent_says_why_and_its_draft_does_not(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    stage.approve(take_id, reasons=["Cleanest"])
    body_of(stage.verdict(take_id, "request_change", note="Too loud.", reasons=["Too loud"], seen_state="approved"))
    assert reasons(stage, cue_id, take_id) == ["Cleanest"]
    stage.send()
    assert (stage.states(take_id), reasons(stage, cue_id, take_id)) == (["change_requested"], ["Too loud"])


def test_a_set_is_approved_for_one_reason(stage: Stage) -> None:
    cue_id = stage.cue(variations=2)
    picks = [stage.take(cue_id, variation) for variation in (1, 2)]
    body_of(stage.world.approver.post(f"/v1/cues/{cue_id}/accept-set", json={"reasons": ["Best timing"]}))
    assert listed(stage, cue_id) == {str(take_id): ["Best timing"] for take_id in picks}


def test_a_version_that_is_checked_again_has_none(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)

    def recheck(session: Session) -> None:
        session.execute(update(Take).where(Take.id == take_id).values(verdict_reasons=["Cleanest"]))
        start_recheck(session, session.get_one(Take, take_id), by=None)

    stage.world.server.in_database(recheck)
    assert reasons(stage, cue_id, take_id) == []


@pytest.mark.slow
def test_the_list_asks_the_database_as_often_for_many_reasons_as_for_none(stage: Stage) -> None:
    cue_id = stage.cue(variations=4)
    takes = [stage.take(cue_id, variation) for variation in (1, 2, 3, 4)]

    def statements() -> int:
        with stage.world.server.counted_selects() as selects:
            listed(stage, cue_id)
        return len(selects)

    listed(stage, cue_id)
    before = statements()
    for take_id in takes:
        stage.approve(take_id, reasons=["Cleanest"])
    assert statements() == before
    assert set(map(tuple, listed(stage, cue_id).values())) == {("Cleanest",)}
