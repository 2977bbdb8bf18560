"""Names in credits, as people wrote them and as they were added by hand."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.projects.models import CreditLine, CreditName


def credit_names(session: Session, project_id: UUID) -> dict[UUID, CreditName]:
    """Return people's statements on their own name in a project, by person."""
    names = session.scalars(select(CreditName).where(CreditName.project_id == project_id))
    return {credit_name.person_id: credit_name for credit_name in names}


def credit_lines(session: Session, project_id: UUID) -> Sequence[CreditLine]:
    """Return the names that were added to a project's credits by hand, in order of adding."""
    return session.scalars(select(CreditLine).where(CreditLine.project_id == project_id).order_by(CreditLine.id)).all()


def credit_line(session: Session, line_id: UUID) -> CreditLine | None:
    """Return a name that was added by hand, without asking who looks."""
    return session.get(CreditLine, line_id)
