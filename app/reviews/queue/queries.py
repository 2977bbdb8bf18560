"""The review queue with all that its cards show, read in few columns; callers have checked access."""

from collections.abc import Collection, Mapping
from datetime import date, datetime, timedelta
from functools import cache
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import (
    ColumnElement,
    ScalarSelect,
    Select,
    String,
    and_,
    case,
    cast,
    exists,
    false,
    func,
    or_,
    select,
    tuple_,
)
from sqlalchemy.orm import InstrumentedAttribute, Session, aliased
from sqlalchemy.sql.functions import aggregate_strings

from app.core.exists import row_exists
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Project, Spec
from app.projects.rules import ApprovalScope
from app.renders.models import Picture, RenderSet
from app.reviews.models import ChangeRequest, Comment, NoteAnswer, Round
from app.reviews.queries import answers_nothing
from app.sound_lists.models import Cue
from app.sound_lists.rules import NO_PLAYBACK_PRIORITY, CueState, Need

URGENT_BEFORE = timedelta(days=7)
NEED_ORDER = (Need.MUST, Need.SHOULD, Need.WISH)
STRETCH = 3  # takes looked at for one cue that is wanted: most of what conforms waits, some cues have several


def in_project(project_id: UUID) -> ColumnElement[bool]:
    """Admit the takes of one project."""
    return Take.project_id == project_id


def in_studios(studio_ids: Collection[UUID]) -> ColumnElement[bool]:
    """Admit the takes of some studios."""
    return _one_of(Take.studio_id, studio_ids)


def _one_of(column: InstrumentedAttribute[UUID], ids: Collection[UUID]) -> ColumnElement[bool]:
    """Admit rows of some ids; those of one alone are in the order of their index, and none is sorted."""
    return column == next(iter(ids)) if len(ids) == 1 else in_array(column, ids)


def _newest_spec_id() -> ScalarSelect[UUID]:
    newer = aliased(Spec)
    return (
        select(newer.id)
        .where(newer.project_id == Take.project_id)
        .order_by(newer.version.desc())
        .limit(1)
        .correlate(Take)
        .scalar_subquery()
    )


def in_scope(project_id: UUID, scope: ApprovalScope) -> ColumnElement[bool]:
    """Admit the takes of one project whose cue a person approves; all of them for who approves none."""
    if scope.is_all or not scope.is_any:
        return in_project(project_id)
    category = select(Cue.category).where(Cue.id == Take.cue_id).correlate(Take).scalar_subquery()
    approved = category.not_in(scope.others) if scope.rest else category.in_(scope.own)
    return and_(in_project(project_id), approved)


def in_scopes(scopes: Mapping[UUID, ApprovalScope]) -> ColumnElement[bool]:
    """Admit the takes of projects whose cue a person approves; all of a project where they approve none."""
    whole = [project_id for project_id, scope in scopes.items() if scope.is_all or not scope.is_any]
    parts = [in_scope(project_id, scope) for project_id, scope in scopes.items() if scope.is_any and not scope.is_all]
    return or_(_one_of(Take.project_id, whole), *parts)


@cache
def waits() -> ColumnElement[bool]:
    """Return the condition of waiting: conforming, cue not cut, drawn, every render made or refused."""
    made = select(RenderSet.take_id).where(
        RenderSet.take_id == Take.id, RenderSet.edition == Take.edition, RenderSet.spec_id == _newest_spec_id()
    )
    rendered = row_exists(made, Take)  # of EXISTS PostgreSQL may gather all that was ever rendered
    drawn = exists().where(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256)
    is_listed = exists().where(Cue.id == Take.cue_id, Cue.state != CueState.CUT)
    return and_(Take.state == TakeState.CONFORMING, is_listed.correlate(Take), drawn.correlate(Take), rendered)


class WaitingCue(NamedTuple):
    """A cue that waits for the approver, since its first take does."""

    id: UUID
    since: datetime
    take_ids: list[UUID]  # all that wait


class QueuePlace(NamedTuple):
    """A place in the queue: what comes first is urgent, needed most, of the highest priority, and waits longest."""

    urgency: int  # 0: of the palette, or due in a week; 1: neither
    need: int  # its place among NEED_ORDER
    priority: int  # the playback priority, 0 first; NO_PLAYBACK_PRIORITY where the list gives none
    since: datetime
    cue_id: UUID

    @property
    def is_urgent(self) -> bool:
        """Whether others wait for the cue."""
        return self.urgency == 0


def queued_cues(
    session: Session, reach: ColumnElement[bool], today: date, *, after: QueuePlace | None, limit: int
) -> list[tuple[QueuePlace, WaitingCue]]:
    """Return the cues that takes wait for, in the order of the queue.

    Others wait for what is urgent: the palette, by which other cues are judged, and what is due in a week. Then come
    need, playback priority, and the time since when it waits. What conforms is sorted a stretch at a time, before the
    dearer question whether it waits is asked of that stretch.
    """
    urgency = case((or_(Cue.palette, Cue.due_on <= today + URGENT_BEFORE), 0), else_=1)
    need = case({need: rank for rank, need in enumerate(NEED_ORDER)}, value=Cue.need, else_=len(NEED_ORDER))
    priority = func.coalesce(Cue.playback_priority, NO_PLAYBACK_PRIORITY)
    order = (urgency, need, priority, Take.state_since, Take.cue_id, Take.id)
    walk = (
        select(*order)
        .join(Cue, Cue.id == Take.cue_id)
        .where(reach, Take.state == TakeState.CONFORMING)
        .order_by(*order)
        .limit(STRETCH * limit)
    )
    stretch = walk if after is None else walk.where(tuple_(*order[:-1]) > tuple_(*after))
    queued: list[tuple[QueuePlace, WaitingCue]] = []
    while len(queued) < limit:
        rows = session.execute(stretch).all()
        by_cue = _waiting_by_cue(session, {cue_id for *_, cue_id, _ in rows if cue_id is not None})
        queued += [
            (QueuePlace._make((*ranks, since, cue_id)), WaitingCue(cue_id, since, by_cue[cue_id]))
            for *ranks, since, cue_id, take_id in rows
            if cue_id in by_cue and take_id == by_cue[cue_id][0]
        ]
        if len(rows) < STRETCH * limit:
            break
        stretch = walk.where(tuple_(*order) > tuple_(*rows[-1]))
    return queued[:limit]


def waiting_cues(
    session: Session, reach: ColumnElement[bool], *, after: tuple[datetime, UUID] | None, limit: int
) -> list[WaitingCue]:
    """Return the cues that takes wait for, oldest first.

    Walks the takes in order of waiting, a stretch at a time, and keeps the first of each cue: a page costs the same
    however long the queue is. Left to itself PostgreSQL reads all that conforms before it sorts.
    """
    order = (Take.state_since, Take.cue_id, Take.id)
    walk = select(*order).where(reach, Take.state == TakeState.CONFORMING).order_by(*order).limit(STRETCH * limit)
    stretch = walk if after is None else walk.where(tuple_(*order[:2]) > tuple_(*after))
    waiting: list[WaitingCue] = []
    while len(waiting) < limit:
        rows = session.execute(stretch).all()
        by_cue = _waiting_by_cue(session, {cue_id for _, cue_id, _ in rows if cue_id is not None})
        waiting += [
            WaitingCue(cue_id, since, by_cue[cue_id])
            for since, cue_id, take_id in rows
            if cue_id in by_cue and take_id == by_cue[cue_id][0]
        ]
        if len(rows) < STRETCH * limit:
            break
        stretch = walk.where(tuple_(*order) > tuple_(*rows[-1]))
    return waiting[:limit]


def _waiting_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, list[UUID]]:
    """Return the takes of some cues that wait, by cue, those first that wait longest."""
    by_cue: dict[UUID, list[UUID]] = {}
    for cue_id, take_id in session.execute(_waiting(), {"cue_ids": cue_ids}):
        if cue_id is not None:
            by_cue.setdefault(cue_id, []).append(take_id)
    return by_cue


# Statements of a page are built once: that takes longer than to send them.
@cache
def _waiting() -> Select[UUID | None, UUID]:
    waiting = select(Take.cue_id, Take.id).where(in_array(Take.cue_id, "cue_ids"), waits())
    return waiting.order_by(Take.state_since, Take.id)


class CueOnReview(NamedTuple):
    """The facts of a cue that a card of the queue shows in addition to its takes."""

    prefix: str  # the letters that cue numbers of its project start with
    rounds: int
    open_requests: int  # notes on versions before those that wait, not done
    open_comments: int
    approved: list[int]  # the variations that have their approved take
    is_changed: bool  # something was sent of it


def cues_on_review(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, CueOnReview]:
    """Return these facts of some cues."""
    rows = session.execute(_cues_on_review(), {"cue_ids": cue_ids})
    return {
        cue_id: CueOnReview(prefix, rounds, requests, comments, sorted(map(int, (approved or "").split())), is_changed)
        for cue_id, prefix, rounds, requests, comments, approved, is_changed in rows
    }


@cache
def _cues_on_review() -> Select[UUID, str, int, int, int, str | None, bool]:
    rounds = select(func.count(Round.number)).where(Round.cue_id == Cue.id)
    variations = aggregate_strings(cast(Take.variation, String), " ")
    approved = select(variations).where(Take.cue_id == Cue.id, Take.state == TakeState.APPROVED)
    changed = select(ChangeRequest.id).where(ChangeRequest.cue_id == Cue.id, ChangeRequest.feedback_id.is_not(None))
    return (
        select(
            *(Cue.id, Project.cue_prefix),
            *(query.correlate(Cue).scalar_subquery() for query in (rounds, *_open_notes(), approved)),
            row_exists(changed, Cue),
        )
        .join(Project, Project.id == Cue.project_id)
        .where(in_array(Cue.id, "cue_ids"))
    )


def _open_notes() -> tuple[Select[int], Select[int]]:
    """Count the change requests and comments of a cue that later versions, which wait, have not done."""
    before, after = aliased(Take), aliased(Take)
    later = exists().where(
        *(after.cue_id == before.cue_id, after.variation == before.variation, after.number > before.number),
        after.state == TakeState.CONFORMING,
    )
    asked_of = (before.cue_id == Cue.id, before.state == TakeState.CHANGE_REQUESTED, later)
    last = select(NoteAnswer.is_done).order_by(NoteAnswer.id.desc()).limit(1)
    done = last.where(NoteAnswer.change_request_id == ChangeRequest.id).correlate(ChangeRequest).scalar_subquery()
    requests = (
        select(func.count())
        .select_from(ChangeRequest)
        .join(before, before.id == ChangeRequest.take_id)
        .where(*asked_of, ChangeRequest.feedback_id.is_not(None), func.coalesce(done, false()).is_(False))
    )
    comments = (
        select(func.count())
        .select_from(Comment)
        .join(before, before.id == Comment.take_id)
        .where(*asked_of, Comment.resolved_at.is_(None))
        .where(answers_nothing())
        .where(Comment.written_by != before.designer_id)
    )
    return requests, comments


def last_changes(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the last requests for cues, of which something was sent."""
    return {cue_id: text for cue_id, text in session.execute(_sent(), {"cue_ids": cue_ids})}  # noqa: C416  a Row is no pair to dict's types


@cache
def _sent() -> Select[UUID, str]:
    sent = (in_array(ChangeRequest.cue_id, "cue_ids"), ChangeRequest.feedback_id.is_not(None))
    return select(ChangeRequest.cue_id, ChangeRequest.text).where(*sent).order_by(ChangeRequest.id)
