"""Queries for passkeys."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import delete, select, update
from sqlalchemy.orm import Session

from app.accounts.models import Passkey
from app.core import clock


def passkeys_of(session: Session, person_id: UUID) -> Sequence[Passkey]:
    """Return a person's passkeys, the oldest first."""
    return session.scalars(select(Passkey).where(Passkey.person_id == person_id).order_by(Passkey.id)).all()


def passkey_by_credential(session: Session, credential_id: bytes) -> Passkey | None:
    """Return the passkey that a browser names."""
    return session.scalar(select(Passkey).where(Passkey.credential_id == credential_id))


def record_passkey_use(session: Session, passkey_id: UUID, *, sign_count: int, challenge_made_at_us: int) -> bool:
    """Keep a passkey's use, and whether its challenge is newer than the last one used: none counts twice."""
    used = (
        update(Passkey)
        .where(Passkey.id == passkey_id, Passkey.challenge_made_at_us < challenge_made_at_us)
        .values(sign_count=sign_count, challenge_made_at_us=challenge_made_at_us, last_used_at=clock.now())
        .returning(Passkey.id)
    )
    return session.scalar(used) is not None


def drop_passkeys(session: Session, person_id: UUID) -> None:
    """Delete every passkey of a person."""
    session.execute(delete(Passkey).where(Passkey.person_id == person_id))
