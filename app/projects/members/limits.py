"""Members of a studio that shows them their own projects only: every statement of theirs leaves out the others.

This is the first lock, on both databases; the row policies of PostgreSQL are the second.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

from sqlalchemy import ColumnElement, Uuid, bindparam, event, or_, select, true
from sqlalchemy.orm import LoaderCriteriaOption, ORMExecuteState, Session, with_loader_criteria

from app.core.db import Base, scope_in_force
from app.projects.models import Engagement, ProjectMember

PERSON, STUDIOS = "limited_person_id", "limited_studio_ids"  # parameters of the statements


@event.listens_for(Session, "do_orm_execute")
def _leave_out_closed_projects(state: ORMExecuteState) -> None:
    reach = scope_in_force(state.session)
    is_query = state.is_select or state.is_update or state.is_delete
    if reach is None or not reach.limited_studio_ids or not is_query or state.is_column_load:
        return
    state.statement = state.statement.options(_open_projects_only())
    parameters = state.parameters or {}
    limits = {PERSON: reach.person_id, STUDIOS: list(reach.limited_studio_ids)}
    if isinstance(parameters, Mapping):
        state.parameters = {**parameters, **limits}
    else:
        state.parameters = [{**row, **limits} for row in parameters]


@cache
def _open_projects_only() -> LoaderCriteriaOption:
    members, engagements = ProjectMember.__table__.c, Engagement.__table__.c  # not the models, which are limited too
    person_id = bindparam(PERSON, type_=Uuid())
    joined = select(members.project_id).where(members.person_id == person_id)
    engaged = select(engagements.project_id).where(engagements.designer_id == person_id, engagements.ended_at.is_(None))
    seen, limited = joined.union_all(engaged), bindparam(STUDIOS, expanding=True, type_=Uuid())

    def is_open(model: Any) -> ColumnElement[bool]:
        table = getattr(model, "__table__", None)  # None: of the base itself, which is asked first
        if table is not None and table.name == "projects_projects":
            return or_(model.studio_id.not_in(limited), model.id.in_(seen))
        if table is None or "project_id" not in table.c:
            return true()
        is_of_studio = (model.project_id.is_(None),) if table.c.project_id.nullable else ()
        return or_(model.studio_id.not_in(limited), model.project_id.in_(seen), *is_of_studio)

    return with_loader_criteria(
        Base, is_open, include_aliases=True, propagate_to_loaders=False, track_closure_variables=False
    )
