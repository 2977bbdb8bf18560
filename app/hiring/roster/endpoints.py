"""The endpoints of the roster."""

import base64
from datetime import date
from typing import Annotated, Any, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Query, Request, Response

from app.accounts.errors import BadAddress, StudioNotFound, TooManyAttempts
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import ensure_invitation_allowed
from app.core import clock
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.storage import BlobMissing
from app.core.uploads import UploadNotFound, UploadUnfinished
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, problems
from app.hiring.errors import (
    AlreadyOnRoster,
    CalendarUnreadable,
    NoSound,
    PostingNotFound,
    ReelFull,
    ReelSoundNotFound,
    RosterEntryChanged,
    RosterEntryNotFound,
    RosterFull,
    RosterInvalid,
    WrongPostingState,
)
from app.hiring.postings import service as postings
from app.hiring.postings.reads import posting_read
from app.hiring.roster import reel
from app.hiring.roster import service as roster
from app.hiring.roster.files import Range, parse_calendar, parse_roster_bytes, parse_roster_text
from app.hiring.roster.imports import import_roster
from app.hiring.roster.reads import entry_read, posting_choices, roster_read
from app.hiring.roster.rules import Busy, RosterFilter, RosterService
from app.hiring.roster.schemas import (
    BusyRangesWrite,
    CalendarFile,
    LoansWrite,
    PostingChoice,
    ReelSoundAdd,
    RosterEntryChange,
    RosterEntryRead,
    RosterEntryWrite,
    RosterImportAsk,
    RosterImportRead,
    RosterInvite,
    RosterRead,
)
from app.hiring.schemas import PostingRead
from app.projects.errors import ProducerNeeded, TeamNeeded
from app.sound_lists.errors import ColumnUnknown, SheetUnreadable
from app.sound_lists.sheets.rules import Sheet

router = APIRouter(prefix="/v1", tags=["roster"])
TEAM: Actor = allows(Audience.TEAM)
# What strangers sent runs nothing and loads nothing in a browser that opens it.
LOCKED = {"Content-Security-Policy": "default-src 'none'; sandbox", "X-Content-Type-Options": "nosniff"}
SentSheet: TypeAlias = tuple[RosterImportAsk, Sheet]
SentCalendar: TypeAlias = tuple[CalendarFile, list[Range]]
Text = Annotated[str, Query(max_length=200)]


@router.get("/studios/{studio_id}/roster", responses=problems(StudioNotFound, TeamNeeded, BadCursor))
def list_roster(
    studio_id: UUID,
    session: DbSession,
    q: Annotated[str, Query(max_length=200, description="Words that must all be found.")] = "",
    speciality: Text = "",
    service: RosterService | None = None,
    language: Text = "",
    free_from: Annotated[date | None, Query(description="With free_to: what is taken in these days is named.")] = None,
    free_to: date | None = None,
    cursor: str | None = None,
    actor: Actor = TEAM,
) -> RosterRead:
    """Return the designers whom a studio has on file, by name."""
    wanted = RosterFilter(words=q, speciality=speciality, service=service, language=language)
    return roster_read(session, actor, studio_id, wanted, days=(free_from, free_to), cursor=cursor)


@router.post(
    "/studios/{studio_id}/roster",
    status_code=201,
    responses=problems(
        StudioNotFound, TeamNeeded, ProducerNeeded, BadAddress, AlreadyOnRoster, RosterFull, RosterInvalid
    ),
)
def add_to_roster(studio_id: UUID, body: RosterEntryWrite, session: DbSession, actor: Actor = TEAM) -> RosterEntryRead:
    """Put a designer on file; nobody is mailed."""
    entry = roster.add_entry(session, actor, studio_id, body.model_dump())
    return entry_read(session, actor, entry.id)


async def _parsed(studio_id: UUID, body: RosterImportAsk, request: Request) -> SentSheet:
    if body.text is not None:
        arguments: tuple[Any, ...] = (parse_roster_text, body.text, body.format == "paste")
    elif body.content_base64 is None:
        raise SheetUnreadable("nothing was sent; give text or content_base64")
    else:
        try:
            arguments = (parse_roster_bytes, base64.b64decode(body.content_base64, validate=True))
        except ValueError:
            raise SheetUnreadable("content_base64 is not base64") from None
    parsed = await parse_request(
        request, *arguments, refusal=SheetUnreadable, permit=roster.roster_access, whose=studio_id
    )
    return body, Sheet(*parsed)


@router.post(
    "/studios/{studio_id}/roster/import",
    responses=problems(StudioNotFound, TeamNeeded, SheetUnreadable, ColumnUnknown, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def import_into_roster(
    studio_id: UUID,
    actor: Annotated[Actor, TEAM],
    sent: Annotated[SentSheet, Depends(_parsed)],
    session: DbSession,
) -> RosterImportRead:
    """Read a sheet of designers into the roster, matched by address; with an error in any row nothing is imported."""
    body, sheet = sent
    return import_roster(session, actor, studio_id, sheet, mapping=body.mapping or {}, dry_run=body.dry_run)


@router.get("/roster/{roster_entry_id}", responses=problems(RosterEntryNotFound, TeamNeeded))
def read_roster_entry(roster_entry_id: UUID, session: DbSession, actor: Actor = TEAM) -> RosterEntryRead:
    """Return a designer on file."""
    return entry_read(session, actor, roster_entry_id)


@router.put(
    "/roster/{roster_entry_id}",
    responses=problems(
        RosterEntryNotFound, TeamNeeded, ProducerNeeded, BadAddress, AlreadyOnRoster, RosterEntryChanged, RosterInvalid
    ),
)
def change_roster_entry(
    roster_entry_id: UUID, body: RosterEntryChange, session: DbSession, actor: Actor = TEAM
) -> RosterEntryRead:
    """Change the facts on file of a designer."""
    facts = body.model_dump(exclude={"revision"})
    roster.change_entry(session, actor, roster_entry_id, facts, revision=body.revision)
    return entry_read(session, actor, roster_entry_id)


@router.delete("/roster/{roster_entry_id}", status_code=204, responses=problems(RosterEntryNotFound, TeamNeeded))
def remove_from_roster(roster_entry_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Remove a designer from the file, with everything that was noted of them."""
    roster.remove_entry(session, actor, roster_entry_id)


@router.put("/roster/{roster_entry_id}/busy", responses=problems(RosterEntryNotFound, TeamNeeded, RosterInvalid))
def set_roster_busy(
    roster_entry_id: UUID, body: BusyRangesWrite, session: DbSession, actor: Actor = TEAM
) -> RosterEntryRead:
    """Replace the days that were typed as taken; those of a calendar file stay."""
    ranges = [Busy(period.from_on, period.to_on, period.kind, period.note) for period in body.ranges]
    roster.set_busy(session, actor, roster_entry_id, ranges)
    return entry_read(session, actor, roster_entry_id)


@router.put("/roster/{roster_entry_id}/loans", responses=problems(RosterEntryNotFound, TeamNeeded, RosterInvalid))
def set_roster_loans(
    roster_entry_id: UUID, body: LoansWrite, session: DbSession, actor: Actor = TEAM
) -> RosterEntryRead:
    """Replace the list of equipment that is lent to a designer on file, with the days of return."""
    roster.set_loans(session, actor, roster_entry_id, body.loans)
    return entry_read(session, actor, roster_entry_id)


async def _parsed_calendar(roster_entry_id: UUID, body: CalendarFile, request: Request) -> SentCalendar:
    try:
        data = base64.b64decode(body.content_base64, validate=True)
    except ValueError:
        raise CalendarUnreadable("content_base64 is not base64") from None
    today = clock.now().date().isoformat()
    calendar = await parse_request(
        request,
        parse_calendar,
        data,
        today,
        refusal=CalendarUnreadable,
        permit=roster.entry_seen,
        whose=roster_entry_id,
    )
    return body, calendar


@router.put(
    "/roster/{roster_entry_id}/calendar",
    responses=problems(RosterEntryNotFound, TeamNeeded, CalendarUnreadable, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def read_roster_calendar(
    roster_entry_id: UUID,
    actor: Annotated[Actor, TEAM],
    sent: Annotated[SentCalendar, Depends(_parsed_calendar)],
    session: DbSession,
) -> RosterEntryRead:
    """Read the taken days of the coming year from a calendar file; no title of an event is kept."""
    body, calendar = sent
    roster.read_calendar(session, actor, roster_entry_id, calendar, file_name=body.file_name)
    return entry_read(session, actor, roster_entry_id)


@router.delete("/roster/{roster_entry_id}/calendar", responses=problems(RosterEntryNotFound, TeamNeeded))
def drop_roster_calendar(roster_entry_id: UUID, session: DbSession, actor: Actor = TEAM) -> RosterEntryRead:
    """Remove the days that came from a calendar file."""
    roster.drop_calendar(session, actor, roster_entry_id)
    return entry_read(session, actor, roster_entry_id)


@router.get("/roster/{roster_entry_id}/postings", responses=problems(RosterEntryNotFound, TeamNeeded))
def list_postings_to_ask_about(roster_entry_id: UUID, session: DbSession, actor: Actor = TEAM) -> list[PostingChoice]:
    """Return the drafts and open postings that a designer on file can be asked about, newest first."""
    return posting_choices(session, actor, roster_entry_id)


@router.post(
    "/postings/{posting_id}/roster-candidates",
    status_code=201,
    responses=problems(PostingNotFound, TeamNeeded, RosterEntryNotFound, TooManyAttempts, WrongPostingState),
)
def invite_from_roster(posting_id: UUID, body: RosterInvite, session: DbSession, actor: Actor = TEAM) -> PostingRead:
    """Ask people on file for a bid, each with a personal link: by mail at once, or when the posting opens."""
    postings.posting_seen(session, actor, posting_id).ensure_team()
    for address in roster.addresses_on_file(session, actor, posting_id, body.entry_ids):
        ensure_invitation_allowed(session, actor, address)
        postings.invite(session, actor, posting_id, address)
    return posting_read(session, actor, posting_id)


@router.post(
    "/roster/{roster_entry_id}/reel",
    status_code=201,
    responses=problems(
        RosterEntryNotFound, TeamNeeded, NoSound, ReelFull, UploadNotFound, UploadUnfinished, BlobMissing
    ),
)
def add_reel_sound(
    roster_entry_id: UUID, body: ReelSoundAdd, session: DbSession, runtime: CurrentRuntime, actor: Actor = TEAM
) -> RosterEntryRead:
    """Add a finished upload to the reel of a designer on file."""
    reel.add_sound(session, actor, roster_entry_id, upload_id=body.upload_id, title=body.title, store=runtime.store)
    return entry_read(session, actor, roster_entry_id)


@router.delete("/reel-sounds/{reel_sound_id}", responses=problems(ReelSoundNotFound, TeamNeeded))
def remove_reel_sound(reel_sound_id: UUID, session: DbSession, actor: Actor = TEAM) -> RosterEntryRead:
    """Remove a sound from its reel."""
    return entry_read(session, actor, reel.remove_sound(session, actor, reel_sound_id))


@router.get(
    "/reel-sounds/{reel_sound_id}/file",
    **downloads("application/octet-stream", ReelSoundNotFound, TeamNeeded, BlobMissing),
)
def get_reel_sound(
    reel_sound_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = TEAM
) -> Response:
    """Send a sound of a reel as it was uploaded, parts of it by Range."""
    sound = reel.sound_seen(session, actor, reel_sound_id)
    headers = LOCKED | {"Cache-Control": WHILE_ASKED}
    return blob_response(
        request, runtime.store, sound.studio_id, sound.sha256, media_type=sound.media_type, headers=headers
    )
