"""What the page of a project's pace shows."""

from datetime import date
from uuid import UUID

from pydantic import Field

from app.kit.http import Schema


class WornCue(Schema):
    """A cue that took too many rounds, and is not accepted yet."""

    cue_id: UUID
    label: str
    name: str
    rounds: int


class StudioPace(Schema):
    """How soon the studio does its own part."""

    review_hours: float | None = Field(description="From conforming to a verdict, half of the time longer.")
    answer_hours: float | None = Field(description="From a question to its answer, half of the time longer.")
    open_questions: int
    days_to_pay: float | None = Field(description="From an invoice to its last payment, half of the time longer.")
    late_invoices: int


class CostsRead(Schema):
    """What a project costs in one currency, in whole minor units; figures of two currencies are never added."""

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


class Pace(Schema):
    """How a project goes: early warnings for both sides; null where too little has happened for a figure."""

    cues: int
    accepted: int
    first_pass: float | None = Field(description="Share of the decided cues that were accepted as they came first.")
    first_pass_lately: float | None = Field(description="The same of the last four weeks.")
    first_pass_before: float | None
    rounds_per_cue: float | None
    days_late: float | None = Field(description="By which accepted cues missed their day; below zero: early.")
    overdue: int
    finish_on: date | None = Field(description="At the pace of the last four weeks.")
    needed_on: date | None = Field(description="The last day on which a cue that is not accepted is needed.")
    worn: list[WornCue]
    studio: StudioPace
    costs: list[CostsRead] = Field(description="Of the contracts that the caller is a party to.")
    estimates: EstimateErrorRead | None = Field(description="For producers, and for designers of their own work.")
