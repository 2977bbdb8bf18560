"""The endpoints of a project's credits."""

from uuid import UUID

from fastapi import APIRouter, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession, problems
from app.dashboards.credits import rules as credit_rules
from app.dashboards.credits import service as credit_list
from app.dashboards.credits.schemas import ProjectCreditsRead
from app.projects.credits import service as credit_names
from app.projects.errors import (
    CreditLineNotFound,
    ProducerNeeded,
    ProjectNotFound,
    TeamNeeded,
    TooManyCredits,
)
from app.projects.schemas import CreditLineAdd, CreditNameSave

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/projects/{project_id}/credits", responses=problems(ProjectNotFound))
def read_credits(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> ProjectCreditsRead:
    """Return the contributors to a project by role; a designer sees their own name alone."""
    return ProjectCreditsRead.model_validate(credit_list.project_credits(session, actor, project_id))


@router.put("/projects/{project_id}/credits/me", responses=problems(ProjectNotFound))
def save_my_credit(
    project_id: UUID, body: CreditNameSave, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> ProjectCreditsRead:
    """State the caller's name in a project's credits, or their omission."""
    credit_names.save_credit_name(session, actor, project_id, name=body.name, is_left_out=body.is_left_out)
    return ProjectCreditsRead.model_validate(credit_list.project_credits(session, actor, project_id))


@router.post(
    "/projects/{project_id}/credits",
    status_code=201,
    responses=problems(ProjectNotFound, ProducerNeeded, TooManyCredits),
)
def add_credit(
    project_id: UUID, body: CreditLineAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> ProjectCreditsRead:
    """Add a name by hand: of a performer, for instance."""
    credit_names.add_credit_line(session, actor, project_id, role=body.role, name=body.name)
    return ProjectCreditsRead.model_validate(credit_list.project_credits(session, actor, project_id))


@router.delete(
    "/credit-lines/{credit_line_id}", status_code=204, responses=problems(CreditLineNotFound, ProducerNeeded)
)
def remove_credit(credit_line_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> None:
    """Remove a name that was added by hand."""
    credit_names.remove_credit_line(session, actor, credit_line_id)


@router.get(
    "/projects/{project_id}/credits.csv",
    **downloads("text/csv", ProjectNotFound, TeamNeeded),
)
def read_credits_csv(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> Response:
    """Return the credits of a project as CSV."""
    listed = credit_list.credits_to_export(session, actor, project_id)
    return file_response(credit_rules.csv_of(listed), "text/csv; charset=utf-8", "credits.csv")


@router.get(
    "/projects/{project_id}/credits.txt",
    **downloads("text/plain", ProjectNotFound, TeamNeeded),
)
def read_credits_text(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> Response:
    """Return the credits of a project as text."""
    listed = credit_list.credits_to_export(session, actor, project_id)
    return file_response(credit_rules.text_of(listed), "text/plain; charset=utf-8", "credits.txt")
