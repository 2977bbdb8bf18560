"""The endpoints of names that a list has and its delivery spec refuses."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Depends, Request

import audio_checks
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.http import DbSession, problems
from app.projects.errors import BadSpec, ProjectNotFound, SpecChanged, TeamNeeded
from app.projects.service import project_access
from app.projects.specs.service import ensure_short, read_spec, refusal_of
from app.sound_lists.errors import NamesNotResolved
from app.sound_lists.names import service as naming
from app.sound_lists.schemas import PatternAdmit, RefusedNames, RefusedRename, SpecDraft

router = APIRouter(prefix="/v1", tags=["sound-lists"])


async def _readable(request: Request, project_id: UUID, body: SpecDraft) -> SpecDraft:
    ensure_short(body.toml)
    try:
        await parse_request(
            request, audio_checks.parse_spec, body.toml, refusal=BadSpec, permit=project_access, whose=project_id
        )
    except audio_checks.SpecError as error:
        raise refusal_of(error) from None
    return body


@router.get("/projects/{project_id}/sound-list/refused-names", responses=problems(ProjectNotFound))
def list_refused_names(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> RefusedNames:
    """Return the file names of the list that the spec refuses, with proposals on either side."""
    return naming.refusals_of_list(session, project_access(session, actor, project_id).project)


@router.post(
    "/projects/{project_id}/sound-list/refused-names/draft",
    responses=problems(ProjectNotFound, BadSpec, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def check_names_by_draft(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    body: Annotated[SpecDraft, Depends(_readable)],
    session: DbSession,
) -> RefusedNames:
    """Return the file names of the list that a draft of the spec would refuse; nothing is saved."""
    project = project_access(session, actor, project_id).project
    return naming.refusals_of_list(session, project, read_spec(body.toml))


@router.post(
    "/projects/{project_id}/sound-list/refused-names/rename",
    responses=problems(ProjectNotFound, TeamNeeded, NamesNotResolved),
)
@accepts_body(LARGE_BODY_BYTES)
def rename_refused_names(
    project_id: UUID, body: RefusedRename, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> RefusedNames:
    """Give cues the proposed file names as one revision, and return what is still refused."""
    return naming.rename_refused(session, actor, project_id, body.cue_ids)


@router.post(
    "/projects/{project_id}/sound-list/refused-names/admit",
    responses=problems(ProjectNotFound, TeamNeeded, SpecChanged, NamesNotResolved),
)
def admit_refused_names(
    project_id: UUID, body: PatternAdmit, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> RefusedNames:
    """Save a version of the spec with the proposed pattern, and return what is still refused."""
    return naming.admit_refused(session, actor, project_id, body.category)
