"""Batches: every game file of a project rendered again in one action, one by one, each recorded before the next.

A batch is planned in one go and then walked in a few lanes. Each lane is one job at a time, which writes its
successor with what it made: so single uploads go first, nothing is made twice after a kill, and to cancel a batch
is to change one row.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.events import publish
from app.core.jobs.queue import BULK, queue_of
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.errors import ProjectNotFound
from app.projects.models import Project, Spec
from app.projects.queries import current_spec, lock_project, project_by_id
from app.projects.service import project_access
from app.renders import queries, service
from app.renders.errors import BatchEnded, BatchNotFound, NothingToRender, TargetUnknown
from app.renders.models import Batch, BatchItem, Picture, Render, RenderSet
from app.renders.rules import OPEN_BATCHES, BatchState, ItemState, Recipe, RenderState, recipes
from app.renders.schemas import BatchRead, BatchSizes, BatchSummary, BatchTrouble
from app.sound_lists.rules import label

LANES = 4
TROUBLE_SHOWN = 100
RENDER_NEXT = "renders.render_next_of_batch"
CHECKED_FIRST = "its version may not ship at the moment; its game files are made once it may"
MOVED_ON = "the spec has changed; the batch of the newer spec makes it"


def request_batch(session: Session, actor: Actor, project_id: UUID, targets: Sequence[str]) -> Batch:
    """Begin a batch over everything that may ship; raise NothingToRender where there is nothing, or no target."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    access.ensure_may_speak()
    target_names = list(queries.parsed_spec(current_spec(session, project_id).toml).targets)
    unknown = [target for target in targets if target not in target_names]
    if unknown:
        raise TargetUnknown(f'the spec has no target "{unknown[0]}"; it has {", ".join(target_names) or "none"}')
    if not target_names or not queries.has_admitted_takes(session, project_id):
        missing = "version conforms" if target_names else "target is in the spec"
        raise NothingToRender(f"no {missing} yet, so there is no game file to make")
    return begin(session, access.project, asked_by=actor.person, targets=targets)


def begin(session: Session, project: Project, *, asked_by: UUID | None, targets: Sequence[str] = ()) -> Batch:
    """Open a batch and schedule its plan; a running one of the project ends."""
    lock_project(session, project.id)
    number = queries.last_batch_number(session, project.id) + 1
    for earlier in queries.open_batches(session, project.id):
        _end(earlier, BatchState.CANCELLED, f"batch {number} took its place")
    batch = Batch(
        studio_id=project.studio_id, project_id=project.id, number=number, targets=list(targets), asked_by=asked_by
    )
    session.add(batch)
    session.flush()
    publish(session, "batch.asked", studio_id=project.studio_id, priority=BULK, batch_id=batch.id)
    return batch


def _end(batch: Batch, state: BatchState, note: str = "") -> None:
    batch.state, batch.ended_at, batch.note = state, clock.now(), note


def plan(session: Session, batch_id: UUID) -> None:
    """Write down every game file that a batch is about, once, and start its lanes."""
    batch = queries.batch_by_id(session, batch_id, locked=True)
    if batch is None or batch.state is not BatchState.PLANNING:
        return
    spec = current_spec(session, batch.project_id)
    takes = queries.admitted_takes(session, batch.project_id)
    items = planned_items(session, batch, spec, takes)
    if items:
        session.execute(sa.insert(BatchItem), items)
    batch.spec_id, batch.state = spec.id, BatchState.RUNNING
    waiting = {item["take_id"] for item in items if item["state"] is ItemState.WAITING}
    for take in takes:  # what lacks nothing at the newest spec goes on to its review
        if take.state is TakeState.CONFORMING and not batch.targets and take.id not in waiting:
            session.merge(RenderSet(take_id=take.id, studio_id=take.studio_id, spec_id=spec.id, edition=take.edition))
    session.flush()
    for lane in range(LANES):
        _ask_for_next(session, batch, lane)
    _end_when_done(session, batch)


def planned_items(session: Session, batch: Batch, spec: Spec, takes: Sequence[Take]) -> list[dict[str, object]]:
    """Return a row for each take and target: what there was, and whether it is already what is wanted."""
    whole = queries.parsed_spec(spec.toml)
    so_far = queries.renders_so_far(session, batch.project_id)

    @cache
    def wanted(category: str | None, loop: bool) -> Mapping[str, Recipe]:
        return recipes(whole, category=category, loop=loop)

    items: list[dict[str, object]] = []
    for take in takes:
        if take.cue is None:
            continue
        category = take.cue.category or whole.category_of(take.file_name)
        for target, recipe in wanted(category, take.cue.loop).items():
            if batch.targets and target not in batch.targets:
                continue
            key = recipe.key(take.master_sha256)
            there = so_far.get((take.id, target), [])
            same_render = next((render for render in there if render.key == key), None)
            before = next(
                (render for render in reversed(there) if render.key != key and render.file_bytes is not None),
                same_render,
            )
            items.append(
                {
                    "batch_id": batch.id,
                    "place": len(items),
                    "studio_id": batch.studio_id,
                    "take_id": take.id,
                    "target": target,
                    "category": category or "",
                    "state": _planned_state(same_render.state if same_render else None),
                    "before_bytes": before.file_bytes if before else None,
                    "after_bytes": same_render.file_bytes if same_render else None,
                    "reason": (same_render.refusal or "") if same_render else "",
                }
            )
    return items


def _planned_state(state: RenderState | None) -> ItemState:
    if state is None:
        return ItemState.WAITING
    return ItemState.KEPT if state is RenderState.MADE else ItemState.REFUSED


@dataclass(frozen=True)
class ItemOrder:
    """The next game file of a lane."""

    batch_id: UUID
    place: int
    target: str
    take: service.RenderOrder | None  # None: it may not ship at the moment

    @property
    def recipe(self) -> Recipe | None:
        """Return the recipe of the file; None if it exists, or is no longer needed."""
        return self.take.missing.get(self.target) if self.take else None


def order_next(session: Session, batch_id: UUID, lane: int) -> ItemOrder | None:
    """Return the next order of a lane; None where it is at its end, or the batch is over."""
    item = queries.next_item(session, batch_id, lane, LANES)
    if item is None:
        return None
    return ItemOrder(batch_id, item.place, item.target, service.order_renders(session, item.take_id))


def record(
    session: Session, order: ItemOrder, lane: int, render: Render | None, picture: Picture | None, fault: str = ""
) -> None:
    """Record one game file and its result, and schedule the lane's next."""
    batch = queries.batch_by_id(session, order.batch_id, locked=True)
    item = session.get(BatchItem, (order.batch_id, order.place))
    if batch is None or item is None:
        return
    if render is not None:
        service.save_renders(session, [(render, picture)])
    if item.state is ItemState.WAITING:
        _become(item, order, render, fault)
        session.flush()
    if order.take is not None and not fault and order.take.missing.keys() <= {order.target}:
        service.complete(session, order.take)
    if batch.state is BatchState.RUNNING:
        _ask_for_next(session, batch, lane)
        _end_when_done(session, batch)


def _become(item: BatchItem, order: ItemOrder, render: Render | None, fault: str) -> None:
    if fault:
        item.state, item.reason = ItemState.LEFT, fault
        return
    there = render or (order.take.there.get(order.target) if order.take else None)
    if there is None:
        item.state, item.reason = ItemState.LEFT, MOVED_ON if order.take else CHECKED_FIRST
        return
    kept_or_refused = _planned_state(there.state)
    item.state = ItemState.MADE if render and kept_or_refused is ItemState.KEPT else kept_or_refused
    item.after_bytes, item.reason = there.file_bytes, there.refusal or ""


def _ask_for_next(session: Session, batch: Batch, lane: int) -> None:
    item = queries.next_item(session, batch.id, lane, LANES)
    if item is not None:
        queue_of(session).enqueue(
            session,
            RENDER_NEXT,
            {"batch_id": str(batch.id), "lane": lane},
            key=f"{batch.id}:{RENDER_NEXT}:{item.place}",
            studio_id=batch.studio_id,
            priority=BULK,
        )


def _end_when_done(session: Session, batch: Batch) -> None:
    if not queries.has_waiting_items(session, batch.id):
        _end(batch, BatchState.DONE)


def cancel(session: Session, actor: Actor, batch_id: UUID) -> Batch:
    """End a batch; what it has made stays."""
    batch = visible_batch(session, actor, batch_id)
    project_access(session, actor, batch.project_id).ensure_may_speak()
    batch = queries.batch_by_id(session, batch.id, locked=True) or batch
    if batch.state not in OPEN_BATCHES:
        raise BatchEnded(f"batch {batch.number} is {batch.state} already", fix="read it again")
    _end(batch, BatchState.CANCELLED, "cancelled by hand")
    return batch


def visible_batch(session: Session, actor: Actor, batch_id: UUID) -> Batch:
    """Return a batch; raise BatchNotFound without sight of its project."""
    batch = queries.batch_by_id(session, batch_id)
    if batch is None:
        raise BatchNotFound(f"no batch {batch_id}")
    try:
        access = project_access(session, actor, batch.project_id)
    except ProjectNotFound:
        raise BatchNotFound(f"no batch {batch_id}") from None
    access.ensure_team()
    return batch


def start_for_spec(session: Session, project_id: UUID) -> None:
    """Open the batch for a changed spec; none if nothing may ship yet."""
    project = project_by_id(session, project_id)
    if project is not None and queries.has_admitted_takes(session, project_id):
        begin(session, project, asked_by=None)


def summaries(session: Session, batches: Sequence[Batch]) -> list[BatchSummary]:
    """Return batches as a list shows them."""
    counts = queries.item_counts(session, [batch.id for batch in batches])
    return [BatchSummary(**_summary(batch, counts[batch.id])) for batch in batches]


def _summary(batch: Batch, counts: Mapping[ItemState, int]) -> dict[str, Any]:
    return {
        "id": batch.id,
        "number": batch.number,
        "state": batch.state,
        "targets": batch.targets,
        "by_spec": batch.asked_by is None,
        "note": batch.note,
        "created_at": batch.created_at,
        "ended_at": batch.ended_at,
        "files": sum(counts.values()),
        **{state.value: counts.get(state, 0) for state in ItemState},
    }


def batch_read(session: Session, batch: Batch) -> BatchRead:
    """Return a batch with its sizes and its trouble."""
    counts = queries.item_counts(session, [batch.id])[batch.id]
    prefix = session.get_one(Project, batch.project_id).cue_prefix
    return BatchRead(
        **_summary(batch, counts),
        sizes=[
            BatchSizes(target=target, category=category, files=files, before_bytes=before or 0, after_bytes=after or 0)
            for target, category, files, before, after in queries.item_sizes(session, batch.id)
        ],
        trouble=[
            BatchTrouble(cue=label(prefix, number), name=name, target=item.target, reason=item.reason)
            for item, number, name in queries.items_without_file(session, batch.id, limit=TROUBLE_SHOWN)
        ],
    )


def batches_in(session: Session, actor: Actor, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Batch]:
    """Return the batches of a project, the newest first."""
    project_access(session, actor, project_id).ensure_team()
    return queries.batches_of(session, project_id, before=before, limit=limit)
