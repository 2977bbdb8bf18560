"""Whether a person sees another's name, and so their picture."""

from uuid import UUID

from sqlalchemy import ColumnElement, exists, or_, select, union
from sqlalchemy.orm import Session

from app.accounts.models import Membership
from app.accounts.rules import Actor
from app.hiring.models import Candidate
from app.projects.models import Engagement


def sees_name(session: Session, actor: Actor, person_id: UUID) -> bool:
    """Whether a person is the caller, of a studio that the caller works for now, or a designer of the caller's studio.

    Designers of the same project do not see each other.
    """
    if person_id == actor.person:
        return True
    studios = list(actor.roles)
    works_for = union(
        select(Engagement.studio_id).where(Engagement.designer_id == actor.person, Engagement.ended_at.is_(None)),
        select(Candidate.studio_id).where(Candidate.person_id == actor.person, Candidate.revoked_at.is_(None)),
    )
    near = or_(Membership.studio_id.in_(studios), Membership.studio_id.in_(works_for))
    seen: tuple[ColumnElement[bool], ...] = (
        exists().where(Membership.person_id == person_id, near),
        exists().where(Engagement.designer_id == person_id, Engagement.studio_id.in_(studios)),
        exists().where(Candidate.person_id == person_id, Candidate.studio_id.in_(studios)),
    )
    return bool(session.scalar(select(or_(*seen))))
