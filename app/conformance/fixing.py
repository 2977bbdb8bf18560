"""Code of the sandbox's child: writes a fixed copy into a folder; and the record of its result."""

from pathlib import Path
from typing import Any, TypeAlias

import audio_checks

MadeFix: TypeAlias = tuple[audio_checks.FixedMaster, tuple[audio_checks.Spot, ...]]


def fix(
    path: str,
    folder: str,
    spec: audio_checks.DeliverySpec,
    *,
    cue: audio_checks.CueFacts | None,
    name: str,
) -> MadeFix:
    """Fix a master into a folder; return what was done, and the sound around each repair."""
    fixed = audio_checks.fix_master(path, spec, folder, cue=cue, name=name)
    return fixed, audio_checks.repair_spots(Path(path), fixed)


def as_record(made: MadeFix) -> dict[str, Any]:
    """Return the record of a fix: the actions, the file that was made, and the sound around each repair."""
    fixed, spots = made
    result = fixed.to_dict()
    facts = result["after"]["facts"] if result["after"] else None
    rate = facts["sample_rate_hz"] if facts else 1
    return {
        "file": str(fixed.path) if fixed.path else None,
        "name": result["name"],
        "conforms": result["conforms"],
        "repairs": result["repairs"],
        "left": [{key: unfixed[key] for key in ("code", "severity", "message", "why")} for unfixed in result["left"]],
        "before": result["before"]["measurements"],
        "after": result["after"]["measurements"] if result["after"] else {},
        "cut_s": [frames / rate for frames in result["cut_frames"]],
        "duration_s": facts["duration_s"] if facts else None,
        "spots": [spot.to_dict() for spot in spots],
    }
