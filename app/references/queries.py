"""References, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import Select, func, or_, select
from sqlalchemy.orm import Session, contains_eager, joinedload

from app.accounts.quotas.queries import Usage
from app.references.models import Reference, ReferenceOpening, ReferenceVersion
from app.sound_lists.models import Cue


class PinnedTo(NamedTuple):
    """A cue with its category: both may have references."""

    cue_id: UUID
    category: str


def newest_versions(
    session: Session, project_id: UUID, *, pinned_to: PinnedTo | None, only_words: bool, before: UUID | None, limit: int
) -> Sequence[ReferenceVersion]:
    """Return the newest version of each reference on the board, the reference added last first."""
    query = _newest().where(Reference.project_id == project_id)
    if pinned_to is not None:
        # A cue without a category has an empty one, which no reference is pinned to.
        query = query.where(or_(Reference.cue_id == pinned_to.cue_id, Reference.category == pinned_to.category))
    if only_words:
        query = query.where(Reference.words != "")
    if before is not None:
        query = query.where(Reference.id < before)
    return session.scalars(query.order_by(Reference.id.desc()).limit(limit)).all()


def newest_version(session: Session, reference_id: UUID) -> ReferenceVersion | None:
    """Return a reference on the board with its newest version."""
    return session.scalar(_newest().where(Reference.id == reference_id))


def version_by_id(session: Session, version_id: UUID) -> ReferenceVersion | None:
    """Return any version of a reference on the board."""
    return session.scalar(_on_board().where(ReferenceVersion.id == version_id))


def versions_of(session: Session, reference_id: UUID) -> Sequence[ReferenceVersion]:
    """Return the versions of a reference on the board, newest first."""
    of_it = _on_board().where(Reference.id == reference_id)
    return session.scalars(of_it.order_by(ReferenceVersion.number.desc())).all()


def reference_locked(session: Session, reference_id: UUID) -> Reference | None:
    """Return a reference on the board, locked until the transaction ends."""
    on_board = select(Reference).where(Reference.id == reference_id, Reference.removed_at.is_(None))
    return session.scalar(on_board.with_for_update().execution_options(populate_existing=True))


def _on_board() -> Select[ReferenceVersion]:
    joined = select(ReferenceVersion).join(Reference, Reference.id == ReferenceVersion.reference_id)
    loaded = joined.options(contains_eager(ReferenceVersion.reference), joinedload(ReferenceVersion.author))
    return loaded.where(Reference.removed_at.is_(None))


def _newest() -> Select[ReferenceVersion]:
    return _on_board().where(ReferenceVersion.number == Reference.newest_number)


def cues_pinned(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, Cue]:
    """Return cues by id."""
    return {cue.id: cue for cue in session.scalars(select(Cue).where(Cue.id.in_(cue_ids)))} if cue_ids else {}


def has_category(session: Session, project_id: UUID, category: str) -> bool:
    """Whether a list has a cue of a category."""
    of_it = select(Cue.id).where(Cue.project_id == project_id, Cue.category == category)
    return session.scalar(of_it.limit(1)) is not None


def references_of_file(
    session: Session, project_id: UUID, sha256: str | None, cue_ids: Collection[UUID]
) -> Sequence[UUID]:
    """Return the references on the board that are pinned to cues and whose newest version is a file."""
    of_file = select(Reference.id).join(ReferenceVersion, ReferenceVersion.reference_id == Reference.id)
    of_file = of_file.where(Reference.project_id == project_id, Reference.cue_id.in_(cue_ids))
    newest = (ReferenceVersion.number == Reference.newest_number, Reference.removed_at.is_(None))
    return session.scalars(of_file.where(*newest, ReferenceVersion.sha256 == sha256)).all()


def parts_locked(session: Session, clip_id: UUID, sha256: str | None) -> Sequence[Reference]:
    """Return the parts of a clip on the board that show a file of it, locked until the transaction ends."""
    shows_it = select(ReferenceVersion.id).where(
        ReferenceVersion.reference_id == Reference.id,
        ReferenceVersion.number == Reference.newest_number,
        ReferenceVersion.sha256 == sha256,
    )
    parts = select(Reference).where(Reference.spotted_from_id == clip_id, Reference.removed_at.is_(None))
    return session.scalars(parts.where(shows_it.exists()).order_by(Reference.id).with_for_update()).all()


def parts_count(session: Session, clip_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the number of parts on the board that were spotted from each clip."""
    of_clip = select(Reference.spotted_from_id, func.count()).where(
        Reference.spotted_from_id.in_(clip_ids), Reference.removed_at.is_(None)
    )
    counts = session.execute(of_clip.group_by(Reference.spotted_from_id))
    return {clip_id: count for clip_id, count in counts if clip_id is not None}


def version_numbered(session: Session, reference_id: UUID, number: int) -> ReferenceVersion | None:
    """Return one version of a reference on the board by its number."""
    return session.scalar(_on_board().where(Reference.id == reference_id, ReferenceVersion.number == number))


def last_opened_at(session: Session, version_id: UUID, person_id: UUID) -> datetime | None:
    """Return the time of a person's last opening of a version."""
    return session.scalar(
        select(func.max(ReferenceOpening.opened_at)).where(
            ReferenceOpening.version_id == version_id, ReferenceOpening.person_id == person_id
        )
    )


def openings(
    session: Session, project_id: UUID, *, reference_id: UUID | None, before: UUID | None, limit: int
) -> Sequence[ReferenceOpening]:
    """Return the openings, newest first; references that were removed since are included."""
    query = (
        select(ReferenceOpening)
        .join(ReferenceOpening.version)
        .where(ReferenceOpening.project_id == project_id)
        .options(
            contains_eager(ReferenceOpening.version).joinedload(ReferenceVersion.reference),
            joinedload(ReferenceOpening.person),
        )
    )
    if reference_id is not None:
        query = query.where(ReferenceVersion.reference_id == reference_id)
    if before is not None:
        query = query.where(ReferenceOpening.id < before)
    return session.scalars(query.order_by(ReferenceOpening.id.desc()).limit(limit)).all()


kept_reference_bytes = Usage(
    ReferenceVersion.studio_id,
    ReferenceVersion.sha256.is_not(None),
    sha256=ReferenceVersion.sha256,
    size_bytes=ReferenceVersion.file_bytes,
)
