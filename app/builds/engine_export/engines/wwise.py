"""Wwise: tables for the import of tab-delimited files, with containers, loops, streaming, notes and events.

Source: Audiokinetic, "Importing Media Files from Tab Delimited Text Files". The header names the columns, in any order;
audio files are relative to the table's folder; object paths are relative to the import destination, so that the tables
fit the Actor-Mixer Hierarchy (up to 2024.1) and the Containers (from 2025.1) alike.

Sounds and events are separate tables. Importing the sounds again finds their objects ("use existing"). What an import
does to an event that exists is not documented, so the second table has only events that no earlier pack handed over.
"""

import re
from collections.abc import Collection, Iterator, Sequence

from app.builds.engine_export.cues import ArchivedFile, ExportedCue, distinct, identifier, one_line

FOLDER = "wwise"
EVENTS = r"\Events\Default Work Unit"
COLUMNS = (
    "Audio File",
    "Object Path",
    "Object Type",
    "Notes",
    "Property[IsLoopingEnabled]",
    "Property[IsStreamingEnabled]",
)
EVENT_COLUMNS = ("Audio File", "Object Path", "Object Type", "Event")
SOUND, VOICE, CONTAINER = "Sound SFX", "Sound Voice", "Random Container"
_NOT_IN_NAMES = re.compile(r'[\\/:*?"<>|@]')


def import_files(cues: Sequence[ExportedCue], known_paths: Collection[str]) -> dict[str, bytes]:
    """Return the tables by their paths: sounds, one for each language that is spoken, and new events.

    `known_paths` are files of earlier packs for Wwise, and those that the adopted game plays: a cue of which one is
    there has its event already.
    """
    tables: dict[str, list[Sequence[str]]] = {}
    paths = _object_paths(cues)
    events = distinct((cue.label, event_name(cue)) for cue in cues)
    for cue in cues:
        name = f"voices-{identifier(cue.language)}.tsv" if cue.language else "sounds.tsv"
        tables.setdefault(name, []).extend(_rows(cue, paths[cue.label]))
    made = {f"{FOLDER}/{name}": _table(COLUMNS, rows) for name, rows in sorted(tables.items())}
    new = [cue for cue in cues if not any(file.path in known_paths for file in cue.files)]
    if new:
        rows = [("", paths[cue.label], _kind(cue), rf"{EVENTS}\{events[cue.label]}@Play") for cue in new]
        made[f"{FOLDER}/events.tsv"] = _table(EVENT_COLUMNS, rows)
    return made


def event_name(cue: ExportedCue) -> str:
    """Return the event's name: the list's own, or `Play_` and the name of the cue."""
    if path := cue.stated_event:
        return identifier(path[-1].partition("@")[0], cue.label)
    return f"Play_{identifier(cue.name, cue.label)}"


def _object_paths(cues: Sequence[ExportedCue]) -> dict[str, str]:
    """Return the path of each cue's object, no two alike, and none that of a category's folder."""
    folders = {_object_name(cue.category).casefold() for cue in cues if cue.category}
    object_paths = {}
    for cue in cues:
        name = _object_name(cue.name)
        object_paths[cue.label] = f"{name}_{identifier(cue.label)}" if name.casefold() in folders else name
    names = distinct(object_paths.items())
    paths = {}
    for cue in cues:
        folder = rf"<Virtual Folder>{_object_name(cue.category)}" + "\\" if cue.category else ""
        paths[cue.label] = f"{folder}<{_kind(cue)}>{names[cue.label]}"
    return paths


def _rows(cue: ExportedCue, path: str) -> Iterator[Sequence[str]]:
    if not cue.is_set:
        yield _sound_row(cue, cue.files[0], path, cue.notes)
        return
    yield "", path, CONTAINER, cue.notes, "", ""
    names = distinct((f"{number:02d}", _object_name(file.stem)) for number, file in enumerate(cue.files, start=1))
    for file, name in zip(cue.files, names.values(), strict=True):
        yield _sound_row(cue, file, rf"{path}\<{_sound_type(cue)}>{name}", "")


def _sound_row(cue: ExportedCue, file: ArchivedFile, path: str, notes: str) -> Sequence[str]:
    audio_file = "..\\" + file.path.replace("/", "\\")
    loop = "true" if cue.loop else "false"
    return audio_file, path, _sound_type(cue), notes, loop, "true" if cue.streamed else ""


def _sound_type(cue: ExportedCue) -> str:
    return VOICE if cue.language else SOUND


def _kind(cue: ExportedCue) -> str:
    return CONTAINER if cue.is_set else _sound_type(cue)


def _object_name(name: str) -> str:
    return _NOT_IN_NAMES.sub("_", one_line(name)) or "sound"


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> bytes:
    lines = ["\t".join(columns), *("\t".join(map(_cell, row)) for row in rows)]
    return "".join(f"{line}\r\n" for line in lines).encode("utf-8")


def _cell(text: str) -> str:
    """Return a value without tabs, line breaks and quotes, which some readers of tables take for their own."""
    return one_line(text).replace('"', "'")
