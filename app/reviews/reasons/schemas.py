"""The bodies of the studio's reasons and labels, and of those that were given."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.reviews.reasons.rules import MAX_REASON_CHARS, MAX_REASONS

ONE_LINE = r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029]*$"
Reason = Annotated[
    str, StringConstraints(strip_whitespace=True, min_length=1, max_length=MAX_REASON_CHARS, pattern=ONE_LINE)
]
Reasons = Annotated[list[Reason], Field(max_length=MAX_REASONS, description="Of the studio's list or in other words.")]


class ReasonListRead(Schema):
    """One list of a studio, in the order of the digits."""

    reasons: list[str]
    is_own: bool = Field(description="Whether the studio wrote it; otherwise it is ours.")


class ReviewReasonsRead(Schema):
    """A studio's most frequent reasons in Review, each on its digit."""

    change: ReasonListRead = Field(description="Why a change is requested.")
    pick: ReasonListRead = Field(description="Why a version is approved.")
    label: ReasonListRead = Field(description="What an alternate is.")


class ReviewReasonsSet(Schema):
    """Whole lists; one that is left out stays as it is, and an empty one gives ours back."""

    change: Reasons | None = None
    pick: Reasons | None = None
    label: Reasons | None = None


class ReasonCount(Schema):
    """The number of uses of a reason."""

    reason: str
    versions: int


class ReasonsRead(Schema):
    """The number of uses of each reason in a project, the most frequent first."""

    change: list[ReasonCount]
    pick: list[ReasonCount]
    designers: list[PersonBrief] = Field(description="Of whose versions reasons were given; a designer sees none.")
    categories: list[str] = Field(description="Of the cues; empty for cues without one.")


class ReasonPlaceRead(Schema):
    """A version of which a reason was given."""

    verdict_id: UUID
    take_id: UUID
    cue_id: UUID
    cue_label: str
    cue_name: str
    variation: int
    number: int
    label: str | None
    designer: PersonBrief
    given_by: PersonBrief | None
    on_behalf_of: PersonBrief | None
    given_at: datetime
    reasons: list[str] = Field(description="All that this verdict gave.")
    text: str = Field(description="What was written with it; a change has its reasons in it.")
    start_s: float | None
