"""Answers of what a designer owes in all of their projects."""

from datetime import date, datetime
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.dashboards.rules import CueStatus
from app.deliveries.schemas import CueBrief


class LatestComment(Schema):
    """The last words on the caller's work for a cue."""

    text: str
    by: str | None = Field(description="Who said it; null: the check.")
    at: datetime


class OwedCue(Schema):
    """A cue that waits for a file from the caller."""

    cue: CueBrief
    project_id: UUID
    project_name: str
    studio_name: str
    status: CueStatus
    due_on: date | None
    latest_comment: LatestComment | None


class OwnDesk(Schema):
    """The caller's owed work in all projects that they are engaged on, the soonest due first; in pages."""

    person: PersonBrief
    projects: int = Field(description="Projects that the caller is engaged on and whose list they see.")
    items: list[OwedCue]
    next: str | None
