"""What this room refuses, each named after the fact."""

from app.kit.errors import Conflict, Invalid


class NoticeGiven(Conflict):
    """A notice stands already; a contract ends once."""


class NoNotice(Conflict):
    """No notice stands that could be withdrawn or agreed to."""


class NoticeTooShort(Invalid):
    """The contract wants more days of notice than that."""


class AlreadyEnded(Conflict):
    """The contract is not agreed any more, or is settled."""
