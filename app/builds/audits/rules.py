"""Rules of audits of game builds and of the listening pass, stated without a database."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from app.builds.errors import ListeningNoteInvalid

SAME_DB = 0.1  # a level that differs by less is the same drift; audio-checks accepts drift by the same figure
MOST_MOVES = 8  # of one sound that are kept
MOST_NAMES = 8
MAX_AMOUNT_DB = 24.0


class AuditStatus(StrEnum):
    """An audit's verdict on a sound: the words of `audio-checks audit`."""

    SAME = "same"
    GAIN = "gain"
    TRIMMED = "trimmed"
    RESAMPLED = "resampled"
    RE_ENCODED = "re-encoded"
    CHANGED = "changed"
    MISSING = "missing"
    UNKNOWN = "unknown"
    PLACEHOLDER = "placeholder"
    DUPLICATE = "duplicate"
    CONVERTED = "converted"
    UNAPPROVED = "unapproved"
    UNUSED = "unused"
    DEPENDS = "depends"


NO_DRIFT = frozenset({AuditStatus.SAME, AuditStatus.DEPENDS})
NOT_IN_BUILD = frozenset(
    {
        *(AuditStatus.CHANGED, AuditStatus.MISSING, AuditStatus.UNKNOWN, AuditStatus.PLACEHOLDER),
        *(AuditStatus.UNAPPROVED, AuditStatus.UNUSED),
    }
)


class HeardAs(StrEnum):
    """A person's verdict on a sound that they heard, or looked for, in the game."""

    TOO_LOUD = "too-loud"
    TOO_SOFT = "too-soft"
    TOO_LONG = "too-long"
    TOO_SHORT = "too-short"
    WRONG = "wrong"
    MISSING = "missing"
    GOOD = "good"
    NOT_REACHED = "not-reached"


class TaskKind(StrEnum):
    """The demand of a task."""

    TOO_LOUD = "too-loud"
    TOO_SOFT = "too-soft"
    TOO_LONG = "too-long"
    TOO_SHORT = "too-short"
    WRONG = "wrong"
    MISSING = "missing"
    DRIFT = "drift"  # an audit found it, and it was sent back


class TaskRole(StrEnum):
    """Whose task it is."""

    IMPLEMENTER = "implementer"
    DESIGNER = "designer"


class CueMark(StrEnum):
    """A state of a cue in the game that a person sets by hand."""

    IN_BUILD = "in-build"
    HEARD = "heard"


UNHEARD = frozenset({HeardAs.MISSING, HeardAs.NOT_REACHED})
_OF_DESIGNER = frozenset({TaskKind.TOO_LONG, TaskKind.TOO_SHORT, TaskKind.WRONG})


def is_heard(heard_as: HeardAs) -> bool:
    """Whether a note means that its sound was heard in the game."""
    return heard_as not in UNHEARD


def task_of(heard_as: HeardAs) -> TaskKind | None:
    """Return the task that a note becomes; None where there is nothing to do."""
    return None if heard_as in (HeardAs.GOOD, HeardAs.NOT_REACHED) else TaskKind(heard_as.value)


def role_of(kind: TaskKind) -> TaskRole:
    """Return a task's role: levels and what the game does not play are set in the project, the rest in the file."""
    return TaskRole.DESIGNER if kind in _OF_DESIGNER else TaskRole.IMPLEMENTER


def ensure_amount(heard_as: HeardAs, amount_db: float | None) -> None:
    """Raise ListeningNoteInvalid unless a suggested gain goes with what was said: down if too loud, up if too soft."""
    if amount_db is None:
        return
    if heard_as not in (HeardAs.TOO_LOUD, HeardAs.TOO_SOFT):
        raise ListeningNoteInvalid(f"a sound that is {heard_as} has no gain to suggest; leave amount_db out")
    if (amount_db < 0) != (heard_as is HeardAs.TOO_LOUD) or not 0 < abs(amount_db) <= MAX_AMOUNT_DB:
        side = "below 0" if heard_as is HeardAs.TOO_LOUD else "above 0"
        raise ListeningNoteInvalid(
            f"{amount_db:+.1f} dB does not go with {heard_as}; send a gain {side}, of {MAX_AMOUNT_DB:.0f} dB at most"
        )


def has_drifted(status: AuditStatus, played_status: AuditStatus) -> bool:
    """Whether file or level are not as approved; a level that the game's state changes is not drift."""
    return status not in NO_DRIFT or played_status not in NO_DRIFT


def is_in_build(statuses: Sequence[tuple[AuditStatus, AuditStatus]]) -> bool:
    """Whether every file of a cue is in the build, and is played where the report knows that."""
    return bool(statuses) and all(NOT_IN_BUILD.isdisjoint(both) for both in statuses)


@dataclass(frozen=True)
class Drift:
    """The drift of one sound: named by an acceptance, and compared between two builds."""

    path: str
    status: AuditStatus
    played_status: AuditStatus
    gain_db: float | None

    def is_same(self, other: "Drift") -> bool:
        """Whether another drift of the sound is this one: another level, or another change, is not."""
        if (self.path, self.status, self.played_status) != (other.path, other.status, other.played_status):
            return False
        if self.gain_db is None or other.gain_db is None:
            return self.gain_db is None and other.gain_db is None
        return abs(self.gain_db - other.gain_db) < SAME_DB


@dataclass(frozen=True)
class PlayedLevel:
    """A sound's level in a build: its parts, and the things that changed them."""

    file_db: float | None
    property_db: float | None
    moves: list[dict[str, Any]]
    depends: list[str]
    events: list[str]


def played_level(entry: Mapping[str, Any]) -> PlayedLevel:
    """Return the level of one entry of a report, by the way of playing it that drifted most.

    The figures are differences from what was approved, in dB; None where the report knows none.
    """
    plays = [play for play in entry.get("plays") or [] if play["used"] is not False]
    worst = max(plays, key=lambda play: abs(play["drift_db"] or 0.0), default=None)
    property_db = worst["drift_db"] if worst else None
    gain_db = entry["gain_db"]
    moved_by_property = property_db if property_db is not None and entry.get("played_status") == "gain" else 0.0
    moves = sorted(worst["moved"] if worst else [], key=lambda move: -abs(move["gain_db"] - move["approved_db"]))[
        :MOST_MOVES
    ]
    depends = dict.fromkeys(
        dependency["what"] for play in plays for dependency in play["depends"] if dependency["on"] != "distance"
    )
    events = dict.fromkeys(name for play in plays for name in play["events"])
    return PlayedLevel(
        file_db=None if gain_db is None else round(gain_db - moved_by_property, 2),
        property_db=property_db,
        moves=[dict(move) for move in moves],
        depends=[*depends][:MOST_NAMES],
        events=[*events][:MOST_NAMES],
    )
