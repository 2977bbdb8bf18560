"""Questions on cues: a designer asks, the team answers, and the answer becomes part of the cue."""

from collections.abc import Mapping
from datetime import date
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import membership
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import publish
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.sound_lists import queries, service
from app.sound_lists.errors import QuestionAnswered, QuestionNotFound, QuestionOwnerUnknown
from app.sound_lists.models import Question
from app.sound_lists.rules import CueState, label, tidy_text
from app.sound_lists.schemas import QuestionRead


def ask_question(
    session: Session, actor: Actor, cue_id: UUID, text: str, *, due_on: date | None = None, blocks: bool = False
) -> tuple[ProjectAccess, Question]:
    """Ask the team what it means by a cue."""
    access, cue = service.visible_cue(session, actor, cue_id)
    question = Question(
        studio_id=cue.studio_id,
        project_id=cue.project_id,
        cue_id=cue.id,
        text=tidy_text(text),
        asked_by=actor.person,
        due_on=due_on,
        blocks=blocks,
    )
    session.add(question)
    session.flush()
    publish(session, "question.asked", studio_id=question.studio_id, question_id=question.id)
    return access, _read_again(session, question.id)


def answer_question(
    session: Session, actor: Actor, question_id: UUID, text: str, *, joins: bool
) -> tuple[ProjectAccess, Question]:
    """Answer once for all; what joins is added to the cue's description, as a revision of the list."""
    access, question = _open_question(session, actor, question_id)
    question.answer, question.answered_by, question.answered_at = tidy_text(text), actor.person, clock.now()
    session.flush()
    cue = service.cue_for(session, access, question.cue_id)
    if joins and cue.state is not CueState.CUT:
        joined = f"{cue.description}\n\n{question.text} {question.answer}".strip()
        service.change_cue(session, actor, cue.id, None, {"description": joined})
    publish(session, "question.answered", studio_id=question.studio_id, question_id=question.id)
    return access, _read_again(session, question.id)


def change_question(
    session: Session, actor: Actor, question_id: UUID, changes: Mapping[str, Any]
) -> tuple[ProjectAccess, Question]:
    """Set who is to answer a question, by which day, and whether work waits for it."""
    access, question = _open_question(session, actor, question_id)
    owner_id = changes.get("owner_id")
    if owner_id is not None and membership(session, question.studio_id, owner_id) is None:
        message = "this person is no member of the studio"
        raise QuestionOwnerUnknown(
            message,
            errors=[FieldProblem(where="owner_id", message=message)],
            fix="choose a member of the team, or leave the question without an owner",
        )
    for name, value in changes.items():
        if value is not None or name != "blocks":
            setattr(question, name, value)
    session.flush()
    session.expire(question, ["owner"])
    return access, _read_again(session, question.id)


def _open_question(session: Session, actor: Actor, question_id: UUID) -> tuple[ProjectAccess, Question]:
    """Return an unanswered question that the caller may answer, with its list locked."""
    question = queries.question_by_id(session, question_id)
    if question is None:
        raise QuestionNotFound(f"no question {question_id}")
    try:
        access = project_access(session, actor, question.project_id)
    except ProjectNotFound:
        raise QuestionNotFound(f"no question {question_id}") from None
    access.ensure_may_speak()
    queries.lock_list(session, question.project_id)
    session.refresh(question, ["answered_at"])
    if question.answered_at is not None:
        raise QuestionAnswered("this question is already answered", fix="change the cue's description instead")
    return access, question


def _read_again(session: Session, question_id: UUID) -> Question:
    session.flush()
    question = queries.question_by_id(session, question_id)
    if question is None:
        raise QuestionNotFound(f"no question {question_id}")
    return question


def question_read(question: Question, access: ProjectAccess) -> QuestionRead:
    """Return a question as the caller may see it: designers do not learn of one another."""
    mine = access.only_designer_id in (None, question.asked_by)
    return QuestionRead(
        id=question.id,
        cue_id=question.cue_id,
        cue_label=label(access.project.cue_prefix, question.cue.number),
        cue_name=question.cue.name,
        text=question.text,
        asked_by=PersonBrief.model_validate(question.asker) if mine else None,
        asked_at=question.asked_at,
        answer=question.answer,
        answered_by=PersonBrief.model_validate(question.answerer) if question.answerer else None,
        answered_at=question.answered_at,
        owner=PersonBrief.model_validate(question.owner) if question.owner else None,
        due_on=question.due_on,
        blocks=question.blocks,
    )
