"""Days and hours worked: the designer logs them, the studio agrees or refuses, and they are due up to the cap."""

from dataclasses import dataclass
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.agreements.access import visible_contract
from app.agreements.clauses.terms import MoneyTerms, PriceMode
from app.agreements.errors import ContractNotFound
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import lock_contract
from app.agreements.record import service as record
from app.agreements.rules import ContractState
from app.core import clock
from app.core.events import publish
from app.core.money import money
from app.core.plural import counted, day_in_words, verb
from app.money import queries
from app.money.errors import (
    CapExceeded,
    DayAgreed,
    DayLogged,
    DayRefused,
    NotDayRate,
    OtherPartyNeeded,
    WorkedDayNotFound,
    WorkNotNamed,
)
from app.money.ledger.book import CLAUSES, Entry, LedgerBook
from app.money.ledger.rules import LineKind, ensure_not_ahead, hours_in_words
from app.money.ledger.service import load_ledger_book, not_agreed, write
from app.money.models import WorkedDay
from app.money.work.schemas import DayRateRead
from app.money.work.worked_hours import HourBook, hour_entries, more_work
from app.projects.errors import ProducerNeeded
from app.sound_lists.errors import CueNotFound

QUARTERS = 4  # of a day


@dataclass(frozen=True)
class Work:
    """A designer's logged work for a day: quarters of it, or minutes."""

    worked_on: date
    quarters: int | None
    minutes: int | None
    note: str = ""
    cue_id: UUID | None = None


def price_of(quarters: int, day_rate_minor: int) -> int:
    """Return the price of quarters of a day, rounded once, half away from zero."""
    return (2 * quarters * day_rate_minor + QUARTERS) // (2 * QUARTERS)


def log_work(session: Session, actor: Actor, contract_id: UUID, work: Work) -> WorkedDay:
    """Log a day or hours as the designer; a day logged again before the studio agreed is corrected."""
    contract = visible_contract(session, actor, contract_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded(
            "only the designer logs days and hours", fix="ask the designer to log them; you agree to each"
        )
    lock_contract(session, contract.id)
    _ensure_loggable(session, contract, work)
    day = None
    if work.quarters is not None:
        logged = queries.worked_days_of(session, contract.id)
        day = next(
            (worked_day for worked_day in logged if worked_day.quarters and worked_day.worked_on == work.worked_on),
            None,
        )
    if day is None:
        day = WorkedDay(
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            contract_id=contract.id,
            logged_by=actor.person,
        )
        session.add(day)
    _ensure_not_agreed(day)
    return _put(session, contract, day, work)


def correct_work(session: Session, actor: Actor, worked_day_id: UUID, work: Work) -> WorkedDay:
    """Correct logged work as its designer and send it again, refused or not, until the studio agrees to it."""
    day, contract = _locked(session, actor, worked_day_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded(
            "only the designer corrects logged work", fix="refuse it and say why; the designer corrects it"
        )
    _ensure_not_agreed(day)
    _ensure_loggable(session, contract, work, instead_of=day.id)
    if work.quarters is not None:
        others = [
            worked_day
            for worked_day in queries.worked_days_of(session, contract.id)
            if worked_day.quarters and worked_day.id != day.id
        ]
        if any(other.worked_on == work.worked_on for other in others):
            raise DayLogged(
                f"{day_in_words(work.worked_on)} is logged already", fix="correct that day, and remove this one"
            )
    return _put(session, contract, day, work)


def _put(session: Session, contract: Contract, day: WorkedDay, work: Work) -> WorkedDay:
    day.worked_on, day.note, day.cue_id = work.worked_on, work.note, work.cue_id
    day.quarters, day.minutes = work.quarters, work.minutes
    day.milestone_id = _milestone_at(session, contract, work.worked_on) if work.quarters else None
    day.refused_at, day.refused_by, day.refusal = None, None, ""
    session.flush()
    record.append(session, contract.id, "work_logged", _facts_of(day), by=contract.designer_id)
    publish(session, "work.logged", studio_id=contract.studio_id, worked_day_id=day.id)
    return day


def drop_day(session: Session, actor: Actor, worked_day_id: UUID) -> None:
    """Take logged work back as its designer, until the studio agrees to it."""
    day, contract = _locked(session, actor, worked_day_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded(
            "only the designer can remove logged work", fix="refuse it and say why; what you do not agree to is not due"
        )
    _ensure_not_agreed(day)
    session.delete(day)
    session.flush()


def agree_day(session: Session, actor: Actor, worked_day_id: UUID) -> WorkedDay:
    """Agree to logged work as the studio; it is due, up to what the cap leaves."""
    day, contract = _locked(session, actor, worked_day_id)
    _ensure_producer(actor, contract, "only a producer of the studio agrees to logged work")
    _ensure_not_agreed(day)
    _ensure_not_refused(day)
    entries = _entries_of_hours(session, contract, day) if day.minutes else [_entry_of_day(session, contract, day)]
    mark_agreed(session, contract, day, by=actor.person)
    write(session, contract, entries, person_id=actor.person)
    return day


def mark_agreed(session: Session, contract: Contract, day: WorkedDay, *, by: UUID | None) -> None:
    """Count logged work as agreed to; `by` None: by the settlement of an early end."""
    day.agreed_at, day.agreed_by = clock.now(), by
    session.flush()
    record.append(session, contract.id, "work_agreed", _facts_of(day), by=by)


def refuse_day(session: Session, actor: Actor, worked_day_id: UUID, *, reason: str) -> WorkedDay:
    """Refuse logged work as the studio, and say why; its designer may correct it and send it again."""
    day, contract = _locked(session, actor, worked_day_id)
    _ensure_producer(actor, contract, "only a producer of the studio refuses logged work")
    _ensure_not_agreed(day)
    _ensure_not_refused(day)
    day.refused_at, day.refused_by, day.refusal = clock.now(), actor.person, reason
    session.flush()
    record.append(session, contract.id, "work_refused", {**_facts_of(day), "reason": reason}, by=actor.person)
    publish(session, "work.refused", studio_id=contract.studio_id, worked_day_id=day.id)
    return day


def _entry_of_day(session: Session, contract: Contract, day: WorkedDay) -> Entry:
    terms = terms_of(session, contract)
    left_minor = terms.days_cap_minor - _agreed_minor(load_ledger_book(session, contract))
    if left_minor <= 0:
        raise CapExceeded(
            f"the {counted(terms.days_cap, 'day')} agreed to {verb(terms.days_cap, 'is', 'are')} used up, "
            f"{money(terms.days_cap_minor, contract.currency)}",
            fix="propose a change order that raises the cap of days; agree to this day once it holds, or refuse it",
        )
    kind, amount_minor = LineKind.WORKED_DAY, min(price_of(day.quarters or 0, terms.day_rate_minor), left_minor)
    return Entry(kind, amount_minor, CLAUSES[kind], milestone_id=day.milestone_id)


def _entries_of_hours(session: Session, contract: Contract, day: WorkedDay) -> list[Entry]:
    hours = HourBook(session, contract)
    return hour_entries(day, hours.charge(day, hours.approved))


def day_rate_read(terms: MoneyTerms, book: LedgerBook) -> DayRateRead | None:
    """Return the rate of days and the used part of the cap; None where a contract pays otherwise."""
    if terms.price_mode is not PriceMode.DAY_RATE:
        return None
    return DayRateRead(
        day_rate_minor=terms.day_rate_minor,
        days_cap=terms.days_cap,
        agreed_minor=_agreed_minor(book),
        cap_minor=terms.days_cap_minor,
    )


def _agreed_minor(book: LedgerBook) -> int:
    return sum(line.amount_minor for line in book.owed if line.kind is LineKind.WORKED_DAY)


def _facts_of(day: WorkedDay) -> dict[str, object]:
    length = {"quarters": day.quarters} if day.quarters else {"minutes": day.minutes}
    return {
        "worked_day": str(day.id),
        "worked_on": day.worked_on.isoformat(),
        **length,
        "cue_id": str(day.cue_id) if day.cue_id else "",
        "note": day.note,
    }


def called_work(day: WorkedDay) -> str:
    """Return logged work as messages name it: 2 h 30 min on 2026-11-20."""
    worked_on = day_in_words(day.worked_on)
    return f"{hours_in_words(day.minutes)} on {worked_on}" if day.minutes else worked_on


def _locked(session: Session, actor: Actor, worked_day_id: UUID) -> tuple[WorkedDay, Contract]:
    day = queries.worked_day_by_id(session, worked_day_id)
    if day is None:
        raise WorkedDayNotFound(f"no logged work {worked_day_id}")
    try:
        contract = visible_contract(session, actor, day.contract_id)
    except ContractNotFound:
        raise WorkedDayNotFound(f"no logged work {worked_day_id}") from None
    lock_contract(session, contract.id)
    session.refresh(day)
    return day, contract


def _ensure_producer(actor: Actor, contract: Contract, message: str) -> None:
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded(message)


def _ensure_not_agreed(day: WorkedDay) -> None:
    if day.agreed_at is not None:
        raise DayAgreed(
            f"{called_work(day)} was agreed to already",
            fix="what was agreed to stands; log what is missing on another day",
        )


def _ensure_not_refused(day: WorkedDay) -> None:
    if day.refused_at is not None:
        raise DayRefused(
            f"{called_work(day)} was refused already: {day.refusal}",
            fix="wait until the designer corrects it and sends it again",
        )


def _ensure_loggable(session: Session, contract: Contract, work: Work, *, instead_of: UUID | None = None) -> None:
    """Raise an error for work that the contract does not pay for, that lies ahead, or that says not what it was."""
    if contract.state is not ContractState.AGREED:
        raise not_agreed(contract, "work can be logged once both have signed the contract")
    ensure_not_ahead(work.worked_on, plan_queries.today_of(session, contract), "log work only after it was done")
    if work.minutes is None:
        terms = terms_of(session, contract)
        if terms.price_mode is not PriceMode.DAY_RATE:
            instead = "log hours instead" if terms.has_hours else more_work(session, contract)
            raise NotDayRate("this contract does not pay by the day", fix=instead)
        return
    if work.cue_id is None and not work.note.strip():
        raise WorkNotNamed(
            "the hours name no cue and have no description", fix="choose a cue, or say what they were for"
        )
    if work.cue_id and not plan_queries.cues_in_project(session, contract.project_id, [work.cue_id]):
        raise CueNotFound(f"no cue {work.cue_id}")
    HourBook(session, contract).ensure_paid(work.worked_on, work.minutes, instead_of=instead_of)


def _milestone_at(session: Session, contract: Contract, worked_on: date) -> UUID | None:
    """Return the milestone that a day works towards: the next one due, else the last; None where none is planned."""
    milestones = [
        milestone for milestone in plan_queries.milestones_of(session, contract.id) if not milestone.is_deposit
    ]
    open_ones = [
        milestone for milestone in milestones if milestone.due_on and milestone.due_on >= worked_on
    ] or milestones[-1:]
    return open_ones[0].id if open_ones else None
