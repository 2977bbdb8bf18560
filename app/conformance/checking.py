"""A take is judged: its report comes out of a child that may crash, hang or eat memory."""

from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar
from uuid import UUID

import structlog
from prometheus_client import Counter
from sqlalchemy.orm import Session

import audio_checks
from app.conformance import mends, queries, service
from app.conformance.benches import Bench
from app.conformance.rules import TRIES, Report, unjudged, with_reverb_before, with_stem
from app.conformance.service import CheckOrder, StemBeside
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.kit import kill
from app.kit.runtime import Runtime
from app.kit.storage import BlobAltered, BlobMissing
from app.projects.models import Spec

Seen = TypeVar("Seen")
log = structlog.get_logger(__name__)
BASE_TIME_S = 60
BYTES_A_SECOND = 8 << 20  # far slower than any machine that this runs on
MEMORY_BYTES = 1 << 30
TAKES_CHECKED = Counter("soundlist_takes_checked", "Takes that were judged, by verdict.", ["verdict"])


def judge(
    runtime: Runtime, take_id: UUID, bench: Bench, beside: Callable[[Session, Take, Spec], Seen]
) -> tuple[TakeState, Seen] | None:
    """Check a received take against the newest spec and record its verdict, once; one that waits for none is left.

    Return what the verdict made of the take, and what `beside` saw of it before, in the moment of the check's order.
    """
    with runtime.database.reading() as session:
        found = queries.take_to_check(session, take_id)
        if found is None or found.take.state is not TakeState.RECEIVED:
            return None
        order = service.order_check(session, found)
        report = service.known_report(session, order)
        seen = beside(session, found.take, found.spec)
    kill.point("conformance.before_check")
    report = with_reverb_before(report or _checked(runtime, order, bench), _beside_before(runtime, order, bench))
    kill.point("conformance.after_check")
    with runtime.database.writing() as session:
        state = service.record_check(session, order, report)
        if state is not None and report["verdict"] != "conforming":
            mends.make_ready(session, order.take_id)
        kill.point("conformance.before_commit")
    if state is not None:
        TAKES_CHECKED.labels(report["verdict"]).inc()
    kill.point("conformance.after_commit")
    return None if state is None else (state, seen)


def _checked(runtime: Runtime, order: CheckOrder, bench: Bench) -> Report:
    """Return the report of a child; after three failures, one that says that it is our fault.

    Where only the comparison with a dry stem fails, the take is judged without it.
    """
    if order.stem is None:
        report, why = _tried(order, bench, bench.child(order.delivery_id))
        return report or unjudged(order.name, order.spec.category, why)
    report, why = _beside_stem(runtime, order, order.stem, bench)
    failed = report is None
    if failed:
        log.warning("no comparison with a dry stem", take_id=str(order.take_id), error=why)
        report, why = _tried(order, bench, bench.child(order.delivery_id))
    return with_stem(report or unjudged(order.name, order.spec.category, why), order.stem.sha256, failed=failed)


def _beside_stem(runtime: Runtime, order: CheckOrder, stem: StemBeside, bench: Bench) -> tuple[Report | None, str]:
    """Return the report of a child that has the dry stem too, and why there is none after three failures."""
    try:
        with (
            runtime.store.local_copy(order.studio_id, stem.sha256) as path,
            # Reads the stem too, so it is not the child that goes on with the take.
            sandbox().child(reads=[bench.master(order.studio_id, order.master_sha256), path]) as child,
        ):
            return _tried(order, bench, child, audio_checks.DryStem(path, stem.name), stem.file_bytes)
    except (BlobAltered, BlobMissing) as error:
        return None, str(error)


def _tried(
    order: CheckOrder,
    bench: Bench,
    child: audio_checks.SandboxChild,
    dry: audio_checks.DryStem | None = None,
    dry_bytes: int = 0,
) -> tuple[Report | None, str]:
    """Return the report of a child, and why there is none after three failures."""
    child.timeout_s = time_for(order.master_bytes + dry_bytes)
    why = ""
    for _ in range(TRIES):
        try:
            path = bench.master(order.studio_id, order.master_sha256)
            report = child.call(
                audio_checks.check_file, path, order.spec, cue=order.cue, name=order.name, all_figures=True, dry=dry
            )
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            why = str(error)
            continue
        return report.to_dict() | {"path": order.name}, ""
    return None, why


def _beside_before(runtime: Runtime, order: CheckOrder, bench: Bench) -> dict[str, Any] | None:
    """Return what the reverb of a take is beside that of an earlier one; None where there is none to compare with."""
    if order.before is None:
        return None
    try:
        path = bench.master(order.studio_id, order.master_sha256)
        with (
            runtime.store.local_copy(order.studio_id, order.before.master_sha256) as before_path,
            # Reads another take's file too, so it is not the child that goes on with this one.
            sandbox().child(timeout_s=time_for(order.master_bytes), reads=[path, before_path]) as child,
        ):
            compared = child.call(audio_checks.reverb_between, path, before_path)
    except (audio_checks.Unreadable, audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
        log.warning("no comparison with an earlier take", take_id=str(order.take_id), error=str(error))
        return None
    return compared.to_dict() | {"take_id": str(order.before.take_id), "number": order.before.number}


def time_for(master_bytes: int) -> float:
    """Return the seconds that a check may take."""
    return BASE_TIME_S + master_bytes / BYTES_A_SECOND


@cache
def sandbox() -> audio_checks.Sandbox:
    """Return the sandbox of what reads masters and draws nothing."""
    return audio_checks.Sandbox(memory_bytes=MEMORY_BYTES, rehearsal=audio_checks.rehearse_check)
