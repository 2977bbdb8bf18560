"""The endpoints of spotting a clip."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import TeamNeeded
from app.references import spotting
from app.references.errors import ReferenceInvalid, ReferenceNotFound
from app.references.schemas import SpottedMarks
from app.sound_lists.errors import AdditionInUse, RowsInvalid
from app.sound_lists.kits.schemas import AdditionUndo
from app.sound_lists.queries import cues_by_id
from app.sound_lists.schemas import CueRead
from app.sound_lists.service import cue_read

router = APIRouter(prefix="/v1", tags=["references"])
TEAM: Actor = allows(Audience.TEAM)


@router.post(
    "/references/{reference_id}/cues",
    status_code=201,
    responses=problems(ReferenceNotFound, TeamNeeded, ReferenceInvalid, RowsInvalid),
)
def add_spotted_cues(reference_id: UUID, body: SpottedMarks, session: DbSession, actor: Actor = TEAM) -> list[CueRead]:
    """Make a cue of each mark of a clip, with its part of the clip as a reference: all of them, or none."""
    access, added = spotting.add_spotted_cues(session, actor, reference_id, body.marks)
    cues = cues_by_id(session, access.project.id, [cue.id for cue in added])
    return [cue_read(access, cues[cue.id]) for cue in added]


@router.post(
    "/references/{reference_id}/cues/undo",
    status_code=204,
    responses=problems(ReferenceNotFound, TeamNeeded, AdditionInUse),
)
def undo_spotted_cues(reference_id: UUID, body: AdditionUndo, session: DbSession, actor: Actor = TEAM) -> None:
    """Remove the cues that were made of marks, while no work on them has begun."""
    spotting.undo_spotted_cues(session, actor, reference_id, body.cue_ids)
