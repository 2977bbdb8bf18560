"""The studio's lists of reasons and labels, stated without a database."""

from collections.abc import Mapping, Sequence
from enum import StrEnum

from app.reviews.errors import ReasonsInvalid

MAX_REASONS = 9  # one for each digit
MAX_REASON_CHARS = 40


class ReasonKind(StrEnum):
    """The purpose of a list of the studio."""

    CHANGE = "change"  # why a change is requested
    PICK = "pick"  # why a take is approved
    LABEL = "label"  # what an alternate is


# What a studio without a list of its own has.
OURS: Mapping[ReasonKind, tuple[str, ...]] = {
    ReasonKind.CHANGE: (
        "Too loud",
        "Too quiet",
        "Too long",
        "Too short",
        "Starts too late",
        "Too bright",
        "Too dull",
        "Doesn’t read in game",
        "Off style",
    ),
    ReasonKind.PICK: (
        "Fits the scene",
        "Best timing",
        "Best weight",
        "Cleanest",
        "Most readable",
        "Most like the palette",
    ),
    ReasonKind.LABEL: ("longer", "shorter", "layered", "dry", "wild", "safe"),
}


def ensure_distinct(reasons: Sequence[str], where: str) -> None:
    """Raise ReasonsInvalid where a list has a reason twice, be it in other letters."""
    seen: set[str] = set()
    for index, reason in enumerate(reasons):
        if reason.casefold() in seen:
            message = f"“{reason}” is in the list twice"
            raise ReasonsInvalid(
                message, errors=[{"where": f"{where}.{index}", "message": message}], fix="keep one of the two"
            )
        seen.add(reason.casefold())
