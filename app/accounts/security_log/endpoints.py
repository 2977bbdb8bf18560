"""The endpoints of the security log."""

from uuid import UUID

from fastapi import APIRouter, Response

from app.accounts.errors import ProducerNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.security_log import service as security_log
from app.accounts.security_log.rules import SecurityEventKind, csv_of
from app.accounts.security_log.schemas import SecurityEventRead
from app.accounts.web.policies import allows
from app.core.web.downloads import downloads, file_response
from app.core.web.http import BadCursor, DbSession, Page, cursor_of, problems, uuid_cursor

router = APIRouter(prefix="/v1", tags=["accounts"])
PAGE = 50
MAX_CSV_ROWS = 50_000


@router.get("/studios/{studio_id}/security-events", responses=problems(StudioNotFound, ProducerNeeded, BadCursor))
def list_security_events(
    studio_id: UUID,
    session: DbSession,
    kind: SecurityEventKind | None = None,
    cursor: str | None = None,
    actor: Actor = allows(Audience.PRODUCER),
) -> Page[SecurityEventRead]:
    """Return the security log of a studio, newest first; lines are kept for two years."""
    before = uuid_cursor(cursor)
    events = security_log.events_of(session, actor, studio_id, kind=kind, before=before, limit=PAGE + 1)
    shown = events[:PAGE]
    following = cursor_of(shown[-1].id) if len(events) > PAGE else None
    return Page(items=[SecurityEventRead.model_validate(event) for event in shown], next=following)


@router.get(
    "/studios/{studio_id}/security-events.csv",
    **downloads("text/csv", StudioNotFound, ProducerNeeded),
)
def download_security_events(
    studio_id: UUID,
    session: DbSession,
    kind: SecurityEventKind | None = None,
    actor: Actor = allows(Audience.PRODUCER),
) -> Response:
    """Return the newest 50,000 lines of the security log as CSV."""
    events = security_log.events_of(session, actor, studio_id, kind=kind, limit=MAX_CSV_ROWS)
    text = csv_of(
        (
            event.at.isoformat(timespec="seconds"),
            event.kind.value,
            event.person.name if event.person else "",
            event.about.name if event.about else "",
            event.summary,
            event.network,
        )
        for event in events
    )
    return file_response(text, "text/csv; charset=utf-8", "security-log.csv")
