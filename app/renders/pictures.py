"""The drawings of a sound, put into the store."""

from pathlib import Path
from uuid import UUID

from app.core.runtime import Runtime
from app.core.storage import StoredBlob
from app.renders import drawing
from app.renders.models import Picture


def stored_picture(
    runtime: Runtime,
    studio_id: UUID,
    sound_sha256: str,
    folder: Path,
    drawn: drawing.Drawn,
    preview: StoredBlob | None = None,
    spectrum: StoredBlob | None = None,
) -> Picture:
    """Store a sound's drawings, but for those stored already: the file that plays it, and the look of that."""
    peaks = runtime.store.put_file(studio_id, folder / drawing.PEAKS)
    spectrum = spectrum or runtime.store.put_file(studio_id, folder / drawing.SPECTRUM)
    if preview is None and not drawn["plays_itself"]:
        preview = runtime.store.put_file(studio_id, folder / drawing.PREVIEW)
    light = runtime.store.put_file(studio_id, folder / drawing.LIGHT) if drawn["has_light"] else None
    return Picture(
        studio_id=studio_id,
        sound_sha256=sound_sha256,
        duration_s=drawn["duration_s"],
        facts=dict(drawn["facts"]),
        thumb=dict(drawn["thumb"]),
        peaks_sha256=peaks.sha256,
        spectrum_sha256=spectrum.sha256,
        preview_sha256=preview.sha256 if preview else sound_sha256,
        preview_media_type="audio/wav",
        light_sha256=light.sha256 if light else None,
        drawn_bytes=sum(blob.size_bytes for blob in (peaks, spectrum, preview, light) if blob),
    )
