"""The jobs of this room."""

from functools import cache
from uuid import UUID

import structlog

from app.core import pictures
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.references import drawing
from app.references.models import ReferenceVersion
from app.references.rules import PreviewState
from audio_checks import Sandbox, SandboxFailed

TIMEOUT_S = 30.0
MEMORY_BYTES = 1 << 30  # of address space; the largest picture that is drawn takes half of it
FILE_BYTES = 64 << 20

log = structlog.get_logger(__name__)


@job("references.draw_preview")
def draw_preview(runtime: Runtime, payload: Payload) -> None:
    """Draw a picture again at two sizes, in a child; or say why that cannot be."""
    version_id = UUID(payload["version_id"])
    with runtime.database.reading() as session:
        version = session.get_one(ReferenceVersion, version_id)
        session.expunge(version)
    if version.preview is not PreviewState.PENDING or version.sha256 is None:
        return
    with runtime.store.making() as folder, runtime.store.local_copy(version.studio_id, version.sha256) as path:
        drawn = folder / "drawn"
        drawn.mkdir()
        try:
            with _sandbox().child(reads=[path], writes=[drawn]) as child:
                outcome = child.call(drawing.draw_previews, str(path), str(drawn))
        except SandboxFailed as error:
            log.warning("a picture could not be drawn", version_id=str(version_id), error=str(error))
            message = f"this picture takes more than {TIMEOUT_S:g} s or {MEMORY_BYTES >> 20:,} MiB to draw"
            outcome = {"width": 0, "height": 0, "problem": message}
        made = {
            "problem": outcome["problem"],
            "width_px": outcome["width"] or None,
            "height_px": outcome["height"] or None,
        }
        if outcome["problem"]:
            made["preview"] = PreviewState.REFUSED
        else:
            made["preview"] = PreviewState.MADE
            for name, file in (("thumb", drawing.THUMB), ("view", drawing.VIEW)):
                stored = runtime.store.put_file(version.studio_id, drawn / file)
                made |= {f"{name}_sha256": stored.sha256, f"{name}_bytes": stored.size_bytes}
    with runtime.database.writing() as session:
        row = session.get_one(ReferenceVersion, version_id, with_for_update=True)
        for name, value in made.items():
            setattr(row, name, value)


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=TIMEOUT_S,
        memory_bytes=MEMORY_BYTES,
        file_bytes=FILE_BYTES,
        preload=(drawing.__name__,),
        rehearsal=pictures.preload,
    )
