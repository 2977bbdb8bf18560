"""The jobs of this room: checks in a throw-away child that may crash, hang or eat memory."""

import math
from functools import cache
from uuid import UUID

from prometheus_client import Counter

import audio_checks
from app.conformance import queries, service
from app.conformance.rules import TRIES, Report, unjudged
from app.conformance.service import CheckOrder
from app.kit import kill
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.kit.storage import BlobMissing

BASE_TIME_S = 60
BYTES_A_SECOND = 8 << 20  # far slower than any machine that this runs on
MEMORY_BYTES = 1 << 30
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
    report = report or _checked(runtime, order)
    kill.point("conformance.after_check")
    with runtime.database.writing() as session:
        is_news = service.record_check(session, order, report)
        kill.point("conformance.before_commit")
    if is_news:
        TAKES_CHECKED.labels(report["verdict"]).inc()
    kill.point("conformance.after_commit")


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
        except (audio_checks.SandboxFailed, BlobMissing) as error:
            why = str(error)
            continue
        return report.to_dict() | {"path": order.name}
    return unjudged(order.name, order.spec.category, why)


def _time_for(master_bytes: int) -> float:
    """Return the seconds that a check may take, in steps, so that few sandboxes stand ready."""
    return BASE_TIME_S * (1 + math.ceil(master_bytes / BYTES_A_SECOND / BASE_TIME_S))


@cache
def _sandbox(timeout_s: float) -> audio_checks.Sandbox:
    return audio_checks.Sandbox(timeout_s=timeout_s, memory_bytes=MEMORY_BYTES)
