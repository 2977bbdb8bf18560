"""The content of the page of a project's pace."""

from datetime import date
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema


class WornCue(Schema):
    """A cue that took too many rounds, and is not accepted yet."""

    cue_id: UUID
    label: str
    name: str
    rounds: int


class StudioPace(Schema):
    """The studio's speed in its own part."""

    review_hours: float | None = Field(
        description="The median from conforming to a verdict; a longer wait without one counts for as long as it lasts."
    )
    waiting_reviews: int = Field(description="Versions that wait for a verdict.")
    longest_review_wait_hours: float | None = Field(description="Of the versions that wait; null where none does.")
    answer_hours: float | None = Field(
        description="The median from a question to its answer; a longer wait counts for as long as it lasts."
    )
    open_questions: int
    longest_answer_wait_hours: float | None = Field(description="Of the open questions; null where there is none.")
    days_to_pay: float | None = Field(
        description="The median from an invoice to its last payment; a longer unpaid one counts for as long as it is."
    )
    late_invoices: int


class CostsRead(Schema):
    """The cost of a project in one currency, in whole minor units; figures of two currencies are never added."""

    currency: str
    budget_minor: int | None = Field(description="As producers set it; null where none is set, and for designers.")
    committed_minor: int = Field(description="Agreed with change orders and extras, less what was saved.")
    spent_minor: int = Field(description="Paid and due.")
    paid_minor: int
    due_minor: int
    kept: int = Field(description="Ordered cues that were accepted and are not cut.")
    per_kept_minor: int | None = Field(description="Spent money by kept sounds.")
    to_finish_minor: int = Field(description="What is agreed and neither due nor saved.")
    ordered: int = Field(description="Cues under agreed contracts.")
    churned: int = Field(description="Ordered cues that were cut or rewritten after work began.")
    churn: float | None = Field(description="The share of the ordered cues; null for fewer than three.")
    churned_minor: int = Field(description="What was agreed for the churned cues.")


class EstimateErrorRead(Schema):
    """The estimates of accepted cues against the time that was logged for them."""

    cues: int
    estimated_min: int
    logged_min: int
    error_percent: float = Field(description="Above zero it took longer than estimated.")


class OverEstimateRead(Schema):
    """The open cues whose logged time exceeds their estimate already."""

    cues: int
    over_min: int


class Pace(Schema):
    """The pace of a project: early warnings for both sides; null where too little has happened for a figure."""

    cues: int
    accepted: int
    first_pass: float | None = Field(
        description="Share of the cues accepted or sent back that were accepted as they came first."
    )
    first_pass_lately: float | None = Field(description="The same of the last four weeks.")
    first_pass_before: float | None
    rounds_per_cue: float | None = Field(description="Mean of the cues accepted or sent back, open ones so far.")
    days_late: float | None = Field(
        description="The median by which cues missed their day, overdue ones so far; below zero: early."
    )
    overdue: int
    finish_on: date | None = Field(
        description="At the pace of the last four weeks, or since the first decision where that is later."
    )
    needed_on: date | None = Field(description="The last day on which a cue that is not accepted is needed.")
    worn: list[WornCue]
    studio: StudioPace
    costs: list[CostsRead] = Field(description="Of the contracts that the caller is a party to.")
    estimates: EstimateErrorRead | None = Field(description="For producers, and for designers of their own work.")
    over_estimate: OverEstimateRead | None = Field(description="For the same; null where no open cue exceeds its own.")
