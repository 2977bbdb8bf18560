"""Saved views: filters of the list that each person keeps under names of their own."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.kit.errors import FieldProblem
from app.projects.service import project_access
from app.shares import queries
from app.shares.errors import SavedViewInvalid, SavedViewNotFound
from app.shares.models import SavedView
from app.shares.rules import MAX_VIEWS
from app.shares.view_schemas import SavedViewAdd


def views_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[SavedView]:
    """Return the caller's views of a project by name."""
    project_access(session, actor, project_id)
    return queries.views_of(session, project_id, actor.person)


def save_view(session: Session, actor: Actor, project_id: UUID, body: SavedViewAdd) -> SavedView:
    """Keep a filter; one of the same name is replaced."""
    access = project_access(session, actor, project_id)
    views = queries.views_of(session, project_id, actor.person)
    for view in views:
        if (view.page, view.name) == (body.page, body.name):
            view.query = body.query
            session.flush()
            return view
    if len(views) >= MAX_VIEWS:
        message = f"you have {len(views)} views in this project, as many as there may be; delete one first"
        raise SavedViewInvalid(message, errors=[FieldProblem(where="name", message=message)])
    view = SavedView(
        studio_id=access.project.studio_id,
        project_id=project_id,
        person_id=actor.person,
        page=body.page,
        name=body.name,
        query=body.query,
    )
    session.add(view)
    session.flush()
    return view


def delete_view(session: Session, actor: Actor, view_id: UUID) -> None:
    """Delete a view of the caller's own."""
    view = queries.view_by_id(session, view_id)
    if view is None or view.person_id != actor.person:
        raise SavedViewNotFound(f"no view {view_id}")
    project_access(session, actor, view.project_id)
    session.delete(view)
    session.flush()
