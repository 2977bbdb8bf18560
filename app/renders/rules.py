"""States and keys of renders, stated without a database."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Any, NamedTuple

import audio_checks
from app.deliveries.rules import TakeState
from audio_checks import DeliverySpec, Target, render_key

RENDERED_STATES = frozenset({TakeState.CONFORMING, TakeState.APPROVED, TakeState.SET_ASIDE})  # may still ship


class RenderState(StrEnum):
    """Whether the game file exists."""

    MADE = "made"
    REFUSED = "refused"


class BatchState(StrEnum):
    """The state of a batch."""

    PLANNING = "planning"
    RUNNING = "running"
    DONE = "done"
    CANCELLED = "cancelled"


OPEN_BATCHES = frozenset({BatchState.PLANNING, BatchState.RUNNING})


class ItemState(StrEnum):
    """The result for one game file of a batch."""

    WAITING = "waiting"
    MADE = "made"
    KEPT = "kept"  # the file that is there is the one that was wanted
    REFUSED = "refused"
    LEFT = "left"  # its take may not ship any more, or is checked again first


OF_ENDING = {
    ".wav": "audio/wav",
    ".ogg": "audio/ogg",
    ".opus": "audio/ogg",
    ".flac": "audio/flac",
    ".mp3": "audio/mpeg",
}
MEDIA_TYPES = tuple(dict.fromkeys(OF_ENDING.values()))  # of game files


def ending_of(facts: Mapping[str, Any]) -> str:
    """Return the ending of a game file's name, by the facts of its render."""
    return audio_checks.ending_of(facts.get("encoding", ""))


def game_ending(facts: Mapping[str, Any], made_to: Target, usual: str) -> str:
    """Return the ending of a game file's name: the usual one of its target, or its own where it is kept coded."""
    encoding = facts.get("encoding", "")
    is_kept = audio_checks.is_lossy(encoding) and encoding != made_to.encoding
    return ending_of(facts) if is_kept else usual


def media_type_of(facts: Mapping[str, Any]) -> str:
    """Return the media type of a game file, by the facts of its render."""
    return OF_ENDING[ending_of(facts)]


class Recipe(NamedTuple):
    """Everything but the master that decides what a game file becomes."""

    target: Target
    loop: bool
    sample_peak_limit_dbfs: float | None
    true_peak_limit_dbtp: float | None
    tolerance_db: float

    def key(self, master_sha256: str) -> str:
        """Return the key that identifies a render: another key means another file."""
        return render_key(master_sha256, **self._asdict())


def recipes(spec: DeliverySpec, *, category: str | None, loop: bool) -> dict[str, Recipe]:
    """Return a spec's recipes for a master of a category, by target."""
    view = spec.for_category(category)
    limits = view.limits
    return {
        name: Recipe(target, loop, limits.sample_peak_dbfs, limits.true_peak_dbtp, limits.tolerance_db)
        for name, target in view.targets.items()
    }
