"""Facts known of a designer from work for one studio."""

from datetime import datetime
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.money.schemas import HabitRead


class WorkedProject(Schema):
    """A project that a designer is or was engaged on."""

    id: UUID
    name: str
    since: datetime
    accepted: int = Field(description="Cues of theirs that were accepted.")


class WorkFigures(Schema):
    """Figures known of a designer from work for one studio; null where too little has happened for a figure."""

    studio_id: UUID
    studio_name: str
    projects: list[WorkedProject]
    accepted: int
    on_time: float | None = Field(description="Share of the cues accepted or overdue that were accepted by their day.")
    days_late: float | None = Field(description="The median, overdue cues so far; below zero: early.")
    first_pass: float | None = Field(
        description="Share of the cues accepted or sent back that were accepted as they came first."
    )
    rounds_per_cue: float | None = Field(description="Mean of the cues accepted or sent back, open ones so far.")
    revision_hours: float | None = Field(
        description="The median from changes that were sent to the next version; a longer wait counts so far."
    )
    estimates: HabitRead | None = Field(
        description="By how much work exceeded its estimates; for the designer and the studio's producers."
    )
