"""Work by the hour and retainers: logged, approved or refused, due once, and never beyond the caps."""

import json
from datetime import date, timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app import commercial
from app.agreements.clauses.terms import MoneyTerms
from app.agreements.models import Contract
from app.agreements.queries import contract_by_id, events_of
from app.amendments.verification import validation_errors
from app.core import clock
from app.money import jobs
from app.money.models import WorkedDay
from app.money.work.rules import HourTerms, month_begins_on, month_of
from tests.app.money.agreed import TODAY, Agreed, day, milestone
from tests.app.reviews.making import refused
from tests.support.server import World

HOURS = {"hour_rate_minor": 6_001, "hours_cap": 5, "hours_month_cap": 4}
RETAINER = {"retainer_minor": 90_000, "retainer_hours": 2, "retainer_months": 3}


def agreed_with(world: World, **terms: int) -> Agreed:
    agreed = Agreed(world, terms={"notice_days": 14, **terms})
    agreed.agree(milestone("Alpha", agreed.cue("radar_ping"), amount_minor=10_000))
    return agreed


@pytest.fixture
def agreed(world: World) -> Agreed:
    """Return a contract of five hours at most, four of them in a month, at 60.01 each."""
    return agreed_with(world, **HOURS)


def ok(answer: Any) -> Any:
    """Return the body of an answer that grants what was asked."""
    assert answer.is_success, answer.text
    return answer.json()


def log(agreed: Agreed, minutes: int, worked_on: str = day(-1), by: Any = None, **more: Any) -> Any:
    body = {"worked_on": worked_on, "minutes": minutes, "note": "Directing", **more}
    return (by or agreed.world.designer).post(f"/v1/contracts/{agreed.contract_id}/worked-days", json=body)


def approve(agreed: Agreed, entry: Any) -> Any:
    return agreed.world.producer.post(f"/v1/worked-days/{ok(entry)['id']}/agree")


def refuse(agreed: Agreed, entry_id: str, by: Any = None) -> Any:
    body = {"reason": "The session was cancelled"}
    return (by or agreed.world.producer).post(f"/v1/worked-days/{entry_id}/refuse", json=body)


def lines(agreed: Agreed) -> list[tuple[str, int, str]]:
    return [(line["kind"], line["amount_minor"], line["clause"]) for line in agreed.ledger()["lines"]]


def began_months_ago(agreed: Agreed, months: int) -> None:
    """Move the agreement back, so that this is the month after so many."""

    def move(session: Any) -> None:
        earlier = month_begins_on(1 - months, TODAY)
        contract = session.get_one(Contract, agreed.contract_id)
        contract.agreed_at = clock.now() - timedelta(days=(TODAY - earlier).days)

    agreed.world.server.in_database(move)


def steps(by: Any, agreed: Agreed) -> dict[str, int]:
    found = ok(by.get(f"/v1/projects/{agreed.world.project_id}/next-steps"))["steps"]
    return {step["kind"]: step["count"] for step in found}


def faults(agreed: Agreed) -> list[str]:
    store = agreed.world.server.runtime.store

    def found(session: Any) -> list[str]:
        whole = validation_errors(session, store, contract_by_id(session, agreed.contract_id))
        # The stage agrees without a text; what is said of work and lines is what counts here.
        return [fault for fault in whole if "work" in fault or "line" in fault]

    said: list[str] = agreed.world.server.in_database(found)
    return said


@pytest.mark.slow
@pytest.mark.both_databases
def test_approved_hours_are_due_and_what_they_were_is_on_the_invoice(agreed: Agreed) -> None:
    assert agreed.figures()["agreed_minor"] == 10_000 + 5 * 6_001
    cue_id = str(agreed.cue("dock_clamp"))
    entry = log(agreed, 90, cue_id=cue_id, note="")
    assert ok(entry)["cue"]["name"] == "dock_clamp"
    assert (ok(entry)["state"], ok(entry)["amount_minor"]) == ("waiting", 9_002)  # 90.015, rounded
    assert steps(agreed.world.producer, agreed)["agree_hours"] == 1
    assert ok(approve(agreed, entry))["state"] == "agreed"
    assert lines(agreed) == [("worked_hours", 9_002, "hours")]
    assert agreed.figures()["due_minor"] == 9_002
    text = agreed.invoice()["lines"][0]["text"]
    worked_on = date.fromisoformat(day(-1))
    assert text.startswith(f"1 h 30 min on {worked_on.day} {worked_on:%B %Y}: ")
    assert text.endswith("dock_clamp")
    assert "agree_hours" not in steps(agreed.world.producer, agreed)
    assert faults(agreed) == []


@pytest.mark.slow
def test_refused_hours_are_corrected_and_sent_again(agreed: Agreed) -> None:
    world = agreed.world
    entry_id = ok(log(agreed, 240))["id"]
    read = ok(refuse(agreed, entry_id))
    assert (read["state"], read["refusal"]) == ("refused", "The session was cancelled")
    assert refused(refuse(agreed, entry_id)) == (409, "day-refused")
    assert refused(world.producer.post(f"/v1/worked-days/{entry_id}/agree")) == (409, "day-refused")
    assert steps(world.designer, agreed)["correct_work"] == 1
    assert "agree_hours" not in steps(world.producer, agreed)
    body = {"worked_on": day(-1), "minutes": 60, "note": "Casting"}
    assert refused(world.producer.put(f"/v1/worked-days/{entry_id}", json=body)) == (403, "other-party-needed")
    again = ok(world.designer.put(f"/v1/worked-days/{entry_id}", json=body))
    assert (again["state"], again["refusal"], again["minutes"]) == ("waiting", "", 60)
    ok(world.producer.post(f"/v1/worked-days/{entry_id}/agree"))
    assert refused(refuse(agreed, entry_id)) == (409, "day-agreed")
    assert refused(world.designer.put(f"/v1/worked-days/{entry_id}", json=body)) == (409, "day-agreed")
    kinds = world.server.in_database(lambda session: [event.kind for event in events_of(session, agreed.contract_id)])
    assert kinds[-4:] == ["work_refused", "work_logged", "work_agreed", "due"]


@pytest.mark.slow
def test_days_are_refused_too_and_logged_again(world: World) -> None:
    agreed = Agreed(world, terms={"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 2})
    agreed.agree()  # without a milestone: a day needs none
    body = {"worked_on": day(-1), "quarters": 2}
    path = f"/v1/contracts/{agreed.contract_id}/worked-days"
    entry_id = ok(world.designer.post(path, json=body))["id"]
    ok(refuse(agreed, entry_id))
    again = ok(world.designer.post(path, json=body | {"quarters": 1}))
    assert (again["id"], again["state"], again["quarters"]) == (entry_id, "waiting", 1)
    assert ok(world.producer.post(f"/v1/worked-days/{entry_id}/agree"))["state"] == "agreed"
    assert agreed.owed() == [("worked_day", 10_000)]
    other = ok(world.designer.post(path, json=body | {"worked_on": day(-2)}))["id"]
    moved = world.designer.put(f"/v1/worked-days/{other}", json=body)
    assert refused(moved) == (409, "day-logged")


@pytest.mark.slow
def test_the_caps_refuse_what_lies_beyond_and_name_the_way_out(agreed: Agreed) -> None:
    assert log(agreed, 200).status_code == 201
    over = log(agreed, 41)
    assert refused(over) == (409, "cap-exceeded")
    assert "at most 4 h a month and 5 h in all are paid by the hour; 40 min left in this month" in over.json()["detail"]
    assert over.json()["fix"] == "log up to 40 min, and propose a change order that raises the caps of hours"
    approve(agreed, log(agreed, 40))
    began_months_ago(agreed, 1)  # the second month begins today
    assert log(agreed, 60, worked_on=day(0)).status_code == 201
    assert refused(log(agreed, 1, worked_on=day(0))) == (409, "cap-exceeded")


@pytest.mark.slow
def test_refused_hours_leave_room(agreed: Agreed) -> None:
    entry_id = ok(log(agreed, 240))["id"]
    ok(refuse(agreed, entry_id))
    assert log(agreed, 240).status_code == 201
    body = {"worked_on": day(-1), "minutes": 60, "note": "Casting"}
    assert refused(agreed.world.designer.put(f"/v1/worked-days/{entry_id}", json=body)) == (409, "cap-exceeded")


@pytest.mark.slow
def test_hours_say_what_they_were_for_and_are_logged_by_the_designer(agreed: Agreed) -> None:
    world = agreed.world
    assert refused(log(agreed, 60, note=" ")) == (422, "work-not-named")
    assert refused(log(agreed, 60, cue_id=str(UUID(int=1)))) == (404, "cue-not-found")
    assert refused(log(agreed, 60, quarters=2))[0] == 422
    assert refused(log(agreed, 60, worked_on=day(3))) == (422, "day-in-future")
    assert refused(log(agreed, 60, by=world.producer)) == (403, "other-party-needed")
    entry_id = ok(log(agreed, 60))["id"]
    assert refused(refuse(agreed, entry_id, by=world.designer))[0] == 403
    for outsider in (world.stranger, world.other_designer, world.reviewer):
        assert refused(refuse(agreed, entry_id, by=outsider))[0] in (403, 404)
    assert world.designer.delete(f"/v1/worked-days/{entry_id}").status_code == 204


def test_a_contract_without_hours_takes_none(world: World) -> None:
    agreed = agreed_with(world)
    assert refused(log(agreed, 60)) == (409, "not-hourly")
    (contract,) = ok(world.producer.get(f"/v1/projects/{world.project_id}/money"))["contracts"]
    assert contract["by_hour"] is None


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_retainer_is_due_each_month_once_and_includes_hours(world: World) -> None:
    agreed = agreed_with(world, **HOURS, **RETAINER)
    assert "money.charge_retainers" in commercial.CHORES
    for _ in range(2):
        jobs.charge_retainers(world.server.runtime, {})
        assert lines(agreed) == [("retainer", 90_000, "retainer")]
    approve(agreed, log(agreed, 100, worked_on=day(0)))
    assert len(lines(agreed)) == 1  # included
    approve(agreed, log(agreed, 80, worked_on=day(0)))
    assert lines(agreed)[1:] == [("worked_hours", 6_001, "hours")]  # 60 of the 80 minutes
    (contract,) = ok(world.producer.get(f"/v1/projects/{world.project_id}/money"))["contracts"]
    said = contract["by_hour"]
    assert (said["paid_min"], said["retainer_minor"], said["included_min"]) == (60, 90_000, 120)
    assert [(one["approved_min"], one["left_min"]) for one in said["months"]] == [(180, 180)]
    began_months_ago(agreed, 5)
    jobs.charge_retainers(world.server.runtime, {})
    assert [line[0] for line in lines(agreed)].count("retainer") == 3  # of six months begun, three were agreed
    texts = [line["text"] for line in agreed.invoice()["lines"]]
    assert texts[0] == "Retainer, month 1"
    assert faults(agreed) == []


def test_a_retainer_alone_pays_no_hour_beyond_it(world: World) -> None:
    agreed = agreed_with(world, **RETAINER)
    over = log(agreed, 121)
    assert refused(over) == (409, "cap-exceeded")
    assert "2 h a month are included; 2 h left in this month" in over.json()["detail"]
    assert log(agreed, 120).status_code == 201


@pytest.mark.slow
@pytest.mark.both_databases
def test_an_early_end_owes_hours_that_wait_and_months_that_began(world: World) -> None:
    agreed = agreed_with(world, **HOURS, **RETAINER)
    approve(agreed, log(agreed, 120))
    log(agreed, 60)
    ok(refuse(agreed, ok(log(agreed, 60))["id"]))
    began_months_ago(agreed, 1)
    path = f"/v1/contracts/{agreed.contract_id}/ending"
    ok(world.producer.post(f"{path}/notice", json={"reason": "Shelved"}))
    said = ok(world.producer.get(path))
    assert (said["hours_minor"], said["retainer_minor"]) == (6_001, 180_000)
    for by, name in ((world.designer, "N. Designer"), (world.producer, "P. Producer")):
        ok(by.post(f"{path}/agree", json={"name": name, "text_sha256": said["statement_sha256"]}))
    assert lines(agreed) == [
        ("retainer", 90_000, "retainer"),
        ("retainer", 90_000, "retainer"),
        ("worked_hours", 6_001, "hours"),
    ]
    assert agreed.figures() == said["figures"]
    assert refused(log(agreed, 60)) == (409, "not-agreed")
    states = [one["state"] for one in ok(world.designer.get(f"/v1/contracts/{agreed.contract_id}/worked-days"))]
    assert sorted(states) == ["agreed", "agreed", "refused"]
    jobs.charge_retainers(world.server.runtime, {})
    assert len(lines(agreed)) == 3
    assert faults(agreed) == []


@pytest.mark.slow
def test_altered_hours_are_named(agreed: Agreed) -> None:
    entry = log(agreed, 60)
    approve(agreed, entry)
    assert faults(agreed) == []
    longer = sa.update(WorkedDay).where(WorkedDay.id == UUID(entry.json()["id"])).values(minutes=600)
    agreed.world.server.in_database(lambda session: session.execute(longer))
    (fault,) = faults(agreed)
    assert "its minutes is 600, and the record says 60" in fault


def test_the_record_says_which_hours(agreed: Agreed) -> None:
    approve(agreed, log(agreed, 60))
    events = agreed.world.server.in_database(
        lambda session: [(event.kind, json.loads(event.payload)) for event in events_of(session, agreed.contract_id)]
    )
    (kind, agreed_work), (_, due) = events[-2:]
    assert (kind, agreed_work["minutes"], agreed_work["note"]) == ("work_agreed", 60, "Directing")
    assert due["worked_day"] == agreed_work["worked_day"]


@pytest.mark.parametrize(
    ("on", "month"),
    [
        (date(2026, 1, 30), 1),
        (date(2026, 1, 31), 1),
        (date(2026, 2, 27), 1),
        (date(2026, 2, 28), 2),
        (date(2026, 3, 30), 2),
        (date(2026, 3, 31), 3),
        (date(2027, 1, 30), 12),
        (date(2027, 1, 31), 13),
    ],
)
def test_months_begin_on_the_day_of_agreement_or_the_last_of_a_shorter_month(on: date, month: int) -> None:
    assert month_of(on, date(2026, 1, 31)) == month


def test_many_short_entries_cost_what_all_their_minutes_cost() -> None:
    terms = HourTerms.of(MoneyTerms(hour_rate_minor=7, hours_cap=1, hours_month_cap=1))
    costs = [terms.charge(1, 5, {1: before}) for before in range(0, 60, 5)]
    assert sum(costs) == 7
    assert terms.left(1, {1: 60}) == 0


@pytest.mark.slow
def test_each_side_is_mailed_what_waits_for_them(agreed: Agreed) -> None:
    world = agreed.world

    def mailed() -> dict[str, str]:
        world.server.wait_for_jobs()
        mails = ok(world.producer.get(f"/v1/studios/{world.studio_id}/outbox"))["mails"]
        return {mail["subject"].partition(": ")[2]: mail["recipient"] for mail in mails}

    entry_id = ok(log(agreed, 90))["id"]
    to_agree = mailed()
    assert set(to_agree) == {"logged work to agree to"}
    ok(refuse(agreed, entry_id))
    both = mailed()
    assert set(both) == {"logged work to agree to", "logged work was refused"}
    assert both["logged work was refused"] != both["logged work to agree to"]
