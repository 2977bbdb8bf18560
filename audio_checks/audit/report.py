"""What an audit found: an entry for each file, and the JSON that others read."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

from audio_checks.audit.statuses import STATUSES, Status
from audio_checks.version import TOOL_VERSION

SCHEMA_VERSION = 1


@dataclass(frozen=True)
class Match:
    """An approved sound that a file of the build holds; `score` is 1.0 for the same samples."""

    cue: str | None
    take: str | None
    path: str
    score: float


@dataclass(frozen=True)
class Entry:
    """What is said of one file of the build, or of one approved sound that is missing.

    Attributes
    ----------
    path : str
        Of the build's file; of the approved one where that is missing.
    gain_db, offset_s : float or None
        None where it is not the same sound.
    matches : tuple of Match
        Every approved sound that it holds, the likeliest first: libraries hold duplicates.
    approved : str or None
        The path of the approved sound that it was held to.
    """

    path: str
    status: Status
    gain_db: float | None = None
    offset_s: float | None = None
    matches: tuple[Match, ...] = ()
    message: str = ""
    approved: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return the entry as JSON has it."""
        return {
            "path": self.path,
            "status": self.status,
            "gain_db": None if self.gain_db is None else round(self.gain_db, 2) + 0.0,
            "offset_s": None if self.offset_s is None else round(self.offset_s, 4) + 0.0,
            "approved": self.approved,
            "message": self.message,
            "matches": [
                {"cue": match.cue, "take": match.take, "path": match.path, "score": match.score}
                for match in self.matches
            ],
        }


@dataclass(frozen=True)
class Audit:
    """What an audit found."""

    entries: tuple[Entry, ...]

    @property
    def summary(self) -> dict[str, int]:
        """How many files are what."""
        counts = Counter(entry.status for entry in self.entries)
        return {"files": len(self.entries), **{status: counts[status] for status in STATUSES}}

    def drifted(self, allowed: tuple[str, ...] = ()) -> tuple[Entry, ...]:
        """Return what is neither the same nor of a status that is allowed."""
        return tuple(entry for entry in self.entries if entry.status not in ("same", *allowed))

    def to_dict(self) -> dict[str, Any]:
        """Return the report as JSON has it."""
        return {
            "schema_version": SCHEMA_VERSION,
            "tool": {"name": "audio-checks", "version": TOOL_VERSION},
            "files": [entry.to_dict() for entry in self.entries],
            "summary": self.summary,
        }


def schema() -> dict[str, Any]:
    """Return the JSON Schema of the report of an audit."""
    text = {"type": ["string", "null"]}
    figure = {"type": ["number", "null"]}
    match = {
        "type": "object",
        "required": ["cue", "take", "path", "score"],
        "properties": {
            "cue": text,
            "take": text,
            "path": {"type": "string"},
            "score": {"type": "number", "minimum": 0, "maximum": 1},
        },
    }
    entry = {
        "type": "object",
        "required": ["path", "status", "gain_db", "offset_s", "approved", "message", "matches"],
        "properties": {
            "path": {"type": "string"},
            "status": {"enum": list(STATUSES)},
            "gain_db": figure,
            "offset_s": figure,
            "approved": text,
            "message": {"type": "string"},
            "matches": {"type": "array", "items": match},
        },
    }
    counts = ["files", *STATUSES]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Audit of audio-checks, schema version 1",
        "type": "object",
        "required": ["schema_version", "tool", "files", "summary"],
        "properties": {
            "schema_version": {"const": SCHEMA_VERSION},
            "tool": {"type": "object", "required": ["name", "version"]},
            "files": {"type": "array", "items": entry},
            "summary": {
                "type": "object",
                "required": counts,
                "properties": {name: {"type": "integer", "minimum": 0} for name in counts},
            },
        },
    }
