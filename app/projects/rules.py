"""Who decides, who is engaged, what a number looks like: without a database."""

from enum import StrEnum


class EngagementKind(StrEnum):
    """A designer's tie to a project."""

    ADVISORY = "advisory"
    CONTRACT = "contract"
    IN_HOUSE = "in-house"
