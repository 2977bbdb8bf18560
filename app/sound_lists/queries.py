"""The list, read from the database; callers have checked access."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from functools import cache
from uuid import UUID

from sqlalchemy import Row, Select, bindparam, func, or_, select, tuple_
from sqlalchemy.orm import Session, joinedload, selectinload

from app.accounts.models import Membership, Person
from app.accounts.quotas.queries import Usage
from app.core.in_array import in_array
from app.projects.models import Engagement, Project
from app.sound_lists.models import Cue, CueChange, OwnColumn, Question, Revision, SpokenPlaceholder, Stem
from app.sound_lists.own_columns.rules import Column
from app.sound_lists.rules import NO_PLAYBACK_PRIORITY, CueOrdering, CueState, Need, folded

IDS_AT_ONCE = 500  # SQLite takes 32,766 variables in a statement, older ones 999


cues_count = Usage(Cue.studio_id)  # of all lists, cut ones included


def cues_of(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return all cues of a project with their stems, in list order."""
    return session.scalars(
        select(Cue)
        .where(Cue.project_id == project_id)
        .options(selectinload(Cue.stems))
        .order_by(Cue.position, Cue.number)
        .execution_options(populate_existing=True)
    ).all()


def category_counts(session: Session, project_id: UUID) -> Sequence[Row[str, int]]:
    """Return the categories of the cues that are not cut, by name, with the number of their cues."""
    of_project = select(Cue.category, func.count()).where(Cue.project_id == project_id, Cue.state != CueState.CUT)
    return session.execute(of_project.group_by(Cue.category).order_by(Cue.category)).all()


def own_columns(session: Session, project_id: UUID) -> list[Column]:
    """Return the columns of the project's own, in order."""
    query = select(OwnColumn.id, OwnColumn.name, OwnColumn.kind, OwnColumn.choices)
    query = query.where(OwnColumn.project_id == project_id).order_by(OwnColumn.position)
    return [Column._make(row) for row in session.execute(query)]


def words_of_cues(session: Session, project_id: UUID) -> Sequence[Row[str, str, str, str, str, str, Need]]:
    """Return category, name, file name, description, use, trigger and need of the cues that are not cut."""
    words = select(Cue.category, Cue.name, Cue.file_name, Cue.description, Cue.use, Cue.trigger, Cue.need)
    return session.execute(words.where(Cue.project_id == project_id, Cue.state != CueState.CUT)).all()


def designers_of(session: Session, project_id: UUID) -> set[UUID]:
    """Return the people who are engaged on a project."""
    engaged = select(Engagement.designer_id).where(Engagement.project_id == project_id, Engagement.ended_at.is_(None))
    return set(session.scalars(engaged))


def people_of_list(
    session: Session, studio_id: UUID, project_id: UUID, designers: Collection[UUID]
) -> Sequence[Row[UUID, str, str]]:
    """Return id, name and address of a studio's members, of designers, and of the people whom cues name, by name."""
    members = select(Membership.person_id).where(Membership.studio_id == studio_id)
    named = [
        select(column).where(Cue.project_id == project_id, column.is_not(None))
        for column in (Cue.implementer_id, Cue.recorder_id)
    ]
    people = select(Person.id, Person.name, Person.email).where(
        or_(Person.id.in_(designers), *(Person.id.in_(ids) for ids in (members, *named)))
    )
    return session.execute(people.order_by(Person.name, Person.id)).all()


def cue_page(
    session: Session, project_id: UUID, order: CueOrdering, *, after: tuple[int, ...] | None, limit: int
) -> Sequence[Cue]:
    """Return the cues after a place in an order: position and number, by priority with that before them."""
    priority = func.coalesce(Cue.playback_priority, NO_PLAYBACK_PRIORITY)
    place = (Cue.position, Cue.number) if order == "list" else (priority, Cue.position, Cue.number)
    query = select(Cue).where(Cue.project_id == project_id)
    if after is not None:
        query = query.where(tuple_(*place) > tuple_(*after))
    return session.scalars(query.order_by(*place).limit(limit)).all()


def stems_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, list[tuple[int, str]]]:
    """Return the stems that cues own, each with its variation, in order; cheaper than with whole cues."""
    owned: dict[UUID, list[tuple[int, str]]] = defaultdict(list)
    for cue_id, variation, stem in session.execute(_stems(), {"cue_ids": cue_ids}):
        owned[cue_id].append((variation, stem))
    return owned


@cache
def _stems() -> Select[UUID, int, str]:
    owned = select(Stem.cue_id, Stem.variation, Stem.stem).where(in_array(Stem.cue_id, "cue_ids"))
    return owned.order_by(Stem.variation)


def requests(
    session: Session, project_id: UUID
) -> Sequence[Row[UUID, str, str, str, str, bool, float | None, list[str]]]:
    """Return the clarity check's input from each cue that is not cut, in list order."""
    facts = Cue.id, Cue.name, Cue.category, Cue.description, Cue.use
    return session.execute(
        select(*facts, Cue.loop, Cue.planned_length_s, Cue.dismissed_facts)
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT)
        .order_by(Cue.position, Cue.number)
    ).all()


def cue_by_id(session: Session, cue_id: UUID) -> Cue | None:
    """Return a cue with its stems."""
    return session.scalar(
        select(Cue).where(Cue.id == cue_id).options(selectinload(Cue.stems)).execution_options(populate_existing=True)
    )


def cues_by_id(session: Session, project_id: UUID, ids: Collection[UUID]) -> dict[UUID, Cue]:
    """Return cues of a project with their stems, by id."""
    wanted = list(ids)
    found: dict[UUID, Cue] = {}
    for start in range(0, len(wanted), IDS_AT_ONCE):
        query = (
            select(Cue)
            .where(Cue.project_id == project_id, Cue.id.in_(wanted[start : start + IDS_AT_ONCE]))
            .options(selectinload(Cue.stems))
            .execution_options(populate_existing=True)
        )
        found |= {cue.id: cue for cue in session.scalars(query)}
    return found


def matchable_cues(session: Session, project_id: UUID) -> Sequence[Row[UUID, int, str, str, str, int]]:
    """Return the match keys for files, of the cues that are still wanted, in list order; cheaper than whole cues."""
    return session.execute(
        select(Cue.id, Cue.number, Cue.name, Cue.file_name, Cue.category, Cue.variations)
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT)
        .order_by(Cue.position, Cue.number)
    ).all()


def slot_of_stem(session: Session, project_id: UUID, stem: str) -> tuple[Cue, int] | None:
    """Return the cue and variation that own a stem, which is in NFC."""
    row = session.execute(_of_stem(), {"project_id": project_id, "folded": folded(stem), "stem": stem}).first()
    return (row[0], row[1]) if row else None


@cache  # asked for with each upload: to build the statement takes as long as to run it
def _of_stem() -> Select[Cue, int]:
    of_stem = (Stem.project_id == bindparam("project_id"), Stem.folded == bindparam("folded"))
    cues = select(Cue, Stem.variation).join(Stem, Stem.cue_id == Cue.id)
    return cues.where(*of_stem, Stem.stem == bindparam("stem"))


def stem_owners(session: Session, project_id: UUID, wanted: Collection[str]) -> dict[str, tuple[UUID, int, str]]:
    """Return the owners of the folded stems asked for: cue id, cue number and the stem itself."""
    query = (
        select(Stem.folded, Stem.cue_id, Cue.number, Stem.stem)
        .join(Cue, Cue.id == Stem.cue_id)
        .where(Stem.project_id == project_id)
    )
    if len(wanted) <= IDS_AT_ONCE:
        query = query.where(Stem.folded.in_(wanted))
    return {key: (cue_id, number, stem) for key, cue_id, number, stem in session.execute(query)}


def lock_list(session: Session, project_id: UUID) -> None:
    """Let no other transaction number cues or revisions of this list until ours ends."""
    session.execute(select(Project.id).where(Project.id == project_id).with_for_update(key_share=True))


def last_numbers(session: Session, project_id: UUID) -> tuple[int, int]:
    """Return the highest cue number and the highest position, 0 for an empty list."""
    number, position = session.execute(
        select(func.coalesce(func.max(Cue.number), 0), func.coalesce(func.max(Cue.position), 0)).where(
            Cue.project_id == project_id
        )
    ).one()
    return number, position


def numbers_taken(session: Session, project_id: UUID) -> dict[int, UUID]:
    """Return the cue ids of a list by number."""
    rows = session.execute(select(Cue.number, Cue.id).where(Cue.project_id == project_id))
    return dict(rows.all())


def revision_number(session: Session, project_id: UUID) -> int:
    """Return the number of the newest revision, 0 before the first."""
    return session.scalar(select(func.max(Revision.number)).where(Revision.project_id == project_id)) or 0


def newest_revision(session: Session, project_id: UUID) -> Revision | None:
    """Return the newest revision; None for a list that nobody has touched."""
    query = select(Revision).where(Revision.project_id == project_id)
    return session.scalar(query.order_by(Revision.number.desc()).limit(1))


def changes_of(session: Session, revision_id: UUID) -> Sequence[CueChange]:
    """Return the changes of one revision."""
    return session.scalars(select(CueChange).where(CueChange.revision_id == revision_id)).all()


def revisions_of(session: Session, project_id: UUID, *, before: int | None, limit: int) -> Sequence[Revision]:
    """Return revisions, the newest first, with their authors."""
    query = select(Revision).where(Revision.project_id == project_id)
    if before is not None:
        query = query.where(Revision.number < before)
    return session.scalars(
        query.options(joinedload(Revision.author)).order_by(Revision.number.desc()).limit(limit)
    ).all()


def changes_between(session: Session, project_id: UUID, first: int, last: int) -> Sequence[tuple[CueChange, Cue]]:
    """Return the changes to each cue by the revisions after `first` up to `last`, the oldest first."""
    return session.execute(
        select(CueChange, Cue)
        .join(Revision, Revision.id == CueChange.revision_id)
        .join(Cue, Cue.id == CueChange.cue_id)
        .where(Revision.project_id == project_id, Revision.number > first, Revision.number <= last)
        .order_by(Revision.number, Cue.position, Cue.number)
    ).all()


QUESTION_PARTS = tuple(joinedload(part) for part in (Question.cue, Question.asker, Question.answerer, Question.owner))


def open_question_counts(session: Session, project_id: UUID) -> dict[UUID, int]:
    """Return the number of unanswered questions of each cue."""
    counts = session.execute(
        select(Question.cue_id, func.count())
        .where(Question.project_id == project_id, Question.answered_at.is_(None))
        .group_by(Question.cue_id)
    )
    return defaultdict(int, counts.all())


def questions_of(
    session: Session,
    project_id: UUID,
    *,
    cue_id: UUID | None = None,
    only_open: bool = False,
    after: UUID | None = None,
    limit: int | None = None,
) -> Sequence[Question]:
    """Return questions with their cue and people, the oldest first."""
    query = select(Question).where(Question.project_id == project_id)
    if cue_id is not None:
        query = query.where(Question.cue_id == cue_id)
    if only_open:
        query = query.where(Question.answered_at.is_(None))
    if after is not None:
        query = query.where(Question.id > after)
    return session.scalars(query.options(*QUESTION_PARTS).order_by(Question.id).limit(limit)).all()


def question_by_id(session: Session, question_id: UUID) -> Question | None:
    """Return a question with its cue and people."""
    return session.scalar(
        select(Question)
        .where(Question.id == question_id)
        .options(*QUESTION_PARTS)
        .execution_options(populate_existing=True)
    )


def spoken_placeholder(session: Session, cue_id: UUID) -> SpokenPlaceholder | None:
    """Return a cue's spoken placeholder, with the person who said it."""
    of_cue = select(SpokenPlaceholder).where(SpokenPlaceholder.cue_id == cue_id)
    return session.scalar(of_cue.options(joinedload(SpokenPlaceholder.speaker)))


def spoken_sha256s(session: Session, project_id: UUID) -> dict[UUID, str]:
    """Return the files of what was said for the cues of a project, by cue."""
    files = select(SpokenPlaceholder.cue_id, SpokenPlaceholder.sha256)
    rows = session.execute(files.where(SpokenPlaceholder.project_id == project_id))
    return {row.cue_id: row.sha256 for row in rows}
