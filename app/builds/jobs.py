"""The jobs of this room: packs put together, placeholder files made, game files listened to."""

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from uuid import UUID

import structlog

from app.builds import queries
from app.builds.engine_export import exported_cues as handed_cues
from app.builds.packs import manifests, placeholders, sealing
from app.builds.packs import service as packs
from app.builds.rules import FileKind, PackState
from app.conformance import checking
from app.core import kill_points
from app.core.errors import Refused
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.projects.models import Project
from audio_checks import (
    FingerprintedFile,
    RenderRefused,
    SandboxFailed,
    fingerprint_files,
    make_placeholder,
    manifest_entry,
)

log = structlog.get_logger(__name__)


class FingerprintFailed(Exception):
    """A game file could not be listened to, though we made it ourselves."""


@job("builds.seal_pack")
def seal_pack(runtime: Runtime, payload: Payload) -> None:
    """Assemble a pack of the sounds accepted now, and store its key, so that it can always be fetched."""
    pack_id = UUID(payload["pack_id"])
    with runtime.database.reading() as session:
        asked = queries.pack_by_id(session, pack_id)
        if asked is None or asked.state is not PackState.SEALING:
            return
        pack = packs.pack_of(session, session.get_one(Project, asked.project_id), asked.target)
        if asked.placeholders:
            pack = placeholders.with_placeholder_files(session, pack)
        handoff = handed_cues.handoff_entries(session, pack, asked.handoff)
    try:
        files = packs.pack_files(
            runtime.store,
            pack,
            masters=asked.with_masters,
            allow_missing=asked.allow_missing,
            placeholders=asked.placeholders,
            handoff=handoff,
        )
    except Refused as error:
        with runtime.database.writing() as session:
            sealing.refuse(session, pack_id, error.message)
        return
    for file in files:
        if file.kind is FileKind.KEY:
            with file.entry.opened() as content:
                runtime.store.put(asked.studio_id, [content.read()])
    kill_points.point("builds.before_seal")
    with runtime.database.writing() as session:
        sealing.seal(session, pack_id, files)


@job("builds.make_placeholder_files")
def make_placeholder_files(runtime: Runtime, payload: Payload) -> None:
    """Make the missing files of a target's pack, each on record before the next."""
    with runtime.database.reading() as session:
        project, slots = placeholders.slots_to_make(session, UUID(payload["project_id"]), payload["target"])
    _make_placeholders(runtime, project, payload["target"], slots)


@job("builds.make_spoken_placeholders")
def make_spoken_placeholders(runtime: Runtime, payload: Payload) -> None:
    """Make the placeholder files of one cue for every target, after a person said one or removed it."""
    project_id, cue_id = UUID(payload["project_id"]), UUID(payload["cue_id"])
    with runtime.database.reading() as session:
        targets = placeholders.targets_of_project(session, project_id)
    for target in targets:
        with runtime.database.reading() as session:
            project, slots = placeholders.slots_to_make(session, project_id, target, cue_id)
        _make_placeholders(runtime, project, target, slots)


def _make_placeholders(runtime: Runtime, project: Project, target: str, slots: Sequence[placeholders.Slot]) -> None:
    for slot in slots:
        blob, is_spoken, refusal = None, False, ""
        with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
            try:
                path = Path(folder, f"placeholder{slot.view.ending}")
                spoken = _said(runtime, project, slot)
                made = make_placeholder(slot.facts, slot.variation, slot.view, path, said=spoken)
                blob, is_spoken = runtime.store.put_file(project.studio_id, made.path), made.is_spoken
            except RenderRefused as error:
                refusal = f"{error}; {error.fix}"
        kill_points.point("builds.before_placeholder_file")
        with runtime.database.writing() as session:
            placeholders.keep(session, project, target, slot, blob, is_spoken=is_spoken, refusal=refusal)


def _said(runtime: Runtime, project: Project, slot: placeholders.Slot) -> bytes | None:
    if slot.said_sha256 is None:
        return None
    with runtime.store.local_copy(project.studio_id, slot.said_sha256) as path:
        return path.read_bytes()


@job("builds.fingerprint_take")
def fingerprint_take(runtime: Runtime, payload: Payload) -> None:
    """Listen to the game files of an approved take, for manifests."""
    with runtime.database.reading() as session:
        unheard = manifests.take_sounds_to_fingerprint(session, UUID(payload["take_id"]))
    _fingerprint(runtime, UUID(payload["studio_id"]), unheard)


@job("builds.fingerprint_pack")
def fingerprint_pack(runtime: Runtime, payload: Payload) -> None:
    """Fingerprint the sounds that a manifest lacks, each recorded before the next."""
    pack_id = UUID(payload["pack_id"]) if payload["pack_id"] else None
    with runtime.database.reading() as session:
        unheard = manifests.pack_sounds_to_fingerprint(session, UUID(payload["project_id"]), payload["target"], pack_id)
    _fingerprint(runtime, UUID(payload["studio_id"]), unheard)


def _fingerprint(runtime: Runtime, studio_id: UUID, sizes_bytes: Mapping[str, int]) -> None:
    """Fingerprint sounds, each in a separate child; a failure delays no other sound, and fails the job at its end."""
    failure: Exception | None = None
    for sha256, size_bytes in sizes_bytes.items():
        with runtime.database.reading() as session:
            if manifests.has_fingerprint(session, studio_id, sha256):  # by another job, meanwhile
                continue
        try:
            heard = _fingerprinted(runtime, studio_id, sha256, size_bytes)
        except (SandboxFailed, FingerprintFailed, BlobAltered, BlobMissing) as error:
            log.warning("a game file could not be listened to", sha256=sha256, error=str(error))
            failure = error
            continue
        with runtime.database.writing() as session:
            manifests.save_fingerprint(session, studio_id, sha256, manifest_entry(heard))
    if failure is not None:
        raise failure


def _fingerprinted(runtime: Runtime, studio_id: UUID, sha256: str, size_bytes: int) -> FingerprintedFile:
    with (
        runtime.store.local_copy(studio_id, sha256) as path,
        checking.sandbox().child(timeout_s=checking.time_for(size_bytes), reads=[path]) as child,
    ):
        (heard,) = child.call(fingerprint_files, [(str(path), sha256)])
    if heard.trouble:
        raise FingerprintFailed(heard.trouble)
    return heard
