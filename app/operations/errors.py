"""Refusals of this room."""

from app.core.errors import Conflict, Invalid, NotFound


class JobNotFound(NotFound):
    """No unfinished job of that id within the caller's sight."""


class JobNotParked(Conflict):
    """The job waits or runs already, so there is nothing to try again."""


class ErasureRefused(Conflict):
    """Something requires that this stays, or ends first."""


class NotASample(Conflict):
    """The project is not a sample, and goes by a confirmed erasure only."""


class ConfirmationMismatch(Invalid):
    """The typed confirmation is not the name of what is to be erased."""
