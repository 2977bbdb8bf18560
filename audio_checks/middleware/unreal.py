"""Reader of `integrations/unreal/export_sounds.py`'s output in the Unreal editor: sounds, cues, classes, submixes.

Assets of Unreal are binary, so a script in the editor names their values. Volumes of waves, cues, nodes and classes are
factors, that of a submix is in dB.

    {"format": 1, "tool": "audio-checks for Unreal", "engine_version": "5.4.1",
     "waves": [{"path": "/Game/Audio/step", "file": "Audio/step.wav", "volume": 1.0, "class": "/Game/SFX", …}],
     "cues": [{"path": "/Game/steps", "volume": 1.0, "class": "…", "plays": [{"wave": "…", "random": true, …}]}],
     "classes": [{"path": "/Game/SFX", "volume": 1.0, "parent": "/Game/Master"}],
     "submixes": [{"path": "/Game/Main", "volume_db": 0.0, "parent": ""}]}
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from audio_checks.errors import SpecError
from audio_checks.middleware.reading import MOST_FILE_BYTES, MOST_STEPS, ProjectRefused, at_most
from audio_checks.middleware.values import (
    Conversion,
    Dependency,
    DependsOn,
    Part,
    PlayedSound,
    Project,
    Unread,
    decibels,
    gain,
    in_order,
)
from audio_checks.system.text_files import read_text

FORMAT = 1
MOST_BRACKETS = 4_000_000
LONGEST_TEXT = 1_024
MOST_NOTED = 64
LISTS = ("waves", "cues", "classes", "submixes")
ON: dict[str, DependsOn] = {"SoundNodeAttenuation": "distance", "SoundNodeModulator": "random"}


def read_unreal(export: Path, texts: Mapping[str, str] | None = None) -> Project:
    """Return an Unreal export's facts on the project's sounds.

    Parameters
    ----------
    export : Path
        The JSON file that the script wrote.
    texts : mapping of str to str, optional
        Its text by its name, where it was sent.

    Raises
    ------
    ProjectRefused
        It is none, or of another version.
    """
    try:
        text = read_text(export, most_bytes=MOST_FILE_BYTES) if texts is None else texts[str(export)]
        if text.count("{") + text.count("[") > MOST_BRACKETS:
            raise ProjectRefused(f"{export.name}: has more than {MOST_BRACKETS:,} brackets")
        document = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise ProjectRefused(f"{export.name}: is not JSON: {error}") from None
    except SpecError as error:
        raise ProjectRefused(f"{export.name}: {error}") from None
    if not isinstance(document, dict) or document.get("format") != FORMAT:
        raise ProjectRefused(
            f'{export.name}: wanted {{"format": {FORMAT}, "waves": [...]}}, as export_sounds.py writes it'
        )
    reading = _Reading(document, export.name)
    played = in_order(at_most(reading.played(), reading.leave_out))
    version = document.get("engine_version")
    name = version[:64] if isinstance(version, str) else ""
    return Project("unreal", str(export.parent), name, played, tuple(reading.unread))


class _Reading:
    def __init__(self, document: dict[str, Any], file: str) -> None:
        self._file = file
        self.unread: list[Unread] = []
        self._by_path: dict[str, dict[str, dict[str, Any]]] = {}
        for list_ in LISTS:
            entries = document.get(list_, [])
            by_path: dict[str, dict[str, Any]] = {}
            for index, entry in enumerate(entries if isinstance(entries, list) else ()):
                if isinstance(entry, dict) and _text(entry, "path"):
                    by_path.setdefault(_text(entry, "path"), entry)
                else:
                    self.leave_out(f"{list_}[{index}]", "wanted an object with a path")
            self._by_path[list_] = by_path

    def leave_out(self, what: str, message: str) -> None:
        """Note that something is not read; the first few of each export are enough."""
        if len(self.unread) < MOST_NOTED:
            self.unread.append(Unread(self._file, f"{what}: {message}"))

    def played(self) -> Iterator[PlayedSound]:
        """Yield a sound for each wave that something plays by itself, and for each that a cue plays."""
        in_cues: set[str] = set()
        for path, cue in self._by_path["cues"].items():
            plays = cue.get("plays")
            for play in plays if isinstance(plays, list) else ():
                name = _text(play, "wave") if isinstance(play, dict) else ""
                wave = self._by_path["waves"].get(name)
                if wave is None:
                    self.leave_out(path, f'plays "{name}", which is not a wave of the export')
                else:
                    in_cues.add(name)
                    yield self._sound(wave, path, cue, play)
        for path, wave in self._by_path["waves"].items():
            if path not in in_cues or wave.get("referenced") is True:
                yield self._sound(wave, path, None, None)

    def _sound(
        self, wave: dict[str, Any], path: str, cue: dict[str, Any] | None, play: dict[str, Any] | None
    ) -> PlayedSound:
        wave_path = _text(wave, "path")
        parts = self._factor(wave_path, "Volume", wave.get("volume"))
        depends: list[Dependency] = []
        holder = wave if cue is None else cue
        nodes = play.get("nodes") if play is not None else None
        for node in nodes if isinstance(nodes, list) else ():
            if isinstance(node, dict):
                kind = _text(node, "kind")
                parts += self._factor(f"{path}: {kind}", _text(node, "property") or "Volume", node.get("volume"))
                if node.get("depends") is True:
                    depends.append(
                        Dependency(f"{path}: {kind}", "", ON.get(kind, "state"), _text(node, "what") or kind)
                    )
        if cue is not None:
            parts += self._factor(path, "VolumeMultiplier", cue.get("volume"))
        if _text(holder, "attenuation"):
            depends.append(
                Dependency(path, "AttenuationSettings", "distance", f'attenuation "{_text(holder, "attenuation")}"')
            )
        parts += self._up("classes", _text(holder, "class") or _text(wave, "class"), "volume")
        parts += self._up("submixes", _text(holder, "submix") or _text(wave, "submix"), "volume_db")
        if wave.get("referenced") is not True and cue is None:
            used = None if wave.get("referenced") is None else False
        else:
            used = True if cue is None or cue.get("referenced") is None else cue.get("referenced") is True
        return PlayedSound(
            _text(wave, "file") or wave_path, path, parts, tuple(depends), tuple(self._harms(wave)),
            (path,) if cue is not None else (), used, True, _flag(wave, "looped"), _flag(wave, "streamed"),
            path if play is not None and play.get("random") is True else "",
        )  # fmt: skip

    def _factor(self, object_path: str, name: str, volume: object) -> tuple[Part, ...]:
        if isinstance(volume, bool) or not isinstance(volume, int | float):
            return ()
        return gain(
            object_path, name, decibels(float(min(volume, 1e9))), self._file, json.dumps(object_path.partition(": ")[0])
        )

    def _up(self, list_: str, path: str, key: str) -> tuple[Part, ...]:
        """Return the gains of a class or a submix and of all above it."""
        parts: tuple[Part, ...] = ()
        seen: set[str] = set()
        while path and path not in seen and len(seen) < MOST_STEPS:
            seen.add(path)
            entry = self._by_path[list_].get(path)
            if entry is None:
                break
            volume = entry.get(key)
            if key == "volume":
                parts += self._factor(path, "Volume", volume)
            elif isinstance(volume, int | float) and not isinstance(volume, bool):
                parts += gain(path, "OutputVolume", float(max(-1e3, min(volume, 1e3))), self._file, json.dumps(path))
            path = _text(entry, "parent")
        return parts

    def _harms(self, wave: dict[str, Any]) -> Iterator[Conversion]:
        rate, imported = wave.get("sample_rate_hz"), wave.get("imported_sample_rate_hz")
        if isinstance(rate, int) and isinstance(imported, int) and 0 < rate != imported > 0:
            yield Conversion("SampleRate", f"resampled from {imported:,} to {rate:,} Hz", self._file)
        if _text(wave, "compression").upper() == "ADPCM":
            yield Conversion("SoundAssetCompressionType", "ADPCM: 4 bits a sample undo the dither", self._file)


def _text(entry: dict[str, Any], key: str) -> str:
    value = entry.get(key)
    return value[:LONGEST_TEXT] if isinstance(value, str) else ""


def _flag(entry: dict[str, Any], key: str) -> bool | None:
    value = entry.get(key)
    return value if isinstance(value, bool) else None
