"""Queries for second factors and recovery codes."""

from uuid import UUID

from sqlalchemy import ColumnElement, SQLColumnExpression, delete, exists, func, literal, select, update
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Passkey, RecoveryCode, Studio, TotpFactor
from app.accounts.rules import SecondFactorUse
from app.core import clock


def second_factor_exists(person_id: SQLColumnExpression[UUID]) -> ColumnElement[bool]:
    """Return the condition that a person's sign-in asks for more than a password."""
    has_totp = exists().where(TotpFactor.person_id == person_id, TotpFactor.confirmed_at.is_not(None))
    return has_totp | exists().where(Passkey.person_id == person_id)


def has_second_factor(session: Session, person_id: UUID) -> bool:
    """Whether a person's sign-in asks for more than a password."""
    return bool(session.scalar(select(second_factor_exists(literal(person_id)))))


def studios_waiting_for_factor(session: Session, person_id: UUID, *, except_studio_id: UUID | None) -> list[str]:
    """Return the names of a person's studios that stay shut until the person has set up a second factor.

    The excepted studio's own provider says that one was used.
    """
    if has_second_factor(session, person_id):
        return []
    rows = session.execute(
        select(Studio.id, Studio.name, Studio.second_factor_for)
        .join(Membership, Membership.studio_id == Studio.id)
        .where(Membership.person_id == person_id)
        .order_by(Studio.name)
    )
    return [name for id_, name, uses in rows if SecondFactorUse.EVERYTHING in uses and id_ != except_studio_id]


def totp_factor(session: Session, person_id: UUID) -> TotpFactor | None:
    """Return a person's authenticator app, set up or begun."""
    return session.get(TotpFactor, person_id)


def advance_totp(session: Session, person_id: UUID, step: int) -> bool:
    """Keep the time step of a used code, and whether this use is its first: of two at once, one is."""
    advanced = (
        update(TotpFactor)
        .where(TotpFactor.person_id == person_id, TotpFactor.last_step < step)
        .values(last_step=step)
        .returning(TotpFactor.person_id)
    )
    return session.scalar(advanced) is not None


def use_recovery_code(session: Session, person_id: UUID, code_sha256: str) -> bool:
    """Mark a recovery code as used, and whether it was unused before."""
    used = (
        update(RecoveryCode)
        .where(
            RecoveryCode.person_id == person_id,
            RecoveryCode.code_sha256 == code_sha256,
            RecoveryCode.used_at.is_(None),
        )
        .values(used_at=clock.now())
        .returning(RecoveryCode.id)
    )
    return session.scalar(used) is not None


def recovery_codes_left(session: Session, person_id: UUID) -> int:
    """Return the number of a person's unused recovery codes."""
    unused = select(func.count()).where(RecoveryCode.person_id == person_id, RecoveryCode.used_at.is_(None))
    return session.scalar(unused) or 0


def drop_totp(session: Session, person_id: UUID) -> None:
    """Delete a person's authenticator app."""
    session.execute(delete(TotpFactor).where(TotpFactor.person_id == person_id))


def drop_recovery_codes(session: Session, person_id: UUID) -> None:
    """Delete a person's recovery codes."""
    session.execute(delete(RecoveryCode).where(RecoveryCode.person_id == person_id))
