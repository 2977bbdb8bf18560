"""Days that contracts name: read from standing clauses, shown to both parties on Today, and mailed once."""

from datetime import date, timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.clauses.named_days import named_days, statement_days
from app.agreements.clauses.rules import default_clauses, term_errors, validation_errors
from app.agreements.models import ContractVersion
from app.agreements.rules import ContractKind
from app.core.jobs.queue import Payload
from app.notifications.day_jobs import remind_of_days
from app.notifications.models import Mail
from tests.app.money.agreed import TODAY, Agreed, deposit
from tests.app.reviews.making import body_of
from tests.support.server import World


def in_days(days: int) -> str:
    return (TODAY + timedelta(days=days)).isoformat()


def steps(world: World, by: Any) -> list[dict[str, Any]]:
    found = body_of(by.get(f"/v1/projects/{world.project_id}/next-steps"))["steps"]
    return [one for one in found if one["kind"] == "think_of_day"]


def mails(world: World) -> list[str]:
    """Run the job as the worker does, and return the mails about days."""
    remind_of_days(world.server.runtime, Payload())

    def read(session: Session) -> list[str]:
        written = session.scalars(sa.select(Mail).where(Mail.topic == f"contract:day:{world.project_id}"))
        return [mail.recipient for mail in written]

    return sorted(world.server.in_database(read))


@pytest.mark.slow
def test_both_parties_are_reminded_and_mailed_once(world: World) -> None:
    agreed = Agreed(world, terms={"option_until_on": in_days(14)})
    agreed.agree(deposit(10_000))
    for by in (world.producer, world.designer):
        [step] = steps(world, by)
        assert (step["subject"], step["what"]) == ("Effects", "the option on the next project ends")
        assert step["day"] == in_days(14)
    assert steps(world, world.reviewer) == []
    sent = mails(world)
    assert len(sent) == len(set(sent)) == 2
    assert mails(world) == sent


@pytest.mark.slow
@pytest.mark.parametrize(("days", "is_shown"), [(15, False), (14, True), (0, True), (-14, True), (-15, False)])
def test_a_day_is_near_for_two_weeks(world: World, days: int, is_shown: bool) -> None:
    agreed = Agreed(world, terms={"exclusive_until": in_days(days)})
    agreed.agree(deposit(10_000))
    assert len(steps(world, world.designer)) == is_shown


@pytest.mark.slow
def test_a_text_that_is_no_day_reminds_nobody(world: World) -> None:
    agreed = Agreed(world, terms={"exclusive_until": "the last milestone"})
    agreed.agree(deposit(10_000))
    assert steps(world, world.producer) == []
    assert mails(world) == []


@pytest.mark.slow
def test_before_both_have_signed_nothing_is_said(world: World) -> None:
    Agreed(world, terms={"option_until_on": in_days(1)})
    assert steps(world, world.producer) == []
    assert mails(world) == []


def test_a_struck_clause_names_no_day(world: World) -> None:
    agreed = Agreed(world, terms={"option_until_on": in_days(1)})
    agreed.agree(deposit(10_000))

    def strike(session: Session) -> None:
        found = sa.select(ContractVersion).where(ContractVersion.contract_id == agreed.contract_id)
        version = session.scalars(found).one()
        version.clauses = [clause | {"stands": False} for clause in version.clauses]

    world.server.in_database(strike)
    assert steps(world, world.producer) == []
    assert mails(world) == []


def test_statements_are_due_each_half_year_up_to_the_one_of_the_last_day() -> None:
    found = list(statement_days(date(2026, 11, 26), date(2028, 3, 1)))
    assert found == [date(2027, 1, 31), date(2027, 7, 31), date(2028, 1, 31), date(2028, 7, 31)]
    assert list(statement_days(date(2026, 11, 26), date(2026, 12, 31))) == [date(2027, 1, 31)]
    terms = {"points_until_on": "2027-01-01"}
    assert [named_day.day for named_day in named_days(terms, date(2026, 11, 26))] == [
        date(2027, 1, 31),
        date(2027, 7, 31),
    ]


@pytest.mark.parametrize("value", ["next spring", "2027-13-01", "31.12.2027"])
def test_a_day_is_written_as_one(value: str) -> None:
    assert "wanted it as in 2027-12-31" in next(iter(term_errors("option_until_on", value)))
    assert list(term_errors("option_until_on", "2027-12-31")) == []


def test_the_library_leaves_the_clauses_out_until_a_day_is_named() -> None:
    clauses, terms = default_clauses(ContractKind.SINGLE)
    keys = {"next_project", "points"}
    assert {clause.key for clause in clauses if clause.key in keys and not clause.stands} == keys
    assert not [place for place, _ in validation_errors(clauses, terms) if place.startswith("terms.")]
