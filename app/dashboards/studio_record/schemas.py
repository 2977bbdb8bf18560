"""The content of a studio's record."""

from pydantic import Field

from app.core.web.http import Schema


class StudioRecord(Schema):
    """How a studio worked with designers so far; a figure is null where it happened fewer than three times."""

    studio_name: str
    review_hours: float | None = Field(description="The median from conforming to a verdict, over its projects.")
    answer_hours: float | None = Field(description="The median from a question to its answer.")
    days_to_pay: float | None = Field(description="The median from an invoice to its last payment.")
    rounds_per_cue: float | None = Field(description="Of the cues that were decided upon.")
    bonuses_promised: int = Field(description="Agreed contracts with a bonus.")
    bonuses_earned: int = Field(description="Those of which the bonus was earned.")
    bonuses_paid: int = Field(description="Those of which the bonus was paid in full.")
