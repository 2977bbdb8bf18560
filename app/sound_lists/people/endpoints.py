"""The endpoint of the people whom cues name."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access
from app.sound_lists.people.schemas import CuePersonRead
from app.sound_lists.people.service import people_seen

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/projects/{project_id}/cue-people", responses=problems(ProjectNotFound))
def list_cue_people(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[CuePersonRead]:
    """Return possible implementers and recorders of a cue, by name; a designer sees only themselves."""
    people = people_seen(session, project_access(session, actor, project_id))
    return [CuePersonRead.model_validate(person) for person in people]
