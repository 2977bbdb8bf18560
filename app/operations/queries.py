"""The storage of studios, summed up from the tables of the rooms; callers have checked access."""

from collections import defaultdict
from collections.abc import Sequence
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import Boolean, ColumnElement, Select, String, Uuid, func, literal, literal_column, select, union_all
from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.agreements.models import ContractVersion, Seal
from app.builds.models import PackedFile, PlaceholderFile
from app.conformance.models import Fix, Split, SplitPart
from app.core.db import Base
from app.deliveries.models import Archive, DryStem, SourceFile, Take
from app.hiring.models import ReelSound, Sample
from app.operations.schemas import KeptFiles, KeptKind, StorageRead
from app.projects.models import Engagement, Project
from app.references.models import ReferenceVersion
from app.renders.models import MasterExport, Picture, Reel, Render
from app.scenes.models import Comparison, SceneSound
from app.shares.models import GuestCopy
from app.voice_lines.models import Release

Sums = Select[UUID, str, int, int | None]


class Source(NamedTuple):
    """A table that refers to files of one kind: their owner, hash and size."""

    kind: KeptKind
    whose: Any
    sha256: Any
    size_bytes: Any


KEPT = (
    Source(KeptKind.MASTERS, Take.studio_id, Take.master_sha256, Take.master_bytes),
    Source(KeptKind.DRY_STEMS, DryStem.studio_id, DryStem.sha256, DryStem.file_bytes),
    Source(KeptKind.SOURCE_FILES, SourceFile.studio_id, SourceFile.sha256, SourceFile.file_bytes),
    Source(KeptKind.ARCHIVES, Archive.studio_id, Archive.sha256, Archive.archive_bytes),
    Source(KeptKind.GAME_FILES, Render.studio_id, Render.sha256, Render.file_bytes),
    Source(KeptKind.FIXES, Fix.studio_id, Fix.sha256, Fix.fixed_bytes),
    Source(KeptKind.FIXES, SplitPart.studio_id, SplitPart.sha256, SplitPart.part_bytes),
    Source(KeptKind.REELS, Reel.studio_id, Reel.sha256, Reel.file_bytes),
    Source(KeptKind.EXPORTS, MasterExport.studio_id, MasterExport.sha256, MasterExport.file_bytes),
    Source(KeptKind.PLACEHOLDER_FILES, PlaceholderFile.studio_id, PlaceholderFile.sha256, PlaceholderFile.file_bytes),
    Source(KeptKind.REFERENCES, ReferenceVersion.studio_id, ReferenceVersion.sha256, ReferenceVersion.file_bytes),
    Source(KeptKind.REFERENCES, SceneSound.studio_id, SceneSound.preview_sha256, SceneSound.preview_bytes),
    Source(KeptKind.REELS, Comparison.studio_id, Comparison.sha256, Comparison.file_bytes),
    Source(KeptKind.ROSTER_REELS, ReelSound.studio_id, ReelSound.sha256, ReelSound.file_bytes),
    Source(KeptKind.ROSTER_REELS, Sample.studio_id, Sample.sha256, Sample.file_bytes),
    Source(KeptKind.GUEST_COPIES, GuestCopy.studio_id, GuestCopy.sha256, GuestCopy.file_bytes),
    Source(KeptKind.DOCUMENTS, Release.studio_id, Release.sha256, Release.file_bytes),
    *(
        Source(KeptKind.REFERENCES, ReferenceVersion.studio_id, sha256, size_bytes)
        for sha256, size_bytes in (
            (ReferenceVersion.thumb_sha256, ReferenceVersion.thumb_bytes),
            (ReferenceVersion.view_sha256, ReferenceVersion.view_bytes),
        )
    ),
    Source(KeptKind.DOCUMENTS, ContractVersion.studio_id, ContractVersion.pdf_sha256, ContractVersion.pdf_bytes),
    Source(KeptKind.DOCUMENTS, Seal.studio_id, Seal.file_sha256, Seal.file_bytes),
    Source(KeptKind.DOCUMENTS, PackedFile.studio_id, PackedFile.sha256, PackedFile.size_bytes),
)
ONLY: dict[type[Base], ColumnElement[bool]] = {
    Fix: Fix.new_take_id.is_(None),  # the others are masters
    SplitPart: SplitPart.split_id.in_(select(Split.id).where(Split.tray_action_id.is_(None))),  # as above
    Take: Take.master_deleted_at.is_(None),
    PackedFile: literal_column(
        "kind = 'key'", Boolean
    ),  # as its index says it; all else in a pack is kept as what it is
}


def studio_names(session: Session, ids: set[UUID] | None = None) -> dict[UUID, str]:
    """Return the names of studios, or of every studio."""
    names = select(Studio.id, Studio.name)
    return dict(session.execute(names if ids is None else names.where(Studio.id.in_(ids))).all())


def storage(session: Session, studio_id: UUID | None = None) -> list[StorageRead]:
    """Return the storage of each studio, the largest first; one studio alone where it is given."""
    sums: dict[UUID, dict[KeptKind, KeptFiles]] = defaultdict(dict)
    rows = session.execute(union_all(*(_summed(source, studio_id) for source in KEPT), _drawn(studio_id)))
    for whose, kind_word, files, size_bytes in rows:
        if not files:
            continue
        kind = KeptKind(kind_word)
        kept_files = sums[whose].get(kind, KeptFiles(kind=kind, files=0, size_bytes=0))
        sums[whose][kind] = KeptFiles(
            kind=kind, files=kept_files.files + files, size_bytes=kept_files.size_bytes + int(size_bytes or 0)
        )
    studios = select(Studio.id, Studio.name)
    if studio_id is not None:
        studios = studios.where(Studio.id == studio_id)
    reads = [
        StorageRead(
            studio_id=id_,
            studio_name=name,
            size_bytes=sum(kept.size_bytes for kept in sums[id_].values()),
            kept=[sums[id_][kind] for kind in KeptKind if kind in sums[id_]],
        )
        for id_, name in session.execute(studios)
    ]
    return sorted(reads, key=lambda read: (-read.size_bytes, read.studio_name))


def _summed(source: Source, studio_id: UUID | None) -> Sums:
    """Sum up files by studio, those with the same bytes once."""
    kind, whose, sha256, size_bytes = source
    # The same bytes have one size, so that both databases walk along the index and sort nothing.
    files = select(whose.label("studio_id"), sha256, size_bytes.label("size_bytes")).distinct()
    files = files.where(sha256.is_not(None))
    if whose.class_ in ONLY:
        files = files.where(ONLY[whose.class_])
    if studio_id is not None:
        distinct_files = files.where(whose == studio_id).subquery()
        of_studio = literal(studio_id, Uuid)
        return select(of_studio, literal(kind.value, String), func.count(), func.sum(distinct_files.c.size_bytes))
    distinct_files = files.subquery()
    summed = select(
        distinct_files.c.studio_id, literal(kind.value, String), func.count(), func.sum(distinct_files.c.size_bytes)
    )
    return summed.group_by(distinct_files.c.studio_id)


def _drawn(studio_id: UUID | None) -> Sums:
    """Sum up what was drawn of sounds; no two sounds look alike."""
    files, size_bytes = func.count(Picture.drawn_bytes), func.sum(Picture.drawn_bytes)
    drawn = select(Picture.studio_id, literal(KeptKind.DRAWINGS.value, String), files, size_bytes)
    drawn = drawn.where(Picture.drawn_bytes.is_not(None))
    return (drawn if studio_id is None else drawn.where(Picture.studio_id == studio_id)).group_by(Picture.studio_id)


def project_names(session: Session, studio_id: UUID) -> dict[UUID | None, str]:
    """Return the names of a studio's projects, archived ones too."""
    return dict(session.execute(select(Project.id, Project.name).where(Project.studio_id == studio_id)).all())


def engagements_of(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Engagement]:
    """Return a person's running engagements on a studio's projects."""
    return session.scalars(
        select(Engagement)
        .where(Engagement.studio_id == studio_id, Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
        .order_by(Engagement.id)
    ).all()
