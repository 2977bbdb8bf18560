"""What this room refuses, each named after the fact."""

from app.kit.errors import Conflict, NotFound


class DeliveryNotFound(NotFound):
    """No delivery of that id within the caller's sight."""


class TakeNotFound(NotFound):
    """No take of that id within the caller's sight."""


class WrongState(Conflict):
    """The take is not in a state from which this can be done."""
