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


class CostPerSound(Schema):
    """What a sound that was kept has cost so far, and what the rest would come to; in whole minor units."""

    currency: str
    accepted_minor: int
    per_kept_minor: int | None
    to_finish_minor: int | None = Field(description="What is agreed and not yet accepted or saved.")


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
    costs: list[CostPerSound] = Field(description="Of the contracts that the caller is a party to.")
