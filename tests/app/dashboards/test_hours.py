"""Hours of agreed work by week and designer, against the hours that the roster says are there."""

from datetime import date, timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import AddressProof
from app.agreements.models import ContractCue
from app.core import clock
from app.core.db import new_id
from app.dashboards.hours.rules import OpenWork, by_category, outlook, summed
from app.hiring.roster.rules import Busy, BusyKind, free_days
from app.money.models import WorkLog
from app.sound_lists.models import Cue
from tests.app.money.agreed import Agreed, milestone
from tests.support.server import World

MONDAY = date(2026, 11, 23)
ME = new_id()


def work(hours: float | None, due_on: date | None, *, worked_min: int = 0, category: str = "ui") -> OpenWork:
    return OpenWork(new_id(), ME, category, None if hours is None else round(60 * hours), worked_min, due_on)


def test_an_unknown_hour_is_counted_and_never_guessed() -> None:
    found = summed([work(3, None, worked_min=60), work(None, MONDAY), work(1, None, worked_min=90)])
    assert (found.cues, found.unknown, found.left_h, found.done_h) == (3, 1, 2.0, 2.5)
    assert summed([]).left_h == 0.0


def test_weeks_add_up_what_is_due_and_what_is_there() -> None:
    works = [
        work(8, MONDAY - timedelta(days=3)),  # overdue: due now
        work(10, MONDAY + timedelta(days=6)),
        work(30, MONDAY + timedelta(days=7)),
        work(99, None),
        work(None, MONDAY),
    ]
    first, second, third = outlook(works, MONDAY, [5.0, 2.5, 5.0], weekly_hours=20)
    assert (first.due_h, first.wanted_h, first.there_h, first.is_short) == (18, 18, 20, False)
    assert (second.due_h, second.wanted_h, second.there_h, second.is_short) == (30, 48, 30, True)
    assert (third.due_h, third.wanted_h, third.there_h, third.is_short) == (0, 48, 50, False)
    unknown = outlook(works, MONDAY, [5.0], weekly_hours=None)
    assert (unknown[0].there_h, unknown[0].is_short) == (None, False)


def test_exactly_enough_is_enough() -> None:
    (week,) = outlook([work(20, MONDAY)], MONDAY, [5.0], weekly_hours=20)
    assert not week.is_short
    (week,) = outlook([work(20 + 1 / 60, MONDAY)], MONDAY, [5.0], weekly_hours=20)
    assert week.is_short


def test_categories_with_the_most_hours_come_first() -> None:
    found = by_category([work(1, None), work(5, None, category="foley"), work(None, None, category="amb")])
    assert [(name, own.left_h, own.unknown) for name, own in found] == [("foley", 5, 0), ("ui", 1, 0), ("amb", 0, 1)]


def test_free_days_leave_out_what_is_booked_past_or_before_the_start() -> None:
    wednesday = MONDAY + timedelta(days=2)
    busy = [
        Busy(MONDAY, wednesday, BusyKind.BOOKED),
        Busy(MONDAY + timedelta(days=7), MONDAY + timedelta(days=8), BusyKind.HALF_DAYS),
    ]
    assert free_days(busy, wednesday)[:3] == [2.0, 4.0, 5.0]
    assert free_days([], wednesday, MONDAY + timedelta(days=9))[:3] == [0.0, 3.0, 5.0]
    assert free_days([], MONDAY + timedelta(days=6))[0] == 0.0  # a Sunday


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def hours(world: World, by: str = "producer") -> Any:
    return getattr(world, by).get(f"/v1/projects/{world.project_id}/hours")


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_producer_sees_hours_against_the_roster(world: World, agreed: Agreed) -> None:
    first, second = agreed.cue("laser", category="weapon"), agreed.cue("door", category="foley")
    agreed.cue("later")
    agreed.agree(milestone("Alpha", first, second, amount_minor=10_000))
    due_on = clock.now().date() + timedelta(days=10)

    def estimate(session: Session) -> str:
        planned = session.scalars(sa.select(ContractCue).where(ContractCue.cue_id == first)).one()
        planned.estimate_min = 600
        session.get_one(Cue, first).due_on = due_on
        of = {"studio_id": world.studio_id, "project_id": world.project_id, "logged_by": world.designer_id}
        session.add(
            WorkLog(**of, contract_id=planned.contract_id, cue_id=first, minutes=120, worked_on=clock.now().date())
        )
        person = session.get_one(Person, world.designer_id)
        person.email_proof, person.email_verified_at = next(iter(AddressProof)), clock.now()
        return person.email

    email = world.server.in_database(estimate)
    entry = {"name": "Sound designer", "email": email, "weekly_hours": 2}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/roster", json=entry).status_code == 201
    read = hours(world).json()
    assert read["total"] == {"cues": 2, "unknown": 1, "left_h": 8.0, "done_h": 2.0}
    assert read["uncontracted"] == 1
    assert [(one["category"], one["left_h"], one["unknown"]) for one in read["categories"]] == [
        ("weapon", 8.0, 0),
        ("foley", 0.0, 1),
    ]
    (designer,) = read["designers"]
    assert (designer["designer"]["name"], designer["weekly_hours"]) == ("Sound designer", 2)
    short = [week for week in designer["weeks"] if week["is_short"]]
    assert short[0]["wanted_h"] == 8.0
    assert date.fromisoformat(short[0]["week_on"]) <= due_on < date.fromisoformat(short[0]["week_on"]) + timedelta(7)
    for by, status in (("designer", 403), ("reviewer", 403), ("approver", 403), ("stranger", 404)):
        assert hours(world, by).status_code == status


def test_without_an_entry_on_file_the_hours_there_are_unknown(world: World, agreed: Agreed) -> None:
    agreed.agree(milestone("Alpha", agreed.cue("laser"), amount_minor=10_000))
    (designer,) = hours(world).json()["designers"]
    assert (designer["weekly_hours"], designer["roster_entry_id"], designer["unknown"]) == (None, None, 1)
    assert {week["there_h"] for week in designer["weeks"]} == {None}
    assert not any(week["is_short"] for week in designer["weeks"])
