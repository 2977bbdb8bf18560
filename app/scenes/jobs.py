"""The jobs of this room."""

from contextlib import ExitStack
from functools import cache
from typing import Any
from uuid import UUID

import structlog

from app.core.db import insert_if_absent
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.scenes import comparisons, listening, queries
from app.scenes.excitations import as_text
from app.scenes.models import SceneSound
from app.scenes.rules import part_bounds
from audio_checks import Sandbox, SandboxFailed

TIMEOUT_S = 60.0
MEMORY_BYTES = 2 << 30  # of address space; two minutes of stereo and their transforms take half of it
FILE_BYTES = 64 << 20
TOO_LARGE = f"this sound takes more than {TIMEOUT_S:g} s or {MEMORY_BYTES >> 20:,} MiB to read"

log = structlog.get_logger(__name__)


@job("scenes.measure_sound")
def measure_sound(runtime: Runtime, payload: Payload) -> None:
    """Measure a sound for scenes; of a reference its part is made playable first."""
    studio_id, sha256, part = UUID(payload["studio_id"]), payload["sha256"], payload["part"]
    with runtime.database.reading() as session:
        if queries.scene_sounds(session, studio_id, [sha256]).get((sha256, part)) is not None:
            return
    made: dict[str, Any]
    try:
        made = _measured(runtime, studio_id, sha256, part)
    except (SandboxFailed, BlobAltered, BlobMissing) as error:
        log.warning("a sound could not be measured", sha256=sha256, error=str(error))
        made = {"problem": TOO_LARGE}
    with runtime.database.writing() as session:
        row = {"studio_id": studio_id, "sound_sha256": sha256, "part": part, **made}
        insert_if_absent(session, SceneSound, row, unique=("studio_id", "sound_sha256", "part"))


def _measured(runtime: Runtime, studio_id: UUID, sha256: str, part: str) -> dict[str, Any]:
    with runtime.store.making() as folder, runtime.store.local_copy(studio_id, sha256) as path:
        written = folder / "made"
        written.mkdir()
        with _sandbox().child(reads=[path], writes=[written]) as child:
            if part:
                measured = child.call(listening.prepare_part, str(path), str(written), *part_bounds(part))
            else:
                measured = child.call(listening.measure_preview, str(path))
        if measured["problem"]:
            return {"problem": measured["problem"]}
        made: dict[str, Any] = {
            "duration_s": measured["duration_s"],
            "excitation": as_text(measured["excitation"]),
            "thumb": dict(measured["thumb"]),
        }
        if part:
            blob = runtime.store.put_file(studio_id, written / listening.PREVIEW)
            made |= {"preview_sha256": blob.sha256, "preview_bytes": blob.size_bytes}
        return made


@job("scenes.compare_sounds")
def compare_sounds(runtime: Runtime, payload: Payload) -> None:
    """Make the difference track of two sounds, and say how far they differ."""
    comparison_id = UUID(payload["comparison_id"])
    with runtime.database.reading() as session:
        comparison = queries.comparison_by_id(session, comparison_id)
    if comparison is None or comparison.sha256 is not None or comparison.refusal is not None:
        return
    studio_id = comparison.studio_id
    with runtime.store.making() as folder, ExitStack() as copies:
        written = folder / "made"
        written.mkdir()
        try:
            paths = [
                copies.enter_context(runtime.store.local_copy(studio_id, sha256))
                for sha256 in (comparison.sound_sha256, comparison.against_sha256)
            ]
            with _sandbox().child(reads=paths, writes=[written]) as child:
                made = child.call(listening.compare, str(paths[0]), str(paths[1]), str(written))
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.warning("two sounds could not be compared", comparison_id=str(comparison_id), error=str(error))
            with runtime.database.writing() as session:
                comparisons.refuse(session, comparison_id, TOO_LARGE)
            return
        blob = runtime.store.put_file(studio_id, written / listening.DIFFERENCE)
    with runtime.database.writing() as session:
        comparisons.keep(session, comparison_id, blob, made)


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=TIMEOUT_S,
        memory_bytes=MEMORY_BYTES,
        file_bytes=FILE_BYTES,
        preload=("numpy", "audio_checks", listening.__name__),
        rehearsal=listening.preload,
    )
