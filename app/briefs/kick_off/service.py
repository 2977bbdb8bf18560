"""The talks before a contract: what was decided, on which day, and who attended."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.briefs.errors import DecisionNotFound, DecisionSigned
from app.briefs.kick_off import queries
from app.briefs.models import Decision
from app.briefs.rules import tidy_text
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access


def decisions(session: Session, actor: Actor, project_id: UUID) -> Sequence[Decision]:
    """Return the decisions of a project, in order of their days."""
    project_access(session, actor, project_id)
    return queries.decisions_of(session, project_id)


def add_decision(
    session: Session, actor: Actor, project_id: UUID, *, decided_on: date, attended: str, text: str
) -> Decision:
    """Add a decision, as someone who acts for the team."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    decision = Decision(
        studio_id=access.project.studio_id,
        project_id=project_id,
        decided_on=decided_on,
        attended=tidy_text(attended),
        text=tidy_text(text),
        written_by=actor.person,
    )
    session.add(decision)
    session.flush()
    session.refresh(decision, ["author"])
    return decision


def change_decision(
    session: Session, actor: Actor, decision_id: UUID, *, decided_on: date, attended: str, text: str
) -> Decision:
    """Change a decision; raise DecisionSigned once a contract is signed."""
    decision = _open_decision(session, actor, decision_id)
    decision.decided_on, decision.attended, decision.text = decided_on, tidy_text(attended), tidy_text(text)
    session.flush()
    return decision


def remove_decision(session: Session, actor: Actor, decision_id: UUID) -> None:
    """Delete a decision; raise DecisionSigned once a contract is signed."""
    session.delete(_open_decision(session, actor, decision_id))
    session.flush()


def _open_decision(session: Session, actor: Actor, decision_id: UUID) -> Decision:
    decision = queries.decision_locked(session, decision_id)
    missing = DecisionNotFound(f"no decision {decision_id}")
    if decision is None:
        raise missing
    try:
        access = project_access(session, actor, decision.project_id)
    except ProjectNotFound:
        raise missing from None
    access.ensure_may_speak()
    if decision.signed_at is not None:
        raise DecisionSigned(
            "a contract was signed since, and this decision stands in its record",
            fix="add another decision, or propose a change order",
        )
    return decision
