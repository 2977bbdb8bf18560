"""What a contract may be and become, stated without a database."""

from enum import StrEnum


class ContractKind(StrEnum):
    """What is agreed by one text."""

    NDA = "nda"
    FRAMEWORK = "framework"  # rights and rates once, for many batches
    STATEMENT_OF_WORK = "statement_of_work"  # one batch under a framework: cues, price, dates
    SINGLE = "single"  # all of it in one text


class ContractState(StrEnum):
    """How far the parties are."""

    DRAFT = "draft"
    SENT = "sent"
    AGREED = "agreed"
    ENDED = "ended"


class ReleaseClause(StrEnum):
    """When an accepted cue's share becomes due."""

    PER_CUE = "per_cue"
    ON_COMPLETION = "on_completion"  # with the last cue of its milestone


class Party(StrEnum):
    """Who agrees with whom."""

    STUDIO = "studio"
    DESIGNER = "designer"


class LineKind(StrEnum):
    """Why a line of the ledger was written."""

    DEPOSIT = "deposit"
    ACCEPTED = "accepted"
    HELD_BACK = "held_back"  # what of an accepted cue's share waited for the last cue
    CUT = "cut"
    EXTRA_ROUND = "extra_round"
    WORKED_DAY = "worked_day"
    TAX = "tax"
    REVERSED = "reversed"  # takes back a line of any kind above
    PAID = "paid"
    REFUNDED = "refunded"  # takes back a line of a payment


class WorkState(StrEnum):
    """How far the work on a cue was when it was cut."""

    NOT_BEGUN = "not_begun"
    IN_WORK = "in_work"
    DELIVERED = "delivered"  # every variation conforms and waits for the decider
    ACCEPTED = "accepted"
