"""The endpoints of this room."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.uploads import UploadNotFound, UploadUnfinished
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.downloads import downloads
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, Page, cursor_of, problems, uuid_cursor
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.references import service, spotting
from app.references.drawing import MEDIA_TYPE
from app.references.errors import NoPreview, ReferenceInvalid, ReferenceNotFound, ReferenceUnopened
from app.references.models import ReferenceVersion
from app.references.reading import read_opening, read_references, read_version
from app.references.rules import ReferenceKind
from app.references.schemas import (
    ReferenceAdd,
    ReferenceChange,
    ReferenceContent,
    ReferenceOpeningRead,
    ReferenceRead,
    ReferenceVersionRead,
)
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["references"])
MAY_SEE: Actor = allows(Audience.PROJECT)
TEAM: Actor = allows(Audience.TEAM)
PAGE = 100
# What strangers sent runs nothing and loads nothing in a browser that opens it.
LOCKED = {"Content-Security-Policy": "default-src 'none'; sandbox", "X-Content-Type-Options": "nosniff"}
SHOWN_IN_PLACE = frozenset({ReferenceKind.AUDIO, ReferenceKind.VIDEO, ReferenceKind.TEXT})


@router.get("/projects/{project_id}/references", responses=problems(ProjectNotFound, CueNotFound, BadCursor))
def list_references(
    project_id: UUID,
    session: DbSession,
    cue_id: Annotated[UUID | None, Query(description="Only those of this cue and of its category.")] = None,
    words: Annotated[bool, Query(description="Only those that show words.")] = False,
    cursor: str | None = None,
    actor: Actor = MAY_SEE,
) -> Page[ReferenceRead]:
    """Return the references of a project, the one added last first."""
    access, versions = service.on_board(
        session, actor, project_id, cue_id=cue_id, only_words=words, before=uuid_cursor(cursor), limit=PAGE + 1
    )
    shown = versions[:PAGE]
    following = cursor_of(shown[-1].reference_id) if len(versions) > PAGE else None
    return Page(items=read_references(session, access, shown), next=following)


@router.post(
    "/projects/{project_id}/references",
    status_code=201,
    responses=problems(
        ProjectNotFound, TeamNeeded, CueNotFound, ReferenceInvalid, UploadNotFound, UploadUnfinished, BlobMissing
    ),
)
def add_reference(
    project_id: UUID, body: ReferenceAdd, session: DbSession, runtime: CurrentRuntime, actor: Actor = TEAM
) -> ReferenceRead:
    """Put a finished upload or a link on the board."""
    version = service.add(
        session,
        actor,
        project_id,
        content=service.Content(body.upload_id, body.url),
        facts=body.model_dump(exclude={"upload_id", "url"}),
        store=runtime.store,
    )
    return _read(session, actor, version)


@router.patch(
    "/references/{reference_id}", responses=problems(ReferenceNotFound, TeamNeeded, CueNotFound, ReferenceInvalid)
)
def change_reference(
    reference_id: UUID, body: ReferenceChange, session: DbSession, actor: Actor = TEAM
) -> ReferenceRead:
    """Change caption, terms, range or pin; both pins null pin it to the whole project."""
    return _read(session, actor, service.change(session, actor, reference_id, body.model_dump(exclude_unset=True)))


@router.delete("/references/{reference_id}", status_code=204, responses=problems(ReferenceNotFound, TeamNeeded))
def remove_reference(reference_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Take a reference off the board; the record of who opened it stays."""
    service.remove(session, actor, reference_id)


@router.get("/references/{reference_id}/versions", responses=problems(ReferenceNotFound))
def list_reference_versions(
    reference_id: UUID, session: DbSession, actor: Actor = MAY_SEE
) -> list[ReferenceVersionRead]:
    """Return every version of a reference, newest first."""
    return [read_version(version) for version in service.versions_of(session, actor, reference_id)]


@router.post(
    "/references/{reference_id}/versions",
    status_code=201,
    responses=problems(ReferenceNotFound, TeamNeeded, ReferenceInvalid, UploadNotFound, UploadUnfinished, BlobMissing),
)
def add_reference_version(
    reference_id: UUID, body: ReferenceContent, session: DbSession, runtime: CurrentRuntime, actor: Actor = TEAM
) -> ReferenceRead:
    """Replace the file or link of a reference; older versions stay, and parts that were spotted from it follow."""
    content = service.Content(body.upload_id, body.url)
    version = service.add_version(session, actor, reference_id, content=content, store=runtime.store)
    spotting.move_parts(session, actor, version)
    return _read(session, actor, version)


@router.get("/projects/{project_id}/reference-openings", responses=problems(ProjectNotFound, TeamNeeded, BadCursor))
def list_reference_openings(
    project_id: UUID,
    session: DbSession,
    reference: Annotated[UUID | None, Query(description="Only those of this reference.")] = None,
    cursor: str | None = None,
    actor: Actor = TEAM,
) -> Page[ReferenceOpeningRead]:
    """Return the openings: person, version and time, newest first."""
    openings = service.openings_of(
        session, actor, project_id, reference_id=reference, before=uuid_cursor(cursor), limit=PAGE + 1
    )
    shown = openings[:PAGE]
    following = cursor_of(shown[-1].id) if len(openings) > PAGE else None
    return Page(items=[read_opening(opening) for opening in shown], next=following)


@router.post(
    "/reference-versions/{reference_version_id}/openings", status_code=204, responses=problems(ReferenceNotFound)
)
def record_reference_opening(reference_version_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> None:
    """Record that the caller opens a version: its file and its large preview are sent to who did."""
    service.record_opening(session, actor, reference_version_id)


@router.get(
    "/reference-versions/{reference_version_id}/file",
    **downloads("application/octet-stream", ReferenceNotFound, ReferenceUnopened, BlobMissing),
)
def get_reference_file(
    reference_version_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    download: bool = False,
    actor: Actor = MAY_SEE,
) -> Response:
    """Send the file as it came, parts of it by Range; what is neither sound, clip nor text is to be kept, not shown."""
    version = service.opened_file(session, actor, reference_version_id)
    is_shown = version.kind in SHOWN_IN_PLACE and not download
    return blob_response(
        request,
        runtime.store,
        version.studio_id,
        service.drawn(version.sha256),
        media_type=version.media_type,
        file_name=None if is_shown else version.file_name,
        headers=LOCKED | {"Cache-Control": WHILE_ASKED},
    )


@router.get(
    "/reference-versions/{reference_version_id}/view",
    **downloads(MEDIA_TYPE, ReferenceNotFound, ReferenceUnopened, NoPreview, BlobMissing),
)
def get_reference_view(
    reference_version_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = MAY_SEE,
) -> Response:
    """Show a picture, drawn again at no more than 1,600 pixels a side."""
    version = service.opened_file(session, actor, reference_version_id)
    sha256 = service.drawn(version.view_sha256)
    headers = LOCKED | {"Cache-Control": WHILE_ASKED}
    return blob_response(request, runtime.store, version.studio_id, sha256, media_type=MEDIA_TYPE, headers=headers)


@router.get(
    "/reference-versions/{reference_version_id}/thumb",
    **downloads(MEDIA_TYPE, ReferenceNotFound, NoPreview, BlobMissing),
)
def get_reference_thumb(
    reference_version_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = MAY_SEE,
) -> Response:
    """Show a picture on the board, at no more than 480 pixels a side."""
    version = service.version_seen(session, actor, reference_version_id)
    sha256 = service.drawn(version.thumb_sha256)
    return blob_response(request, runtime.store, version.studio_id, sha256, media_type=MEDIA_TYPE, headers=LOCKED)


def _read(session: DbSession, actor: Actor, version: ReferenceVersion) -> ReferenceRead:
    (read,) = read_references(session, service.access_to(session, actor, version), [version])
    return read
