"""The permitted cost of a project, by currency; set by producers and never seen by designers."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.projects.budgets.queries import budgets_of
from app.projects.models import Budget
from app.projects.queries import lock_project
from app.projects.service import project_access


def set_budget(
    session: Session, actor: Actor, project_id: UUID, *, currency: str, amount_minor: int | None
) -> Sequence[Budget]:
    """Set the budget of one currency, or remove it; return the budgets of the project.

    Raises ProducerNeeded for others of the team and for designers.
    """
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    lock_project(session, project_id)
    budget = session.get(Budget, (project_id, currency))
    if amount_minor is None:
        if budget is not None:
            session.delete(budget)
    elif budget is None:
        session.add(
            Budget(
                project_id=project_id,
                currency=currency,
                studio_id=access.project.studio_id,
                amount_minor=amount_minor,
                set_by=actor.person,
            )
        )
    else:
        budget.amount_minor, budget.set_by, budget.set_at = amount_minor, actor.person, clock.now()
    session.flush()
    return budgets_of(session, project_id)
