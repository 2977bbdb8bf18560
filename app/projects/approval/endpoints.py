"""The endpoints of who may approve: approvers of categories, and deputies."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects import overviews, schemas
from app.projects.approval import service as approval
from app.projects.endpoints import project_read
from app.projects.errors import (
    BadDeputy,
    CannotApprove,
    DeputyNotFound,
    ProducerNeeded,
    ProjectNotFound,
    TeamNeeded,
)
from app.projects.models import Deputy

router = APIRouter(prefix="/v1", tags=["projects"])


@router.put(
    "/projects/{project_id}/category-approvers",
    responses=problems(ProjectNotFound, ProducerNeeded, CannotApprove),
)
def name_category_approver(
    project_id: UUID,
    body: schemas.CategoryApproverName,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> schemas.ProjectRead:
    """Give a category of the sound list an approver of its own, or give it back to the project's approver."""
    approval.name_category_approver(session, actor, project_id, category=body.category, person_id=body.person_id)
    return project_read(overviews.overview(session, actor, project_id))


@router.get("/projects/{project_id}/deputies", responses=problems(ProjectNotFound, TeamNeeded))
def list_deputies(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> schemas.DeputiesRead:
    """Return the deputies with their approvers, today and on later days."""
    time_zone, deputies = approval.deputies_named(session, actor, project_id)
    return schemas.DeputiesRead(
        time_zone=time_zone,
        today=approval.today_in(time_zone),
        deputies=[schemas.DeputyRead.model_validate(deputy) for deputy in deputies],
    )


@router.post(
    "/projects/{project_id}/deputies",
    status_code=201,
    response_model=schemas.DeputyRead,
    responses=problems(ProjectNotFound, ProducerNeeded, CannotApprove, BadDeputy),
)
def name_deputy(
    project_id: UUID, body: schemas.DeputyAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Deputy:
    """Let a member of the studio approve in place of another, from one day to another."""
    return approval.name_deputy(
        session,
        actor,
        project_id,
        person_id=body.person_id,
        deputy_id=body.deputy_id,
        from_on=body.from_on,
        until_on=body.until_on,
    )


@router.delete(
    "/projects/{project_id}/deputies/{deputy_id}",
    status_code=204,
    responses=problems(ProjectNotFound, ProducerNeeded, DeputyNotFound),
)
def withdraw_deputy(
    project_id: UUID, deputy_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """End the right of a deputy at once."""
    approval.withdraw_deputy(session, actor, project_id, deputy_id)
