"""Jobs of a batch: all game files at a new spec."""

from uuid import UUID

from app.conformance.workspaces import TakeWorkspace
from app.core import kill_points
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.renders.batches import service as batches
from app.renders.children import children
from app.renders.making import RENDERS, make_missing


@job("renders.plan_batch")
def plan_batch(runtime: Runtime, payload: Payload) -> None:
    """Write down every game file that a batch is about, in one go."""
    with runtime.database.writing() as session:
        batches.plan(session, UUID(payload["batch_id"]))
        kill_points.point("renders.batch_planned")


@job(batches.RENDER_NEXT)
def render_next_of_batch(runtime: Runtime, payload: Payload) -> None:
    """Make the next game file of one lane of a batch."""
    batch_id, lane = UUID(payload["batch_id"]), int(payload["lane"])
    with runtime.database.reading() as session:
        order = batches.order_next(session, batch_id, lane)
    if order is None:
        return
    render, picture, fault = None, None, ""
    if order.take is not None and order.recipe is not None:
        try:
            with TakeWorkspace(runtime.store, children()) as workspace:
                ((render, picture),), _ = make_missing(
                    runtime, order.take, {order.target: order.recipe}, workspace, draws=False
                )
            RENDERS.labels(render.state.value).inc()
        except (BlobAltered, BlobMissing) as error:  # one lost master must not hold up the others
            fault = str(error)
    kill_points.point("renders.batch_item_made")
    with runtime.database.writing() as session:
        batches.record(session, order, lane, render, picture, fault)
        kill_points.point("renders.batch_before_commit")
    kill_points.point("renders.batch_after_commit")
