"""The endpoints of a studio's calendar."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.calendars import service as calendars
from app.accounts.errors import DayNamedTwice, ProducerNeeded, StudioNotFound, TimeZoneUnknown
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import CalendarRead, CalendarSave
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems

router = APIRouter(prefix="/v1", tags=["accounts"])


@router.get("/studios/{studio_id}/calendar", response_model=CalendarRead, responses=problems(StudioNotFound))
def get_studio_calendar(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.STUDIO)) -> CalendarRead:
    """Return the studio's time zone and holidays, by which working days are counted."""
    return calendars.calendar(session, actor, studio_id)


@router.put(
    "/studios/{studio_id}/calendar",
    response_model=CalendarRead,
    responses=problems(StudioNotFound, ProducerNeeded, TimeZoneUnknown, DayNamedTwice),
)
def save_studio_calendar(
    studio_id: UUID, body: CalendarSave, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> CalendarRead:
    """Replace the studio's time zone and holidays. For a cue that waits already, a holiday entered now is ignored."""
    return calendars.save_calendar(session, actor, studio_id, body)
