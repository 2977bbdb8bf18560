"""The bodies of checklists, and of what blocks approval."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.reviews.rules import ApprovalBlockers

MAX_ITEMS = 30
MAX_ITEM_CHARS = 200
NO_NUL = "^[^\\x00]*$"  # PostgreSQL takes none in text
Item = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=MAX_ITEM_CHARS, pattern=NO_NUL)]

Category = Annotated[
    str, StringConstraints(strip_whitespace=True, to_lower=True, max_length=60, pattern=r"^([^\W_][\w-]*)?$")
]


class ChecklistItemRead(Schema):
    """Something to check of a version."""

    id: UUID
    category: str = Field(description="Empty for an item of every cue.")
    text: str


class ChecklistRead(Schema):
    """Items to check of the versions of one category, in order."""

    category: str = Field(description="Empty for the checklist of every cue.")
    items: list[ChecklistItemRead]


class ApprovalSettingsRead(Schema):
    """The checklists of a project, and what blocks approval there."""

    blockers: ApprovalBlockers
    checklists: list[ChecklistRead]


class ChecklistSet(Schema):
    """The checklist of one category; an item that is written as before keeps its checks."""

    category: Category = Field(description="Empty for the checklist of every cue.")
    items: list[Item] = Field(max_length=MAX_ITEMS, description="In order; none removes the checklist.")


class ApprovalBlockersSet(Schema):
    """The blockers of approval in a project."""

    blockers: ApprovalBlockers


class ItemCheckSet(Schema):
    """Whether an item is checked."""

    is_checked: bool


class ItemCheckRead(Schema):
    """The checker of an item for a version, and the time."""

    take_id: UUID
    item_id: UUID
    by: PersonBrief = Field(validation_alias="person")
    checked_at: datetime


class BlockedTake(Schema):
    """A version that cannot be approved yet."""

    take_id: UUID
    why: str = Field(description="What is open, in words.")


class CueChecklist(Schema):
    """The checklist of a cue, what is checked of its versions, and which of them cannot be approved yet."""

    blockers: ApprovalBlockers
    items: list[ChecklistItemRead]
    checks: list[ItemCheckRead]
    blocked: list[BlockedTake]
