"""What a render may be, stated without a database."""

from enum import StrEnum


class RenderState(StrEnum):
    """Whether the game file exists."""

    MADE = "made"
    REFUSED = "refused"
