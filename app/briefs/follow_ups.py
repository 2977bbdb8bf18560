"""Follow-ups: a designer asks about a question of the brief, and the team answers once."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.briefs import queries
from app.briefs.errors import FollowUpAnswered, FollowUpNotFound
from app.briefs.models import FollowUp
from app.briefs.rules import question_of, tidy_text
from app.briefs.schemas import FollowUpRead
from app.core import clock
from app.projects.errors import ProjectNotFound
from app.projects.queries import lock_project
from app.projects.service import ProjectAccess, project_access


def ask(session: Session, actor: Actor, project_id: UUID, *, question: str, text: str) -> FollowUpRead:
    """Ask the team about a question of the brief."""
    access = project_access(session, actor, project_id)
    access.ensure_designer()
    follow_up = FollowUp(
        studio_id=access.project.studio_id,
        project_id=project_id,
        question=question_of(question).key,
        text=tidy_text(text),
        asked_by=actor.person,
    )
    session.add(follow_up)
    session.flush()
    return follow_up_read(_found(session, follow_up.id), access)


def answer(session: Session, actor: Actor, follow_up_id: UUID, text: str) -> FollowUpRead:
    """Answer a follow-up; raise FollowUpAnswered where it has its answer."""
    try:
        follow_up = _found(session, follow_up_id)
        access = project_access(session, actor, follow_up.project_id)
    except ProjectNotFound:
        raise FollowUpNotFound(f"no follow-up {follow_up_id}") from None
    access.ensure_may_speak()
    lock_project(session, follow_up.project_id)
    session.refresh(follow_up, ["answered_at"])
    if follow_up.answered_at is not None:
        raise FollowUpAnswered("this follow-up is already answered", fix="change the answer of the brief instead")
    follow_up.answer, follow_up.answered_by, follow_up.answered_at = tidy_text(text), actor.person, clock.now()
    session.flush()
    return follow_up_read(_found(session, follow_up_id), access)


def _found(session: Session, follow_up_id: UUID) -> FollowUp:
    follow_up = queries.follow_up_by_id(session, follow_up_id)
    if follow_up is None:
        raise FollowUpNotFound(f"no follow-up {follow_up_id}")
    return follow_up


def follow_up_read(follow_up: FollowUp, access: ProjectAccess) -> FollowUpRead:
    """Return a follow-up as the caller may see it: designers do not see one another's names."""
    is_shown = access.only_designer_id in (None, follow_up.asked_by)
    return FollowUpRead(
        id=follow_up.id,
        question=follow_up.question,
        text=follow_up.text,
        asked_by=PersonBrief.model_validate(follow_up.asker) if is_shown else None,
        asked_at=follow_up.asked_at,
        answer=follow_up.answer,
        answered_by=PersonBrief.model_validate(follow_up.answerer) if follow_up.answerer else None,
        answered_at=follow_up.answered_at,
    )
