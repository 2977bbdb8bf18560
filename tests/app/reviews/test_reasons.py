"""The studio's lists of reasons, and the reasons that verdicts give."""

from typing import Any
from uuid import UUID

import pytest

from app.reviews.reasons.rules import OURS, ReasonKind
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World

CHANGE, PICK, LABEL = (list(OURS[kind]) for kind in (ReasonKind.CHANGE, ReasonKind.PICK, ReasonKind.LABEL))


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def lists_path(stage: Stage) -> str:
    return f"/v1/studios/{stage.world.studio_id}/review-reasons"


def write(stage: Stage, **lists: Any) -> dict[str, Any]:
    return body_of(stage.world.producer.put(lists_path(stage), json=lists))


def history(stage: Stage, take_id: UUID) -> list[dict[str, Any]]:
    entries: list[dict[str, Any]] = stage.world.designer.get(f"/v1/takes/{take_id}/history").json()
    return entries


def test_a_studio_without_lists_has_ours(stage: Stage) -> None:
    lists = body_of(stage.world.reviewer.get(lists_path(stage)))
    ours = {"change": CHANGE, "pick": PICK, "label": LABEL}
    assert lists == {kind: {"reasons": reasons, "is_own": False} for kind, reasons in ours.items()}


def test_a_list_that_is_left_out_stays_and_an_empty_one_gives_ours_back(stage: Stage) -> None:
    assert write(stage, pick=["  Feels right ", "Right size"])["pick"] == {
        "reasons": ["Feels right", "Right size"],
        "is_own": True,
    }
    lists = write(stage, change=["Too wet"])
    assert (lists["change"]["reasons"], lists["pick"]["reasons"]) == (["Too wet"], ["Feels right", "Right size"])
    assert write(stage, pick=["Right size"])["pick"]["reasons"] == ["Right size"]
    assert write(stage, pick=[])["pick"] == {"reasons": PICK, "is_own": False}
    assert write(stage, change=CHANGE)["change"] == {"reasons": CHANGE, "is_own": False}


def test_the_team_and_the_projects_designers_read_them(stage: Stage) -> None:
    write(stage, label=["wilder"])
    path = f"/v1/projects/{stage.world.project_id}/review-reasons"
    for person in (stage.world.designer, stage.world.reviewer):
        assert body_of(person.get(path))["label"]["reasons"] == ["wilder"]
    assert stage.world.designer.get(lists_path(stage)).status_code == 404


@pytest.mark.parametrize(
    ("reasons", "status"),
    [
        (["Fits", "fits"], 422),
        (["Straße", "STRASSE"], 422),
        ([""], 422),
        (["   "], 422),
        (["x" * 40], 200),
        (["x" * 41], 422),
        (["Too\nlong"], 422),
        (["Too\x00long"], 422),
        (["Too\u2028long"], 422),
        ([str(number) for number in range(9)], 200),
        ([str(number) for number in range(10)], 422),
    ],
)
def test_what_a_list_may_hold(stage: Stage, reasons: list[str], status: int) -> None:
    answer = stage.world.producer.put(lists_path(stage), json={"pick": reasons})
    assert answer.status_code == status
    take_id = stage.take(stage.cue())
    assert stage.verdict(take_id, "approve", reasons=reasons).status_code == status


def test_a_reason_twice_is_named_with_its_place(stage: Stage) -> None:
    answer = stage.world.producer.put(lists_path(stage), json={"pick": ["Fits", "Clean", "FITS"]})
    assert refused(answer) == (422, "reasons-invalid")
    assert answer.json()["errors"] == [{"where": "pick.2", "message": "“FITS” is in the list twice"}]
    assert answer.json()["fix"] == "keep one of the two"


@pytest.mark.slow
def test_the_reason_of_a_pick_stands_with_its_verdict_for_the_team_and_the_designer(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    stage.approve(take_id, reasons=["Fits the scene"])
    (verdict,) = stage.review(cue_id)["verdicts"]
    assert (verdict["kind"], verdict["reasons"], verdict["note"]) == ("approve", ["Fits the scene"], "")
    assert history(stage, take_id)[-1]["reasons"] == ["Fits the scene"]


@pytest.mark.slow
def test_a_later_list_changes_no_verdict(stage: Stage) -> None:
    cue_id = stage.cue()
    write(stage, pick=["Feels right"])
    stage.approve(stage.take(cue_id), reasons=["Feels right"])
    write(stage, pick=["Right size"])
    assert stage.review(cue_id)["verdicts"][0]["reasons"] == ["Feels right"]


def test_a_set_is_accepted_with_one_reason_and_what_gives_way_has_none(stage: Stage) -> None:
    cue_id = stage.cue(variations=2)
    older = stage.take(cue_id, 1)
    picks = [stage.take(cue_id, 1), stage.take(cue_id, 2)]
    answer = stage.world.approver.post(f"/v1/cues/{cue_id}/accept-set", json={"reasons": ["Best timing"]})
    body_of(answer)
    said = {verdict["take_id"]: verdict["reasons"] for verdict in stage.review(cue_id)["verdicts"]}
    assert said == {str(older): [], **{str(take_id): ["Best timing"] for take_id in picks}}


@pytest.mark.slow
def test_the_reasons_of_a_change_stand_beside_its_text_and_come_back_with_undo(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    draft = stage.draft(take_id, "Too loud. 3 dB less.", reasons=["Too loud"])
    assert (draft["text"], draft["reasons"]) == ("Too loud. 3 dB less.", ["Too loud"])
    assert stage.draft(take_id, "Off style.", reasons=["Off style"])["reasons"] == ["Off style"]
    stage.approve(take_id)
    body_of(stage.undo(take_id))
    (take,) = stage.review(cue_id)["takes"]
    assert (take["draft_change"]["text"], take["draft_change"]["reasons"]) == ("Off style.", ["Off style"])
    (sent,) = stage.send()["change_requests"]
    assert sent["reasons"] == ["Off style"]
    assert [verdict["reasons"] for verdict in stage.review(cue_id)["verdicts"]][-1] == ["Off style"]
