"""What runs in the sandbox's child: a mended copy written into a folder, told in plain values."""

from pathlib import Path
from typing import Any

import audio_checks


def mend(
    path: str,
    folder: str,
    spec: audio_checks.DeliverySpec,
    *,
    cue: audio_checks.CueFacts | None,
    name: str,
) -> dict[str, Any]:
    """Mend a master into a folder; return what was done, the file that was made, and the sound around each repair."""
    mended = audio_checks.mend_master(path, spec, folder, cue=cue, name=name)
    told = mended.to_dict()
    facts = told["after"]["facts"] if told["after"] else None
    rate = facts["sample_rate_hz"] if facts else 1
    return {
        "file": str(mended.path) if mended.path else None,
        "name": told["name"],
        "conforms": told["conforms"],
        "repairs": told["repairs"],
        "left": [{key: one[key] for key in ("code", "severity", "message", "why")} for one in told["left"]],
        "before": told["before"]["measurements"],
        "after": told["after"]["measurements"] if told["after"] else {},
        "cut_s": [frames / rate for frames in told["cut_frames"]],
        "duration_s": facts["duration_s"] if facts else None,
        "spots": [spot.to_dict() for spot in audio_checks.repair_spots(Path(path), mended)],
    }
