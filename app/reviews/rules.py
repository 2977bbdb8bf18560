"""What a verdict does, stated without a database."""

from enum import StrEnum


class VerdictKind(StrEnum):
    """What the decider said of a take."""

    APPROVE = "approve"
    REQUEST_CHANGE = "request_change"
    SET_ASIDE = "set_aside"
