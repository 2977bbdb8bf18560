"""The endpoints of performers' releases."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.uploads import UploadNotFound, UploadUnfinished
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import project_access
from app.voice_lines import releases
from app.voice_lines.errors import ReleaseNotFound, VoiceLineInvalid
from app.voice_lines.schemas import ReleaseAdd, ReleasesRead

router = APIRouter(prefix="/v1", tags=["voice lines"])
MAY_SEE: Actor = allows(Audience.PROJECT)
TEAM: Actor = allows(Audience.TEAM)
# What strangers sent runs nothing and loads nothing in a browser that opens it.
LOCKED = {"Content-Security-Policy": "default-src 'none'; sandbox", "X-Content-Type-Options": "nosniff"}


@router.get("/projects/{project_id}/voice-releases", responses=problems(ProjectNotFound))
def list_voice_releases(project_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> ReleasesRead:
    """Return performers with their parts and releases, and the approved lines that no release covers."""
    return releases.releases_read(session, project_access(session, actor, project_id))


@router.post(
    "/projects/{project_id}/voice-releases",
    status_code=201,
    responses=problems(ProjectNotFound, TeamNeeded, VoiceLineInvalid, UploadNotFound, UploadUnfinished),
)
def add_voice_release(project_id: UUID, body: ReleaseAdd, session: DbSession, actor: Actor = TEAM) -> ReleasesRead:
    """File a finished upload as the signed release of a performer."""
    facts = body.model_dump(exclude={"performer", "upload_id"})
    access = releases.add_release(
        session, actor, project_id, performer=body.performer, upload_id=body.upload_id, facts=facts
    )
    return releases.releases_read(session, access)


@router.delete("/voice-releases/{voice_release_id}", status_code=204, responses=problems(ReleaseNotFound, TeamNeeded))
def remove_voice_release(voice_release_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Take a release off the list; its file and record stay."""
    releases.remove_release(session, actor, voice_release_id)


@router.get(
    "/voice-releases/{voice_release_id}/file",
    **downloads("application/octet-stream", ReleaseNotFound, BlobMissing),
)
def get_voice_release_file(
    voice_release_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = MAY_SEE,
) -> Response:
    """Send the file of a release as it came, to be kept, not shown."""
    release = releases.release_seen(session, actor, voice_release_id)
    return blob_response(
        request,
        runtime.store,
        release.studio_id,
        release.sha256,
        media_type="application/octet-stream",
        file_name=release.file_name,
        headers=LOCKED | {"Cache-Control": WHILE_ASKED},
    )
