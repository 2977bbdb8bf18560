"""A take is judged: its report comes out of a child that may crash, hang or eat memory."""

from functools import cache
from typing import Any
from uuid import UUID

import structlog
from prometheus_client import Counter

import audio_checks
from app.conformance import fixes, queries, service
from app.conformance.rules import TRIES, Report, awaits_check, unjudged, with_reverb_before, with_stem
from app.conformance.service import CheckOrder, ComparedStem
from app.conformance.workspaces import TakeWorkspace
from app.core import kill_points
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.deliveries.rules import TakeState

log = structlog.get_logger(__name__)
BASE_TIME_S = 60
BYTES_A_SECOND = 8 << 20  # far slower than any machine that this runs on
MEMORY_BYTES = 1 << 30
TAKES_CHECKED = Counter("soundlist_takes_checked", "Takes that were judged, by verdict.", ["verdict"])


def check_take(runtime: Runtime, take_id: UUID, workspace: TakeWorkspace) -> None:
    """Check a received or adopted take against the newest spec and record its verdict, once; other takes are left."""
    with runtime.database.reading() as session:
        to_check = queries.take_to_check(session, take_id)
        if to_check is None or not awaits_check(
            to_check.take.state, is_checked=queries.current_run(session, take_id) is not None
        ):
            return
        order = service.order_check(session, to_check)
        report = service.known_report(session, order)
    kill_points.point("conformance.before_check")
    report = with_reverb_before(
        report or _checked(runtime, order, workspace), _compared_with_previous(runtime, order, workspace)
    )
    kill_points.point("conformance.after_check")
    with runtime.database.writing() as session:
        state = service.record_check(session, order, report)
        if state not in (None, TakeState.APPROVED) and report["verdict"] != "conforming":
            fixes.prepare_fix(session, order.take_id)
        kill_points.point("conformance.before_commit")
    if state is not None:
        TAKES_CHECKED.labels(report["verdict"]).inc()
    kill_points.point("conformance.after_commit")


def _checked(runtime: Runtime, order: CheckOrder, workspace: TakeWorkspace) -> Report:
    """Return the report of a child; after three failures, one that names it our fault.

    If only the comparison with a dry stem fails, the take is judged without it.
    """
    if order.stem is None:
        report, why = _tried(order, workspace, workspace.child(order.delivery_id))
        return report or unjudged(order.name, order.spec.category, why)
    report, why = _compared_with_stem(runtime, order, order.stem, workspace)
    failed = report is None
    if failed:
        log.warning("no comparison with a dry stem", take_id=str(order.take_id), error=why)
        report, why = _tried(order, workspace, workspace.child(order.delivery_id))
    return with_stem(report or unjudged(order.name, order.spec.category, why), order.stem.sha256, failed=failed)


def _compared_with_stem(
    runtime: Runtime, order: CheckOrder, stem: ComparedStem, workspace: TakeWorkspace
) -> tuple[Report | None, str]:
    """Return the report of a child that has the dry stem too, and why there is none after three failures."""
    try:
        with (
            runtime.store.local_copy(order.studio_id, stem.sha256) as path,
            # Reads the stem too, so it is not the child that goes on with the take.
            sandbox().child(reads=[workspace.master(order.studio_id, order.master_sha256), path]) as child,
        ):
            return _tried(order, workspace, child, audio_checks.DryStem(path, stem.name), stem.file_bytes)
    except (BlobAltered, BlobMissing) as error:
        return None, str(error)


def _tried(
    order: CheckOrder,
    workspace: TakeWorkspace,
    child: audio_checks.SandboxChild,
    dry: audio_checks.DryStem | None = None,
    dry_bytes: int = 0,
) -> tuple[Report | None, str]:
    """Return the report of a child, and why there is none after three failures."""
    child.timeout_s = time_for(order.master_bytes + dry_bytes)
    why = ""
    for _ in range(TRIES):
        try:
            path = workspace.master(order.studio_id, order.master_sha256)
            report = child.call(
                audio_checks.check_file,
                path,
                order.spec,
                cue=order.cue,
                name=order.name,
                all_figures=True,
                dry=dry,
                shipped=order.shipped,
            )
        except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
            why = str(error)
            continue
        return report.to_dict() | {"path": order.name}, ""
    return None, why


def _compared_with_previous(runtime: Runtime, order: CheckOrder, workspace: TakeWorkspace) -> dict[str, Any] | None:
    """Return the reverb of a take compared with an earlier one; None if there is none to compare with."""
    if order.before is None:
        return None
    try:
        path = workspace.master(order.studio_id, order.master_sha256)
        with (
            runtime.store.local_copy(order.studio_id, order.before.master_sha256) as before_path,
            # Reads another take's file too, so it is not the child that goes on with this one.
            sandbox().child(timeout_s=time_for(order.master_bytes), reads=[path, before_path]) as child,
        ):
            compared = child.call(audio_checks.compare_reverb_of_takes, path, before_path)
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
