"""A bed, the part of a reference and a comparison, as part of one of everything."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.scenes.models import Bed, Comparison, SceneSound
from app.scenes.rules import BedRole


def add_scene(
    session: Session, of: dict[str, UUID], *, take_id: UUID, sha256: str, file_bytes: int, changed_by: UUID
) -> dict[str, UUID]:
    """Add what a scene has beside its version; return the ids by the names in paths."""
    bed = Bed(**of, category="", role=BedRole.MUSIC, take_id=take_id, level_db=-12.0, is_on=True, changed_by=changed_by)
    sound = SceneSound(
        studio_id=of["studio_id"],
        sound_sha256=sha256,
        part="0.000-",
        duration_s=1.0,
        excitation="",
        preview_sha256=sha256,
        preview_bytes=file_bytes,
    )
    levels = {"hz": [], "sound_dbfs": [], "against_dbfs": [], "difference_dbfs": []}
    comparison = Comparison(
        **of,
        sound_sha256=sha256,
        against_sha256="0" * 64,
        lag_s=0.0,
        gain_db=0.0,
        residue_db=-20.0,
        spectra=levels,
        sha256=sha256,
        file_bytes=file_bytes,
    )
    session.add_all([bed, sound, comparison])
    session.flush()
    return {"bed_id": bed.id, "scene_sound_id": sound.id, "comparison_id": comparison.id}
