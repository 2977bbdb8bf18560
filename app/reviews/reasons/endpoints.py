"""The endpoints of the studio's reasons and labels, and of reasons that were given."""

from typing import Annotated, Literal
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.errors import ProducerNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import BadCursor, DbSession, Page, problems
from app.projects.errors import ProjectNotFound
from app.reviews.errors import ReasonsInvalid
from app.reviews.reasons import reason_counts as found_reasons
from app.reviews.reasons import service as reasons
from app.reviews.reasons.rules import ReasonKind
from app.reviews.reasons.schemas import Reason, ReasonPlaceRead, ReasonsRead, ReviewReasonsRead, ReviewReasonsSet

Designer = Annotated[UUID | None, Query(description="Of whose versions; a designer sees their own alone.")]
Category = Annotated[str | None, Query(max_length=60, description="Of which cues; empty for those without one.")]
router = APIRouter(prefix="/v1", tags=["reviews"])


@router.get("/studios/{studio_id}/review-reasons", responses=problems(StudioNotFound))
def get_review_reasons(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.STUDIO)
) -> ReviewReasonsRead:
    """Return the reasons and labels of a studio, in the order of the digits."""
    return reasons.reasons_of_studio(session, actor, studio_id)


@router.put("/studios/{studio_id}/review-reasons", responses=problems(StudioNotFound, ProducerNeeded, ReasonsInvalid))
def set_review_reasons(
    studio_id: UUID, body: ReviewReasonsSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> ReviewReasonsRead:
    """Write whole lists; what was said before stays as it was said. An empty list gives ours back."""
    chosen_by_kind = {kind: chosen for kind in ReasonKind if (chosen := getattr(body, kind.value)) is not None}
    return reasons.set_reasons(session, actor, studio_id, chosen_by_kind)


@router.get("/projects/{project_id}/review-reasons", responses=problems(ProjectNotFound))
def get_review_reasons_of_project(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> ReviewReasonsRead:
    """Return the reasons and labels of a project's studio, for its team and designers."""
    return reasons.reasons_of_project(session, actor, project_id)


@router.get("/projects/{project_id}/reasons", responses=problems(ProjectNotFound))
def count_reasons(
    project_id: UUID,
    session: DbSession,
    designer_id: Designer = None,
    category: Category = None,
    actor: Actor = allows(Audience.PROJECT),
) -> ReasonsRead:
    """Return the number of uses of each reason; a designer sees those of their own versions."""
    return found_reasons.reason_counts(session, actor, project_id, designer_id=designer_id, category=category)


@router.get("/projects/{project_id}/reasons/versions", responses=problems(ProjectNotFound, BadCursor))
def list_versions_with_reason(
    project_id: UUID,
    kind: Literal["change", "pick"],
    reason: Reason,
    session: DbSession,
    designer_id: Designer = None,
    category: Category = None,
    cursor: str | None = None,
    actor: Actor = allows(Audience.PROJECT),
) -> Page[ReasonPlaceRead]:
    """Return the versions of which a reason was given, newest first; a designer sees their own."""
    return found_reasons.reason_places(
        session,
        actor,
        project_id,
        ReasonKind(kind),
        reason,
        designer_id=designer_id,
        category=category,
        cursor=cursor,
    )
