"""The endpoint of budgets; how much of them is used is read with the pace of a project."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.budgets.schemas import BudgetRead, BudgetSet
from app.projects.budgets.service import set_budget
from app.projects.errors import ProducerNeeded, ProjectNotFound

router = APIRouter(prefix="/v1", tags=["projects"])


@router.put("/projects/{project_id}/budget", responses=problems(ProjectNotFound, ProducerNeeded))
def set_project_budget(
    project_id: UUID, body: BudgetSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> list[BudgetRead]:
    """Set the project's budget in one currency, or remove it; return the budgets of all its currencies."""
    budgets = set_budget(session, actor, project_id, currency=body.currency, amount_minor=body.amount_minor)
    return [BudgetRead.model_validate(budget) for budget in budgets]
