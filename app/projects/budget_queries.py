"""Budgets of a project."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.projects.models import Budget


def budgets_of(session: Session, project_id: UUID) -> Sequence[Budget]:
    """Return the budgets of a project by currency, without a check of the caller."""
    return session.scalars(select(Budget).where(Budget.project_id == project_id).order_by(Budget.currency)).all()
