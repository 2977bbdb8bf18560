"""The roster of a studio: designers on file, the days on which they are busy, and asking them for a bid."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from typing import Any
from uuid import UUID
from zoneinfo import ZoneInfo

from sqlalchemy.orm import Session

from app.accounts.models import Person, Studio
from app.accounts.rules import Actor, Role, ensure_address
from app.accounts.service import ensure_member_of
from app.core import clock
from app.core.errors import FieldProblem
from app.hiring.errors import (
    AlreadyOnRoster,
    RosterEntryChanged,
    RosterEntryNotFound,
    RosterFull,
    RosterInvalid,
)
from app.hiring.models import BusyRange, Loan, Posting, RosterEntry
from app.hiring.postings.access import posting_for_team
from app.hiring.roster import queries as roster_queries
from app.hiring.roster.files import HORIZON, Range
from app.hiring.roster.rules import MAX_ENTRIES, Busy, BusyKind, Known, RosterFilter, matches, tidy_values
from app.hiring.roster.schemas import LoanFacts
from app.projects.errors import ProducerNeeded, TeamNeeded
from app.projects.service import project_access
from app.references.errors import ReferenceInvalid
from app.references.rules import host_of

READERS = frozenset({Role.PRODUCER, Role.LIAISON})


@dataclass(frozen=True)
class RosterAccess:
    """A caller's place at a roster; everyone with it acts for the studio."""

    studio: Studio
    is_producer: bool

    @property
    def today(self) -> date:
        """The day that it is now for the studio."""
        return clock.now().astimezone(ZoneInfo(self.studio.time_zone)).date()


def roster_access(session: Session, actor: Actor, studio_id: UUID) -> RosterAccess:
    """Return the caller's place at a studio's roster; raise TeamNeeded for its other members."""
    ensure_member_of(actor, studio_id)
    roles = actor.roles_in(studio_id)
    if not roles & READERS:
        raise TeamNeeded("only a producer or an audio lead of the studio can do this")
    return RosterAccess(session.get_one(Studio, studio_id), is_producer=Role.PRODUCER in roles)


def entry_seen(session: Session, actor: Actor, entry_id: UUID) -> tuple[RosterAccess, RosterEntry]:
    """Return an entry of the caller's studio; raise RosterEntryNotFound where there is none."""
    entry = roster_queries.entry_for(session, actor, entry_id)
    if entry is None:
        raise RosterEntryNotFound(f"nobody on file under {entry_id}")
    return roster_access(session, actor, entry.studio_id), entry


def found_entries(
    session: Session, studio_id: UUID, wanted: RosterFilter
) -> tuple[Sequence[RosterEntry], list[RosterEntry]]:
    """Return all entries of a roster, and those that match, by name."""
    all_entries = roster_queries.entries_of(session, studio_id)
    return all_entries, [entry for entry in all_entries if matches(known_of(entry), wanted)]


def known_of(entry: RosterEntry) -> Known:
    """Return the facts of an entry that a search can find; a rate is none of them."""
    texts = (entry.name, entry.email, entry.equipment, entry.credits, entry.referees, entry.notes)
    return Known(texts, entry.specialities, entry.services, entry.languages)


def entries_of_bidders(
    session: Session, actor: Actor, studio_id: UUID, emails: Sequence[str]
) -> dict[str, tuple[RosterEntry, list[Busy]]]:
    """Return by address who is on file, with the days that are taken; nobody to those who do not see the roster."""
    if not actor.roles_in(studio_id) & READERS:
        return {}
    entries = roster_queries.entries_of_addresses(session, studio_id, emails)
    ranges = roster_queries.ranges_of(session, [entry.id for entry in entries.values()])
    return {email: (entry, busy_of(ranges.get(entry.id, []))) for email, entry in entries.items()}


def busy_of(ranges: Iterable[BusyRange]) -> list[Busy]:
    """Return the days that are taken as rules read them."""
    return [Busy(busy.from_on, busy.to_on, busy.kind, busy.note) for busy in ranges]


def add_entry(session: Session, actor: Actor, studio_id: UUID, facts: Mapping[str, Any]) -> RosterEntry:
    """Put a designer on file; `facts` are the columns that people write, without a rate for all but producers."""
    access = roster_access(session, actor, studio_id)
    roster_queries.lock_roster(session, studio_id)
    if is_full(session, studio_id):
        raise RosterFull(f"a roster has {MAX_ENTRIES:,} people at most", fix="remove those whom you will not ask again")
    entry = RosterEntry(studio_id=studio_id, added_by=actor.person, revision=1)
    _put(session, access, entry, facts)
    session.add(entry)
    session.flush()
    return entry


def change_entry(session: Session, actor: Actor, entry_id: UUID, facts: Mapping[str, Any], *, revision: int) -> None:
    """Change the facts on file; those that the caller may not see stay."""
    access, _ = entry_seen(session, actor, entry_id)
    entry = _locked(session, entry_id)
    if entry.revision != revision:
        raise RosterEntryChanged("someone changed this entry since you read it", fix="read it again, then save yours")
    _put(session, access, entry, facts)
    session.flush()


def remove_entry(session: Session, actor: Actor, entry_id: UUID) -> None:
    """Remove a designer from the file, with everything that was noted of them."""
    entry_seen(session, actor, entry_id)
    roster_queries.drop_entry(session, entry_id)


def ensure_links(links: Sequence[Mapping[str, str]]) -> None:
    """Raise RosterInvalid for a link that is not a plain https address."""
    for index, link in enumerate(links):
        try:
            host_of(link["url"])
        except ReferenceInvalid as error:
            raise RosterInvalid(
                error.message, errors=[FieldProblem(where=f"links.{index}.url", message=error.message)]
            ) from None


def put_facts(entry: RosterEntry, facts: Mapping[str, Any]) -> None:
    """Set columns of an entry, which counts as a change of one that is kept already."""
    for name, value in facts.items():
        is_list = name in ("specialities", "services", "languages")
        setattr(entry, name, tidy_values(value) if is_list else value)
    if entry.id is not None:
        entry.revision += 1
    entry.changed_at = clock.now()


def is_full(session: Session, studio_id: UUID) -> bool:
    """Whether a roster has as many people as a studio may keep."""
    return roster_queries.entries_count(session, studio_id) >= MAX_ENTRIES


def keep_on_roster(session: Session, actor: Actor, studio_id: UUID, designer_id: UUID) -> bool:
    """Put a designer on file under the name and address of their account, and return whether they are on file.

    One who is there stays as they are; a full roster takes nobody.
    """
    designer = session.get_one(Person, designer_id)
    roster_queries.lock_roster(session, studio_id)
    if roster_queries.has_address(session, studio_id, designer.email):
        return True
    if is_full(session, studio_id):
        return False
    entry = RosterEntry(
        studio_id=studio_id,
        name=designer.name,
        email=designer.email,
        specialities=[],
        services=[],
        languages=[],
        links=[],
        added_by=actor.person,
        revision=1,
    )
    session.add(entry)
    session.flush()
    return True


def _put(session: Session, access: RosterAccess, entry: RosterEntry, facts: Mapping[str, Any]) -> None:
    facts = dict(facts)
    rate = facts.pop("rate")
    if access.is_producer:
        facts |= {
            "rate_minor": rate["amount_minor"] if rate else None,
            "rate_currency": rate["currency"] if rate else "USD",
            "rate_unit": rate["unit"] if rate else None,
        }
    elif rate is not None:
        raise ProducerNeeded("only a producer of the studio writes rates")
    facts["email"] = ensure_address(facts["email"])
    if roster_queries.has_address(session, access.studio.id, facts["email"], but=entry.id):
        message = "is on file already"
        raise AlreadyOnRoster(
            f"{facts['email']} {message}", errors=[FieldProblem(where="email", message=message)], fix="open that entry"
        )
    ensure_links(facts["links"])
    put_facts(entry, facts)


def _locked(session: Session, entry_id: UUID) -> RosterEntry:
    entry = roster_queries.entry_locked(session, entry_id)
    if entry is None:  # removed between two of our statements
        raise RosterEntryNotFound(f"nobody on file under {entry_id}")
    return entry


def set_busy(session: Session, actor: Actor, entry_id: UUID, ranges: Sequence[Busy]) -> None:
    """Replace the days that were typed; those of the calendar file stay."""
    entry_seen(session, actor, entry_id)
    for index, busy in enumerate(ranges):
        if busy.to_on < busy.from_on:
            message = "ends before it begins"
            raise RosterInvalid(
                f"a period {message}", errors=[FieldProblem(where=f"ranges.{index}.to_on", message=message)]
            )
    _replace(session, _locked(session, entry_id), ranges, from_calendar=False)


def set_loans(session: Session, actor: Actor, entry_id: UUID, loans: Sequence[LoanFacts]) -> None:
    """Replace the loans to a designer on file; raise RosterInvalid where one ends before it begins."""
    entry_seen(session, actor, entry_id)
    for index, loan in enumerate(loans):
        for name in ("due_on", "returned_on"):
            ends_on = getattr(loan, name)
            if ends_on is not None and ends_on < loan.lent_on:
                message = "is before the day on which it was lent"
                where = FieldProblem(where=f"loans.{index}.{name}", message=message)
                raise RosterInvalid(f"the end of a loan {message}", errors=[where])
    entry = _locked(session, entry_id)
    roster_queries.drop_loans(session, entry.id)
    session.add_all(Loan(studio_id=entry.studio_id, entry_id=entry.id, **loan.model_dump()) for loan in loans)
    session.flush()


def read_calendar(session: Session, actor: Actor, entry_id: UUID, calendar: Sequence[Range], *, file_name: str) -> None:
    """Replace the days of the calendar file by those of a newer one."""
    access, _ = entry_seen(session, actor, entry_id)
    entry = _locked(session, entry_id)
    ranges = [
        Busy(date.fromisoformat(first), date.fromisoformat(last), BusyKind(kind)) for first, last, kind in calendar
    ]
    _replace(session, entry, ranges, from_calendar=True)
    entry.calendar_name, entry.calendar_read_at = file_name, clock.now()
    entry.calendar_to_on = access.today + HORIZON
    session.flush()


def drop_calendar(session: Session, actor: Actor, entry_id: UUID) -> None:
    """Remove the days of the calendar file."""
    entry_seen(session, actor, entry_id)
    entry = _locked(session, entry_id)
    _replace(session, entry, (), from_calendar=True)
    entry.calendar_name = entry.calendar_read_at = entry.calendar_to_on = None
    session.flush()


def _replace(session: Session, entry: RosterEntry, ranges: Sequence[Busy], *, from_calendar: bool) -> None:
    roster_queries.drop_ranges(session, entry.id, from_calendar=from_calendar)
    session.add_all(
        BusyRange(
            studio_id=entry.studio_id,
            entry_id=entry.id,
            from_on=busy.from_on,
            to_on=busy.to_on,
            kind=busy.kind,
            note=busy.note,
            is_from_calendar=from_calendar,
        )
        for busy in ranges
    )
    session.flush()


def postings_to_ask_about(session: Session, actor: Actor, entry: RosterEntry) -> list[Posting]:
    """Return the drafts and open postings that the caller may ask a designer about."""
    postings = []
    may_speak: dict[UUID, bool] = {}
    for posting in roster_queries.postings_to_ask_about(session, entry.studio_id):
        if posting.project_id not in may_speak:
            access = project_access(session, actor, posting.project_id)
            may_speak[posting.project_id] = access.is_producer or access.is_liaison or access.is_approver
        if may_speak[posting.project_id]:
            postings.append(posting)
    return postings


def addresses_on_file(session: Session, actor: Actor, posting_id: UUID, entry_ids: Sequence[UUID]) -> list[str]:
    """Return the addresses of people on file, to ask for a bid; raise RosterEntryNotFound where one is not on file."""
    posting = posting_for_team(session, actor, posting_id)
    roster_access(session, actor, posting.studio_id)
    entries = roster_queries.entries_by_id(session, posting.studio_id, entry_ids)
    if missing := set(entry_ids) - {entry.id for entry in entries}:
        raise RosterEntryNotFound(f"nobody on file under {min(missing)}")
    return [entry.email for entry in entries]
