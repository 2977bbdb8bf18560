"""The endpoint of same sounds in other projects."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.builds.same_sounds import service as same_sounds
from app.builds.same_sounds.schemas import SameSoundsRead
from app.core.web.http import DbSession, problems
from app.deliveries.errors import TakeNotFound

router = APIRouter(prefix="/v1", tags=["builds"])


@router.get("/takes/{take_id}/same-sounds", response_model=SameSoundsRead, responses=problems(TakeNotFound))
def see_same_sounds(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> SameSoundsRead:
    """Show the approved versions of the studio's other projects that hold the same sound, changed or not."""
    return same_sounds.same_sounds_of_take(session, actor, take_id)
