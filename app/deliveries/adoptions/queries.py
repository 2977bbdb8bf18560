"""Adoptions, read from the database; callers have checked access."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session, defer, joinedload

from app.core import clock
from app.core.uploads import Upload
from app.core.uploads.model import FINISHED_KEPT_FOR
from app.deliveries.models import Adoption
from app.sound_lists.models import Cue, Stem


def adoption_by_id(session: Session, adoption_id: UUID, *, locked: bool = False) -> Adoption | None:
    """Return an adoption with who adopted it, without a check of the caller."""
    query = select(Adoption).where(Adoption.id == adoption_id)
    if locked:
        query = query.with_for_update(of=Adoption).execution_options(populate_existing=True)
    return session.scalar(query.options(joinedload(Adoption.adopter)))


def adoptions_of(session: Session, project_id: UUID) -> Sequence[Adoption]:
    """Return the adoptions of a project without their files, the newest first."""
    query = select(Adoption).where(Adoption.project_id == project_id).order_by(Adoption.id.desc())
    return session.scalars(query.options(defer(Adoption.files), joinedload(Adoption.adopter)).limit(100)).all()


def owned_stems(session: Session, project_id: UUID) -> Sequence[tuple[str, int]]:
    """Return each folded stem of a list, and the number of its cue."""
    owned = select(Stem.folded, Cue.number).join(Cue, Cue.id == Stem.cue_id).where(Stem.project_id == project_id)
    return [(folded, number) for folded, number in session.execute(owned)]


def finished_uploads(session: Session, studio_id: UUID, scope: str) -> dict[str, tuple[UUID, int]]:
    """Return the finished uploads of a scope by their SHA-256: the id and the size in bytes of the first of each."""
    query = select(Upload.sha256, Upload.id, Upload.length).where(
        Upload.studio_id == studio_id,
        Upload.scope == scope,
        Upload.sha256.is_not(None),
        Upload.finished_at >= clock.now() - FINISHED_KEPT_FOR,
    )
    uploads: dict[str, tuple[UUID, int]] = {}
    for sha256, upload_id, length in session.execute(query.order_by(Upload.id)):
        uploads.setdefault(str(sha256), (upload_id, length))
    return uploads
