"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class MailNotFound(NotFound):
    """No mail of that id within the caller's sight."""


class MailBusy(Conflict):
    """Another worker is handing this mail to the server."""


class MailLinkNotFound(NotFound):
    """The link at the end of a mail is altered, cut short, or of another server."""


class ContractMailNeeded(Invalid):
    """Mails about contracts and payments are not turned off."""


class QuietHoursUnclear(Invalid):
    """Quiet hours need a begin and an end that differ."""


class MailNotFailed(Conflict):
    """The mail was sent, is on its way, or contains no link that could be handed over."""
