"""Checklists by category, and what is checked of a take."""

from collections.abc import Sequence
from itertools import groupby
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import insert_if_absent
from app.deliveries.service import take_for
from app.projects.queries import lock_project
from app.projects.service import project_access
from app.reviews.checklists import queries
from app.reviews.checklists.schemas import (
    ApprovalSettingsRead,
    ChecklistItemRead,
    ChecklistRead,
    CueChecklist,
    ItemCheckRead,
)
from app.reviews.errors import ChecklistItemNotFound, TooManyChecklists
from app.reviews.models import ApprovalRule, ChecklistItem, ItemCheck
from app.reviews.rules import ApprovalBlockers, ensure_checklist
from app.reviews.verdicts.approval_blocks import OfCue, blocked_takes
from app.sound_lists.models import Cue

MAX_CHECKLISTS = 100


def approval_settings(session: Session, actor: Actor, project_id: UUID) -> ApprovalSettingsRead:
    """Return the checklists of a project and what blocks approval there."""
    project_access(session, actor, project_id).ensure_team()
    by_category = groupby(queries.items_in(session, [project_id]), lambda item: item.category)
    return ApprovalSettingsRead(
        blockers=queries.blockers_of(session, project_id),
        checklists=[ChecklistRead(category=category, items=_shown(list(items))) for category, items in by_category],
    )


def set_checklist(
    session: Session, actor: Actor, project_id: UUID, *, category: str, items: Sequence[str]
) -> ApprovalSettingsRead:
    """Write the checklist of a category; items that are written as before keep their checks."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    ensure_checklist(items)
    lock_project(session, project_id)
    has_one = {item.category for item in queries.items_in(session, [project_id])}
    if items and category not in has_one and len(has_one) >= MAX_CHECKLISTS:
        raise TooManyChecklists(
            f"{len(has_one)} categories have a checklist, as many as may have one",
            fix="remove a checklist, or write the items in the one for every cue",
        )
    items_by_text = {item.text: item for item in queries.items_ever(session, project_id, category)}
    for text, item in items_by_text.items():
        if text not in items and item.removed_at is None:
            item.removed_at = clock.now()
    for position, text in enumerate(items):
        item = items_by_text.get(text) or ChecklistItem(
            studio_id=access.project.studio_id,
            project_id=project_id,
            category=category,
            text=text,
            written_by=actor.person,
        )
        item.place, item.removed_at = position, None
        session.add(item)
    session.flush()
    return approval_settings(session, actor, project_id)


def set_blockers(session: Session, actor: Actor, project_id: UUID, blockers: ApprovalBlockers) -> ApprovalSettingsRead:
    """Set the blockers of approval in a project."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    lock_project(session, project_id)
    rule = session.get(ApprovalRule, project_id)
    if rule is None:
        rule = ApprovalRule(project_id=project_id, studio_id=access.project.studio_id)
        session.add(rule)
    rule.blockers, rule.set_by, rule.set_at = blockers, actor.person, clock.now()
    session.flush()
    return approval_settings(session, actor, project_id)


def check_item(session: Session, actor: Actor, take_id: UUID, item_id: UUID, *, is_checked: bool) -> None:
    """Check an item for a take, or take that back; anyone of the team may."""
    take, access = take_for(session, actor, take_id)
    access.ensure_team()
    items = queries.items_for(session, take.project_id, take.cue.category) if take.cue else []
    if item_id not in {item.id for item in items}:
        raise ChecklistItemNotFound(f"no item {item_id} on the checklist of this version")
    if is_checked:
        row = {
            "take_id": take.id,
            "item_id": item_id,
            "studio_id": take.studio_id,
            "project_id": take.project_id,
            "checked_by": actor.person,
            "checked_at": clock.now(),
        }
        insert_if_absent(session, ItemCheck, row, unique=("take_id", "item_id"))
        return
    check = session.get(ItemCheck, (take.id, item_id))
    if check is not None:
        session.delete(check)
        session.flush()


def cue_checklist(session: Session, cue: Cue, takes: Sequence[OfCue]) -> CueChecklist:
    """Return a cue's checklist, what is checked of some takes, and which of them cannot be approved yet."""
    items = queries.items_for(session, cue.project_id, cue.category)
    checks = queries.checks_of(session, [take.id for take in takes]) if items else []
    return CueChecklist(
        blockers=queries.blockers_of(session, cue.project_id),
        items=_shown(items),
        checks=[ItemCheckRead.model_validate(check) for check in checks],
        blocked=blocked_takes(session, {cue: takes}).get(cue.id, []),
    )


def _shown(items: Sequence[ChecklistItem]) -> list[ChecklistItemRead]:
    return [ChecklistItemRead.model_validate(item) for item in items]
