"""What is known of a designer from work for a studio: computed, and seen by the two of them alone."""

from datetime import UTC, date, datetime, timedelta
from typing import Any

import pytest

from app.accounts.models import Person
from app.accounts.rules import AddressProof
from app.core import clock
from app.dashboards.velocity.rules import CuePace, on_time_share
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import Agreed, milestone
from tests.support.server import World

NOW = datetime(2026, 11, 25, 12, tzinfo=UTC)


def accepted(days_after_due: int | None) -> CuePace:
    due = NOW.date() - timedelta(days=days_after_due) if days_after_due is not None else None
    return CuePace(0, NOW, NOW, due)


def test_on_time_is_by_the_day_and_of_cues_that_have_one() -> None:
    today = NOW.date()
    assert on_time_share([accepted(0), accepted(-3), accepted(1), accepted(None)], today) == pytest.approx(2 / 3)
    assert on_time_share([accepted(0), accepted(0), accepted(None)], today) is None
    assert on_time_share([CuePace(0, None, None, today)] * 5, today) is None


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)


@pytest.fixture
def agreed(world: World, contracts: Contracts) -> Agreed:
    return Agreed(world)


def on_file(world: World) -> str:
    """Put the designer, whose address is proven, on file; return the entry."""

    def prove(session: Any) -> str:
        person = session.get_one(Person, world.designer_id)
        person.email_verified_at, person.email_proof = clock.now(), AddressProof.MAIL
        return str(person.email)

    body = {"name": "As filed", "email": world.server.in_database(prove), "notes": "A private note."}
    body |= {"rate": {"amount_minor": 4_500, "currency": "USD", "unit": "hour"}}
    answer = world.producer.post(f"/v1/studios/{world.studio_id}/roster", json=body)
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


def work_three(world: World, agreed: Agreed) -> None:
    """Accept three cues, one of them late and after a round; each took half as long again as estimated."""
    cues = [agreed.cue(f"cue_{n}", due_on=date(2999, 1, 1)) for n in range(2)]
    cues.append(agreed.cue("late", due_on=date(2020, 1, 1)))
    planned = milestone("Alpha", *cues, amount_minor=18_000)
    planned["cues"] = [{"cue_id": str(cue), "estimate_min": 100} for cue in cues]
    agreed.agree(planned)
    agreed.draft(agreed.take(cues[2]))
    agreed.send()
    for cue in cues:
        logged = world.designer.post(
            f"/v1/contracts/{agreed.contract_id}/work-logs",
            json={"cue_id": str(cue), "minutes": 150, "worked_on": str(clock.now().date())},
        )
        assert logged.is_success, logged.text
        agreed.approve(agreed.take(cue))


@pytest.mark.slow
@pytest.mark.both_databases
def test_both_see_the_same_figures(world: World, agreed: Agreed) -> None:
    entry = on_file(world)
    work_three(world, agreed)
    seen = world.producer.get(f"/v1/roster/{entry}/work").json()
    assert [project["accepted"] for project in seen["projects"]] == [3]
    assert seen["accepted"] == 3
    assert seen["on_time"] == pytest.approx(2 / 3)
    assert seen["first_pass"] == pytest.approx(2 / 3)
    assert seen["rounds_per_cue"] == pytest.approx(1 / 3)
    assert (seen["estimates"]["pairs"], seen["estimates"]["mean_percent"]) == (3, pytest.approx(50))
    assert seen["revision_hours"] is None, "one round is too few for a figure"
    own = world.designer.get("/v1/me/work")
    assert own.json() == [seen]
    assert "private note" not in own.text
    assert "4500" not in own.text


@pytest.mark.slow
@pytest.mark.both_databases
def test_no_one_else_sees_them(world: World, agreed: Agreed) -> None:
    entry = on_file(world)
    work_three(world, agreed)
    path = f"/v1/roster/{entry}/work"
    assert world.stranger.get(path).status_code == 404
    assert world.designer.get(path).status_code == 404
    assert world.other_designer.get(path).status_code == 404
    assert world.reviewer.get(path).status_code == 403
    lead = world.approver.get(path).json()
    assert (lead["first_pass"], lead["estimates"]) == (pytest.approx(2 / 3), None)
    assert [one["studio_id"] for one in world.other_designer.get("/v1/me/work").json()] != [str(world.studio_id)]


@pytest.mark.slow
def test_without_work_there_are_no_figures(world: World) -> None:
    body = {"name": "New", "email": "new@example.test"}
    entry = world.producer.post(f"/v1/studios/{world.studio_id}/roster", json=body).json()["id"]
    answer = world.producer.get(f"/v1/roster/{entry}/work")
    assert (answer.status_code, answer.json()) == (200, None)
    known = on_file(world)
    empty = world.producer.get(f"/v1/roster/{known}/work").json()
    assert (empty["accepted"], empty["first_pass"], empty["on_time"]) == (0, None, None)
    assert [project["accepted"] for project in empty["projects"]] == [0]
