"""Jobs that measure what sounds are like, for comparing them."""

import tempfile
from functools import cache
from pathlib import Path
from uuid import UUID

import structlog

from app.core.events import publish
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.deliveries.queries import take_with_cue
from app.renders import queries, service
from app.renders.children import MEMORY_BYTES, TIMEOUT_S, in_child, retried
from app.renders.models import Timbre
from app.renders.timbre import rules as timbre
from audio_checks import (
    RenderRefused,
    Sandbox,
    SandboxFailed,
    Unreadable,
)

log = structlog.get_logger(__name__)


@cache
def _librosa_sandbox() -> Sandbox:
    loaded = ("numpy", "audio_checks", "librosa.core.spectrum", "librosa.feature.spectral", timbre.__name__)
    return Sandbox(timeout_s=TIMEOUT_S, memory_bytes=2 * MEMORY_BYTES, preload=loaded)


@job("renders.measure_timbre")
def measure_timbre(runtime: Runtime, payload: Payload) -> None:
    """Measure the timbre of a take's master, for comparing it with others."""
    with runtime.database.reading() as session:
        take = take_with_cue(session, UUID(payload["take_id"]))
        if take is None or queries.timbre_of(session, take.studio_id, take.master_sha256) is not None:
            return
        studio_id, sha256 = take.studio_id, take.master_sha256
        loop = take.cue is not None and take.cue.loop
    with (
        runtime.store.local_copy(studio_id, sha256) as master,
        tempfile.TemporaryDirectory(prefix="soundlist-") as folder,
    ):
        try:
            heard = retried(
                in_child(_librosa_sandbox(), [master], [Path(folder)], timbre.measure, str(master), folder, loop=loop)
            )
        except (Unreadable, RenderRefused, SandboxFailed) as error:
            log.info("a sound could not be compared", sha256=sha256, error=str(error))
            heard = None
    with runtime.database.writing() as session:
        service.save_timbre(session, Timbre(studio_id=studio_id, sound_sha256=sha256, **(dict(heard) if heard else {})))


@job("renders.measure_palette")
def measure_palette(runtime: Runtime, payload: Payload) -> None:
    """Ask for what is needed to compare the sounds of a project, once it has a palette."""
    project_id, studio_id = UUID(payload["project_id"]), UUID(payload["studio_id"])
    with runtime.database.writing() as session:
        if queries.has_palette(session, project_id):
            for take_id in queries.take_ids_without_timbre(session, project_id):
                publish(session, "take.rendered", studio_id=studio_id, priority=BULK, take_id=take_id)
