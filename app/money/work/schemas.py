"""Inputs and answers of the endpoints of days and hours; amounts are in minor units of the contract's currency."""

from collections.abc import Sequence
from datetime import date, datetime
from typing import Annotated, Literal, Self
from uuid import UUID

from pydantic import Field, StringConstraints, model_validator

from app.core.web.http import Schema
from app.money.schemas import ContractedCue, Words

DAY_MIN = 24 * 60


class WorkedDayAdd(Schema):
    """Work of one day: a day or quarters of one where the contract pays by the day, minutes where by the hour."""

    worked_on: date
    quarters: Annotated[int, Field(ge=1, le=4)] | None = Field(
        default=None, description="Of a day; a whole day where neither quarters nor minutes are given."
    )
    minutes: Annotated[int, Field(ge=1, le=DAY_MIN)] | None = None
    cue_id: UUID | None = Field(default=None, description="What hours went into; else the note says it.")
    note: Words = ""

    @model_validator(mode="after")
    def _in_one_unit(self) -> Self:
        if self.quarters is not None and self.minutes is not None:
            raise ValueError("quarters and minutes are given; send quarters for a day, or minutes for hours")
        if self.minutes is None and self.quarters is None:
            self.quarters = 4
        return self


class WorkRefusal(Schema):
    """A reason to refuse logged work, for its designer to read."""

    reason: Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=2_000)]


class WorkedDayRead(Schema):
    """Logged work; due once the studio has agreed."""

    id: UUID
    worked_on: date
    quarters: int | None = Field(description="Of a day; null for hours.")
    minutes: int | None = Field(description="Null for days.")
    cue: ContractedCue | None
    note: str
    state: Literal["waiting", "agreed", "refused"]
    amount_minor: int = Field(description="What it costs; of waiting hours, if they are approved in their order.")
    agreed_at: datetime | None
    refused_at: datetime | None
    refusal: str


class DayRateRead(Schema):
    """The day's price in a contract by the day, and the most days paid."""

    day_rate_minor: int
    days_cap: int
    agreed_minor: int
    cap_minor: int


class HoursMonthRead(Schema):
    """A month of a contract by the hour, counted from the agreement."""

    number: int
    begins_on: date
    is_retained: bool = Field(description="The retainer is paid for it.")
    approved_min: int
    waiting_min: int
    left_min: int = Field(description="How much more the contract pays for in it.")


class HoursRead(Schema):
    """A contract's pay for hours and as a retainer, and the used part of it."""

    rate_minor: int = Field(description="An hour beyond those that the retainer includes; 0: none is paid.")
    cap_min: int
    month_cap_min: int
    paid_min: int = Field(description="Approved, and paid by the hour.")
    retainer_minor: int = Field(description="A month; 0: the contract has no retainer.")
    included_min: int = Field(description="In a month of the retainer.")
    retainer_months: int
    months: Sequence[HoursMonthRead] = Field(description="The last twelve, the oldest first.")
