"""The project of a game's middleware or engine: its texts read in a child process, and kept in plain values."""

import json
import zlib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from app.deliveries.errors import GameProjectUnreadable
from audio_checks import (
    AudioChecksError,
    FingerprintedFile,
    Part,
    PlayedSound,
    Project,
    manifest_entry,
    read_project_texts,
    with_plays,
)

MAX_UNPACKED_BYTES = 64 << 20
MAX_PLAYS = 20_000  # ways of playing a sound, of all sounds together
MAX_PLAYS_OF_FILE = 50
MAX_PARTS = 256  # as many as a manifest holds
MAX_TEXT = 500
MAX_EVENTS = 20
UNREAD_SHOWN = 20
GZIP = 16 + zlib.MAX_WBITS


def read_sent(path: str, packed: bytes) -> str:
    """Return a project's statements on its sounds, as JSON; run in a child process.

    `packed` is a gzip of a JSON object: the project's texts by their paths from its root.
    """
    unpacker = zlib.decompressobj(GZIP)
    try:
        whole = unpacker.decompress(packed, MAX_UNPACKED_BYTES)
        if unpacker.unconsumed_tail:
            raise GameProjectUnreadable(
                f"the project's texts have more than {MAX_UNPACKED_BYTES >> 20} MiB together",
                fix="send only the files that hold sounds, events, buses and scenes",
            )
        texts = json.loads(whole)
    except (zlib.error, ValueError, RecursionError):
        raise GameProjectUnreadable("this is not a gzip-compressed JSON object of texts by their paths") from None
    if not isinstance(texts, dict) or not all(isinstance(text, str) for text in texts.values()):
        raise GameProjectUnreadable("wanted a JSON object of texts by their paths")
    try:
        project = read_project_texts(path, texts)
    except AudioChecksError as error:
        raise GameProjectUnreadable(_storable(str(error))) from None
    return json.dumps(plain_project(path, project))


def plain_project(path: str, project: Project) -> dict[str, Any]:
    """Return a project as it is stored with an adoption, within bounds."""
    counts: dict[str, int] = {}
    sounds: list[dict[str, Any]] = []
    for sound in project.played:
        counts[sound.file] = counts.get(sound.file, 0) + 1
        if len(sound.file) <= MAX_TEXT and counts[sound.file] <= MAX_PLAYS_OF_FILE and len(sounds) < MAX_PLAYS:
            sounds.append(_plain_sound(sound))
    return {
        "name": _storable(path or "Unity project"),
        "engine": project.engine,
        "version": _storable(project.version),
        "sounds": sounds,
        "unread": [_storable(f"{unread.file}: {unread.message}") for unread in project.unread[:UNREAD_SHOWN]],
        "unread_count": len(project.unread),
    }


def _plain_sound(sound: PlayedSound) -> dict[str, Any]:
    return {
        "file": _storable(sound.file),
        "object": _storable(sound.object_path),
        "set": _storable(sound.random_set),
        "parts": [
            {"object": _storable(part.object_path), "property": _storable(part.property), "gain_db": part.gain_db}
            for part in sound.parts[:MAX_PARTS]
        ],
        "events": [_storable(event) for event in sound.events[:MAX_EVENTS]],
        "used": sound.is_used,
        "is_known": sound.is_known,
        "looped": sound.is_looped,
    }


def _storable(text: str) -> str:
    """Return a text as both databases hold it: without NUL and lone surrogates, and not too long."""
    return text[:MAX_TEXT].replace("\0", "").encode("utf-8", "replace").decode()


def project_of(game: Mapping[str, Any]) -> Project:
    """Return the project that was stored with an adoption."""
    sounds = (
        PlayedSound(
            sound["file"],
            sound["object"],
            parts=tuple(Part(part["object"], part["property"], part["gain_db"], "") for part in sound["parts"]),
            events=tuple(sound["events"]),
            is_used=sound["used"],
            is_known=sound["is_known"],
            is_looped=sound["looped"],
            random_set=sound["set"],
        )
        for sound in game["sounds"]
    )
    return Project(game["engine"], "", game["version"], tuple(sounds))


def plays_by_path(game: Mapping[str, Any], paths: Iterable[str]) -> dict[str, list[dict[str, Any]]]:
    """Return the game's playback of each file that it plays, as a manifest for audits has it."""
    files = [FingerprintedFile(path) for path in paths]
    return {
        with_play.path: manifest_entry(with_play)["plays"]
        for with_play in with_plays(files, project_of(game))
        if with_play.plays
    }


def levels_in_words(plays: Sequence[Mapping[str, Any]]) -> str:
    """Return the level at which the game plays a file: "at -6.0 dB", or from the lowest to the highest."""
    levels = sorted({round(play["gain_db"], 1) + 0.0 for play in plays if play["gain_db"] is not None})
    if not levels:
        return "at a level that a script sets" if plays else ""
    if len(levels) == 1:
        return f"at {levels[0]:+.1f} dB".replace("+0.0", "0.0")
    return f"at {levels[0]:+.1f} to {levels[-1]:+.1f} dB".replace("+0.0", "0.0")
