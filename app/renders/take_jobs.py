"""Jobs of one take: its check, its picture and its game files."""

from collections.abc import Callable
from uuid import UUID

import structlog

from app.conformance.checking import check_take
from app.conformance.queries import fix_by_id
from app.conformance.workspaces import TakeWorkspace
from app.core import kill_points
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.deliveries.queries import take_with_cue
from app.renders import drawing, queries, service
from app.renders.batches import service as batches
from app.renders.children import children, in_child, retried, sandbox
from app.renders.making import RENDERS, make_missing
from app.renders.models import Picture
from app.renders.pictures import stored_picture
from audio_checks import (
    RenderRefused,
    SandboxFailed,
    Unreadable,
)

Step = Callable[[Runtime, UUID, TakeWorkspace], None]
_last_steps: list[Step] = []
log = structlog.get_logger(__name__)


def last_step(step: Step) -> Step:
    """Register a higher room's step on a received take, which the take's own job runs last, in the same child."""
    _last_steps.append(step)
    return step


@job("renders.prepare_take")
def prepare_take(runtime: Runtime, payload: Payload) -> None:
    """Check a received take and record its verdict; then draw it and make its game files, in the same child."""
    with TakeWorkspace(runtime.store, children()) as workspace:
        take_id = UUID(payload["take_id"])
        check_take(runtime, take_id, workspace)
        _make_renders(runtime, take_id, workspace)
        for step in _last_steps:
            step(runtime, take_id, workspace)


@job("renders.make_renders")
def make_renders(runtime: Runtime, payload: Payload) -> None:
    """Draw the master of a checked take and, of one that may ship, make the game files that its spec wants."""
    with TakeWorkspace(runtime.store, children()) as workspace:
        _make_renders(runtime, UUID(payload["take_id"]), workspace)


def _make_renders(runtime: Runtime, take_id: UUID, workspace: TakeWorkspace) -> None:
    """Make and record what a take lacks; a change made meanwhile schedules its own job."""
    with runtime.database.reading() as session:
        order = service.order_renders_and_drawing(session, take_id)
    if order is None:
        return
    kill_points.point("renders.before_render")
    renders, picture = make_missing(runtime, order, order.missing, workspace, draws=order.draws)
    kill_points.point("renders.after_render")
    with runtime.database.writing() as session:
        service.save_renders(session, renders, picture)
        if order.may_ship:
            service.complete(session, order)
        kill_points.point("renders.before_commit")
    kill_points.point("renders.after_commit")
    for render, _ in renders:
        RENDERS.labels(render.state.value).inc()


@job("renders.draw_fix")
def draw_fix(runtime: Runtime, payload: Payload) -> None:
    """Draw a fixed copy and make its preview, so that its designer sees and hears it before it is used."""
    with runtime.database.reading() as session:
        fix = fix_by_id(session, UUID(payload["fix_id"]))
        if fix is None or fix.sha256 is None:
            return
        if queries.picture_of(session, fix.studio_id, fix.sha256) is not None:
            return
        studio_id, sha256 = fix.studio_id, fix.sha256
        take = take_with_cue(session, fix.take_id)
        loop = take is not None and take.cue is not None and take.cue.loop
    with runtime.store.local_copy(studio_id, sha256) as master, runtime.store.making() as folder:
        try:
            drawn = retried(in_child(sandbox(), [master], [folder], drawing.draw, str(master), str(folder), loop=loop))
        except (Unreadable, RenderRefused, SandboxFailed) as error:
            log.info("a sound could not be drawn", sha256=sha256, error=str(error))
            picture = Picture(studio_id=studio_id, sound_sha256=sha256)
        else:
            picture = stored_picture(runtime, studio_id, sha256, folder, drawn)
    with runtime.database.writing() as session:
        service.save_renders(session, [], picture)


@job("renders.update_renders")
def update_renders(runtime: Runtime, payload: Payload) -> None:
    """Ask for the game files that a new spec or changed cues want of takes admitted before; old ones stay."""
    project_id = UUID(payload["project_id"])
    if "cue_ids" not in payload:
        with runtime.database.writing() as session:
            batches.start_for_spec(session, project_id)
        return
    with runtime.database.writing() as session:
        for take_id in queries.admitted_take_ids(session, project_id, [UUID(cue) for cue in payload["cue_ids"]]):
            runtime.queue.enqueue(
                session,
                "renders.make_renders",
                {"take_id": str(take_id)},
                key=f"{payload['event_id']}:renders.make_renders:{take_id}",
                studio_id=UUID(payload["studio_id"]),
                priority=BULK,
            )
