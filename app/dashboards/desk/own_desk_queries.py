"""Queries of what a designer owes in all of their projects; each function is one SELECT."""

from collections.abc import Collection, Sequence
from datetime import date, datetime
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Row, String, and_, cast, exists, func, literal, or_, select, tuple_
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Person
from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Take, TakeCounts
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.projects.visibility import engaged_with_nda_accepted
from app.reviews.models import ChangeRequest, Comment, Feedback
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState

NO_DAY = date(9999, 12, 31)  # cues without a day are due last


def engaged_projects(session: Session, designer_id: UUID) -> Sequence[Project]:
    """Return the projects that a designer works on and whose list they see, with their studios."""
    return session.scalars(
        select(Project)
        .join(Engagement, Engagement.project_id == Project.id)
        .where(Engagement.designer_id == designer_id, engaged_with_nda_accepted(), Project.archived_at.is_(None))
        .options(joinedload(Project.studio))
    ).all()


def kept_facts(session: Session, project_ids: Collection[UUID], designer_id: UUID) -> Sequence[Row[str, int]]:
    """Return each pair of facts and number of variations that a designer's takes add up to."""
    of_designer = (in_array(TakeCounts.project_id, project_ids), TakeCounts.viewer_id == designer_id)
    return session.execute(select(TakeCounts.facts, TakeCounts.variations).where(*of_designer).distinct()).all()


class OwedRow(NamedTuple):
    """A cue that waits for its designer."""

    id: UUID
    project_id: UUID
    number: int
    name: str
    state: CueState
    variations: int
    placeholder: bool
    due_on: date | None
    is_asked: bool
    facts: str | None


def owed_cues(
    session: Session,
    project_ids: Collection[UUID],
    designer_id: UUID,
    *,
    owed: Collection[tuple[str, int]],
    after: tuple[date, UUID] | None,
    limit: int,
) -> list[OwedRow]:
    """Return the cues of projects without a take of a designer, or whose takes add up to what is owed, by day."""
    of_designer = and_(TakeCounts.cue_id == Cue.id, TakeCounts.viewer_id == designer_id)
    facts = TakeCounts.facts.concat(literal("/")).concat(cast(TakeCounts.variations, String))
    is_owed = in_array(facts, [f"{each}/{variations}" for each, variations in owed])
    asked = (Question.project_id == Cue.project_id, Question.cue_id == Cue.id, Question.answered_at.is_(None))
    due_on: ColumnElement[date] = func.coalesce(Cue.due_on, NO_DAY, type_=Cue.due_on.type)
    columns = (Cue.id, Cue.project_id, Cue.number, Cue.name, Cue.state, Cue.variations, Cue.placeholder, Cue.due_on)
    query = (
        select(*columns, exists().where(*asked), TakeCounts.facts)
        .join(TakeCounts, of_designer, isouter=True)
        .where(in_array(Cue.project_id, project_ids), Cue.state != CueState.CUT)
        .where(or_(TakeCounts.cue_id.is_(None), is_owed))
    )
    if after is not None:
        query = query.where(tuple_(due_on, Cue.id) > tuple_(*after))
    return [OwedRow._make(row) for row in session.execute(query.order_by(due_on, Cue.id).limit(limit))]


class Said(NamedTuple):
    """Something that was said on a designer's work for a cue, and by whom; nobody: the check."""

    cue_id: UUID
    at: datetime
    text: str
    by: str | None


def comments(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> list[Said]:
    """Return the newest comment on a designer's takes of each cue."""
    by = func.coalesce(Person.name, Comment.guest_name)
    rank = func.row_number().over(partition_by=Take.cue_id, order_by=(Comment.created_at.desc(), Comment.id.desc()))
    ranked = (
        select(Take.cue_id, Comment.created_at, Comment.text, by.label("by"), rank.label("place"))
        .select_from(Comment)
        .join(Take, Take.id == Comment.take_id)
        .join(Person, Person.id == Comment.written_by, isouter=True)
        .where(in_array(Take.cue_id, cue_ids), Take.designer_id == designer_id)
        .subquery()
    )
    rows = session.execute(
        select(ranked.c.cue_id, ranked.c.created_at, ranked.c.text, ranked.c.by).where(ranked.c.place == 1)
    )
    return [Said._make(row) for row in rows]


def changes(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> list[Said]:
    """Return the changes that were sent for a designer's takes of cues, the oldest first."""
    rows = session.execute(
        select(ChangeRequest.cue_id, Feedback.created_at, ChangeRequest.text, Person.name)
        .join(Feedback, Feedback.id == ChangeRequest.feedback_id)
        .join(Take, Take.id == ChangeRequest.take_id)
        .join(Person, Person.id == Feedback.sent_by)
        .where(in_array(ChangeRequest.cue_id, cue_ids), Take.designer_id == designer_id)
        .order_by(Feedback.created_at, ChangeRequest.created_at)
    )
    return [Said._make(row) for row in rows]


def answers(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> list[Said]:
    """Return the answers to a designer's questions on cues, the oldest first."""
    rows = session.execute(
        select(Question.cue_id, Question.answered_at, Question.answer, Person.name)
        .join(Person, Person.id == Question.answered_by)
        .where(in_array(Question.cue_id, cue_ids), Question.asked_by == designer_id)
        .where(Question.answered_at.is_not(None), Question.answer.is_not(None))
        .order_by(Question.answered_at)
    )
    return [Said(cue_id, at, text, by) for cue_id, at, text, by in rows if at is not None and text is not None]


def returned(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> Sequence[Row[Take, CheckRun]]:
    """Return a designer's takes that the check returned, with its reports, the oldest first."""
    return session.execute(
        select(Take, CheckRun)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(in_array(Take.cue_id, cue_ids), Take.designer_id == designer_id, Take.state == TakeState.RETURNED)
        .order_by(Take.state_since)
    ).all()
