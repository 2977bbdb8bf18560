"""Approvers of categories, and deputies."""

from collections.abc import Collection, Sequence
from datetime import date
from uuid import UUID

from sqlalchemy import Row, and_, func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership, Studio
from app.accounts.rules import LEAD_ROLES
from app.projects.models import CategoryApprover, Deputy, Project


def category_approvers(session: Session, project_ids: Collection[UUID]) -> Sequence[CategoryApprover]:
    """Return the newest row of each category, in order of categories."""
    order = func.row_number().over(
        partition_by=(CategoryApprover.project_id, CategoryApprover.category), order_by=CategoryApprover.id.desc()
    )
    numbered = (
        select(CategoryApprover.id, order.label("place")).where(CategoryApprover.project_id.in_(project_ids)).subquery()
    )
    return session.scalars(
        select(CategoryApprover)
        .join(numbered, and_(numbered.c.id == CategoryApprover.id, numbered.c.place == 1))
        .where(CategoryApprover.person_id.is_not(None))
        .order_by(CategoryApprover.category)
    ).all()


def deputies(session: Session, project_ids: Collection[UUID], *, until: date) -> Sequence[Row[Deputy, str]]:
    """Return the deputies whose last day is not before a day, with the time zone of their studio, in order of dates."""
    return session.execute(
        select(Deputy, Studio.time_zone)
        .join(Studio, Studio.id == Deputy.studio_id)
        .where(Deputy.project_id.in_(project_ids), Deputy.withdrawn_at.is_(None), Deputy.until_on >= until)
        .options(joinedload(Deputy.person), joinedload(Deputy.deputy))
        .order_by(Deputy.from_on, Deputy.id)
    ).all()


def leads(session: Session, studio_ids: Collection[UUID], person_ids: Collection[UUID]) -> set[tuple[UUID, UUID]]:
    """Return the studio and the person of each of these people's memberships whose roles allow to approve."""
    rows = select(Membership.studio_id, Membership.person_id, Membership.roles).where(
        Membership.studio_id.in_(studio_ids), Membership.person_id.in_(person_ids)
    )
    return {
        (studio_id, person_id)
        for studio_id, person_id, roles in session.execute(rows)
        if not LEAD_ROLES.isdisjoint(roles)
    }


def deputies_with(session: Session, studio_id: UUID, person_id: UUID, *, until: date) -> Sequence[Deputy]:
    """Return the deputies in a studio who are a person, or stand in for them, on a day or later."""
    return session.scalars(
        select(Deputy)
        .where(
            Deputy.studio_id == studio_id,
            or_(Deputy.deputy_id == person_id, Deputy.person_id == person_id),
            Deputy.withdrawn_at.is_(None),
            Deputy.until_on >= until,
        )
        .options(joinedload(Deputy.person), joinedload(Deputy.deputy))
        .order_by(Deputy.from_on, Deputy.id)
    ).all()


def project_ids_of(session: Session, studio_id: UUID) -> Sequence[UUID]:
    """Return the projects of a studio, archived ones too."""
    return session.scalars(select(Project.id).where(Project.studio_id == studio_id)).all()


def deputy_by_id(session: Session, project_id: UUID, deputy_id: UUID) -> Deputy | None:
    """Return a deputy of a project that was not withdrawn."""
    return session.scalar(
        select(Deputy).where(Deputy.id == deputy_id, Deputy.project_id == project_id, Deputy.withdrawn_at.is_(None))
    )


def is_deputy_until(session: Session, project_id: UUID, person_id: UUID, *, until: date) -> bool:
    """Whether a person is a deputy, or has one, on a day or later."""
    named = or_(Deputy.deputy_id == person_id, Deputy.person_id == person_id)
    query = select(Deputy.id).where(Deputy.project_id == project_id, named)
    return session.scalar(query.where(Deputy.withdrawn_at.is_(None), Deputy.until_on >= until).limit(1)) is not None
