"""The endpoint that guesses the category of a new cue."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.categories.rules import category_of_name
from app.sound_lists.categories.schemas import CategoryGuess
from app.sound_lists.rules import LINES

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/projects/{project_id}/category-guess", responses=problems(ProjectNotFound))
def guess_category(
    project_id: UUID,
    session: DbSession,
    name: Annotated[str, Query(min_length=1, max_length=LINES["name"], examples=["door slam"])],
    actor: Actor = allows(Audience.PROJECT),
) -> CategoryGuess:
    """Return the category of the cues whose names share words with a new name, else that of its kind of sound."""
    project_access(session, actor, project_id)
    listed = [(row.name, row.category) for row in queries.matchable_cues(session, project_id)]
    return CategoryGuess(category=category_of_name(name, listed))
