"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class ReferenceNotFound(NotFound):
    """No reference of that id within the caller's sight."""


class ReferenceInvalid(Invalid):
    """A reference does not say what it is, or says what cannot be; `errors` names each field."""


class ReferenceUnopened(Conflict):
    """The file is sent to people whose opening of it was recorded."""


class NoPreview(NotFound):
    """No preview is drawn of this version: it is not a picture, not drawn yet, or one that could not be drawn."""
