"""Saved views: filters of the list that each person keeps, and of the review queue that a team shares."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.errors import FieldProblem
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access
from app.shares import queries
from app.shares.errors import SavedViewInvalid, SavedViewNotFound
from app.shares.models import SavedView
from app.shares.rules import MAX_VIEWS, ViewedPage
from app.shares.view_schemas import SavedViewAdd


def views_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[SavedView]:
    """Return the caller's views of a project by name, and those of the review queue that its team shares."""
    access = project_access(session, actor, project_id)
    return queries.views_of(session, project_id, actor.person, with_shared=access.is_team)


def save_view(session: Session, actor: Actor, project_id: UUID, body: SavedViewAdd) -> SavedView:
    """Keep a filter; one of the same name is replaced, of the review queue by anyone of the team."""
    access = project_access(session, actor, project_id)
    if body.page is ViewedPage.REVIEW_QUEUE:
        access.ensure_team()
    all_seen = queries.views_of(session, project_id, actor.person, with_shared=access.is_team)
    views = [view for view in all_seen if view.page is body.page]
    for view in views:
        if (view.page, view.name) == (body.page, body.name):
            view.query = body.query
            session.flush()
            return view
    if len(views) >= MAX_VIEWS:
        message = f"this page has {len(views)} views in this project, as many as there may be; delete one first"
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
    """Delete a view of the caller's own, or one that the team shares."""
    view = queries.view_by_id(session, view_id)
    if view is None:
        raise SavedViewNotFound(f"no view {view_id}")
    is_shared = view.page is ViewedPage.REVIEW_QUEUE and bool(actor.roles_in(view.studio_id))
    if view.person_id != actor.person and not is_shared:
        raise SavedViewNotFound(f"no view {view_id}")
    try:
        project_access(session, actor, view.project_id)
    except ProjectNotFound:
        raise SavedViewNotFound(f"no view {view_id}") from None
    session.delete(view)
    session.flush()
