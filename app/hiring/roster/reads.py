"""The roster as its callers may see it: rates for producers only."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core.web.http import bad_cursor, uuid_cursor
from app.hiring.models import BusyRange, ReelSound, RosterEntry
from app.hiring.roster import queries as roster_queries
from app.hiring.roster.rules import (
    Busy,
    RosterFilter,
    clashes,
    counted,
    free_from,
    monday_of,
    weeks,
)
from app.hiring.roster.schemas import (
    BusyRangeRead,
    LoanFacts,
    PostingChoice,
    ReelSoundRead,
    RosterEntryRead,
    RosterRate,
    RosterRead,
    RosterRow,
    ValueCount,
)
from app.hiring.roster.service import (
    RosterAccess,
    busy_of,
    entry_seen,
    found_entries,
    postings_to_ask_about,
    roster_access,
)
from app.hiring.schemas import BusyRangeWrite

PAGE = 100
AS_KEPT = (
    *("id", "studio_id", "name", "email", "specialities", "services", "languages", "equipment", "credits"),
    *("referees", "links", "exclusivity", "weekly_hours", "available_from_on", "notes", "revision"),
    *("calendar_name", "calendar_read_at", "calendar_to_on", "added_at", "changed_at"),
)


def roster_read(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    wanted: RosterFilter,
    *,
    days: tuple[date | None, date | None],
    cursor: str | None,
) -> RosterRead:
    """Return one page of those on file who match, with what is taken of their days."""
    access = roster_access(session, actor, studio_id)
    all_entries, entries = found_entries(session, studio_id, wanted)
    start = _after(entries, cursor)
    shown = entries[start : start + PAGE]
    ids = [entry.id for entry in shown]
    ranges, sounds = roster_queries.ranges_of(session, ids), roster_queries.sounds_of(session, ids)
    engaged = roster_queries.designers_of(session, studio_id, [entry.email for entry in shown])
    return RosterRead(
        items=[
            _row(access, entry, ranges.get(entry.id, []), sounds.get(entry.id, []), days, entry.email in engaged)
            for entry in shown
        ],
        next=str(shown[-1].id) if start + PAGE < len(entries) else None,
        found=len(entries),
        total=len(all_entries),
        first_week_on=monday_of(access.today),
        specialities=_counts([entry.specialities for entry in all_entries]),
        services=_counts([entry.services for entry in all_entries]),
        languages=_counts([entry.languages for entry in all_entries]),
    )


def _after(entries: Sequence[RosterEntry], cursor: str | None) -> int:
    last = uuid_cursor(cursor)
    if last is None or cursor is None:
        return 0
    index = next((position for position, entry in enumerate(entries) if entry.id == last), None)
    if index is None:
        raise bad_cursor(cursor)
    return index + 1


def _counts(values: Sequence[Sequence[str]]) -> list[ValueCount]:
    return [ValueCount(value=value, count=count) for value, count in counted(values)]


def _rate(access: RosterAccess, entry: RosterEntry) -> RosterRate | None:
    if not access.is_producer or entry.rate_minor is None or entry.rate_unit is None:
        return None
    return RosterRate(amount_minor=entry.rate_minor, currency=entry.rate_currency, unit=entry.rate_unit)


def _clashes(busy: Sequence[Busy], days: tuple[date | None, date | None], from_on: date | None) -> list[BusyRangeWrite]:
    return [BusyRangeWrite(**vars(clash)) for clash in clashes(busy, *days, from_on)]


def _row(
    access: RosterAccess,
    entry: RosterEntry,
    ranges: Sequence[BusyRange],
    sounds: Sequence[ReelSound],
    days: tuple[date | None, date | None],
    works_here: bool,
) -> RosterRow:
    busy = busy_of(ranges)
    return RosterRow(
        id=entry.id,
        name=entry.name,
        email=entry.email,
        specialities=entry.specialities,
        services=entry.services,
        languages=entry.languages,
        exclusivity=entry.exclusivity,
        weekly_hours=entry.weekly_hours,
        free_from_on=free_from(busy, access.today, entry.available_from_on),
        weeks=weeks(busy, access.today, entry.available_from_on),
        clashes=_clashes(busy, days, entry.available_from_on),
        rate=_rate(access, entry),
        reel=[ReelSoundRead.model_validate(sound) for sound in sounds],
        works_here=works_here,
    )


def entry_read(session: Session, actor: Actor, entry_id: UUID) -> RosterEntryRead:
    """Return a designer on file as the caller may see it."""
    access, entry = entry_seen(session, actor, entry_id)
    ranges = roster_queries.ranges_of(session, [entry.id]).get(entry.id, [])
    sounds = roster_queries.sounds_of(session, [entry.id]).get(entry.id, [])
    busy = busy_of(ranges)
    person = roster_queries.designers_of(session, entry.studio_id, [entry.email]).get(entry.email)
    return RosterEntryRead(
        **{name: getattr(entry, name) for name in AS_KEPT},
        rate=_rate(access, entry),
        may_see_rate=access.is_producer,
        free_from_on=free_from(busy, access.today, entry.available_from_on),
        first_week_on=monday_of(access.today),
        weeks=weeks(busy, access.today, entry.available_from_on),
        busy=[BusyRangeRead.model_validate(busy_range) for busy_range in ranges],
        loans=[LoanFacts.model_validate(loan) for loan in roster_queries.loans_of(session, entry.id)],
        reel=[ReelSoundRead.model_validate(sound) for sound in sounds],
        designer=PersonBrief.model_validate(person) if person else None,
    )


def posting_choices(session: Session, actor: Actor, entry_id: UUID) -> list[PostingChoice]:
    """Return the postings that a designer on file can be asked about, newest first, with clashes of dates."""
    _, entry = entry_seen(session, actor, entry_id)
    postings = postings_to_ask_about(session, actor, entry)
    asked = roster_queries.asked_postings(session, entry.email, [posting.id for posting in postings])
    busy = busy_of(roster_queries.ranges_of(session, [entry.id]).get(entry.id, []))
    return [
        PostingChoice(
            id=posting.id,
            project_id=posting.project_id,
            project_name=posting.project.name,
            title=posting.title,
            state=posting.state,
            work_from_on=posting.work_from_on,
            work_to_on=posting.work_to_on,
            clashes=_clashes(busy, (posting.work_from_on, posting.work_to_on), entry.available_from_on),
            is_asked=posting.id in asked,
        )
        for posting in postings
    ]
