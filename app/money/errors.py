"""Refusals of money, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound


class NoShippingBonus(Conflict):
    """No bonus of the contract waits for the game to ship, or it is said already."""


class NotAgreed(Conflict):
    """Money is invoiced, paid and logged under an agreed contract only."""


class NoInterestDue(Conflict):
    """No interest is due on the invoice, or it is charged up to today."""


class NothingToInvoice(Conflict):
    """Nothing is due that is not on an invoice already."""


class InvoiceNumberTaken(Conflict):
    """The designer has issued another invoice under this number."""


class InvoiceNotFound(NotFound):
    """No invoice of that id within the caller's sight."""


class PaymentNotFound(NotFound):
    """No payment of that id within the caller's sight."""


class Overpayment(Invalid):
    """A payment is none, or more than what is open on its invoice."""


class RefundTooLarge(Invalid):
    """A refund is none, or more than what is left of its payment."""


class ExtraRoundNotFound(NotFound):
    """No round of that id beyond the included ones within the caller's sight."""


class RoundAlreadySettled(Conflict):
    """The extra round was agreed or dropped already."""


class CueNotInContract(NotFound):
    """The contract does not cover that cue."""


class OtherPartyNeeded(Forbidden):
    """Only the other party of the contract can do this."""


class CalendarNotFound(NotFound):
    """No calendar behind this link; it may have been withdrawn."""


class NotDayRate(Conflict):
    """The contract does not pay by the day."""


class NotHourly(Conflict):
    """The contract does not pay by the hour."""


class DayAgreed(Conflict):
    """The studio agreed to this work already."""


class DayRefused(Conflict):
    """The studio refused this work; its designer can correct it and send it again."""


class DayLogged(Conflict):
    """Another entry of a contract by the day has this day."""


class WorkNotNamed(Invalid):
    """Hours name neither a cue nor what they were for."""


class DayInFuture(Invalid):
    """A day of work or of a payment that has not come yet."""


class InvoiceDetailsMissing(Conflict):
    """An electronic invoice lacks a field of one of the parties."""


class NoElectronicInvoice(Invalid):
    """The standard has no way to write this invoice."""


class MilestoneNotFound(NotFound):
    """No milestone of that id within the caller's sight."""


class CapExceeded(Conflict):
    """The days or hours that were agreed on are used up."""


class WorkedDayNotFound(NotFound):
    """No logged work of that id within the caller's sight."""


class OwnTimeNotFound(NotFound):
    """The caller logged no such time."""
