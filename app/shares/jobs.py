"""The job that makes a guest's copy of a preview."""

from functools import cache
from pathlib import Path
from uuid import UUID

import structlog

from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.renders.children import in_child, retried
from app.shares import beeps
from app.shares.models import GuestCopy
from audio_checks import Sandbox, SandboxFailed

TIMEOUT_S = 300.0
MEMORY_BYTES = 3 << 30  # of address space; ten minutes in stereo take half of it
NOT_MADE = "this sound could not be made ready; that is our fault"

log = structlog.get_logger(__name__)


@job("shares.make_guest_copy")
def make_guest_copy(runtime: Runtime, payload: Payload) -> None:
    """Write a preview again without metadata, with beeps where they are wanted, in a child."""
    studio_id, key = UUID(payload["studio_id"]), payload["key"]
    with runtime.database.reading() as session:
        guest_copy = session.get_one(GuestCopy, (studio_id, key))
        session.expunge(guest_copy)
    if guest_copy.sha256 is not None:
        return
    blob, refusal = None, None
    with runtime.store.making() as folder:
        made = folder / "made"
        made.mkdir()
        try:
            with runtime.store.local_copy(studio_id, guest_copy.preview_sha256) as path:
                _make(path, made, has_beeps=guest_copy.has_beeps)
            blob = runtime.store.put_file(studio_id, made / "copy.wav")
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.error("a guest's copy failed", key=key, error=str(error))
            refusal = NOT_MADE
    with runtime.database.writing() as session:
        row = session.get_one(GuestCopy, (studio_id, key), with_for_update=True)
        if row.sha256 is None:
            row.sha256, row.file_bytes = (blob.sha256, blob.size_bytes) if blob else (None, None)
            row.refusal = refusal


def _make(path: Path, folder: Path, *, has_beeps: bool) -> None:
    out = str(folder / "copy.wav")
    retried(in_child(_sandbox(), [path], [folder], beeps.copy_for_guests, str(path), out, has_beeps=has_beeps))


@cache
def _sandbox() -> Sandbox:
    return Sandbox(timeout_s=TIMEOUT_S, memory_bytes=MEMORY_BYTES, preload=(beeps.__name__,))
