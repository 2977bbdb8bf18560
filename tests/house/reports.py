"""Reports of `audio-checks` on nothing and on one file, as part of one of everything."""

from typing import Any


def report_file() -> dict[str, Any]:
    """Return a report's object of one file without findings."""
    return {
        "path": "shield_hit.wav",
        "sha256": "0" * 64,
        "pcm_sha256": "0" * 64,
        "category": None,
        "verdict": "conforming",
        "facts": {"container": "wav", "sample_rate_hz": 44_100, "bit_depth": 16, "channels": 1, "duration_s": 1.0},
        "measurements": {},
        "judgements": {},
        "findings": [],
    }


def report() -> dict[str, Any]:
    """Return a report of no files."""
    summary = dict.fromkeys(("files", "conforming", "rejected", "unreadable", "unjudged", "errors", "warnings"), 0)
    return {
        "schema_version": 1,
        "tool": {"name": "audio-checks", "version": "1"},
        "spec": None,
        "files": [],
        "summary": summary,
    }
