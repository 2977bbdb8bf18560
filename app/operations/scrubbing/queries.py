"""The blobs that rows name. Every column that names one is listed here; a test compares the list with all tables."""

from datetime import timedelta
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, Select, String, exists, func, literal, select, union_all
from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.conformance.models import Fix, Split, SplitPart
from app.core import clock
from app.core.db import Base
from app.core.uploads.model import FINISHED_KEPT_FOR, Upload
from app.deliveries.models import Archive, DryStem, SourceFile, Take
from app.operations.models import DamagedBlob, Scrub
from app.operations.queries import KEPT, Source
from app.operations.schemas import KeptKind
from app.references.models import Reference, ReferenceVersion
from app.renders.models import MasterExport, Picture
from app.sound_lists.models import SpokenPlaceholder
from app.voice_lines.models import Release

NAMING = (
    *KEPT,
    Source(KeptKind.PLACEHOLDER_FILES, SpokenPlaceholder.studio_id, SpokenPlaceholder.sha256, None),
    *(
        Source(KeptKind.DRAWINGS, Picture.studio_id, sha256, None)
        for sha256 in (Picture.peaks_sha256, Picture.spectrum_sha256, Picture.preview_sha256, Picture.light_sha256)
    ),
    Source(KeptKind.UPLOADS, Upload.studio_id, Upload.sha256, None),
)
MASTERLESS = select(Take.id).where(Take.master_deleted_at.is_not(None))


def _came_with_deleted_masters(delivery_id: Any, received_at: Any) -> ColumnElement[bool]:
    """Return whether masters of a delivery were deleted after a file of it came."""
    return exists().where(Take.delivery_id == delivery_id, Take.master_deleted_at >= received_at)


UPLOADS_NAME_FOR = FINISHED_KEPT_FOR + timedelta(days=1)  # a request that uses one at the last moment may still run
REMOVED: dict[type[Base], ColumnElement[bool]] = {  # rows that stay as history, and whose files go
    ReferenceVersion: ReferenceVersion.reference_id.in_(select(Reference.id).where(Reference.removed_at.is_not(None))),
    Release: Release.removed_at.is_not(None),
    Take: Take.master_deleted_at.is_not(None),
    DryStem: _came_with_deleted_masters(DryStem.delivery_id, DryStem.received_at),
    SourceFile: SourceFile.take_id.in_(MASTERLESS),
    Archive: _came_with_deleted_masters(Archive.delivery_id, Archive.received_at),
    Fix: Fix.take_id.in_(MASTERLESS),
    SplitPart: SplitPart.split_id.in_(select(Split.id).where(Split.take_id.in_(MASTERLESS))),
    MasterExport: MasterExport.take_id.in_(MASTERLESS),
}


def studio_ids(session: Session) -> list[UUID]:
    """Return the ids of all studios, in order."""
    return list(session.scalars(select(Studio.id).order_by(Studio.id)))


def named_blobs(session: Session, studio_id: UUID) -> dict[str, KeptKind]:
    """Return the hashes of a studio's blobs that rows name, each with the first kind that names it."""
    kinds: dict[str, KeptKind] = {}
    for sha256, kind in session.execute(union_all(*(_named(source, studio_id) for source in NAMING))):
        kinds.setdefault(sha256, KeptKind(kind))
    return kinds


def is_named(session: Session, studio_id: UUID, sha256: str) -> bool:
    """Whether any row names a blob."""
    named = union_all(*(_named(source, studio_id).where(source.sha256 == sha256) for source in NAMING))
    return session.execute(named.limit(1)).first() is not None


def newest_scrub(session: Session, *, finished: bool = False) -> Scrub | None:
    """Return the newest pass, or the newest that came to its end."""
    scrubs = select(Scrub).order_by(Scrub.started_at.desc(), Scrub.id.desc()).limit(1)
    return session.scalar(scrubs.where(Scrub.finished_at.is_not(None)) if finished else scrubs)


def damaged_counts(session: Session) -> dict[str, int]:
    """Return the number of damaged blobs, by their state."""
    counts = select(DamagedBlob.state, func.count()).group_by(DamagedBlob.state)
    return {state.value: count for state, count in session.execute(counts)}


def damaged_of(session: Session, studio_id: UUID, sha256s: list[str]) -> list[DamagedBlob]:
    """Return those of a studio's blobs that are noted as damaged."""
    damaged = select(DamagedBlob).where(DamagedBlob.studio_id == studio_id)
    return [blob for blob in session.scalars(damaged) if blob.sha256 in set(sha256s)]


def _named(source: Source, studio_id: UUID) -> Select[str, str]:
    named = select(source.sha256, literal(source.kind.value, String))
    if source.whose.class_ in REMOVED:
        named = named.where(~REMOVED[source.whose.class_])
    if source.kind is KeptKind.UPLOADS:
        named = named.where(Upload.finished_at >= clock.now() - UPLOADS_NAME_FOR)
    return named.where(source.whose == studio_id, source.sha256.is_not(None)).distinct()
