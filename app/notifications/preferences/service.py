"""The mails that each person wants: saved on their page, and by the link that every such mail ends with."""

import base64
import hmac
from dataclasses import dataclass
from datetime import datetime, timedelta
from uuid import UUID
from zoneinfo import available_timezones

from sqlalchemy.orm import Session

from app.accounts.errors import TimeZoneUnknown
from app.accounts.models import Person
from app.accounts.rules import Actor
from app.core import clock
from app.core.access_scope import AccessScope
from app.core.db import set_access_scope
from app.core.server_keys import derived
from app.notifications import queries
from app.notifications.errors import ContractMailNeeded, MailLinkNotFound, QuietHoursUnclear
from app.notifications.models import Mail, MailPreferences
from app.notifications.preferences.rules import ALWAYS_MAILED, Cadence, News, Preferences, send_after
from app.notifications.schemas import MailPreferencesSave

EVERYTHING = ""  # the link of a digest is about all news that may be turned off
MAC_BYTES = 16
ID_BYTES = 16


@dataclass(frozen=True)
class MailChoice:
    """The choice that a mail's link may change: one kind of news, or None for all that may be turned off."""

    person: Person
    news: News | None

    @property
    def kinds(self) -> tuple[News, ...]:
        """Return the kinds of news that the link is about."""
        return (self.news,) if self.news else tuple(news for news in News if news not in ALWAYS_MAILED)


def read(session: Session, person_id: UUID) -> Preferences:
    """Return a person's wishes; those of who has said nothing, where nothing was saved."""
    saved = queries.preferences_of(session, person_id)
    if saved is None:
        return Preferences()
    return Preferences(
        {News(news): Cadence(cadence) for news, cadence in saved.cadences.items()},
        saved.time_zone,
        saved.daily_at,
        saved.quiet_from,
        saved.quiet_until,
    )


def save(session: Session, actor: Actor, preferences_save: MailPreferencesSave) -> Preferences:
    """Replace the caller's wishes; mails that wait are sent by the new ones."""
    if preferences_save.time_zone not in available_timezones():
        raise TimeZoneUnknown(
            f'there is no time zone "{preferences_save.time_zone}"',
            fix="give a name of the IANA list, such as Europe/Berlin",
        )
    if (preferences_save.quiet_from is None) != (preferences_save.quiet_until is None):
        raise QuietHoursUnclear("quiet hours have a begin or an end alone", fix="give both, or neither")
    if preferences_save.quiet_from is not None and preferences_save.quiet_from == preferences_save.quiet_until:
        raise QuietHoursUnclear("quiet hours begin and end at the same time", fix="give different times, or neither")
    for news in ALWAYS_MAILED:
        _ensure_mailed(news, preferences_save.cadences.get(news, Cadence.AT_ONCE))
    wishes = Preferences(
        preferences_save.cadences,
        preferences_save.time_zone,
        preferences_save.daily_at,
        preferences_save.quiet_from,
        preferences_save.quiet_until,
    )
    _keep(session, actor.person, wishes)
    return wishes


def timing(session: Session, recipient: str, news: News, delay: timedelta) -> tuple[Cadence, datetime]:
    """Return the cadence that an address's reader wants for a kind of news, and the send time of mail begun now."""
    person_id = queries.person_id_at(session, recipient)
    wishes = read(session, person_id) if person_id else Preferences()
    cadence = wishes.cadence(news)
    return cadence, send_after(wishes, cadence, clock.now(), delay)


def link_token(secret_key: str, person_id: UUID, news: News | None) -> str:
    """Return the token for a person and a kind of news in a mail's link; no one else can make one."""
    facts = person_id.bytes + (news or EVERYTHING).encode()
    return base64.urlsafe_b64encode(_mac(secret_key, facts) + facts).rstrip(b"=").decode()


def token_for(session: Session, secret_key: str, mail: Mail) -> str | None:
    """Return the token of the link that a mail of news ends with; None for other mails, and for who has no account."""
    if mail.news is None or (person_id := queries.person_id_at(session, mail.recipient)) is None:
        return None
    return link_token(secret_key, person_id, News(mail.news) if mail.news else None)


def by_link(session: Session, secret_key: str, token: str) -> MailChoice:
    """Return the choice of a mail's link, and let the session see that person's rows; raise MailLinkNotFound."""
    unknown = MailLinkNotFound(
        "this link is not whole", fix="open it from the email again, or sign in and open Account"
    )
    try:
        content = base64.urlsafe_b64decode(token + "=" * (-len(token) % 4))
        mac, facts = content[:MAC_BYTES], content[MAC_BYTES:]
        if not hmac.compare_digest(mac, _mac(secret_key, facts)):
            raise unknown
        news = facts[ID_BYTES:].decode()
        person = session.get(Person, UUID(bytes=facts[:ID_BYTES]))
        choice = MailChoice(person, News(news) if news else None) if person else None
    except ValueError:
        raise unknown from None
    if choice is None:
        raise unknown
    set_access_scope(session, AccessScope(person_id=choice.person.id))
    return choice


def change_by_link(session: Session, choice: MailChoice, cadence: Cadence) -> Preferences:
    """Set the mail frequency of the news of a link."""
    for news in choice.kinds:
        _ensure_mailed(news, cadence)
    before = read(session, choice.person.id)
    cadences = {**before.cadences, **dict.fromkeys(choice.kinds, cadence)}
    wishes = Preferences(cadences, before.time_zone, before.daily_at, before.quiet_from, before.quiet_until)
    _keep(session, choice.person.id, wishes)
    return wishes


def drop_unwanted(session: Session, mail: Mail) -> bool:
    """Delete a mail of news that its reader has turned off since it was begun; whether it was one."""
    if not mail.news:
        return False
    person_id = queries.person_id_at(session, mail.recipient)
    if person_id is None or read(session, person_id).cadence(News(mail.news)) is not Cadence.NEVER:
        return False
    session.delete(mail)
    return True


def _ensure_mailed(news: News, cadence: Cadence) -> None:
    if news in ALWAYS_MAILED and cadence is Cadence.NEVER:
        raise ContractMailNeeded(
            "mails about contracts and payments can't be turned off: they name days to keep", fix="choose daily"
        )


def _keep(session: Session, person_id: UUID, wishes: Preferences) -> None:
    saved = queries.preferences_of(session, person_id) or MailPreferences(person_id=person_id)
    saved.cadences = {str(news): str(cadence) for news, cadence in wishes.cadences.items()}
    saved.time_zone, saved.daily_at = wishes.time_zone, wishes.daily_at
    saved.quiet_from, saved.quiet_until = wishes.quiet_from, wishes.quiet_until
    session.add(saved)
    session.flush()


def _mac(secret_key: str, facts: bytes) -> bytes:
    return hmac.digest(derived(secret_key, "mail-preferences", 32), facts, "sha256")[:MAC_BYTES]
