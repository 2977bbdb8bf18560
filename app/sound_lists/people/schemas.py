"""Bodies about the people of cues."""

from uuid import UUID

from app.core.web.http import Schema


class CuePersonRead(Schema):
    """A person whom cues may name: a member of the studio, or a designer of the project."""

    id: UUID
    name: str
    is_designer: bool
