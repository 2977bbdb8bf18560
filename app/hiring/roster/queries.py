"""Designers on file, within the studios of the caller."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import delete, exists, func, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Person, Studio
from app.accounts.quotas.queries import Usage
from app.accounts.rules import Actor
from app.hiring.models import BusyRange, Candidate, Loan, Posting, ReelSound, RosterEntry
from app.hiring.roster.rules import MAX_ENTRIES
from app.hiring.rules import PostingState
from app.projects.models import Engagement, Project

MAX_POSTINGS = 100


def entries_of(session: Session, studio_id: UUID) -> Sequence[RosterEntry]:
    """Return all designers whom a studio has on file, by name."""
    query = select(RosterEntry).where(RosterEntry.studio_id == studio_id)
    return session.scalars(query.order_by(func.lower(RosterEntry.name), RosterEntry.id).limit(MAX_ENTRIES)).all()


def entry_for(session: Session, actor: Actor, entry_id: UUID) -> RosterEntry | None:
    """Return an entry of one of the caller's studios."""
    return session.scalar(select(RosterEntry).where(RosterEntry.id == entry_id, RosterEntry.studio_id.in_(actor.roles)))


def entry_locked(session: Session, entry_id: UUID) -> RosterEntry | None:
    """Return an entry as it is now, locked until the transaction ends."""
    query = select(RosterEntry).where(RosterEntry.id == entry_id).with_for_update(key_share=True)
    return session.scalar(query.execution_options(populate_existing=True))


def lock_roster(session: Session, studio_id: UUID) -> None:
    """Keep other imports out of a studio's roster until the transaction ends."""
    session.execute(select(Studio.id).where(Studio.id == studio_id).with_for_update(key_share=True))


def has_address(session: Session, studio_id: UUID, email: str, *, but: UUID | None = None) -> bool:
    """Whether a studio has an address on file, in another entry than one."""
    query = select(RosterEntry.id).where(RosterEntry.studio_id == studio_id, RosterEntry.email == email)
    if but is not None:
        query = query.where(RosterEntry.id != but)
    return session.scalar(query) is not None


def entries_count(session: Session, studio_id: UUID) -> int:
    """Return the number of people that a studio has on file."""
    return session.scalar(select(func.count()).where(RosterEntry.studio_id == studio_id)) or 0


def ranges_of(session: Session, entry_ids: Collection[UUID]) -> dict[UUID, list[BusyRange]]:
    """Return by entry the days that are taken, the earliest first."""
    by_entry: defaultdict[UUID, list[BusyRange]] = defaultdict(list)
    query = select(BusyRange).where(BusyRange.entry_id.in_(entry_ids)).order_by(BusyRange.from_on, BusyRange.id)
    for busy_range in session.scalars(query):
        by_entry[busy_range.entry_id].append(busy_range)
    return by_entry


def drop_ranges(session: Session, entry_id: UUID, *, from_calendar: bool) -> None:
    """Remove the days that were typed, or those of the calendar file."""
    session.execute(
        delete(BusyRange).where(BusyRange.entry_id == entry_id, BusyRange.is_from_calendar.is_(from_calendar))
    )


def drop_entry(session: Session, entry_id: UUID) -> None:
    """Remove an entry with its days and its reel."""
    for table, column in (
        (BusyRange, BusyRange.entry_id),
        (Loan, Loan.entry_id),
        (ReelSound, ReelSound.entry_id),
        (RosterEntry, RosterEntry.id),
    ):
        session.execute(delete(table).where(column == entry_id))


def loans_of(session: Session, entry_id: UUID) -> Sequence[Loan]:
    """Return the loans to a designer on file, the first lent first."""
    return session.scalars(select(Loan).where(Loan.entry_id == entry_id).order_by(Loan.lent_on, Loan.id)).all()


def drop_loans(session: Session, entry_id: UUID) -> None:
    """Remove the loans to a designer on file."""
    session.execute(delete(Loan).where(Loan.entry_id == entry_id))


def sounds_of(session: Session, entry_ids: Collection[UUID]) -> dict[UUID, list[ReelSound]]:
    """Return by entry the sounds of the reel, in the order in which they were added."""
    by_entry: defaultdict[UUID, list[ReelSound]] = defaultdict(list)
    for sound in session.scalars(select(ReelSound).where(ReelSound.entry_id.in_(entry_ids)).order_by(ReelSound.id)):
        by_entry[sound.entry_id].append(sound)
    return by_entry


def sound_for(session: Session, actor: Actor, sound_id: UUID) -> ReelSound | None:
    """Return a sound of a reel of one of the caller's studios."""
    return session.scalar(select(ReelSound).where(ReelSound.id == sound_id, ReelSound.studio_id.in_(actor.roles)))


kept_reel_bytes = Usage(ReelSound.studio_id, sha256=ReelSound.sha256, size_bytes=ReelSound.file_bytes)


def designers_of(session: Session, studio_id: UUID, emails: Collection[str]) -> dict[str, Person]:
    """Return by address the people with that proven address who are or were engaged by a studio."""
    engaged = exists().where(Engagement.designer_id == Person.id, Engagement.studio_id == studio_id)
    query = select(Person).where(Person.email.in_(emails), Person.email_proof.is_not(None), engaged)
    return {person.email: person for person in session.scalars(query)}


def entries_of_addresses(session: Session, studio_id: UUID, emails: Collection[str]) -> dict[str, RosterEntry]:
    """Return by address whom a studio has on file."""
    query = select(RosterEntry).where(RosterEntry.studio_id == studio_id, RosterEntry.email.in_(emails))
    return {entry.email: entry for entry in session.scalars(query)}


def entries_by_id(session: Session, studio_id: UUID, entry_ids: Collection[UUID]) -> Sequence[RosterEntry]:
    """Return those of these entries that a studio has."""
    query = select(RosterEntry).where(RosterEntry.studio_id == studio_id, RosterEntry.id.in_(entry_ids))
    return session.scalars(query.order_by(RosterEntry.id)).all()


def postings_to_ask_about(session: Session, studio_id: UUID) -> Sequence[Posting]:
    """Return the postings of a studio's projects that are drafts or open, newest first."""
    states = (PostingState.DRAFT, PostingState.OPEN)
    return session.scalars(
        select(Posting)
        .join(Posting.project)
        .where(Posting.studio_id == studio_id, Posting.state.in_(states), Project.archived_at.is_(None))
        .options(joinedload(Posting.project))
        .order_by(Posting.id.desc())
        .limit(MAX_POSTINGS)
    ).all()


def asked_postings(session: Session, email: str, posting_ids: Collection[UUID]) -> set[UUID]:
    """Return those of these postings that an address is asked about."""
    query = select(Candidate.posting_id).where(
        Candidate.email == email, Candidate.posting_id.in_(posting_ids), Candidate.revoked_at.is_(None)
    )
    return set(session.scalars(query))
