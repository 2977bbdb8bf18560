"""The brief: answered as people type, published as versions, read by designers."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.briefs import queries
from app.briefs.errors import AnswerChanged, BriefVersionNotFound, NothingToPublish
from app.briefs.models import Brief, BriefRead, BriefVersion
from app.briefs.questions import BY_KEY
from app.briefs.rules import (
    completeness,
    differences,
    fitted,
    in_words,
    is_answered,
    is_same,
    number_of,
    question_of,
    tidy_text,
)
from app.core import clock
from app.core.errors import FieldProblem
from app.projects.models import Engagement
from app.projects.queries import engagements_of, lock_project
from app.projects.service import ProjectAccess, project_access


@dataclass(frozen=True)
class NewAnswer:
    """An answer as it is sent: without a value, and not unknown, it removes the one that is there."""

    value: Any
    is_unknown: bool
    note: str


@dataclass(frozen=True)
class LastRead:
    """A designer who is engaged now, and the newest version that they opened."""

    engagement: Engagement
    read: BriefRead | None
    behind: int


@dataclass(frozen=True)
class OpenAnswer:
    """A question of the brief that has no answer, or the answer "I don't know yet"."""

    number: int
    text: str
    required: bool
    note: str  # what is said with "I don't know yet"


def open_answers(session: Session, project_id: UUID) -> Sequence[OpenAnswer]:
    """Return the open questions of a project's brief, in their order; none where nobody has begun a brief."""
    answers = queries.answers_of(session, project_id)
    return [
        OpenAnswer(
            number=number_of(BY_KEY[key]),
            text=BY_KEY[key].text,
            required=BY_KEY[key].required,
            note=answers.get(key, {}).get("note", ""),
        )
        for key in (completeness(answers).open if answers else ())
    ]


def answers_in_words(session: Session, project_id: UUID, keys: Collection[str]) -> list[tuple[str, str]]:
    """Return the answered ones of some questions of a project's brief, each with its answer in one line."""
    answers = queries.answers_of(session, project_id)
    return [
        (BY_KEY[key].text, in_words(BY_KEY[key], answers[key]).replace("\n", "; "))
        for key in keys
        if is_answered(BY_KEY[key], answers)
    ]


def change_answers(
    session: Session, actor: Actor, project_id: UUID, *, revision: int, changes: Mapping[str, NewAnswer]
) -> None:
    """Save answers; raise AnswerChanged for those that another person changed after the revision that was read."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    new = {key: _as_row(key, change) for key, change in changes.items()}
    lock_project(session, project_id)
    brief = queries.brief_of(session, project_id)
    answers = dict(brief.answers) if brief else {}
    changed = {key: row for key, row in new.items() if not is_same(answers.get(key), row)}
    if brief is not None:
        _ensure_unchanged(session, brief, changed, revision)
    if not changed:
        return
    if brief is None:
        brief = Brief(studio_id=access.project.studio_id, project_id=project_id, revision=0, changed_by=actor.person)
        session.add(brief)
    brief.revision += 1
    brief.changed_by, brief.changed_at = actor.person, clock.now()
    stamp = {
        "revision": brief.revision,
        "answered_by": str(actor.person),
        "answered_at": brief.changed_at.isoformat(),
    }
    for key, row in changed.items():
        if row is None:
            answers.pop(key)
        else:
            answers[key] = row | stamp
    brief.answers = answers
    session.flush()


def _as_row(key: str, change: NewAnswer) -> dict[str, Any] | None:
    question_of(key)
    value = None if change.is_unknown else fitted(key, change.value)
    if value is None and not change.is_unknown:
        return None
    return {"value": value, "is_unknown": change.is_unknown, "note": tidy_text(change.note)}


def _ensure_unchanged(
    session: Session, brief: Brief, changed: Mapping[str, dict[str, Any] | None], revision: int
) -> None:
    newer = {key: brief.answers[key] for key in changed if brief.answers.get(key, {}).get("revision", 0) > revision}
    if not newer:
        return
    people = people_by_id(session, {UUID(answer["answered_by"]) for answer in newer.values()})
    errors = [
        FieldProblem(where=key, message=f"{people[UUID(answer['answered_by'])].name} changed this answer")
        for key, answer in newer.items()
    ]
    raise AnswerChanged(
        errors[0]["message"], errors=errors, fix="read their answer, then save yours again if you still want it"
    )


def publish_version(session: Session, actor: Actor, project_id: UUID, *, revision: int, note: str) -> BriefVersion:
    """Keep the answers as a version; raise NothingToPublish where the newest version has the same ones."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    lock_project(session, project_id)
    brief = queries.brief_of(session, project_id)
    if brief is None:
        raise NothingToPublish("nothing is answered yet", fix="answer a question first")
    if brief.revision != revision:
        raise AnswerChanged("an answer was changed since you read the brief", fix="read it again, then publish")
    number = queries.newest_version(session, project_id)
    newest = queries.version_of(session, project_id, number)
    if newest is not None and not differences(newest.answers, brief.answers):
        raise NothingToPublish(f"the answers are those of version {number}")
    version = BriefVersion(
        studio_id=brief.studio_id,
        project_id=project_id,
        number=number + 1,
        answers=brief.answers,
        note=tidy_text(note),
        published_by=actor.person,
    )
    session.add(version)
    session.flush()
    return version_seen(session, access, version.number)


def version_seen(session: Session, access: ProjectAccess, number: int) -> BriefVersion:
    """Return a published version, or raise BriefVersionNotFound."""
    version = queries.version_of(session, access.project.id, number)
    if version is None:
        raise BriefVersionNotFound(f"this project has no brief of version {number}")
    return version


def answers_at(session: Session, access: ProjectAccess, number: int | None) -> Mapping[str, Any]:
    """Return the answers of a version; of the brief as it is now for None, of no brief for 0."""
    if number is None:
        return queries.answers_of(session, access.project.id)
    return version_seen(session, access, number).answers if number else {}


def record_read(session: Session, actor: Actor, project_id: UUID, number: int) -> None:
    """Record that a designer opened a version; only the first time counts."""
    access = project_access(session, actor, project_id)
    access.ensure_designer()
    version = version_seen(session, access, number)
    if not queries.has_read(session, version.id, actor.person):
        session.add(
            BriefRead(
                version_id=version.id,
                designer_id=actor.person,
                studio_id=version.studio_id,
                project_id=project_id,
            )
        )
        session.flush()


def last_reads(session: Session, actor: Actor, project_id: UUID) -> Sequence[LastRead]:
    """Return for each designer engaged now which version they opened last."""
    project_access(session, actor, project_id).ensure_team()
    newest = queries.newest_version(session, project_id)
    reads = queries.newest_reads(session, project_id)
    engaged = [engagement for engagement in engagements_of(session, [project_id]) if engagement.ended_at is None]
    found = [(one, reads.get(one.designer_id)) for one in engaged]
    return [LastRead(one, read, newest - (read.version.number if read else 0)) for one, read in found]
