"""The endpoints of sound libraries."""

from typing import Annotated, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Request

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.builds.errors import BadLibrarySheet, LibraryFull, LibraryNotFound
from app.builds.libraries import service as libraries
from app.builds.libraries.schemas import LIBRARY_BODY_BYTES, LibrarySheetAdd, SoundLibraryRead
from app.builds.libraries.sheet import SheetSound, parse_library_sheet
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import accepts_body
from app.core.web.http import DbSession, problems
from app.projects.errors import ProducerNeeded, ProjectNotFound

router = APIRouter(prefix="/v1", tags=["builds"])
SentSheet: TypeAlias = tuple[LibrarySheetAdd, list[SheetSound]]


async def _parsed(project_id: UUID, body: LibrarySheetAdd, request: Request) -> SentSheet:
    sounds = await parse_request(
        request,
        parse_library_sheet,
        body.content_base64,
        refusal=BadLibrarySheet,
        permit=libraries.access_to_register,
        whose=project_id,
    )
    return body, sounds


@router.get("/projects/{project_id}/sound-libraries", responses=problems(ProjectNotFound))
def list_sound_libraries(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[SoundLibraryRead]:
    """Return the sound libraries that takes are compared with: the studio's to its team, their own to designers."""
    return libraries.libraries(session, actor, project_id)


@router.post(
    "/projects/{project_id}/sound-libraries",
    status_code=201,
    responses=problems(ProjectNotFound, ProducerNeeded, BadLibrarySheet, LibraryFull, ParsingBusy),
)
@accepts_body(LIBRARY_BODY_BYTES)
def add_sound_library(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    sent: Annotated[SentSheet, Depends(_parsed)],
    session: DbSession,
) -> SoundLibraryRead:
    """Register the files of a library by their fingerprints; takes of the studio are compared with them."""
    body, sounds = sent
    return libraries.add_library_sheet(session, actor, project_id, name=body.name, licence=body.licence, sounds=sounds)


@router.delete("/sound-libraries/{library_id}", status_code=204, responses=problems(LibraryNotFound, ProducerNeeded))
def remove_sound_library(library_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> None:
    """Forget a library, and that takes equal its files."""
    libraries.remove_library(session, actor, library_id)
