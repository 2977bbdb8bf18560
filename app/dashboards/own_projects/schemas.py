"""Answers about the projects of a designer."""

from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.shares.playlist_schemas import PlaylistBrief


class Colleague(Schema):
    """A person with whom the caller works."""

    person: PersonBrief
    role: str = Field(examples=["Audio lead"])


class OwnProject(Schema):
    """A project that the caller is engaged on, as they may tell of it."""

    project_id: UUID
    project_name: str
    studio_name: str
    credit_name: str
    is_left_out: bool = Field(description="The caller wants no credit.")
    credit_roles: list[str] = Field(description="Empty while nothing of theirs is approved.")
    agreed_line: str = Field(description="What the contract says of the credit to the letter, or nothing.")
    shown_from: str = Field(description="From when the work may be shown, as the contract says; or nothing.")
    people: list[Colleague]
    playlists: list[PlaylistBrief] = Field(description="Those with sounds of theirs, and of others as they hear them.")
