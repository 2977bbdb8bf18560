"""What this room asks the rooms above it, in its own transaction."""

from dataclasses import dataclass
from uuid import UUID

from app.core.events import Signal


@dataclass(frozen=True)
class NeededPeople(Signal[dict[UUID, str]]):
    """Asks for the people whom a room needs in a project, each with what they are there."""

    project_id: UUID
