"""Decisions, read from the database."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session, joinedload

from app.briefs.models import Decision


def decisions_of(session: Session, project_id: UUID) -> Sequence[Decision]:
    """Return the decisions of a project, in order of their days."""
    of_project = select(Decision).where(Decision.project_id == project_id).options(joinedload(Decision.author))
    return session.scalars(of_project.order_by(Decision.decided_on, Decision.id)).all()


def decision_locked(session: Session, decision_id: UUID) -> Decision | None:
    """Return a decision with its author, locked until this transaction ends."""
    decision = select(Decision).where(Decision.id == decision_id).options(joinedload(Decision.author))
    return session.scalar(decision.with_for_update(of=Decision))
