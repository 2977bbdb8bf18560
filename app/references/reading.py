"""References as they are shown."""

from collections.abc import Sequence

from sqlalchemy.orm import Session

from app.accounts.schemas import PersonBrief
from app.projects.service import ProjectAccess
from app.references import queries
from app.references.models import ReferenceOpening, ReferenceVersion
from app.references.schemas import PinnedCue, ReferenceOpeningRead, ReferenceRead, ReferenceVersionRead


def read_references(
    session: Session, access: ProjectAccess, versions: Sequence[ReferenceVersion]
) -> list[ReferenceRead]:
    """Return references with these versions, and the cues that they are pinned to."""
    cue_ids = {version.reference.cue_id for version in versions if version.reference.cue_id}
    cues = queries.cues_pinned(session, cue_ids)
    parts = queries.parts_count(session, [version.reference_id for version in versions])
    may_change = access.is_producer or access.is_liaison or access.is_approver
    return [
        ReferenceRead(
            id=reference.id,
            project_id=reference.project_id,
            cue=PinnedCue.model_validate(cues[reference.cue_id]) if reference.cue_id else None,
            category=reference.category,
            caption=reference.caption,
            words=reference.words,
            terms=reference.terms,
            start_s=reference.start_s,
            end_s=reference.end_s,
            added_at=reference.added_at,
            version=read_version(version),
            parts=parts.get(reference.id, 0),
            may_change=may_change,
        )
        for version, reference in ((version, version.reference) for version in versions)
    ]


def read_version(version: ReferenceVersion) -> ReferenceVersionRead:
    """Return one version."""
    facts = {name: getattr(version, name) for name in ReferenceVersionRead.model_fields if name != "added_by"}
    return ReferenceVersionRead(**facts, added_by=PersonBrief.model_validate(version.author))


def read_opening(opening: ReferenceOpening) -> ReferenceOpeningRead:
    """Return the facts of an opening."""
    version = opening.version
    return ReferenceOpeningRead(
        reference_id=version.reference_id,
        caption=version.reference.caption,
        file_name=version.file_name,
        version=version.number,
        person=PersonBrief.model_validate(opening.person),
        opened_at=opening.opened_at,
        is_removed=version.reference.removed_at is not None,
    )
