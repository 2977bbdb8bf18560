"""The endpoints of adoptions."""

import base64
import json
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Depends, Request

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import REPORT_BODY_BYTES, accepts_body
from app.core.web.http import DbSession, problems
from app.deliveries.adoptions import service as adoptions
from app.deliveries.adoptions.game_projects import read_sent
from app.deliveries.adoptions.schemas import (
    Adopted,
    AdoptionOpened,
    AdoptionPlanRead,
    AdoptionProgress,
    AdoptionRead,
    FolderAsk,
)
from app.deliveries.errors import (
    AdoptionClosed,
    AdoptionNotFound,
    AlreadyUndone,
    GameProjectUnreadable,
    PathTwice,
)
from app.projects.errors import ApproverNeeded, ProjectNotFound, TeamNeeded
from app.reviews.adoptions import service as adopting
from app.reviews.errors import AdoptionInUse, FilesMissing, NothingToAdopt, NothingToUndo
from app.sound_lists.errors import AdditionInUse, RowsInvalid

router = APIRouter(prefix="/v1", tags=["adoptions"])
TEAM: Actor = allows(Audience.TEAM)
TEAM_OR_BUILD: Actor = allows(Audience.TEAM, build=Scope.DELIVERIES_WRITE)
SentFolder = tuple[FolderAsk, dict[str, Any] | None]


async def _sent(project_id: UUID, body: FolderAsk, request: Request) -> SentFolder:
    """Return a folder, and what the game's project says of its sounds where the project was sent with it."""
    if body.project is None:
        return body, None
    try:
        packed = base64.b64decode(body.project.content_base64, validate=True)
    except ValueError:
        raise GameProjectUnreadable("content_base64 is no base64") from None
    arguments = (read_sent, body.project.path, packed)
    permit = adoptions.ensure_may_send_to
    plan_json = await parse_request(request, *arguments, refusal=GameProjectUnreadable, permit=permit, whose=project_id)
    return body, json.loads(plan_json)


@router.post(
    "/projects/{project_id}/adoption-plan",
    responses=problems(ApproverNeeded, GameProjectUnreadable, ParsingBusy, PathTwice, ProjectNotFound),
)
@accepts_body(REPORT_BODY_BYTES)
def plan_adoption(
    project_id: UUID,
    actor: Annotated[Actor, TEAM_OR_BUILD],
    sent: Annotated[SentFolder, Depends(_sent)],
    session: DbSession,
) -> AdoptionPlanRead:
    """Return the effects of adopting a folder of shipped files; nothing is written."""
    body, game = sent
    return adoptions.plan_folder(session, actor, project_id, body.files, game)


@router.post(
    "/projects/{project_id}/adoptions",
    status_code=201,
    responses=problems(ApproverNeeded, GameProjectUnreadable, ParsingBusy, PathTwice, ProjectNotFound),
)
@accepts_body(REPORT_BODY_BYTES)
def open_adoption(
    project_id: UUID,
    actor: Annotated[Actor, TEAM_OR_BUILD],
    sent: Annotated[SentFolder, Depends(_sent)],
    session: DbSession,
) -> AdoptionOpened:
    """Open an adoption, for its files to be uploaded; nothing changes in the list until it is adopted."""
    body, game = sent
    return adoptions.open_adoption(session, actor, project_id, folder=body.folder, files=body.files, game=game)


@router.get("/projects/{project_id}/adoptions", responses=problems(ProjectNotFound, TeamNeeded))
def list_adoptions(project_id: UUID, session: DbSession, actor: Actor = TEAM) -> list[AdoptionRead]:
    """Return the newest 100 adoptions of a project, those that were undone included."""
    return [adoptions.adoption_read(adoption) for adoption in adoptions.adoptions_of(session, actor, project_id)]


@router.get("/adoptions/{adoption_id}", responses=problems(AdoptionNotFound, TeamNeeded))
def get_adoption(adoption_id: UUID, session: DbSession, actor: Actor = TEAM) -> AdoptionProgress:
    """Return the progress of the checks of adopted sounds, and the odd ones out."""
    return adopting.progress(session, actor, adoption_id)


@router.get("/adoptions/{adoption_id}/plan", responses=problems(AdoptionNotFound, ApproverNeeded))
def get_adoption_plan(adoption_id: UUID, session: DbSession, actor: Actor = TEAM_OR_BUILD) -> AdoptionOpened:
    """Return the effects of adopting on the list as it is now, and the files that are still to be uploaded."""
    adoption, access = adoptions.adoption_for(session, actor, adoption_id)
    adoptions.ensure_may_send(access)
    return adoptions.opened_adoption(session, access, adoption)


@router.post(
    "/adoptions/{adoption_id}/adopt",
    responses=problems(
        AdoptionClosed, AdoptionNotFound, ApproverNeeded, FilesMissing, NothingToAdopt, RowsInvalid
    ),
)  # fmt: skip
def adopt_folder(adoption_id: UUID, session: DbSession, actor: Actor = TEAM) -> Adopted:
    """Make cues with approved takes of the uploaded files; their checks follow."""
    return adopting.adopt(session, actor, adoption_id)


@router.post(
    "/adoptions/{adoption_id}/undo",
    responses=problems(AdditionInUse, AdoptionInUse, AdoptionNotFound, AlreadyUndone, ApproverNeeded, NothingToUndo),
)
def undo_adoption(adoption_id: UUID, session: DbSession, actor: Actor = TEAM) -> AdoptionRead:
    """Remove the results of an adoption while nothing is built on them; the uploaded masters are kept."""
    return adoptions.adoption_read(adopting.undo(session, actor, adoption_id))
