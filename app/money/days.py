"""Days of a contract by the day: the designer logs them, the studio agrees, and they are due up to the cap."""

from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.agreements import plan_queries
from app.agreements.access import visible_contract
from app.agreements.errors import ContractNotFound
from app.agreements.models import Contract, Milestone
from app.agreements.plan_queries import terms_of
from app.agreements.queries import lock_contract
from app.agreements.rules import ContractState
from app.agreements.terms import MoneyTerms, PriceMode
from app.kit import clock
from app.kit.money import money
from app.money import queries, schemas
from app.money.errors import CapExceeded, DayAgreed, NotAgreed, NotDayRate, OtherPartyNeeded, WorkedDayNotFound
from app.money.ledger import load_ledger_book, write
from app.money.ledger_book import CLAUSES, Entry, LedgerBook
from app.money.models import WorkedDay
from app.money.rules import LineKind, ensure_not_ahead
from app.projects.errors import ProducerNeeded

QUARTERS = 4  # of a day


def price_of(quarters: int, day_rate_minor: int) -> int:
    """Return what quarters of a day cost, rounded once, half away from zero."""
    return (2 * quarters * day_rate_minor + QUARTERS) // (2 * QUARTERS)


def log_day(
    session: Session, actor: Actor, contract_id: UUID, *, worked_on: date, quarters: int, note: str
) -> WorkedDay:
    """Log a day, or quarters of one, as the designer; a day logged again before the studio agreed is corrected."""
    contract = visible_contract(session, actor, contract_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("only the designer logs days")
    _ensure_by_day(session, contract)
    ensure_not_ahead(worked_on, clock.now().date(), "log a day only after it was worked")
    lock_contract(session, contract.id)
    known = {day.worked_on: day for day in queries.worked_days_of(session, contract.id)}
    day = known.get(worked_on)
    if day is not None and day.agreed_at is not None:
        raise DayAgreed(f"{worked_on} was agreed to already", fix="log what is missing on another day")
    if day is None:
        day = WorkedDay(
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            contract_id=contract.id,
            milestone_id=_milestone_at(session, contract, worked_on).id,
            worked_on=worked_on,
            logged_by=actor.person,
        )
        session.add(day)
    day.quarters, day.note = quarters, note
    session.flush()
    return day


def drop_day(session: Session, actor: Actor, worked_day_id: UUID) -> None:
    """Take a logged day back as its designer, until the studio agrees to it."""
    day, contract = _day_in_sight(session, actor, worked_day_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("only the designer can remove a logged day; a day you do not agree to is not due")
    lock_contract(session, contract.id)
    session.refresh(day, ["agreed_at"])
    if day.agreed_at is not None:
        raise DayAgreed(f"{day.worked_on} was agreed to already")
    session.delete(day)
    session.flush()


def agree_day(session: Session, actor: Actor, worked_day_id: UUID) -> WorkedDay:
    """Agree to a logged day as the studio; it is due, up to what the cap leaves."""
    day, contract = _day_in_sight(session, actor, worked_day_id)
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio agrees to days")
    lock_contract(session, contract.id)
    session.refresh(day, ["agreed_at", "quarters"])
    if day.agreed_at is not None:
        raise DayAgreed(f"{day.worked_on} was agreed to already")
    terms = terms_of(session, contract)
    left_minor = terms.days_cap_minor - _agreed_minor(load_ledger_book(session, contract))
    if left_minor <= 0:
        raise CapExceeded(
            f"the {terms.days_cap} days agreed to are used up, {money(terms.days_cap_minor, contract.currency)}",
            fix="sign another statement of work for more days",
        )
    day.agreed_at, day.agreed_by = clock.now(), actor.person
    kind = LineKind.WORKED_DAY
    entry = Entry(
        kind,
        min(price_of(day.quarters, terms.day_rate_minor), left_minor),
        CLAUSES[kind],
        milestone_id=day.milestone_id,
    )
    write(session, contract, [entry], person_id=actor.person)
    return day


def day_rate_read(terms: MoneyTerms, book: LedgerBook) -> schemas.DayRateRead | None:
    """Return by which rate days are paid and how much of the cap is used; None where a contract pays otherwise."""
    if terms.price_mode is not PriceMode.DAY_RATE:
        return None
    return schemas.DayRateRead(
        day_rate_minor=terms.day_rate_minor,
        days_cap=terms.days_cap,
        agreed_minor=_agreed_minor(book),
        cap_minor=terms.days_cap_minor,
    )


def _agreed_minor(book: LedgerBook) -> int:
    return sum(line.amount_minor for line in book.owed if line.kind is LineKind.WORKED_DAY)


def worked_days(session: Session, actor: Actor, contract_id: UUID) -> list[schemas.WorkedDayRead]:
    """Return the days that were logged, with their prices."""
    contract = visible_contract(session, actor, contract_id)
    return [worked_day(session, day) for day in queries.worked_days_of(session, contract.id)]


def worked_day(session: Session, day: WorkedDay) -> schemas.WorkedDayRead:
    """Return a logged day with its price, the cap left aside."""
    contract = session.get_one(Contract, day.contract_id)
    return schemas.WorkedDayRead(
        id=day.id,
        worked_on=day.worked_on,
        quarters=day.quarters,
        note=day.note,
        amount_minor=price_of(day.quarters, terms_of(session, contract).day_rate_minor),
        agreed_at=day.agreed_at,
    )


def _day_in_sight(session: Session, actor: Actor, worked_day_id: UUID) -> tuple[WorkedDay, Contract]:
    day = queries.worked_day_by_id(session, worked_day_id)
    if day is None:
        raise WorkedDayNotFound(f"no logged day {worked_day_id}")
    try:
        return day, visible_contract(session, actor, day.contract_id)
    except ContractNotFound:
        raise WorkedDayNotFound(f"no logged day {worked_day_id}") from None


def _ensure_by_day(session: Session, contract: Contract) -> None:
    if contract.state is not ContractState.AGREED:
        raise NotAgreed("days can be logged once both have signed the contract")
    if terms_of(session, contract).price_mode is not PriceMode.DAY_RATE:
        raise NotDayRate("this contract does not pay by the day", fix="log time on its cues instead")


def _milestone_at(session: Session, contract: Contract, worked_on: date) -> Milestone:
    """Return the milestone that a day works towards: the next one due, else the last."""
    milestones = [one for one in plan_queries.milestones_of(session, contract.id) if not one.is_deposit]
    if not milestones:
        raise NotDayRate("this contract has no milestone that a day could belong to", fix="plan one, without an amount")
    return next((one for one in milestones if one.due_on and one.due_on >= worked_on), milestones[-1])
