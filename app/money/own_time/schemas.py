"""Inputs and answers of the endpoints of time without a contract."""

from collections.abc import Sequence
from datetime import date
from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.money.schemas import ContractedCue, Words
from app.money.work.schemas import DAY_MIN


class OwnTimeAdd(Schema):
    """Time of one day; of a bid, where the posting is all that the caller sees of the project."""

    cue_id: UUID | None = Field(default=None, description="What the time went into; else the note says it.")
    posting_id: UUID | None = Field(default=None, description="Of the bid that it went into.")
    minutes: Annotated[int, Field(ge=1, le=DAY_MIN)]
    worked_on: date
    note: Words = ""


class OwnTimeRead(Schema):
    """Time that the caller logged."""

    id: UUID
    cue: ContractedCue | None
    minutes: int
    worked_on: date
    note: str


class CategoryHabit(Schema):
    """The time that a cue of one category takes the caller, variations included."""

    category: str
    cues: int
    low_min: int = Field(description="A quarter of the cues took less.")
    high_min: int = Field(description="A quarter of the cues took more.")


class OwnTimes(Schema):
    """Time that the caller logged in a project without a contract, and how long a cue takes them."""

    times: Sequence[OwnTimeRead] = Field(description="The newest first.")
    categories: Sequence[CategoryHabit] = Field(
        description="Of cues with an approved version of the caller's, in all projects of the studio; time under"
        " contracts counts too. Categories of fewer than three cues are left out."
    )
