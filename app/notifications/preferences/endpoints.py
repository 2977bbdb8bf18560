"""A person's choice of mails: their own page, and the link that every such mail ends with."""

from fastapi import APIRouter
from sqlalchemy.orm import Session

from app.accounts.errors import TimeZoneUnknown
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.runtime import Runtime
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.notifications.errors import ContractMailNeeded, MailLinkNotFound, QuietHoursUnclear
from app.notifications.preferences import service as preferences
from app.notifications.preferences.rules import ALWAYS_MAILED, Cadence, News, Preferences
from app.notifications.preferences.service import MailChoice
from app.notifications.schemas import MailChoiceRead, MailChoiceSave, MailPreferencesRead, MailPreferencesSave

router = APIRouter(prefix="/v1", tags=["notifications"])


def _read(wishes: Preferences) -> MailPreferencesRead:
    return MailPreferencesRead(
        cadences={news: wishes.cadence(news) for news in News},
        time_zone=wishes.time_zone,
        daily_at=wishes.daily_at,
        quiet_from=wishes.quiet_from,
        quiet_until=wishes.quiet_until,
    )


@router.get("/me/mail-preferences")
def read_my_mail_preferences(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> MailPreferencesRead:
    """Return the mails that the caller gets, and their times."""
    return _read(preferences.read(session, actor.person))


@router.put("/me/mail-preferences", responses=problems(TimeZoneUnknown, QuietHoursUnclear, ContractMailNeeded))
def save_my_mail_preferences(
    body: MailPreferencesSave, session: DbSession, actor: Actor = allows(Audience.PERSON)
) -> MailPreferencesRead:
    """Save the mails that the caller gets, and their times."""
    return _read(preferences.save(session, actor, body))


def _choice(secret: str, session: Session, runtime: Runtime) -> MailChoice:
    return preferences.by_link(session, runtime.settings.secret_key.get_secret_value(), secret)


def _read_choice(choice: MailChoice, wishes: Preferences) -> MailChoiceRead:
    cadences = {wishes.cadence(news) for news in choice.kinds}
    return MailChoiceRead(
        email=choice.person.email,
        news=list(choice.kinds),
        cadence=cadences.pop() if len(cadences) == 1 else None,
        can_stop=ALWAYS_MAILED.isdisjoint(choice.kinds),
    )


@router.get("/mail-choices/{secret}", responses=problems(MailLinkNotFound))
def read_mail_choice(
    secret: str, session: DbSession, runtime: CurrentRuntime, _actor: Actor = allows(Audience.ANYONE)
) -> MailChoiceRead:
    """Return the choice changed by the link at the end of a mail; it changes nothing by being opened."""
    choice = _choice(secret, session, runtime)
    return _read_choice(choice, preferences.read(session, choice.person.id))


@router.put("/mail-choices/{secret}", responses=problems(MailLinkNotFound, ContractMailNeeded))
def save_mail_choice(
    secret: str,
    body: MailChoiceSave,
    session: DbSession,
    runtime: CurrentRuntime,
    _actor: Actor = allows(Audience.ANYONE),
) -> MailChoiceRead:
    """Set the mail frequency of the news of a mail's link, without signing in."""
    choice = _choice(secret, session, runtime)
    return _read_choice(choice, preferences.change_by_link(session, choice, body.cadence))


@router.post(
    "/mail-choices/{secret}/stop",
    status_code=204,
    responses=problems(MailLinkNotFound, ContractMailNeeded),
)
def stop_mails(
    secret: str, session: DbSession, runtime: CurrentRuntime, _actor: Actor = allows(Audience.ANYONE)
) -> None:
    """Stop mails like one, as a mail program's own button asks for it (RFC 8058)."""
    preferences.change_by_link(session, _choice(secret, session, runtime), Cadence.NEVER)
