"""The manifest of a pack, for `audio-checks audit`: what each of its game files is known by.

What a sound is known by is found out by a job, once a sound, and kept; no request opens a sound.
"""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.builds import queries
from app.builds.errors import ManifestNotReady
from app.builds.models import Fingerprint, SealedPack
from app.builds.packs.service import Pack, ensure_stored, pack_of, stored_entry
from app.builds.rules import PackState
from app.builds.schemas import Manifest
from app.core import clock
from app.core.db import insert_if_absent
from app.core.events import publish
from app.core.plural import counted, verb
from app.core.storage import Store
from app.deliveries.queries import take_with_cue
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.queries import current_spec
from app.renders.errors import TargetUnknown
from app.renders.queries import current_renders
from app.renders.rules import RenderState
from audio_checks import FINGERPRINT_VERSION, manifest_of

REQUEST_AGAIN_AFTER_S = (
    300  # within this time requests share one job; a later one starts another, in case the first failed
)


@dataclass(frozen=True)
class ApprovedFile:
    """One game file of a pack, and whose it is."""

    path: str
    sha256: str
    size_bytes: int
    cue: str | None
    take: str


@dataclass(frozen=True)
class Approved:
    """The game files of a pack: of what is accepted now, or of a sealed one."""

    studio_id: UUID
    project_id: UUID
    target: str
    pack_id: UUID | None  # of the sealed one
    files: Sequence[ApprovedFile]

    @property
    def sizes_bytes(self) -> dict[str, int]:
        """The size of each sound by its hash; files that are alike are one."""
        return {file.sha256: file.size_bytes for file in self.files}


def approved_now(pack: Pack) -> Approved:
    """Return the game files of what is accepted now."""
    files = [
        ApprovedFile(
            path=sound.path,
            sha256=render.sha256 or "",
            size_bytes=render.file_bytes or 0,
            cue=str(sound.cue.number),
            take=str(sound.take.id),
        )
        for sound in pack.sounds
        if (render := sound.made)
    ]
    return Approved(pack.project.studio_id, pack.project.id, pack.target, None, files)


def approved_in_pack(session: Session, pack: SealedPack) -> Approved:
    """Return the game files of a sealed pack; placeholder files were not approved, and are none of them."""
    files = [
        ApprovedFile(
            path=row.path,
            sha256=row.sha256,
            size_bytes=row.size_bytes,
            cue=None if row.cue_number is None else str(row.cue_number),
            take=str(row.take_id),
        )
        for row in queries.packed_sounds_of(session, pack.id)
    ]
    return Approved(pack.studio_id, pack.project_id, pack.target, pack.id, files)


def manifest_read(session: Session, store: Store, approved: Approved) -> Manifest:
    """Return the manifest of a pack, whole.

    Raises ManifestNotReady where sounds have not been listened to, BlobDamaged where the store has lost one of those.
    """
    sizes_bytes = approved.sizes_bytes
    unheard = sizes_bytes.keys() - queries.fingerprinted_sounds(session, approved.studio_id, sizes_bytes)
    if unheard:
        entries = [
            stored_entry(store, approved.studio_id, file.path, file.sha256, file.size_bytes)
            for file in approved.files
            if file.sha256 in unheard
        ]
        ensure_stored(store, approved.studio_id, entries)
        wait_s = ManifestNotReady.retry_after_s
        raise ManifestNotReady(
            f"{len(unheard)} of {counted(len(sizes_bytes), 'approved sound')} "
            f"{verb(len(unheard), 'is', 'are')} still being listened to",
            fix=f"ask again in {wait_s} seconds; where it stays so, the page of jobs says why",
        )
    entries_by_sha256 = queries.manifest_entries(session, approved.studio_id, sizes_bytes)
    levels = queries.game_levels(session, [UUID(file.take) for file in approved.files])
    files = [
        {**entries_by_sha256[file.sha256], "path": file.path, "cue": file.cue, "take": file.take}
        | ({"plays": levels[file.take]} if file.take in levels else {})
        for file in approved.files
    ]
    return Manifest.model_validate(manifest_of(files))


def request_fingerprints(session: Session, approved: Approved) -> None:
    """Schedule fingerprints of a pack's sounds: one job for all requests within some minutes."""
    asked = [str(FINGERPRINT_VERSION), approved.target, str(approved.pack_id), *sorted(approved.sizes_bytes)]
    digest = hashlib.sha256("\0".join(asked).encode()).hexdigest()
    turn = int(clock.now().timestamp()) // REQUEST_AGAIN_AFTER_S
    publish(
        session,
        "manifest.asked",
        studio_id=approved.studio_id,
        once=f"manifest:{approved.project_id}:{digest}@{turn}",
        project_id=approved.project_id,
        target=approved.target,
        pack_id=approved.pack_id,
    )


def pack_sounds_to_fingerprint(
    session: Session, project_id: UUID, target: str, pack_id: UUID | None
) -> Mapping[str, int]:
    """Return the size of each sound of a pack that has not been listened to, by its hash."""
    if pack_id is not None:
        pack = queries.pack_by_id(session, pack_id)
        if pack is None or pack.state is not PackState.SEALED:
            return {}
        approved = approved_in_pack(session, pack)
    else:
        try:
            approved = approved_now(pack_of(session, session.get_one(Project, project_id), target))
        except TargetUnknown:  # a newer spec has no such target
            return {}
    return _without_fingerprint(session, approved.studio_id, approved.sizes_bytes)


def take_sounds_to_fingerprint(session: Session, take_id: UUID) -> Mapping[str, int]:
    """Return the size of each game file of an approved take that has not been listened to, by its hash."""
    take = take_with_cue(session, take_id)
    if take is None or take.state is not TakeState.APPROVED:
        return {}
    renders = current_renders(session, {take.project_id: current_spec(session, take.project_id)}, [take])[take.id]
    sizes_bytes = {
        render.sha256 or "": render.file_bytes or 0
        for render in renders.values()
        if render and render.state is RenderState.MADE
    }
    return _without_fingerprint(session, take.studio_id, sizes_bytes)


def _without_fingerprint(session: Session, studio_id: UUID, sizes_bytes: Mapping[str, int]) -> Mapping[str, int]:
    heard = queries.fingerprinted_sounds(session, studio_id, sizes_bytes)
    return {sha256: size_bytes for sha256, size_bytes in sizes_bytes.items() if sha256 not in heard}


def has_fingerprint(session: Session, studio_id: UUID, sha256: str) -> bool:
    """Whether a stored sound has been listened to."""
    return bool(queries.fingerprinted_sounds(session, studio_id, [sha256]))


def save_fingerprint(session: Session, studio_id: UUID, sha256: str, entry: Mapping[str, Any]) -> None:
    """Record a sound's fingerprint once, in place of one made by another version."""
    session.execute(
        delete(Fingerprint).where(
            Fingerprint.studio_id == studio_id,
            Fingerprint.sound_sha256 == sha256,
            Fingerprint.fingerprint_version != FINGERPRINT_VERSION,
        )
    )
    row = {"fingerprint_version": FINGERPRINT_VERSION, "entry": {**entry}, "fingerprinted_at": clock.now()}
    known_by = {"studio_id": studio_id, "sound_sha256": sha256}
    insert_if_absent(session, Fingerprint, known_by | row, unique=tuple(known_by))
