"""Accepted drift: what an audit lets through, kept in the baseline file of `check` under a key of its own.

    {"format": 1, "waived": [],
     "accepted": [{"path": "foot_deck.wav", "status": "gain", "played_status": "gain", "gain_db": 6.0,
                   "reason": "quiet under the battle music", "on": "2026-12-04"}]}

An entry lets through the drift that it names and no other: a sound turned up further is found again.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

from audio_checks.audit.report import Audit, Entry
from audio_checks.errors import SpecError
from audio_checks.run.baseline import DEFAULT_NAME, read_baseline
from audio_checks.system.atomic_write import write_atomically
from audio_checks.system.text_files import read_text

__all__ = ["DEFAULT_NAME", "accept", "read_accepted", "with_accepted"]

SAME_DB = 0.1  # a drift that differs by less is the accepted one
LONGEST_REASON = 1_024
Key = tuple[str, str, str]


def read_accepted(path: str | Path) -> Mapping[Key, list[tuple[float | None, str]]]:
    """Return the accepted drifts, by path and statuses: the gain in dB, and the reason with its day.

    Raises
    ------
    SpecError
        The file holds no baseline.
    """
    accepted: dict[Key, list[tuple[float | None, str]]] = {}
    for index, entry in enumerate(_document(path).get("accepted", [])):
        key, gain_db, reason = _entry(entry, f"{path}: accepted[{index}]")
        accepted.setdefault(key, []).append((gain_db, reason))
    return accepted


def with_accepted(audit: Audit, accepted: Mapping[Key, Sequence[tuple[float | None, str]]]) -> Audit:
    """Return an audit whose accepted drifts say why they are let through."""
    return replace(audit, entries=tuple(_with_reason(entry, accepted) for entry in audit.entries))


def accept(path: str | Path, audit: Audit, allowed: tuple[str, ...], reason: str) -> int:
    """Let through what has drifted now; return how many entries were added.

    Raises
    ------
    SpecError
        What stands at the path is not a baseline.
    OSError
        It cannot be written.
    """
    document: dict[str, Any] = _document(path) if Path(path).exists() else {"format": 1, "waived": []}
    added = [
        {
            "path": entry.path,
            "status": entry.status,
            "played_status": entry.played_status,
            "gain_db": entry.gain_db,
            "reason": reason,
            "on": date.today().isoformat(),  # noqa: DTZ011 - the day of the person who accepts
        }
        for entry in audit.drifted(allowed)
    ]
    document["accepted"] = [*document.get("accepted", []), *added]
    write_atomically(path, json.dumps(document, indent=2) + "\n")
    return len(added)


def _with_reason(entry: Entry, accepted: Mapping[Key, Sequence[tuple[float | None, str]]]) -> Entry:
    for gain_db, reason in accepted.get((entry.path, entry.status, entry.played_status), ()):
        if (gain_db is None) == (entry.gain_db is None) and abs((gain_db or 0.0) - (entry.gain_db or 0.0)) < SAME_DB:
            return replace(entry, accepted=reason)
    return entry


def _document(path: str | Path) -> dict[str, Any]:
    read_baseline(path)  # refuses what is not a baseline
    document: dict[str, Any] = json.loads(read_text(Path(path)))
    if not isinstance(document.get("accepted", []), list):
        raise SpecError("accepted must be a list", where=str(path))
    return document


def _entry(entry: object, where: str) -> tuple[Key, float | None, str]:
    texts = ("path", "status", "played_status", "reason", "on")
    if not isinstance(entry, dict) or not all(isinstance(entry.get(name), str) for name in texts):
        raise SpecError(f"wanted an object with the texts {', '.join(texts)}", where=where)
    gain_db = entry.get("gain_db")
    if gain_db is not None and (isinstance(gain_db, bool) or not isinstance(gain_db, int | float)):
        raise SpecError("gain_db must be a number or null", where=where)
    if not entry["reason"].strip() or len(entry["reason"]) > LONGEST_REASON:
        raise SpecError(f"reason must have 1 to {LONGEST_REASON:,} characters", where=where)
    return (entry["path"], entry["status"], entry["played_status"]), gain_db, f"{entry['reason']} ({entry['on']})"
