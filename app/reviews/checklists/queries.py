"""Checklists and their checks; callers have checked access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session, joinedload

from app.core.in_array import in_array
from app.reviews.models import ApprovalRule, ChecklistItem, Comment, ItemCheck
from app.reviews.queries import answers_nothing
from app.reviews.rules import ApprovalBlockers


def blockers_of(session: Session, project_id: UUID) -> ApprovalBlockers:
    """Return the blockers of approval in a project."""
    return blockers_in(session, [project_id]).get(project_id, ApprovalBlockers.NONE)


def blockers_in(session: Session, project_ids: Collection[UUID]) -> dict[UUID, ApprovalBlockers]:
    """Return the blockers of approval in projects, by project, of those that have set them."""
    query = select(ApprovalRule.project_id, ApprovalRule.blockers)
    return dict(session.execute(query.where(in_array(ApprovalRule.project_id, project_ids))).all())


def items_in(session: Session, project_ids: Collection[UUID]) -> Sequence[ChecklistItem]:
    """Return the items of projects' checklists by category, those of every cue first, in order."""
    return session.scalars(
        select(ChecklistItem)
        .where(in_array(ChecklistItem.project_id, project_ids), ChecklistItem.removed_at.is_(None))
        .order_by(ChecklistItem.category, ChecklistItem.place)
    ).all()


def items_ever(session: Session, project_id: UUID, category: str) -> Sequence[ChecklistItem]:
    """Return every item that a checklist has or had."""
    return session.scalars(
        select(ChecklistItem).where(ChecklistItem.project_id == project_id, ChecklistItem.category == category)
    ).all()


def items_for(session: Session, project_id: UUID, category: str) -> Sequence[ChecklistItem]:
    """Return the checklist of a category's cues: the items of every cue, then its own."""
    return session.scalars(
        select(ChecklistItem)
        .where(
            ChecklistItem.project_id == project_id,
            ChecklistItem.removed_at.is_(None),
            ChecklistItem.category.in_({"", category}),
        )
        .order_by(ChecklistItem.category, ChecklistItem.place)
    ).all()


def checks_of(session: Session, take_ids: Collection[UUID]) -> Sequence[ItemCheck]:
    """Return the checked items of some takes, with their checkers."""
    return session.scalars(
        select(ItemCheck)
        .where(in_array(ItemCheck.take_id, take_ids))
        .options(joinedload(ItemCheck.person))
        .order_by(ItemCheck.checked_at, ItemCheck.item_id)
    ).all()


def open_comments(session: Session, take_ids: Collection[UUID]) -> dict[UUID, int]:
    """Count the comments on takes that are not resolved, without replies, by take."""
    counted = session.execute(
        select(Comment.take_id, func.count())
        .where(in_array(Comment.take_id, take_ids), Comment.resolved_at.is_(None))
        .where(answers_nothing())
        .group_by(Comment.take_id)
    )
    return dict(counted.all())
