"""The endpoints of columns of the project's own."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.errors import ColumnsChanged, ColumnsInvalid
from app.sound_lists.own_columns.rules import Column
from app.sound_lists.own_columns.schemas import ColumnRead, ColumnsRead, ColumnsSet
from app.sound_lists.own_columns.service import edition_of, set_columns

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/projects/{project_id}/sound-list/columns", responses=problems(ProjectNotFound))
def list_columns(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> ColumnsRead:
    """Return the columns of the project's own, in order."""
    project_access(session, actor, project_id)
    return _read(queries.own_columns(session, project_id))


@router.put(
    "/projects/{project_id}/sound-list/columns",
    responses=problems(ProjectNotFound, TeamNeeded, ColumnsChanged, ColumnsInvalid),
)
def replace_columns(
    project_id: UUID, body: ColumnsSet, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> ColumnsRead:
    """Set all columns of the project's own; one that is left out is removed, and its values stay with the cues."""
    wanted = [Column(column.id, column.name, column.kind, column.choices) for column in body.columns]
    return _read(set_columns(session, actor, project_id, body.edition, wanted))


def _read(columns: Sequence[Column]) -> ColumnsRead:
    return ColumnsRead(columns=[ColumnRead.model_validate(column) for column in columns], edition=edition_of(columns))
