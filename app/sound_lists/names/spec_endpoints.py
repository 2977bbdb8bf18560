"""The endpoints that save a delivery spec, and say which file names of the list it refuses."""

from typing import Annotated, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Request
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.http import DbSession, problems
from app.projects import service
from app.projects.errors import BadSpec, ProjectNotFound, SpecChanged, TeamNeeded
from app.projects.schemas import SpecChange, SpecFormChange
from app.projects.specs import service as specs
from app.projects.specs.endpoints import ensure_readable, spec_read
from app.sound_lists.names import service as naming
from app.sound_lists.schemas import SpecSaved

router = APIRouter(prefix="/v1", tags=["projects"])
SentForm: TypeAlias = tuple[SpecFormChange, str]  # with the text that it comes to


async def _readable_text(request: Request, project_id: UUID, body: SpecChange) -> SpecChange:
    await ensure_readable(request, project_id, body.toml, saves=True)
    return body


async def _readable_form(request: Request, project_id: UUID, body: SpecFormChange) -> SentForm:
    toml = await run_in_threadpool(specs.toml_of_form, body.tables)
    await ensure_readable(request, project_id, toml, saves=True)
    return body, toml


@router.put(
    "/projects/{project_id}/spec",
    responses=problems(ProjectNotFound, TeamNeeded, SpecChanged, BadSpec, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def save_spec(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.TEAM)],
    body: Annotated[SpecChange, Depends(_readable_text)],
    session: DbSession,
) -> SpecSaved:
    """Save the spec from its text, and return the file names of the list that it refuses; takes are checked again."""
    return _saved(session, actor, project_id, body.toml, body)


@router.post(
    "/projects/{project_id}/spec/form",
    responses=problems(ProjectNotFound, TeamNeeded, SpecChanged, BadSpec, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def save_spec_form(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.TEAM)],
    sent: Annotated[SentForm, Depends(_readable_form)],
    session: DbSession,
) -> SpecSaved:
    """Save the spec from a form's tables, and return the names that it refuses; takes are checked again."""
    body, toml = sent
    return _saved(session, actor, project_id, toml, body)


def _saved(session: Session, actor: Actor, project_id: UUID, toml: str, body: SpecChange | SpecFormChange) -> SpecSaved:
    spec = service.save_spec(
        session, actor, project_id, toml=toml, note=body.note, based_on_version=body.based_on_version
    )
    project = service.project_access(session, actor, project_id).project
    refused = naming.refusals_of_list(session, project, specs.read_spec(spec.toml))
    return SpecSaved.model_validate(spec_read(spec).model_dump() | {"refused_names": refused})
