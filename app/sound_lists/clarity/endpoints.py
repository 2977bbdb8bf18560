"""The endpoints of the clarity check."""

from functools import cache
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import project_access
from app.sound_lists.clarity import service as clarity
from app.sound_lists.clarity.rules import Fact, Question
from app.sound_lists.errors import CueIsCut, CueNotFound, RowsInvalid
from app.sound_lists.schemas import ClarityRead, FactAnswer, FactDismissal, FactQuestion, UnclearCue

router = APIRouter()


@router.get("/projects/{project_id}/clarity", response_model=ClarityRead, responses=problems(ProjectNotFound))
def check_clarity(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> ClarityRead:
    """Return the cues whose words leave something open, with a question for each fact; it blocks nothing."""
    access = project_access(session, actor, project_id)
    unclear = [
        UnclearCue(cue_id=cue_id, questions=[_shown(question) for question in left])
        for cue_id, left in clarity.unclear_cues(session, access)
    ]
    return ClarityRead(unclear=unclear)


@cache
def _shown(question: Question) -> FactQuestion:
    """Return a question as it is answered; the lexicon has a few dozen, and a large list asks thousands."""
    return FactQuestion.model_validate(question)


@router.post(
    "/cues/{cue_id}/clarity/{fact}/answer",
    status_code=204,
    responses=problems(CueNotFound, TeamNeeded, CueIsCut, RowsInvalid),
)
def answer_fact(
    cue_id: UUID, fact: Fact, body: FactAnswer, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Write an answer into the cue's description; that of the category becomes its category."""
    clarity.answer(session, actor, cue_id, fact, body.text)


@router.put("/cues/{cue_id}/clarity/{fact}/dismissed", status_code=204, responses=problems(CueNotFound, TeamNeeded))
def dismiss_fact(
    cue_id: UUID, fact: Fact, body: FactDismissal, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Ask for a fact of a cue no more, or again."""
    clarity.dismiss(session, actor, cue_id, fact, dismissed=body.dismissed)
