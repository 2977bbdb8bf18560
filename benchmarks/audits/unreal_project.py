"""A small project of Unreal Engine with a gain at each place of its tree."""

from __future__ import annotations

import json
from pathlib import Path

from benchmarks.audits.places import IN_BUS, IN_CONTAINER, Gains, factor, put_file


def write_unreal(root: Path, sounds: int, gains: Gains) -> Path:
    """Write what the script in the editor would: waves, cues with nodes, classes in a class, a submix."""

    def of(*place):
        return gains.get(place)

    def linear(*place):
        return float(factor(of(*place)))

    document = {
        "format": 1,
        "tool": "audio-checks for Unreal",
        "engine_version": "5.4.1",
        "waves": [
            {
                "path": f"/Game/Audio/snd_{one:04}", "file": f"Audio/steps/snd_{one:04}.wav",
                "volume": linear("wave", one), "referenced": False,
            }
            for one in range(sounds)
        ],
        "cues": [
            {
                "path": f"/Game/Audio/cue_{cue}", "volume": linear("cue", cue), "referenced": True,
                "class": f"/Game/Classes/class_{cue * IN_CONTAINER // IN_BUS}", "submix": "/Game/Submixes/main",
                "plays": [
                    {
                        "wave": f"/Game/Audio/snd_{one:04}",
                        "nodes": [
                            {"kind": "SoundNodeMixer", "property": f"InputVolume {one}", "volume": linear("node", one)}
                        ],
                    }
                    for one in range(cue * IN_CONTAINER, min(sounds, (cue + 1) * IN_CONTAINER))
                ],
            }
            for cue in range(-(-sounds // IN_CONTAINER))
        ],
        "classes": [
            {"path": "/Game/Classes/all", "volume": linear("parent class", 0), "parent": ""},
            *(
                {"path": f"/Game/Classes/class_{one}", "volume": linear("class", one), "parent": "/Game/Classes/all"}
                for one in range(-(-sounds // IN_BUS))
            ),
        ],
        "submixes": [{"path": "/Game/Submixes/main", "volume_db": of("submix", 0) or 0.0, "parent": ""}],
    }  # fmt: skip
    put_file(root, "sounds.json", json.dumps(document, indent=1))
    return root / "sounds.json"
