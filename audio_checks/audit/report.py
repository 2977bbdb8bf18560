"""Results of an audit: an entry for each file, and the JSON that others read."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

from audio_checks.audit.plays import Play
from audio_checks.audit.statuses import NO_DRIFT, STATUSES, Status
from audio_checks.middleware.values import Project
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
    """The report on one file of the build, or on one approved sound that is missing.

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
    plays : tuple of Play
        How the game plays it; empty without a project.
    played_status : str
        What happened to the level at which the game plays it, apart from the file: gain, converted, unused, depends or
        same.
    played_message : str
        The same in words.
    accepted : str
        Why this drift was accepted, where a baseline says so.
    """

    path: str
    status: Status
    gain_db: float | None = None
    offset_s: float | None = None
    matches: tuple[Match, ...] = ()
    message: str = ""
    approved: str | None = None
    plays: tuple[Play, ...] = ()
    played_status: Status = "same"
    played_message: str = ""
    accepted: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return the entry as JSON has it."""
        entry: dict[str, Any] = {
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
        if self.plays or self.played_message:
            entry["played_status"] = self.played_status
            entry["played_message"] = self.played_message
            entry["plays"] = [play.to_dict() for play in self.plays]
        if self.accepted:
            entry["accepted"] = self.accepted
        return entry

    def has_drifted(self, allowed: tuple[str, ...] = ()) -> bool:
        """Whether file or level are neither as approved, nor of a status that is allowed, nor accepted."""
        fine = (*NO_DRIFT, *allowed)
        return not self.accepted and (self.status not in fine or self.played_status not in fine)


@dataclass(frozen=True)
class Audit:
    """The result of an audit; `project` is None where the files alone were compared."""

    entries: tuple[Entry, ...]
    project: Project | None = None

    @property
    def summary(self) -> dict[str, int]:
        """Return file counts by status."""
        counts = Counter(entry.status for entry in self.entries)
        return {"files": len(self.entries), **{status: counts[status] for status in STATUSES}}

    def drifted(self, allowed: tuple[str, ...] = ()) -> tuple[Entry, ...]:
        """Return the entries neither the same nor of a status that is allowed."""
        return tuple(entry for entry in self.entries if entry.has_drifted(allowed))

    def to_dict(self) -> dict[str, Any]:
        """Return the report as JSON has it."""
        document: dict[str, Any] = {
            "schema_version": SCHEMA_VERSION,
            "tool": {"name": "audio-checks", "version": TOOL_VERSION},
            "files": [entry.to_dict() for entry in self.entries],
            "summary": self.summary,
        }
        if self.project is not None:
            document["project"] = {
                "engine": self.project.engine,
                "version": self.project.version,
                "unread": [unread.to_dict() for unread in self.project.unread],
            }
        return document


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
            "played_status": {"enum": ["same", "depends", "gain", "converted", "unused"]},
            "played_message": {"type": "string"},
            "plays": {"type": "array", "items": _play_schema()},
            "accepted": {"type": "string"},
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
            "project": {
                "type": "object",
                "required": ["engine", "version", "unread"],
                "properties": {
                    "engine": {"enum": ["wwise", "fmod", "unity", "unreal", "godot"]},
                    "version": {"type": "string"},
                    "unread": {
                        "type": "array",
                        "items": {"type": "object", "required": ["file", "line", "message"]},
                    },
                },
            },
            "summary": {
                "type": "object",
                "required": counts,
                "properties": {name: {"type": "integer", "minimum": 0} for name in counts},
            },
        },
    }


def _play_schema() -> dict[str, Any]:
    text, figure = {"type": "string"}, {"type": "number"}
    flag = {"type": ["boolean", "null"]}
    part = {"object": text, "property": text, "file": text, "gain_db": figure}
    moved = {
        **part,
        "approved_db": figure,
        "changelist": {"type": ["object", "null"], "required": ["id", "on", "subject"]},
    }
    depends = {
        "object": text,
        "property": text,
        "on": {"enum": ["state", "random", "distance", "effect", "loudness", "script"]},
        "what": text,
    }
    lists: dict[str, dict[str, Any]] = {
        "parts": part,
        "moved": moved,
        "depends": depends,
        "conversions": {"setting": text, "harm": text, "file": text},
    }
    return {
        "type": "object",
        "required": ["file", "object", "gain_db", "approved_db", "drift_db", "events", "used", *lists],
        "properties": {
            "file": text,
            "object": text,
            "gain_db": {"type": ["number", "null"]},
            "approved_db": {"type": ["number", "null"]},
            "drift_db": {"type": ["number", "null"]},
            "events": {"type": "array", "items": text},
            "used": flag,
            "looped": flag,
            "streamed": flag,
            **{
                name: {"type": "array", "items": {"type": "object", "required": list(keys), "properties": keys}}
                for name, keys in lists.items()
            },
        },
    }
