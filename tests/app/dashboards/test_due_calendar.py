"""What is due as a calendar: cues by day, and what contracts name, to who sees it."""

from datetime import date
from typing import Any
from uuid import UUID

import pytest

from tests.app.money.agreed import Agreed, day, milestone
from tests.app.reviews.making import refused
from tests.support.calendars import calendar_of, events_at, events_of
from tests.support.deliver import add_cues
from tests.support.server import World


def due(world: World, *cues: dict[str, Any]) -> list[UUID]:
    return [UUID(cue["id"]) for cue in add_cues(world, *cues)]


@pytest.mark.slow
def test_cues_of_a_day_are_one_event_until_they_are_approved_or_cut(world: World) -> None:
    stage = Agreed(world)
    ping = stage.cue("radar_ping", due_on=date.fromisoformat(day(7)))
    whoosh, _ = due(world, {"name": "whoosh", "due_on": day(7)}, {"name": "someday"})
    due(world, {"name": "alarm", "due_on": day(9), "variations": 2})
    path = calendar_of(world, world.reviewer)
    assert events_at(world, path) == [
        (day(7), "Shield Wing: 2 cues due", "radar_ping, whoosh"),
        (day(9), "Shield Wing: 1 cue due", "alarm"),
    ]
    stage.approve(stage.take(ping))
    world.producer.post(f"/v1/cues/{whoosh}/cut", json={"reason": "Not in the game."}).raise_for_status()
    assert events_at(world, path) == [(day(9), "Shield Wing: 1 cue due", "alarm")]


def test_many_cues_of_a_day_are_counted(world: World) -> None:
    due(world, *({"name": f"step_{number:02}", "due_on": day(3)} for number in range(23)))
    ((_, summary, names),) = events_of(world, world.approver)
    assert summary == "Shield Wing: 23 cues due"
    assert names.endswith("step_19 and 3 more")


@pytest.mark.slow
def test_a_designer_has_the_cues_of_their_contract(world: World) -> None:
    stage = Agreed(world)
    mine = stage.cue("mine", due_on=date.fromisoformat(day(5)))
    stage.cue("of_another", due_on=date.fromisoformat(day(5)))
    assert [event[2] for event in events_of(world, world.designer)] == ["mine, of_another"]  # before there is one
    stage.agree(milestone("Alpha", mine, amount_minor=18_000))
    assert events_of(world, world.designer) == [
        (day(5), "Shield Wing: 1 cue due", "mine"),
        (day(14), "Shield Wing: Alpha due, 0 of 1 accepted", "Effects, USD 180.00"),
    ]


@pytest.mark.slow
def test_invoices_until_they_are_paid_and_the_days_that_contracts_name(world: World) -> None:
    stage = Agreed(world, terms={"option_until_on": day(40)})
    cue = stage.cue("radar_ping")
    stage.agree(milestone("Alpha", cue, amount_minor=18_000))
    stage.approve(stage.take(cue))
    invoice = stage.invoice()
    path = calendar_of(world, world.designer)
    named = (day(40), "Shield Wing: the option on the next project ends", "Effects")
    alpha = (day(14), "Shield Wing: Alpha due, 1 of 1 accepted", "Effects, USD 180.00")
    owed = (invoice["due_on"], f"Shield Wing: invoice {invoice['full_number']} due", "Effects, USD 180.00 open")
    assert events_at(world, path) == [alpha, owed, named]
    stage.pay(invoice, 18_000).raise_for_status()
    assert events_at(world, path) == [alpha, named]


def test_a_new_link_replaces_the_old_one_and_either_can_be_withdrawn(world: World) -> None:
    old = calendar_of(world, world.designer)
    new = calendar_of(world, world.designer)
    assert refused(world.nobody.get(old)) == (404, "calendar-not-found")
    assert events_at(world, new) == []
    world.designer.delete(f"/v1/projects/{world.project_id}/calendar").raise_for_status()
    assert refused(world.nobody.get(new)) == (404, "calendar-not-found")
    assert world.stranger.post(f"/v1/projects/{world.project_id}/calendar").status_code == 404


@pytest.mark.slow
def test_it_closes_with_the_project_for_its_holder(world: World) -> None:
    due(world, {"name": "alarm", "due_on": day(9)})
    path = calendar_of(world, world.designer)
    assert len(events_at(world, path)) == 1
    world.producer.patch(f"/v1/projects/{world.project_id}", json={"nda_needed": True}).raise_for_status()
    assert refused(world.nobody.get(path)) == (404, "calendar-not-found")
