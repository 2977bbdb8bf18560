"""Released packs: assembled by the worker, numbered for their target, the same bytes at every download."""

from collections.abc import Sequence
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.builds import queries
from app.builds.errors import PackNotFound, PackNotSealed
from app.builds.models import PackedFile, SealedPack
from app.builds.packs.placeholders import with_placeholder_files
from app.builds.packs.service import (
    Packed,
    changes_read,
    ensure_packable,
    ensure_stored,
    ensure_team_or_build,
    mark_of,
    pack_of,
    stored_entry,
)
from app.builds.packs.zip_stream import Entry
from app.builds.rules import PackState
from app.builds.schemas import PackAdd, SealedPackRead, SealedPackSummary
from app.core import clock
from app.core.events import publish
from app.core.storage import Store
from app.projects.errors import ProjectNotFound
from app.projects.queries import lock_project
from app.projects.service import project_access


def request_pack(session: Session, actor: Actor, project_id: UUID, pack_add: PackAdd) -> SealedPack:
    """Begin a numbered pack of the sounds accepted now, for the worker to assemble; raise what prevents it."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    pack_now = pack_of(session, access.project, pack_add.target, actor)
    if pack_add.placeholders:
        pack_now = with_placeholder_files(session, pack_now)
    ensure_packable(pack_now, allow_missing=pack_add.allow_missing, placeholders=pack_add.placeholders)
    lock_project(session, project_id)
    pack = SealedPack(
        studio_id=access.project.studio_id,
        project_id=project_id,
        target=pack_add.target,
        number=queries.last_pack_number(session, project_id, pack_add.target) + 1,
        note=pack_add.note,
        with_masters=pack_add.masters,
        allow_missing=pack_add.allow_missing,
        placeholders=pack_add.placeholders,
        handoff=pack_add.handoff,
        sealer=session.get_one(Person, actor.person),
    )
    session.add(pack)
    session.flush()
    publish(session, "pack.asked", studio_id=pack.studio_id, pack_id=pack.id)
    return pack


def seal(session: Session, pack_id: UUID, files: Sequence[Packed]) -> None:
    """Write down what a pack holds, once."""
    pack = queries.pack_by_id(session, pack_id)
    if pack is None or pack.state is not PackState.SEALING:
        return
    rows = [
        {
            "pack_id": pack.id,
            "place": index,
            "studio_id": pack.studio_id,
            "path": file.entry.path,
            "kind": file.kind,
            "sha256": file.entry.sha256,
            "size_bytes": file.entry.size_bytes,
            "pcm_sha256": file.render.pcm_sha256 if file.render else None,
            "render_id": file.render.id if file.render else None,
        }
        for index, file in enumerate(files)
    ]
    session.execute(sa.insert(PackedFile), rows)
    pack.state, pack.sealed_at = PackState.SEALED, clock.now()
    publish(session, "pack.made", studio_id=pack.studio_id, pack_id=pack.id)


def refuse(session: Session, pack_id: UUID, refusal: str) -> None:
    """Record the reason for a pack's failed assembly."""
    pack = queries.pack_by_id(session, pack_id)
    if pack is not None and pack.state is PackState.SEALING:
        pack.state, pack.refusal = PackState.REFUSED, refusal


def visible_sealed(session: Session, actor: Actor, pack_id: UUID) -> SealedPack:
    """Return a pack; raise PackNotFound without sight of its project."""
    pack = queries.pack_by_id(session, pack_id)
    if pack is None:
        raise PackNotFound(f"no pack {pack_id}")
    try:
        access = project_access(session, actor, pack.project_id)
    except ProjectNotFound:
        raise PackNotFound(f"no pack {pack_id}") from None
    ensure_team_or_build(access)
    return pack


def packs_in(
    session: Session, actor: Actor, project_id: UUID, *, target: str | None, before: UUID | None, limit: int
) -> Sequence[SealedPack]:
    """Return the packs of a project that were handed out, the newest first."""
    ensure_team_or_build(project_access(session, actor, project_id))
    return queries.packs_of(session, project_id, target=target, before=before, limit=limit)


def sealed_entries(session: Session, store: Store, pack: SealedPack) -> list[Entry]:
    """Return the files of a sealed pack; raise PackNotSealed, or BlobDamaged where one is lost."""
    ensure_sealed(pack)
    entries = [
        stored_entry(store, pack.studio_id, file.path, file.sha256, file.size_bytes)
        for file in queries.files_of(session, pack.id)
    ]
    ensure_stored(store, pack.studio_id, entries)
    return entries


def ensure_sealed(pack: SealedPack) -> None:
    """Raise PackNotSealed for a pack that is being put together, or could not be."""
    if pack.state is not PackState.SEALED:
        reason = pack.refusal or "it is being built; try again in a moment"
        raise PackNotSealed(f"pack {pack.number} for {pack.target} cannot be fetched: {reason}")


def summaries(session: Session, packs: Sequence[SealedPack]) -> list[SealedPackSummary]:
    """Return packs as a list shows them."""
    sums = queries.pack_sums(session, [pack.id for pack in packs])
    return [SealedPackSummary(**_summary(pack, sums.get(pack.id, queries.PackSums()))) for pack in packs]


def _summary(pack: SealedPack, sums: queries.PackSums) -> dict[str, object]:
    return {
        "id": pack.id,
        "target": pack.target,
        "number": pack.number,
        "note": pack.note,
        "with_masters": pack.with_masters,
        "placeholders": pack.placeholders,
        "handoff": pack.handoff,
        "state": pack.state,
        "refusal": pack.refusal,
        "sealed_by": pack.sealer.name,
        "created_at": pack.created_at,
        "sealed_at": pack.sealed_at,
        "files": sums.files,
        "placeholder_files": sums.placeholder_files,
        "bytes": sums.size_bytes,
    }


def sealed_read(session: Session, pack: SealedPack) -> SealedPackRead:
    """Return a pack with what is not as it was in the one before."""
    before = queries.last_sealed(session, pack.project_id, pack.target, below=pack.number)
    sums = queries.pack_sums(session, [pack.id]).get(pack.id, queries.PackSums())

    def marks(of: SealedPack | None) -> dict[str, str]:
        renders = queries.game_renders_of(session, of.id) if of else {}
        return {path: mark_of(render) for path, render in renders.items()}

    changes = changes_read(before.number if before else None, marks(before), marks(pack))
    return SealedPackRead.model_validate({**_summary(pack, sums), "changes": changes})
