"""Working times of studios: their time zone, and their holidays besides Saturdays and Sundays."""

from collections.abc import Collection, Sequence
from uuid import UUID
from zoneinfo import available_timezones

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.errors import DayNamedTwice, TimeZoneUnknown
from app.accounts.models import Holiday, Studio
from app.accounts.rules import Actor
from app.accounts.schemas import CalendarRead, CalendarSave, HolidayRead
from app.accounts.service import ensure_member_of, ensure_producer_of


def calendar(session: Session, actor: Actor, studio_id: UUID) -> CalendarRead:
    """Return the calendar of the caller's studio."""
    ensure_member_of(actor, studio_id)
    return calendar_of(session, studio_id)


def save_calendar(session: Session, actor: Actor, studio_id: UUID, calendar_save: CalendarSave) -> CalendarRead:
    """Replace a studio's calendar, as a producer; a holiday that stays keeps the moment at which it was entered."""
    studio = ensure_producer_of(session, actor, studio_id)
    if calendar_save.time_zone not in available_timezones():
        raise TimeZoneUnknown(
            f'there is no time zone "{calendar_save.time_zone}"',
            fix="give a name of the IANA list, such as Europe/Berlin",
        )
    names = {day_off.day: day_off.name for day_off in calendar_save.holidays}
    if len(names) != len(calendar_save.holidays):
        raise DayNamedTwice("a day is named twice; name each holiday once")
    studio.time_zone = calendar_save.time_zone
    for holiday in holidays_of(session, {studio_id}):
        if holiday.day in names:
            holiday.name = names.pop(holiday.day)
        else:
            session.delete(holiday)
    session.add_all(Holiday(studio_id=studio_id, day=day, name=name) for day, name in names.items())
    session.flush()
    return calendar_of(session, studio_id)


def calendar_of(session: Session, studio_id: UUID) -> CalendarRead:
    """Return a studio's calendar, without a check of the caller."""
    return CalendarRead(
        time_zone=session.get_one(Studio, studio_id).time_zone,
        holidays=[HolidayRead.model_validate(holiday) for holiday in holidays_of(session, {studio_id})],
    )


def holidays_of(session: Session, studio_ids: Collection[UUID]) -> Sequence[Holiday]:
    """Return the holidays of studios, in order."""
    return queries.holidays_of(session, studio_ids)


def time_zones_of(session: Session, studio_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the time zone of each studio."""
    return queries.time_zones_of(session, studio_ids)
