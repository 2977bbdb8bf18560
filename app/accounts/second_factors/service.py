"""Second factors of accounts: authenticator apps (TOTP) and recovery codes."""

from dataclasses import dataclass
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.authentication import sha256_of
from app.accounts.errors import (
    NoSecondFactor,
    NotInDemo,
    SecondFactorExists,
    SecondFactorNeeded,
    WrongSecondFactor,
)
from app.accounts.models import Person, RecoveryCode, TotpFactor
from app.accounts.passkeys import queries as passkey_queries
from app.accounts.rules import Actor
from app.accounts.second_factors import queries as second_factor_queries
from app.accounts.second_factors.rules import (
    accepted_step,
    is_recovery_code,
    new_recovery_codes,
    new_totp_secret,
    plain_code,
    provisioning_uri,
    qr_code_svg,
)
from app.core import clock
from app.core.db import Database
from app.core.events import publish
from app.core.server_keys import sealed, unsealed
from app.settings import Settings

KEY_PURPOSE = "second factors"


@dataclass(frozen=True)
class SecondFactors:
    """The second factors of a person."""

    totp_since: datetime | None
    recovery_codes_left: int


@dataclass(frozen=True)
class TotpSetup:
    """The secret of an authenticator app that is being set up, as text, address and picture."""

    secret: str
    uri: str
    qr_svg: str


def has_second_factor(database: Database, person_id: UUID) -> bool:
    """Whether a person's sign-in asks for more than a password."""
    with database.reading() as session:
        return second_factor_queries.has_second_factor(session, person_id)


def second_factors_of(session: Session, actor: Actor) -> SecondFactors:
    """Return the caller's second factors."""
    factor = second_factor_queries.totp_factor(session, actor.person)
    return SecondFactors(
        totp_since=factor.confirmed_at if factor else None,
        recovery_codes_left=second_factor_queries.recovery_codes_left(session, actor.person),
    )


def begin_totp(session: Session, actor: Actor, settings: Settings) -> TotpSetup:
    """Make the secret of an authenticator app; it counts once a code confirms it."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no second factor")
    factor = second_factor_queries.totp_factor(session, person.id)
    if factor is not None and factor.confirmed_at is not None:
        raise SecondFactorExists("an authenticator app is set up already", fix="remove it first to set up another one")
    second_factor_queries.drop_totp(session, person.id)
    secret = new_totp_secret()
    session.add(TotpFactor(person_id=person.id, sealed_secret=_sealed(settings, person.id, secret)))
    session.flush()
    uri = provisioning_uri(secret, person.email)
    return TotpSetup(secret, uri, qr_code_svg(uri))


def confirm_totp(
    session: Session, actor: Actor, settings: Settings, code: str, *, kept_secret: str | None
) -> list[str]:
    """Put an authenticator app to use by its first code, end other sign-ins, and return the recovery codes."""
    factor = second_factor_queries.totp_factor(session, actor.person)
    if factor is None:
        raise NoSecondFactor("no authenticator app is being set up", fix="begin with its QR code")
    if factor.confirmed_at is not None:
        raise SecondFactorExists("an authenticator app is set up already", fix="remove it first to set up another one")
    _use_totp_code(session, settings, factor, plain_code(code))
    factor.confirmed_at = clock.now()
    session.flush()
    # They began with a password alone.
    queries.end_sign_ins(session, actor.person, except_sha256=sha256_of(kept_secret) if kept_secret else None)
    publish_change(
        session, actor.person, "An authenticator app was set up for your account.", "set up an authenticator app"
    )
    return _renewed_recovery_codes(session, actor.person)


def end_totp(session: Session, actor: Actor) -> None:
    """Take the caller's authenticator app away, and the recovery codes with it."""
    factor = second_factor_queries.totp_factor(session, actor.person)
    if factor is None or factor.confirmed_at is None:
        raise NoSecondFactor("no authenticator app is set up")
    second_factor_queries.drop_totp(session, actor.person)
    drop_unneeded_codes(session, actor.person)
    publish_change(
        session, actor.person, "The authenticator app of your account was removed.", "removed the authenticator app"
    )


def renew_recovery_codes(session: Session, actor: Actor) -> list[str]:
    """Return new recovery codes; the earlier ones stop working."""
    if not second_factor_queries.has_second_factor(session, actor.person):
        raise NoSecondFactor("recovery codes belong to a second factor", fix="set up an app or a passkey first")
    publish_change(session, actor.person, "New recovery codes were made for your account.", "made new recovery codes")
    return _renewed_recovery_codes(session, actor.person)


def remove_all(session: Session, person_id: UUID) -> None:
    """Take every second factor of a person away, as when the devices were lost, and end every sign-in."""
    if not second_factor_queries.has_second_factor(session, person_id):
        raise NoSecondFactor("this account has no second factor")
    second_factor_queries.drop_totp(session, person_id)
    passkey_queries.drop_passkeys(session, person_id)
    drop_unneeded_codes(session, person_id)
    queries.end_sign_ins(session, person_id)
    change = "The operator of the server removed the second factor of your account."
    publish_change(session, person_id, change, "second factor removed by the operator of the server")


def ensure_code_given(code: str | None) -> str:
    """Return the code that came with a sign-in, or raise SecondFactorNeeded."""
    if code is None or not plain_code(code):
        raise SecondFactorNeeded(
            "this account asks for a second factor",
            fix="enter the code of your authenticator app, or a recovery code; a passkey signs in without it",
        )
    return code


def ensure_right_code(session: Session, settings: Settings, person_id: UUID, code: str) -> None:
    """Use a code once, or raise WrongSecondFactor."""
    plain = plain_code(code)
    if is_recovery_code(plain):
        if not second_factor_queries.use_recovery_code(session, person_id, sha256_of(plain)):
            raise _wrong("this recovery code is wrong or was used already", fix="enter another one")
        left = second_factor_queries.recovery_codes_left(session, person_id)
        change = f"A recovery code signed in to your account. Codes left: {left}."
        publish_change(session, person_id, change, f"used a recovery code; codes left: {left}")
        return
    factor = second_factor_queries.totp_factor(session, person_id)
    if factor is None or factor.confirmed_at is None:
        raise _wrong("this is not one of your recovery codes", fix="enter all 16 characters of one that is unused")
    _use_totp_code(session, settings, factor, plain)


def _use_totp_code(session: Session, settings: Settings, factor: TotpFactor, code: str) -> None:
    secret = _opened(settings, factor.person_id, factor.sealed_secret)
    step = accepted_step(secret, code, clock.now(), last_step=factor.last_step)
    if step is None or not second_factor_queries.advance_totp(session, factor.person_id, step):
        raise _wrong(
            "this code is wrong, too old or was used already",
            fix="enter the code that the app shows now; if it is refused again, check the clock of that device",
        )


def _wrong(message: str, fix: str) -> WrongSecondFactor:
    return WrongSecondFactor(message, fix=fix, errors=[{"where": "code", "message": f"{message}: {fix}"}])


def codes_for_first_factor(session: Session, person_id: UUID) -> list[str]:
    """Return recovery codes where a person sets up their first second factor; empty for a further one."""
    if second_factor_queries.has_second_factor(session, person_id):
        return []
    return _renewed_recovery_codes(session, person_id)


def _renewed_recovery_codes(session: Session, person_id: UUID) -> list[str]:
    second_factor_queries.drop_recovery_codes(session, person_id)
    codes = new_recovery_codes()
    session.add_all(RecoveryCode(person_id=person_id, code_sha256=sha256_of(plain_code(code))) for code in codes)
    session.flush()
    return codes


def drop_unneeded_codes(session: Session, person_id: UUID) -> None:
    """Delete a person's recovery codes where no second factor is left that they stand in for."""
    if not second_factor_queries.has_second_factor(session, person_id):
        second_factor_queries.drop_recovery_codes(session, person_id)


def publish_change(session: Session, person_id: UUID, change: str, summary: str) -> None:
    """Have a person told of a change to their second factors, and their studios' security logs by a summary of it."""
    publish(session, "second_factor.changed", studio_id=None, person_id=person_id, change=change, summary=summary)


def _sealed(settings: Settings, person_id: UUID, secret: str) -> bytes:
    """Encrypt a secret with a key that the database does not hold."""
    return sealed(settings.secret_key.get_secret_value(), KEY_PURPOSE, secret, context=person_id.bytes)


def _opened(settings: Settings, person_id: UUID, sealed_secret: bytes) -> str:
    return unsealed(settings.secret_key.get_secret_value(), KEY_PURPOSE, sealed_secret, context=person_id.bytes)
