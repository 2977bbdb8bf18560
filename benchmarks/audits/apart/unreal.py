"""Unreal, as its export writes it: a wave of its own, mixers in mixers, a modulator, classes, submixes three deep."""

from __future__ import annotations

import json
from pathlib import Path

from benchmarks.audits.apart.project import Apart, Gains, put


def write_unreal(root: Path, gains: Gains) -> Path:
    """Write the export of an Unreal project."""

    def factor(place: str) -> float:
        return float(10 ** (gains.get(place, 0.0) / 20))

    def wave(name: str, sound_class: str = "", submix: str = "", attenuation: str = "") -> dict[str, object]:
        return {
            "path": f"/Game/Audio/{name}", "file": f"Audio/{name}.wav", "volume": factor(f"wave {name}"),
            "class": sound_class, "submix": submix, "attenuation": attenuation, "looped": False,
            "sample_rate_hz": 48_000, "imported_sample_rate_hz": 48_000, "compression": "", "referenced": True,
        }  # fmt: skip

    def node(kind: str, place: str, name: str) -> dict[str, object]:
        return {"kind": kind, "property": name, "volume": factor(place)}

    modulated = {"kind": "SoundNodeModulator", "volume": 1.0, "depends": True, "what": "random from 0.8 to 1"}
    outer, inner = (
        node("SoundNodeMixer", "outer 0", "InputVolume 0"),
        node("SoundNodeMixer", "inner 1", "InputVolume 1"),
    )
    other = node("SoundNodeMixer", "outer 1", "InputVolume 1")
    fixed = {"kind": "SoundNodeModulator", "volume": factor("modulator"), "depends": False, "what": ""}
    plays = [
        {"wave": "/Game/Audio/boom", "random": False, "nodes": [outer, inner]},
        {"wave": "/Game/Audio/crack", "random": True, "nodes": [other, modulated]},
        {"wave": "/Game/Audio/dust", "random": True, "nodes": [other, fixed]},
    ]
    document = {
        "format": 1,
        "tool": "audio-checks for Unreal",
        "engine_version": "5.4.4-35576357+++UE5+Release-5.4",
        "waves": [
            wave("boom"), wave("crack"), wave("dust"), wave("beep", "/Game/Classes/UI", "/Game/Mix/UI"),
            wave("far", "/Game/Classes/World", "", "/Game/Attenuation/Far"),
        ],
        "cues": [
            {"path": "/Game/Cues/Explosion", "volume": factor("cue"), "class": "/Game/Classes/Guns",
             "submix": "/Game/Mix/Guns", "attenuation": "", "plays": plays, "referenced": True},
        ],
        "classes": [
            {"path": "/Game/Classes/Guns", "volume": factor("class Guns"), "parent": "/Game/Classes/World"},
            {"path": "/Game/Classes/World", "volume": factor("class World"), "parent": "/Game/Classes/All"},
            {"path": "/Game/Classes/UI", "volume": factor("class UI"), "parent": "/Game/Classes/All"},
            {"path": "/Game/Classes/All", "volume": factor("class All"), "parent": ""},
        ],
        "submixes": [
            {"path": "/Game/Mix/Guns", "volume_db": gains.get("submix Guns", 0.0), "parent": "/Game/Mix/World"},
            {"path": "/Game/Mix/World", "volume_db": gains.get("submix World", 0.0), "parent": "/Game/Mix/All"},
            {"path": "/Game/Mix/UI", "volume_db": gains.get("submix UI", 0.0), "parent": "/Game/Mix/All"},
            {"path": "/Game/Mix/All", "volume_db": gains.get("submix All", 0.0), "parent": ""},
        ],
    }  # fmt: skip
    put(root, "sounds.json", json.dumps(document))
    return root / "sounds.json"


def _unreal(*names: str) -> tuple[str, ...]:
    return tuple(f"Audio/{name}.wav" for name in names)


BLAST = _unreal("boom", "crack", "dust")
UNREAL = Apart(
    write_unreal,
    {
        "wave boom": _unreal("boom"), "wave beep": _unreal("beep"), "outer 0": _unreal("boom"),
        "inner 1": _unreal("boom"), "outer 1": _unreal("crack", "dust"), "modulator": _unreal("dust"), "cue": BLAST,
        "class Guns": BLAST, "class World": (*BLAST, *_unreal("far")), "class UI": _unreal("beep"),
        "class All": (*BLAST, *_unreal("far", "beep")), "submix Guns": BLAST, "submix World": BLAST,
        "submix UI": _unreal("beep"), "submix All": (*BLAST, *_unreal("beep")),
    },
    {
        **dict.fromkeys(_unreal("boom", "beep"), ("",)), **dict.fromkeys(_unreal("crack"), ("random",)),
        **dict.fromkeys(_unreal("far"), ("distance",)),
    },
)  # fmt: skip
