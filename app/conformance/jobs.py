"""The jobs of this room, without the check itself: `renders` continues with its take in the same job."""

import tempfile
from pathlib import Path
from typing import Any
from uuid import UUID

import structlog

import audio_checks
from app.conformance import checking, fixes, fixing, queries, service, splits, splitting
from app.conformance.rules import TRIES
from app.core import kill_points
from app.core.jobs.queue import NORMAL, Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing, StoredBlob
from app.deliveries import queries as deliveries

log = structlog.get_logger(__name__)
FIX_PASSES = 4  # a fix checks the master, writes the copy and checks that; now and then twice


@job("conformance.make_fix")
def make_fix(runtime: Runtime, payload: Payload) -> None:
    """Make the fixed copy of a master, and publish it once."""
    fix_id = UUID(payload["fix_id"])
    with runtime.database.reading() as session:
        order = fixes.order_fix(session, fix_id)
    if order is None:
        return
    kill_points.point("conformance.before_fix")
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        made = _fixed(runtime, order, folder)
        if made is None:
            with runtime.database.writing() as session:
                fixes.give_up(session, fix_id)
            return
        stored = _stored(runtime, order, Path(folder), made)
    kill_points.point("conformance.after_fix")
    with runtime.database.writing() as session:
        fixes.record_fix(session, fix_id, made, (stored.sha256, stored.size_bytes) if stored else None)


@job("conformance.split_master")
def split_master(runtime: Runtime, payload: Payload) -> None:
    """Find the parts of a master, and store each as a file of its own."""
    split_id = UUID(payload["split_id"])
    with runtime.database.reading() as session:
        order = splits.order_split(session, split_id)
    if order is None:
        return
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        made = _split(runtime, order, folder)
        if isinstance(made, str):
            with runtime.database.writing() as session:
                splits.refuse_split(session, split_id, made)
            return
        # Only files inside the folder are accepted of a child.
        paths = [Path(folder) / Path(part.file_name).name for part in made.parts]
        stored = [runtime.store.put_file(order.studio_id, path) for path in paths]
    with runtime.database.writing() as session:
        splits.record_split(session, split_id, made, [(blob.sha256, blob.size_bytes) for blob in stored])


@job("conformance.recheck_takes")
def recheck_takes(runtime: Runtime, payload: Payload) -> None:
    """Have the undecided takes checked again of which a changed spec, or changed cues, now ask something else."""
    cue_ids = [UUID(cue_id) for cue_id in payload["cue_ids"]] if "cue_ids" in payload else None
    by = UUID(payload["person_id"]) if "person_id" in payload else None
    with runtime.database.reading() as session:
        take_ids = queries.checkable_takes(session, UUID(payload["project_id"]), cue_ids)
    for take_id in take_ids:
        with runtime.database.writing() as session:
            service.recheck_if_changed(session, take_id, by=by)


@job("conformance.compare_takes")
def compare_takes(runtime: Runtime, payload: Payload) -> None:
    """Have the undecided takes checked again whose dry stem came, changed or was withdrawn."""
    with runtime.database.reading() as session:
        delivery = deliveries.delivery_by_id(session, UUID(payload["delivery_id"]))
        take_ids = deliveries.takes_beside(session, UUID(payload["delivery_id"]), payload["stem"])
    by = delivery.designer_id if delivery else None
    for take_id in take_ids:
        with runtime.database.writing() as session:
            service.recheck_if_changed(session, take_id, by=by, priority=NORMAL)


def _stored(runtime: Runtime, order: fixes.FixOrder, folder: Path, made: dict[str, Any]) -> StoredBlob | None:
    """Store the file that a child reports; only files inside its folder are accepted."""
    return runtime.store.put_file(order.studio_id, folder / Path(made["file"]).name) if made["file"] else None


def _fixed(runtime: Runtime, order: fixes.FixOrder, folder: str) -> dict[str, Any] | None:
    """Return a child's result on a master; None after three failures."""
    for _ in range(TRIES):
        try:
            with (
                runtime.store.local_copy(order.studio_id, order.master_sha256) as path,
                checking.sandbox().child(
                    timeout_s=FIX_PASSES * checking.time_for(order.master_bytes), reads=[path], writes=[folder]
                ) as child,
            ):
                made = child.call(fixing.fix, str(path), folder, order.spec, cue=order.cue, name=order.name)
            return fixing.as_record(made)
        except audio_checks.FixRefused as refusal:
            return _refused(order, refusal)
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            log.warning("a fix failed", fix_id=str(order.fix_id), error=str(error))
    return None


def _refused(order: fixes.FixOrder, refusal: audio_checks.FixRefused) -> dict[str, Any]:
    left = {"code": refusal.code, "severity": "error", "message": str(refusal), "why": f"{refusal}; {refusal.fix}."}
    return {"file": None, "name": order.name, "conforms": False, "repairs": [], "left": [left]}


def _split(runtime: Runtime, order: splits.SplitOrder, folder: str) -> audio_checks.SplitMaster | str:
    """Return a child's parts of a master, or why there are none."""
    for _ in range(TRIES):
        try:
            with (
                runtime.store.local_copy(order.studio_id, order.master_sha256) as path,
                checking.sandbox().child(
                    timeout_s=FIX_PASSES * checking.time_for(order.master_bytes), reads=[path], writes=[folder]
                ) as child,
            ):
                made: audio_checks.SplitMaster = child.call(
                    splitting.split, str(path), folder, shortest_pause_s=order.shortest_pause_s
                )
            return made
        except audio_checks.SplitRefused as refusal:
            return f"Not split: {refusal}. To get parts, {refusal.fix}."
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            log.warning("a split failed", split_id=str(order.split_id), error=str(error))
    return splits.OUR_FAULT
