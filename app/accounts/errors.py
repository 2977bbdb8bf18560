"""What this room refuses, each named after the fact."""

from app.kit.errors import Forbidden, NotFound, Refused


class NotSignedIn(Refused):
    """No credential came with the request, or it is no longer good."""

    status = 401


class PersonNeeded(Forbidden):
    """Only a person can do this."""


class ScopeMissing(Forbidden):
    """The build's token lacks the scope for this."""


class CsrfMismatch(Forbidden):
    """The request carries our cookie, but does not come from our page."""


class StudioNotFound(NotFound):
    """No studio of that id within the caller's sight."""


class ProducerNeeded(Forbidden):
    """Only a producer of the studio may do this."""
