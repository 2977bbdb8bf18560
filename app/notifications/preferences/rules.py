"""The times of mails to a person by news, stated without a database."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime, time, timedelta
from enum import StrEnum
from zoneinfo import ZoneInfo


class News(StrEnum):
    """A subject of mails; a person says for each how often it is mailed."""

    SOUNDS = "sounds"  # to review, returned, approved, changes requested
    TALK = "talk"  # questions, answers, replies
    MENTIONS = "mentions"  # comments and change requests that name the person
    LIST = "list"  # the sound list changed, a person joined, a build was refused
    CONTRACTS = "contracts"  # signatures, change orders, invoices
    HIRING = "hiring"  # postings and bids


class Cadence(StrEnum):
    """The mail frequency of news."""

    AT_ONCE = "at_once"
    HOURLY = "hourly"
    DAILY = "daily"
    NEVER = "never"


ALWAYS_MAILED = frozenset({News.CONTRACTS})  # at the rarest daily: money and signatures have days to keep


@dataclass(frozen=True)
class Preferences:
    """A person's wishes; these are the ones of who has said nothing."""

    cadences: Mapping[News, Cadence] = field(default_factory=dict)
    time_zone: str = "UTC"  # an IANA name
    daily_at: time = time(8)
    quiet_from: time | None = None
    quiet_until: time | None = None

    def cadence(self, news: News) -> Cadence:
        """Return the frequency that the person wants for news of a kind."""
        return self.cadences.get(news, Cadence.AT_ONCE)


def send_after(wishes: Preferences, cadence: Cadence, now: datetime, delay: timedelta) -> datetime:
    """Return the moment from which a mail begun now is to be sent: by its cadence, and outside quiet hours."""
    zone = ZoneInfo(wishes.time_zone)
    if cadence is Cadence.DAILY:
        return _next(wishes.daily_at, now, zone)
    if cadence is Cadence.HOURLY:
        local = now.astimezone(zone)
        moment = now + (timedelta(hours=1) - timedelta(minutes=local.minute, seconds=local.second))
    else:
        moment = now + delay
    if _is_quiet(wishes, moment.astimezone(zone).time()) and wishes.quiet_until is not None:
        return _next(wishes.quiet_until, moment, zone)
    return moment


def _is_quiet(wishes: Preferences, at: time) -> bool:
    first, end = wishes.quiet_from, wishes.quiet_until
    if first is None or end is None:
        return False
    return first <= at < end if first <= end else at >= first or at < end


def _next(at: time, now: datetime, zone: ZoneInfo) -> datetime:
    """Return the next moment at which clocks of a zone show a time; a time that a change of clocks skips is later."""
    local = now.astimezone(zone)
    for days in (0, 1):
        moment = datetime.combine(local.date() + timedelta(days=days), at, zone).astimezone(UTC)
        if moment > now:
            break
    return moment
