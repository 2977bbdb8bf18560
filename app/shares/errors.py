"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound


class GuestLinkNotFound(NotFound):
    """No guest link of that id within the caller's sight, or one that opens nothing any more."""


class GuestPasswordWrong(Forbidden):
    """The link asks for a password, and this is not it."""


class GuestLinkInvalid(Invalid):
    """A guest link says what cannot be; `errors` names each field."""


class GuestVisitOver(NotFound):
    """The visit is unknown or over, or its link was revoked or has expired."""


class NothingToShare(Conflict):
    """None of what was chosen has a version that can be played."""


class GuestSoundNotFound(NotFound):
    """The link has no sound in that place."""


class GuestSoundNotMade(Conflict):
    """The sound cannot be played yet, or its preview with beeps could not be made."""


class GuestSoundUnplayed(Conflict):
    """A preview is sent to guests whose playing of it was recorded."""


class CommentsClosed(Forbidden):
    """The link is for listening only."""


class PlaylistNotFound(NotFound):
    """No playlist of that id within the caller's sight."""


class PlaylistChanged(Conflict):
    """Another person changed the playlist since it was read."""


class PlaylistInvalid(Invalid):
    """A playlist says what cannot be; `errors` names each field."""


class ControlTaken(Conflict):
    """Another person has control of the session."""


class PlayheadMoved(Conflict):
    """The playhead was moved since the caller's last look."""


class ListenerNotFound(NotFound):
    """The person is not in the session."""


class SavedViewNotFound(NotFound):
    """No view of that id of the caller's own."""


class SavedViewInvalid(Invalid):
    """A view cannot be saved so; `errors` names each field."""
