"""The endpoint of what is due."""

from typing import Any

from fastapi import APIRouter, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.dashboards.due import service as due_calendar
from app.money.errors import CalendarNotFound

ICALENDAR = "text/calendar"
ANSWER: dict[int | str, dict[str, Any]] = {200: {"content": {ICALENDAR: {}}, "description": "Dates"}}

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/calendars/{secret}", response_class=Response, responses=ANSWER | problems(CalendarNotFound))
def read_calendar(secret: str, session: DbSession, _actor: Actor = allows(Audience.ANYONE)) -> Response:
    """Return a project's due things as iCalendar, for the holder of the address."""
    return Response(due_calendar.feed(session, secret), media_type=ICALENDAR)
