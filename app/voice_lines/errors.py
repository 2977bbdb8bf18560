"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class VoiceLineNotFound(NotFound):
    """No voice line of that id within the caller's sight, or no text of it in that language."""


class CharacterNotFound(NotFound):
    """No character of that id within the caller's sight."""


class ReleaseNotFound(NotFound):
    """No release of that id within the caller's sight."""


class VoiceTextChanged(Conflict):
    """Another person changed the text since it was read."""


class ScriptUnreadable(Invalid):
    """A script cannot be read as it was sent."""


class SpeakerMissing(Invalid):
    """A sheet of voice lines does not say who speaks."""


class VoiceLineInvalid(Invalid):
    """A value does not fit; `errors` names each field."""
