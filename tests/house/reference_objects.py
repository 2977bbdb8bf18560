"""A reference that was opened, as part of one of everything."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.references.models import Reference, ReferenceOpening, ReferenceVersion
from app.references.rules import PreviewState, ReferenceKind


def add_reference(
    session: Session,
    of: dict[str, UUID],
    *,
    cue_id: UUID,
    sha256: str,
    file_bytes: int,
    added_by: UUID,
    opened_by: UUID,
) -> dict[str, UUID]:
    """Add a sound that is pinned to a cue, which a person opened; return its ids by the names in paths."""
    reference = Reference(**of, cue_id=cue_id, caption="Like this", terms="", newest_number=1, added_by=added_by)
    session.add(reference)
    session.flush()
    version = ReferenceVersion(
        **of,
        reference_id=reference.id,
        number=1,
        kind=ReferenceKind.AUDIO,
        media_type="audio/wav",
        file_name="like_this.wav",
        sha256=sha256,
        file_bytes=file_bytes,
        excerpt="",
        preview=PreviewState.MADE,
        thumb_sha256=sha256,
        thumb_bytes=file_bytes,
        view_sha256=sha256,
        view_bytes=file_bytes,
        added_by=added_by,
    )
    session.add(version)
    session.flush()
    session.add(ReferenceOpening(**of, version_id=version.id, person_id=opened_by))
    return {"reference_id": reference.id, "reference_version_id": version.id}
