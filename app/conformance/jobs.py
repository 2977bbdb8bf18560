"""The jobs of this room: checks in a throw-away child that may crash, hang or eat memory."""

import math
import tempfile
from functools import cache
from pathlib import Path
from typing import Any
from uuid import UUID

import structlog
from prometheus_client import Counter

import audio_checks
from app.conformance import mending, mends, queries, service
from app.conformance.rules import TRIES, Report, unjudged, with_reverb_before
from app.conformance.service import CheckOrder
from app.kit import kill
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.kit.storage import BlobAltered, BlobMissing

log = structlog.get_logger(__name__)
BASE_TIME_S = 60
BYTES_A_SECOND = 8 << 20  # far slower than any machine that this runs on
MEMORY_BYTES = 1 << 30
MEND_PASSES = 4  # a mend checks the master, writes the copy and checks that; now and then twice
TAKES_CHECKED = Counter("soundlist_takes_checked", "Takes that were judged, by verdict.", ["verdict"])


@job("conformance.check_take")
def check_take(runtime: Runtime, payload: Payload) -> None:
    """Judge a received take against the newest spec, and say so once."""
    with runtime.database.reading() as session:
        order = service.order_check(session, UUID(payload["take_id"]))
        report = service.known_report(session, order) if order else None
    if order is None:
        return
    kill.point("conformance.before_check")
    report = with_reverb_before(report or _checked(runtime, order), _beside_before(runtime, order))
    kill.point("conformance.after_check")
    with runtime.database.writing() as session:
        is_news = service.record_check(session, order, report)
        if is_news and report["verdict"] != "conforming":
            mends.make_ready(session, order.take_id)
        kill.point("conformance.before_commit")
    if is_news:
        TAKES_CHECKED.labels(report["verdict"]).inc()
    kill.point("conformance.after_commit")


@job("conformance.make_mend")
def make_mend(runtime: Runtime, payload: Payload) -> None:
    """Make the mended copy of a master, and say so once."""
    mend_id = UUID(payload["mend_id"])
    with runtime.database.reading() as session:
        order = mends.order_mend(session, mend_id)
    if order is None:
        return
    kill.point("conformance.before_mend")
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        made = _mended(runtime, order, folder)
        if made is None:
            with runtime.database.writing() as session:
                mends.give_up(session, mend_id)
            return
        stored = runtime.store.put_file(order.studio_id, Path(made["file"])) if made["file"] else None
    kill.point("conformance.after_mend")
    with runtime.database.writing() as session:
        mends.record_mend(session, mend_id, made, (stored.sha256, stored.size_bytes) if stored else None)


@job("conformance.recheck_takes")
def recheck_takes(runtime: Runtime, payload: Payload) -> None:
    """Have the undecided takes checked again of which a changed spec, or changed cues, now ask something else."""
    cue_ids = [UUID(cue_id) for cue_id in payload["cue_ids"]] if "cue_ids" in payload else None
    with runtime.database.reading() as session:
        take_ids = queries.checkable_takes(session, UUID(payload["project_id"]), cue_ids)
    for take_id in take_ids:
        with runtime.database.writing() as session:
            service.recheck_if_changed(session, take_id)


def _checked(runtime: Runtime, order: CheckOrder) -> Report:
    """Return the report of a child; after three failures, one that says that it is our fault."""
    sandbox = _sandbox(_time_for(order.master_bytes))
    why = ""
    for _ in range(TRIES):
        try:
            with runtime.store.local_copy(order.studio_id, order.master_sha256) as path:
                report = sandbox.call(
                    audio_checks.check_file, path, order.spec, cue=order.cue, name=order.name, all_figures=True
                )
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            why = str(error)
            continue
        return report.to_dict() | {"path": order.name}
    return unjudged(order.name, order.spec.category, why)


def _beside_before(runtime: Runtime, order: CheckOrder) -> dict[str, Any] | None:
    """Return what the reverb of a take is beside that of an earlier one; None where there is none to compare with."""
    if order.before is None:
        return None
    sandbox, store = _sandbox(_time_for(order.master_bytes)), runtime.store
    try:
        with (
            store.local_copy(order.studio_id, order.master_sha256) as path,
            store.local_copy(order.studio_id, order.before.master_sha256) as before_path,
        ):
            compared = sandbox.call(audio_checks.reverb_between, path, before_path)
    except (audio_checks.Unreadable, audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
        log.warning("no comparison with an earlier take", take_id=str(order.take_id), error=str(error))
        return None
    return compared.to_dict() | {"take_id": str(order.before.take_id), "number": order.before.number}


def _mended(runtime: Runtime, order: mends.MendOrder, folder: str) -> dict[str, Any] | None:
    """Return what a child made of a master; None after three failures."""
    sandbox = _sandbox(MEND_PASSES * _time_for(order.master_bytes))
    for _ in range(TRIES):
        try:
            with runtime.store.local_copy(order.studio_id, order.master_sha256) as path:
                return sandbox.call(mending.mend, str(path), folder, order.spec, cue=order.cue, name=order.name)
        except audio_checks.MendRefused as refusal:
            return _refused(order, refusal)
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            log.warning("a mend failed", mend_id=str(order.mend_id), error=str(error))
    return None


def _refused(order: mends.MendOrder, refusal: audio_checks.MendRefused) -> dict[str, Any]:
    left = {"code": refusal.code, "severity": "error", "message": str(refusal), "why": f"{refusal}; {refusal.fix}."}
    return {"file": None, "name": order.name, "conforms": False, "repairs": [], "left": [left]}


def _time_for(master_bytes: int) -> float:
    """Return the seconds that a check may take, in steps, so that few sandboxes stand ready."""
    return BASE_TIME_S * (1 + math.ceil(master_bytes / BYTES_A_SECOND / BASE_TIME_S))


@cache
def _sandbox(timeout_s: float) -> audio_checks.Sandbox:
    return audio_checks.Sandbox(timeout_s=timeout_s, memory_bytes=MEMORY_BYTES, rehearsal=audio_checks.rehearse_check)
