"""The refusals of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class NoticeGiven(Conflict):
    """A notice stands already; a contract ends once."""


class NoNotice(Conflict):
    """No notice stands that could be withdrawn or agreed to."""


class NoticeTooShort(Invalid):
    """The contract wants more days of notice than that."""


class AlreadyEnded(Conflict):
    """The contract is not agreed any more, or is settled."""


class BadChangeOrder(Invalid):
    """A change order asks for what cannot be; its errors say what and why."""


class ChangeOrderNotFound(NotFound):
    """The contract has no change order of that number."""


class ChangeOrderClosed(Conflict):
    """The change order was agreed, refused or withdrawn."""


class ChangeOrderStale(Conflict):
    """The subject of the change order has changed since it was proposed."""


class NotInForce(Conflict):
    """Only an agreed contract that orders work is changed by change orders."""


class OwnChangeOrder(Conflict):
    """The proposer of a change order withdraws it; the other party refuses it."""


class NotOwnChangeOrder(Conflict):
    """A party that did not propose a change order refuses it; the other party withdraws it."""


class OfferSettled(Conflict):
    """Nothing of that kind is offered to the caller's party: a change order has it, or it was dismissed."""
