"""What a cue may be, stated without a database."""

from enum import StrEnum


class CueState(StrEnum):
    """How settled a cue is."""

    CONCEPT = "concept"
    PROTOTYPE = "prototype"
    LOCKED = "locked"
    CUT = "cut"


class Reverb(StrEnum):
    """Whether the file carries reverb of its own."""

    DRY = "dry"
    DESIGNED_TAIL = "designed-tail"
    SEPARATE_TAIL = "separate-tail"


MAX_VARIATIONS = 99
