"""What this room refuses, each named after the fact."""

from app.kit.errors import Forbidden, NotFound


class ProjectNotFound(NotFound):
    """No project of that id within the caller's sight."""


class TeamNeeded(Forbidden):
    """Only the game team may do this."""


class ProducerNeeded(Forbidden):
    """Only a producer of the studio may do this."""


class DeciderNeeded(Forbidden):
    """Only the project's decider may do this."""


class DesignerNeeded(Forbidden):
    """Only a designer engaged on the project may do this."""
