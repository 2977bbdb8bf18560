"""The endpoints of placeholders that a person says."""

import base64
import binascii
from typing import Annotated, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.storage import BlobMissing
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.projects.errors import TeamNeeded
from app.sound_lists.errors import CueIsCut, CueNotFound, RecordingInvalid, SpokenPlaceholderMissing
from app.sound_lists.models import SpokenPlaceholder
from app.sound_lists.spoken_placeholders import service as spoken
from app.sound_lists.spoken_placeholders.rules import read_said
from app.sound_lists.spoken_placeholders.schemas import RecordingAdd, SpokenPlaceholderRead

router = APIRouter(prefix="/v1", tags=["sound-lists"])
MAY_SEE: Actor = allows(Audience.PROJECT)
TEAM: Actor = allows(Audience.TEAM)
Said: TypeAlias = tuple[bytes, float]


async def _heard(cue_id: UUID, body: RecordingAdd, request: Request) -> Said:
    try:
        content = base64.b64decode(body.content_base64, validate=True)
    except (ValueError, binascii.Error):
        raise RecordingInvalid("content_base64 is not base64", fix="send a WAV file in base64") from None
    return await parse_request(
        request, read_said, content, refusal=RecordingInvalid, permit=spoken.ensure_may_say, whose=cue_id
    )


@router.put(
    "/cues/{cue_id}/spoken-placeholder",
    responses=problems(CueNotFound, TeamNeeded, CueIsCut, RecordingInvalid, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def record_spoken_placeholder(
    cue_id: UUID,
    runtime: CurrentRuntime,
    actor: Annotated[Actor, TEAM],
    said: Annotated[Said, Depends(_heard)],
    session: DbSession,
) -> SpokenPlaceholderRead:
    """Keep a recorded word for a cue, trimmed and at one level, and make its placeholder files of it."""
    content, duration_s = said
    kept = spoken.save_spoken_placeholder(
        session, actor, cue_id, content=content, duration_s=duration_s, store=runtime.store
    )
    return _read(kept)


@router.get("/cues/{cue_id}/spoken-placeholder", responses=problems(CueNotFound))
def get_spoken_placeholder(cue_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> SpokenPlaceholderRead | None:
    """Return a cue's spoken placeholder; null where there is none."""
    try:
        return _read(spoken.get_spoken_placeholder(session, actor, cue_id))
    except SpokenPlaceholderMissing:
        return None


@router.delete(
    "/cues/{cue_id}/spoken-placeholder",
    status_code=204,
    responses=problems(CueNotFound, TeamNeeded, CueIsCut, SpokenPlaceholderMissing),
)
def remove_spoken_placeholder(cue_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Remove a cue's spoken placeholder."""
    spoken.remove_said(session, actor, cue_id)


@router.get(
    "/cues/{cue_id}/spoken-placeholder/file",
    **downloads("audio/wav", CueNotFound, SpokenPlaceholderMissing, BlobMissing),
)
def get_spoken_placeholder_file(
    cue_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Send a cue's spoken placeholder, parts of it by Range."""
    placeholder = spoken.get_spoken_placeholder(session, actor, cue_id)
    headers = {"Cache-Control": WHILE_ASKED}
    return blob_response(
        request, runtime.store, placeholder.studio_id, placeholder.sha256, media_type="audio/wav", headers=headers
    )


def _read(recording: SpokenPlaceholder) -> SpokenPlaceholderRead:
    return SpokenPlaceholderRead(
        cue_id=recording.cue_id,
        sha256=recording.sha256,
        duration_s=recording.duration_s,
        recorded_by=recording.speaker,
        recorded_at=recording.recorded_at,
    )
