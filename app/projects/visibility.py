"""Whether a designer sees a project's work: engaged now, and past its NDA. Every other room asks here."""

from collections.abc import Collection
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, and_, exists, not_, or_
from sqlalchemy.orm import InstrumentedAttribute

from app.accounts.models import Membership, Studio
from app.accounts.rules import Actor, MembersSee
from app.projects.members import limits  # noqa: F401  every statement of who is limited leaves projects out
from app.projects.models import Engagement, Project, ProjectMember
from app.projects.rules import DesignersHear, EngagementKind

Column = InstrumentedAttribute[UUID] | InstrumentedAttribute[UUID | None] | ColumnElement[Any]


def nda_is_pending(project: Project, engagement: Engagement) -> bool:
    """Whether a designer has yet to accept the NDA that the project asks for; the studio's own people need none."""
    return project.nda_needed and engagement.kind is not EngagementKind.IN_HOUSE and engagement.nda_accepted_at is None


def engaged_with_nda_accepted() -> ColumnElement[bool]:
    """Admit engagements, joined with their projects, that run and of which `nda_is_pending` is false."""
    past_nda = or_(
        Project.nda_needed.is_(False),
        Engagement.kind == EngagementKind.IN_HOUSE,
        Engagement.nda_accepted_at.is_not(None),
    )
    return and_(Project.id == Engagement.project_id, Engagement.ended_at.is_(None), past_nda)


def visible_work(actor: Actor, *, studio_id: Column, project_id: Column, designer_id: Column) -> ColumnElement[bool]:
    """Admit work of the caller's studios, and the caller's own in projects that show it to them."""
    own = and_(designer_id == actor.person_id, _shows_list(actor, project_id))
    return or_(_of_studios(actor, studio_id), own)


def visible_list(actor: Actor, *, studio_id: Column, project_id: Column) -> ColumnElement[bool]:
    """Admit rows that each person in a project sees, such as its cues, in all projects that show them to the caller."""
    return or_(_of_studios(actor, studio_id), _shows_list(actor, project_id))


def _of_studios(actor: Actor, studio_id: Column) -> ColumnElement[bool]:
    return studio_id.in_([studio for studio, roles in actor.roles.items() if roles])


def _shows_list(actor: Actor, project_id: Column) -> ColumnElement[bool]:
    return exists().where(
        Engagement.project_id == project_id, Engagement.designer_id == actor.person_id, engaged_with_nda_accepted()
    )


def is_closed_to(
    person_id: Column | UUID, *, studio_id: Column | UUID, project_id: Column | UUID
) -> ColumnElement[bool]:
    """Admit projects that a member of the studio does not see, since they are not in it and see only their own."""
    limited = exists().where(
        Membership.studio_id == studio_id,
        Membership.person_id == person_id,
        Studio.id == Membership.studio_id,
        Studio.members_see == MembersSee.OWN,
    )
    member = exists().where(ProjectMember.project_id == project_id, ProjectMember.person_id == person_id)
    engaged = exists().where(
        Engagement.project_id == project_id, Engagement.designer_id == person_id, Engagement.ended_at.is_(None)
    )
    return and_(limited, not_(member), not_(engaged))


def project_opens(actor: Actor, project_id: Column, choices: Collection[DesignersHear]) -> ColumnElement[bool]:
    """Admit projects on which the caller is engaged, past the NDA, and whose designers hear one of these choices."""
    return exists().where(
        Engagement.project_id == project_id,
        Engagement.designer_id == actor.person_id,
        engaged_with_nda_accepted(),
        Project.designers_hear.in_(choices),
    )
