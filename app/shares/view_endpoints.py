"""The endpoints of saved views."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound
from app.shares import views
from app.shares.errors import SavedViewInvalid, SavedViewNotFound
from app.shares.models import SavedView
from app.shares.view_schemas import SavedViewAdd, SavedViewRead

router = APIRouter(prefix="/v1", tags=["saved-views"])
PROJECT: Actor = allows(Audience.PROJECT)


@router.get(
    "/projects/{project_id}/saved-views", response_model=list[SavedViewRead], responses=problems(ProjectNotFound)
)
def list_saved_views(project_id: UUID, session: DbSession, actor: Actor = PROJECT) -> Sequence[SavedView]:
    """Return the filters that the caller kept in a project, by name."""
    return views.views_of(session, actor, project_id)


@router.post(
    "/projects/{project_id}/saved-views",
    status_code=201,
    response_model=SavedViewRead,
    responses=problems(ProjectNotFound, SavedViewInvalid),
)
def save_view(project_id: UUID, body: SavedViewAdd, session: DbSession, actor: Actor = PROJECT) -> SavedView:
    """Keep a filter under a name; one of the same name is replaced."""
    return views.save_view(session, actor, project_id, body)


@router.delete("/saved-views/{saved_view_id}", status_code=204, responses=problems(SavedViewNotFound, ProjectNotFound))
def delete_saved_view(saved_view_id: UUID, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Delete a view of the caller's own."""
    views.delete_view(session, actor, saved_view_id)
