"""The endpoints of decisions before a contract, and of the brief's vision."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.briefs.errors import DecisionNotFound, DecisionSigned
from app.briefs.kick_off import service
from app.briefs.kick_off.schemas import DecisionRead, DecisionWrite, Vision
from app.briefs.models import Decision
from app.briefs.service import answers_in_words
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import project_access

router = APIRouter(prefix="/v1", tags=["briefs"])
VISION = "feel"  # the question of the brief


@router.get("/projects/{project_id}/vision", responses=problems(ProjectNotFound))
def read_vision(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Vision:
    """Return the vision: the current answer about the game's sound."""
    project_access(session, actor, project_id)
    answers = answers_in_words(session, project_id, [VISION])
    return Vision(text=answers[0][1] if answers else None)


@router.get("/projects/{project_id}/decisions", response_model=list[DecisionRead], responses=problems(ProjectNotFound))
def list_decisions(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Sequence[Decision]:
    """Return the decisions of the talks before a contract, in order of their days."""
    return service.decisions(session, actor, project_id)


@router.post(
    "/projects/{project_id}/decisions",
    status_code=201,
    response_model=DecisionRead,
    responses=problems(ProjectNotFound, TeamNeeded),
)
def add_decision(
    project_id: UUID, body: DecisionWrite, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> Decision:
    """Add a decision of the talks before a contract."""
    return service.add_decision(session, actor, project_id, **body.model_dump())


@router.put(
    "/decisions/{decision_id}",
    response_model=DecisionRead,
    responses=problems(DecisionNotFound, TeamNeeded, DecisionSigned),
)
def change_decision(
    decision_id: UUID, body: DecisionWrite, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> Decision:
    """Change a decision until a contract is signed."""
    return service.change_decision(session, actor, decision_id, **body.model_dump())


@router.delete(
    "/decisions/{decision_id}", status_code=204, responses=problems(DecisionNotFound, TeamNeeded, DecisionSigned)
)
def remove_decision(decision_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> None:
    """Delete a decision until a contract is signed."""
    service.remove_decision(session, actor, decision_id)
