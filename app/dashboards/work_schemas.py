"""What is known of a designer from work for one studio."""

from datetime import datetime
from uuid import UUID

from pydantic import Field

from app.kit.http import Schema
from app.money.schemas import HabitRead


class WorkedProject(Schema):
    """A project that a designer is or was engaged on."""

    id: UUID
    name: str
    since: datetime
    accepted: int = Field(description="Cues of theirs that were accepted.")


class WorkFigures(Schema):
    """What is known of a designer from work for one studio; null where too little has happened for a figure."""

    studio_id: UUID
    studio_name: str
    projects: list[WorkedProject]
    accepted: int
    on_time: float | None = Field(description="Share of accepted cues with a day that were accepted by it.")
    days_late: float | None = Field(description="Half of them later; below zero: early.")
    first_pass: float | None = Field(description="Share of the decided cues that were accepted as they came first.")
    rounds_per_cue: float | None
    revision_hours: float | None = Field(
        description="From changes that were sent to the next version, half of the time longer."
    )
    estimates: HabitRead | None = Field(
        description="By how much work exceeded its estimates; for the designer and the studio's producers."
    )
