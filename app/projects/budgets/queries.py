"""Budgets of a project."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select, true
from sqlalchemy.orm import Session

from app.projects.models import Budget


def latest_budget_currency(session: Session, studio_id: UUID, project_id: UUID | None = None) -> str | None:
    """Return the currency of the budget that was set last on a project, or on any project of a studio."""
    of_project = Budget.project_id == project_id if project_id else true()
    currencies = select(Budget.currency).where(Budget.studio_id == studio_id, of_project)
    return session.scalar(currencies.order_by(Budget.set_at.desc()).limit(1))


def budgets_of(session: Session, project_id: UUID) -> Sequence[Budget]:
    """Return the budgets of a project by currency, without a check of the caller."""
    return session.scalars(select(Budget).where(Budget.project_id == project_id).order_by(Budget.currency)).all()
