"""The sounds of an engine export as JSON, for the scripts of FMOD Studio, Unity and Unreal.

The scripts are the same in every pack and read this document. No name becomes part of a script, so none can change one.
"""

import json
from collections.abc import Sequence
from importlib import resources
from typing import Any

from app.builds.engine_export.cues import ArchivedFile, ExportedCue, distinct, file_safe, identifier

DOCUMENT = "soundlist-handoff.json"
FORMAT = 1


def document(cues: Sequence[ExportedCue]) -> bytes:
    """Return the document: ASCII, the same bytes for the same cues."""
    assets = distinct((cue.label, identifier(cue.name, cue.label)) for cue in cues)
    files = distinct(
        (_key(cue, index), identifier(file.stem, cue.label)) for cue in cues for index, file in enumerate(cue.files)
    )
    events = _events(cues)
    sounds = [
        {
            "cue": cue.label,
            "name": cue.name,
            "title": cue.title,
            "asset": assets[cue.label],
            "event_path": events[cue.label].split("/"),
            "category": cue.category,
            "language": cue.language,
            "loop": cue.loop,
            "streamed": cue.streamed,
            "load": cue.load,
            "compression": cue.compression,
            "notes": cue.notes,
            "files": [_file(cue, file, files[_key(cue, index)]) for index, file in enumerate(cue.files)],
        }
        for cue in cues
    ]
    return (json.dumps({"format": FORMAT, "sounds": sounds}, ensure_ascii=True, indent=1) + "\n").encode("ascii")


def _key(cue: ExportedCue, index: int) -> str:
    return f"{cue.label}_{index + 1:02d}"


def _events(cues: Sequence[ExportedCue]) -> dict[str, str]:
    """Return a path for each cue's event: its own, and no folder of another's."""
    paths = {cue.label: "/".join(_event(cue)) for cue in cues}
    folders = {path[:index].casefold() for path in paths.values() for index, char in enumerate(path) if char == "/"}
    for label in paths:
        while paths[label].casefold() in folders:
            paths[label] += f"_{identifier(label)}"
    return distinct(paths.items())


def _event(cue: ExportedCue) -> list[str]:
    """Return the folders and the name of a cue's event: the list's own, or the category and the cue's name."""
    stated = cue.stated_event or (cue.name,)
    folders = (cue.category,) if cue.category and len(stated) == 1 else ()
    return [file_safe(part) for part in (*folders, *stated)]


def _file(cue: ExportedCue, file: ArchivedFile, asset: str) -> dict[str, Any]:
    """Return one file; its loop in seconds, of length 0 where it does not loop."""
    start_s, end_s = 0.0, 0.0
    if cue.loop:
        end_s = file.duration_s
        if file.loop_points and file.sample_rate_hz:
            first, last = file.loop_points[0]
            start_s, end_s = first / file.sample_rate_hz, (last + 1) / file.sample_rate_hz
    return {
        "path": file.path,
        "asset": asset,
        "sha256": file.sha256,
        "duration_s": file.duration_s,
        "loop_start_s": start_s,
        "loop_end_s": end_s,
    }


def script(name: str) -> bytes:
    """Return one of the scripts that packs carry."""
    return resources.files("app.builds.engine_export").joinpath("scripts", name).read_bytes()
