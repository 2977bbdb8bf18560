"""Answers about credits."""

from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema


class CreditRead(Schema):
    """One name under one role."""

    role: str
    name: str
    person_id: UUID | None
    line_id: UUID | None = Field(description="Of a name that was added by hand.")
    agreed_line: str = Field(description="What the person's contract says to the letter, or nothing.")


class ProjectCreditsRead(Schema):
    """The credits of a project as the caller sees them."""

    credits: list[CreditRead]
    left_out: int = Field(description="How many people want to be left out.")
    is_team: bool
    is_editor: bool
    my_name: str
    my_account_name: str
    am_left_out: bool
