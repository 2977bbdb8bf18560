"""Answers about hours of work."""

from datetime import date
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema


class HoursSum(Schema):
    """Hours of cues that are neither accepted nor cut."""

    cues: int
    unknown: int = Field(description="Cues without an estimate; no hours are guessed for them.")
    left_h: float = Field(description="Of the estimates, less what was logged.")
    done_h: float = Field(description="Logged so far.")


class CategoryHours(HoursSum):
    """The hours of one category."""

    category: str


class WeekHours(Schema):
    """The hours due by the end of a week against the hours there are."""

    week_on: date = Field(description="Its Monday.")
    due_h: float = Field(description="Due in this week; in the first one, what is overdue too.")
    wanted_h: float = Field(description="Due from today to the end of this week.")
    there_h: float | None = Field(description="There from today to the end of this week; null where it is not known.")
    is_short: bool = Field(description="More is wanted by then than there is.")


class DesignerHours(HoursSum):
    """The hours of one designer in this project."""

    designer: PersonBrief
    undated: int = Field(description="Cues without a day, which are in no week.")
    roster_entry_id: UUID | None = Field(description="Where hours a week and booked days are kept; null: not on file.")
    weekly_hours: int | None = Field(description="As they say; null where that is not known.")
    weeks: list[WeekHours]


class ProjectHours(Schema):
    """Hours of a project's agreed work: wanted, done, and there."""

    total: HoursSum
    uncontracted: int = Field(description="Cues of the list that no agreed contract covers: their hours are unknown.")
    categories: list[CategoryHours]
    designers: list[DesignerHours]
