"""Queries of the security log."""

from collections.abc import Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import delete, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership
from app.accounts.security_log.models import SecurityEvent
from app.accounts.security_log.rules import SecurityEventKind


def studios_of(session: Session, person_id: UUID) -> Sequence[UUID]:
    """Return the studios that a person belongs to."""
    return session.scalars(select(Membership.studio_id).where(Membership.person_id == person_id)).all()


def events(
    session: Session, studio_id: UUID, *, kind: SecurityEventKind | None, before: UUID | None, limit: int
) -> Sequence[SecurityEvent]:
    """Return lines of a studio's log, newest first."""
    query = select(SecurityEvent).where(SecurityEvent.studio_id == studio_id)
    if kind is not None:
        query = query.where(SecurityEvent.kind == kind)
    if before is not None:
        query = query.where(SecurityEvent.id < before)
    loaded = query.options(joinedload(SecurityEvent.person), joinedload(SecurityEvent.about))
    return session.scalars(loaded.order_by(SecurityEvent.id.desc()).limit(limit)).all()


def delete_before(session: Session, at: datetime) -> None:
    """Delete lines that are older than the log goes back."""
    session.execute(delete(SecurityEvent).where(SecurityEvent.at < at))
