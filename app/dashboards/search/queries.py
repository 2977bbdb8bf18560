"""Queries of the search: what holds the words that a person typed, in one project or in all others."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import Row, Select, or_, select
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Person
from app.accounts.rules import Actor
from app.core.icontains import icontains
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.projects.models import Engagement, Project
from app.projects.visibility import visible_list, visible_work
from app.reviews.models import Comment
from app.sound_lists.models import Cue, Question

HITS = 20
CUE_TEXTS = (Cue.name, Cue.use, Cue.description, Cue.category)


def find_cues(session: Session, project_id: UUID, words: Sequence[str]) -> Sequence[Cue]:
    """Return the cues whose name, use or description holds every word."""
    query = select(Cue).where(Cue.project_id == project_id)
    for word in words:
        query = query.where(or_(*(icontains(text, word) for text in CUE_TEXTS)))
    return session.scalars(query.order_by(Cue.number).limit(HITS)).all()


def find_files(
    session: Session, project_id: UUID, designer_id: UUID | None, words: Sequence[str], *, limit: int
) -> Sequence[Row[Take, Cue | None]]:
    """Return the newest takes whose file name holds every word, with their cue; of one designer where one is given."""
    take_ids = _named(words, limit).where(Take.project_id == project_id)
    if designer_id is not None:
        take_ids = take_ids.where(Take.designer_id == designer_id)
    return session.execute(
        select(Take, Cue)
        .join(Cue, Cue.id == Take.cue_id, isouter=True)
        .where(Take.id.in_(take_ids))
        .order_by(Take.id.desc())
    ).all()


def _named(words: Sequence[str], limit: int) -> Select[UUID]:
    """Return the query of the newest takes by their names: an index has all that it looks at."""
    is_named = (icontains(Take.file_name, word) for word in words)
    return select(Take.id).where(Take.discarded_at.is_(None), *is_named).order_by(Take.id.desc()).limit(limit)


def projects_elsewhere(session: Session, actor: Actor, *, except_in: UUID | None) -> Sequence[UUID]:
    """Return the ids of all projects that show the caller their list, but one: by them rows are found by an index."""
    seen = select(Project.id).where(visible_list(actor, studio_id=Project.studio_id, project_id=Project.id))
    if except_in is not None:
        seen = seen.where(Project.id != except_in)
    return session.scalars(seen).all()


def find_cues_elsewhere(
    session: Session, project_ids: Sequence[UUID], words: Sequence[str]
) -> Sequence[Row[Cue, Project]]:
    """Return cues of some projects that have every word in their texts, those of the newest project first."""
    query = (
        select(Cue, Project)
        .join(Project, Project.id == Cue.project_id)
        .where(in_array(Cue.project_id, project_ids))
        .where(*(or_(*(icontains(text, word) for text in CUE_TEXTS)) for word in words))
    )
    return session.execute(query.order_by(Cue.project_id.desc(), Cue.number).limit(HITS)).all()


def find_files_elsewhere(
    session: Session, actor: Actor, project_ids: Sequence[UUID], words: Sequence[str], *, limit: int
) -> Sequence[Row[Take, Cue | None, Project]]:
    """Return the newest takes of some projects that have every word in their file name, as far as the caller sees."""
    is_visible = visible_work(actor, studio_id=Take.studio_id, project_id=Take.project_id, designer_id=Take.designer_id)
    return session.execute(
        select(Take, Cue, Project)
        .join(Project, Project.id == Take.project_id)
        .join(Cue, Cue.id == Take.cue_id, isouter=True)
        .where(Take.id.in_(_named(words, limit).where(in_array(Take.project_id, project_ids), is_visible)))
        .order_by(Take.id.desc())
    ).all()


def find_people(session: Session, studio_id: UUID, project_id: UUID, phrase: str, *, limit: int) -> Sequence[Person]:
    """Return members of the studio and designers of the project whose name or address holds a phrase."""
    members = select(Membership.person_id).where(Membership.studio_id == studio_id)
    designers = select(Engagement.designer_id).where(Engagement.project_id == project_id)
    return session.scalars(
        select(Person)
        .where(or_(Person.id.in_(members), Person.id.in_(designers)))
        .where(or_(icontains(Person.name, phrase), icontains(Person.email, phrase)))
        .order_by(Person.name, Person.id)
        .limit(limit)
    ).all()


def find_comments(
    session: Session, project_id: UUID, designer_id: UUID | None, phrase: str, *, limit: int
) -> Sequence[Row[Comment, Cue]]:
    """Return the newest comments that hold a phrase, with their cue; on takes of one designer where one is given."""
    query = (
        select(Comment, Cue)
        .join(Take, Take.id == Comment.take_id)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Comment.project_id == project_id, icontains(Comment.text, phrase))
    )
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return session.execute(query.order_by(Comment.id.desc()).limit(limit)).all()


def find_questions(session: Session, project_id: UUID, phrase: str, *, limit: int) -> Sequence[Row[Question, Cue]]:
    """Return the newest questions that hold a phrase, with their cue."""
    return session.execute(
        select(Question, Cue)
        .join(Cue, Cue.id == Question.cue_id)
        .where(Question.project_id == project_id, icontains(Question.text, phrase))
        .order_by(Question.id.desc())
        .limit(limit)
    ).all()


def cue_by_number(session: Session, project_id: UUID, number: int) -> Cue | None:
    """Return the cue of that number."""
    return session.scalar(select(Cue).where(Cue.project_id == project_id, Cue.number == number))
