"""The manifest of approved sounds: what an audit compares a game build with, as one JSON file.

    {"schema_version": 1, "tool": {"name": "audio-checks", "version": "…"}, "fingerprint_version": 1,
     "files": [{"path": "ui/click.wav", "pcm_sha256": "…", "sample_rate_hz": 48000, "bit_depth": 16,
                "channels": 1, "frames": 4800, "sample_peak_dbfs": -3.0, "rms_dbfs": -18.2,
                "fingerprint": "…", "cue": "12", "take": null}]}

An entry may say how the game played the sound when it was approved:

    "plays": [{"object": "event:/steps/deck", "gain_db": -6.0,
               "parts": [{"object": "bus:/foley", "property": "volume", "gain_db": -6.0}]}]

It comes from a server or out of a repository, and is read as a stranger's: what is not just so is refused.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from audio_checks.audit.fingerprint import FINGERPRINT_VERSION, PIECE_BYTES, as_text, from_text, pieces_of
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.plays import ApprovedPlayback
from audio_checks.errors import SpecError
from audio_checks.system.atomic_write import write_atomically
from audio_checks.system.text_files import read_text
from audio_checks.version import TOOL_VERSION

SCHEMA_VERSION = 1
MOST_BYTES = 2 << 30
MOST_FILES = 200_000
LONGEST_TEXT = 1_024
MOST_FRAMES = 1 << 40
MOST_PLAYS, MOST_PARTS = 10_000, 256  # of one sound
LONGEST_OBJECT_PATH = 8_192


def write_manifest(path: str | Path, fingerprinted: Iterable[FingerprintedFile]) -> None:
    """Write a manifest in one step; OSError when it cannot be written."""
    write_atomically(path, manifest_text(fingerprinted))


def manifest_text(fingerprinted: Iterable[FingerprintedFile]) -> str:
    """Return a manifest as its file holds it."""
    return json.dumps(manifest_of([manifest_entry(file) for file in fingerprinted]), indent=1) + "\n"


def manifest_of(entries: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """Return the manifest of some approved sounds, as its file holds it.

    Parameters
    ----------
    entries : iterable of dict
        See `manifest_entry`; no two of one path.
    """
    return {
        "schema_version": SCHEMA_VERSION,
        "tool": {"name": "audio-checks", "version": TOOL_VERSION},
        "fingerprint_version": FINGERPRINT_VERSION,
        "files": list(entries),
    }


def manifest_entry(file: FingerprintedFile) -> dict[str, Any]:
    """Return a manifest's entry for one approved sound, in plain values; None for levels of silence."""
    plays = {} if file.plays is None else {"plays": [_play_entry(play) for play in file.plays]}
    return {
        "path": file.path,
        "pcm_sha256": file.pcm_sha256,
        "sample_rate_hz": file.sample_rate_hz,
        "bit_depth": file.bit_depth,
        "channels": file.channels,
        "frames": file.frames,
        "sample_peak_dbfs": file.sample_peak_dbfs,
        "rms_dbfs": file.rms_dbfs,
        "fingerprint": None if file.fingerprint is None else as_text(file.fingerprint),
        "cue": file.cue,
        "take": file.take,
        **plays,
    }


def _play_entry(play: ApprovedPlayback) -> dict[str, Any]:
    return {
        "object": play.object_path,
        "gain_db": None if play.gain_db is None else round(play.gain_db, 3) + 0.0,
        "parts": [
            {"object": object_path, "property": name, "gain_db": round(gain_db, 3) + 0.0}
            for object_path, name, gain_db in play.parts
        ],
    }


def read_manifest(path: str | Path) -> list[FingerprintedFile]:
    """Return the approved sounds that a manifest lists, in its order.

    Raises
    ------
    SpecError
        The file cannot be read, is not a manifest, or of another version; `where` names the place.
    """
    where = str(path)
    return parse_manifest(read_text(Path(path), most_bytes=MOST_BYTES), where)


def parse_manifest(text: str, where: str = "manifest") -> list[FingerprintedFile]:
    """Return the approved sounds that the text of a manifest lists; see `read_manifest`.

    Parameters
    ----------
    text : str
        All of the file.
    where : str
        What errors call it.
    """
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise SpecError(f"is not JSON: {error}", where=where) from None
    if not isinstance(document, dict) or not isinstance(document.get("files"), list):
        raise SpecError('is not a manifest: wanted {"schema_version": 1, "files": [...]}', where=where)
    for key, version in (("schema_version", SCHEMA_VERSION), ("fingerprint_version", FINGERPRINT_VERSION)):
        if document.get(key) != version or isinstance(document.get(key), bool):
            raise SpecError(f"{key} must be {version}; write a new manifest with this version", where=where)
    if len(document["files"]) > MOST_FILES:
        raise SpecError(f"lists more than {MOST_FILES:,} files", where=where)
    fingerprinted = [_read(entry, f"{where}: files[{position}]") for position, entry in enumerate(document["files"])]
    seen: set[str] = set()
    for index, file in enumerate(fingerprinted):
        if file.path in seen:
            raise SpecError(f'"{file.path}" is listed twice', where=f"{where}: files[{index}]")
        seen.add(file.path)
    return fingerprinted


def schema() -> dict[str, Any]:
    """Return the JSON Schema of the manifest."""
    text = {"type": ["string", "null"], "maxLength": LONGEST_TEXT}
    level = {"type": ["number", "null"]}
    whole = {"type": "integer", "minimum": 0}
    entry = {
        "path": {"type": "string", "minLength": 1, "maxLength": LONGEST_TEXT},
        "pcm_sha256": {"type": ["string", "null"], "pattern": "^[0-9a-f]{64}$"},
        "sample_rate_hz": {"type": "integer", "minimum": 1_000, "maximum": 768_000},
        "bit_depth": {"type": ["integer", "null"], "minimum": 1, "maximum": 64},
        "channels": {"type": "integer", "minimum": 1},
        "frames": whole,
        "sample_peak_dbfs": level,
        "rms_dbfs": level,
        "fingerprint": {"type": ["string", "null"], "contentEncoding": "base64"},
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Manifest of approved sounds of audio-checks, schema version 1",
        "type": "object",
        "required": ["schema_version", "tool", "fingerprint_version", "files"],
        "properties": {
            "schema_version": {"const": SCHEMA_VERSION},
            "fingerprint_version": {"const": FINGERPRINT_VERSION},
            "tool": {"type": "object", "properties": {"name": {"type": "string"}, "version": {"type": "string"}}},
            "files": {
                "type": "array",
                "items": {
                    "type": "object",
                    "required": list(entry),
                    "properties": {**entry, "cue": text, "take": text, "plays": _plays_schema()},
                    "additionalProperties": False,
                },
            },
        },
    }


def _read(entry: object, where: str) -> FingerprintedFile:
    if not isinstance(entry, dict):
        raise SpecError("wanted an object", where=where)
    if unknown := sorted(set(entry) - set(_KINDS) - {"plays"}):
        raise SpecError(f'no such key: "{unknown[0]}"', where=where)
    for key, (is_so, kind_in_words) in _KINDS.items():
        if key not in entry and key not in ("cue", "take"):
            raise SpecError(f"{key} is missing", where=where)
        if not is_so(entry.get(key)):
            raise SpecError(f"{key} must be {kind_in_words}", where=where)
    packed = None
    if entry["fingerprint"] is not None:
        try:
            packed = from_text(entry["fingerprint"])
        except ValueError:
            raise SpecError("fingerprint is none of ours", where=where) from None
        if len(packed) != pieces_of(entry["frames"], entry["sample_rate_hz"]) * PIECE_BYTES:
            raise SpecError("fingerprint is not as long as the sound", where=where)
    levels = {key: None if entry[key] is None else float(entry[key]) for key in ("sample_peak_dbfs", "rms_dbfs")}
    plays = _read_plays(entry.get("plays"), where)
    return FingerprintedFile(**{**entry, **levels, "fingerprint": packed, "plays": plays})


def _plays_schema() -> dict[str, Any]:
    text = {"type": "string", "maxLength": LONGEST_OBJECT_PATH}
    level = {"type": ["number", "null"]}
    part = {"object": text, "property": text, "gain_db": {"type": "number"}}
    one_part = {"type": "object", "required": list(part), "properties": part, "additionalProperties": False}
    play = {
        "object": text,
        "gain_db": level,
        "parts": {"type": "array", "maxItems": MOST_PARTS, "items": one_part},
    }
    return {
        "type": ["array", "null"],
        "maxItems": MOST_PLAYS,
        "items": {"type": "object", "required": list(play), "properties": play, "additionalProperties": False},
    }


def _read_plays(plays: object, where: str) -> tuple[ApprovedPlayback, ...] | None:
    if plays is None:
        return None
    if not isinstance(plays, list) or len(plays) > MOST_PLAYS:
        raise SpecError(f"plays must be a list of at most {MOST_PLAYS:,}", where=where)
    return tuple(_read_play(play, f"{where}.plays[{index}]") for index, play in enumerate(plays))


def _read_play(play: object, where: str) -> ApprovedPlayback:
    expected = 'wanted {"object": text, "gain_db": number or null, "parts": [...]}'
    if not isinstance(play, dict) or set(play) != {"object", "gain_db", "parts"}:
        raise SpecError(expected, where=where)
    parts = play["parts"]
    if not (_is_object_path(play["object"]) and _is_level(play["gain_db"]) and isinstance(parts, list)):
        raise SpecError(expected, where=where)
    if len(parts) > MOST_PARTS:
        raise SpecError(f"has more than {MOST_PARTS} parts", where=where)
    return ApprovedPlayback(play["object"], play["gain_db"], tuple(_read_part(part, where) for part in parts))


def _read_part(part: object, where: str) -> tuple[str, str, float]:
    if not isinstance(part, dict) or set(part) != {"object", "property", "gain_db"}:
        raise SpecError('wanted parts {"object": text, "property": text, "gain_db": number}', where=where)
    object_path, name, gain_db = part["object"], part["property"], part["gain_db"]
    if not (_is_object_path(object_path) and _is_object_path(name) and gain_db is not None and _is_level(gain_db)):
        raise SpecError('wanted parts {"object": text, "property": text, "gain_db": number}', where=where)
    return object_path, name, float(gain_db)


def _is_object_path(value: object) -> bool:
    return isinstance(value, str) and len(value) <= LONGEST_OBJECT_PATH


def _is_whole(least: int, most: int) -> Callable[[object], bool]:
    return lambda value: type(value) is int and least <= value <= most


def _is_hash(value: object) -> bool:
    return value is None or (isinstance(value, str) and re.fullmatch(r"[0-9a-f]{64}", value) is not None)


def _is_path(value: object) -> bool:
    return (
        isinstance(value, str)
        and 0 < len(value) <= LONGEST_TEXT
        and value.isprintable()
        and not value.startswith("/")
        and ".." not in value.split("/")
    )


def _is_level(value: object) -> bool:
    if value is None:
        return True
    return isinstance(value, int | float) and not isinstance(value, bool) and -1_000 < value < 1_000


def _is_text(value: object) -> bool:
    return value is None or (isinstance(value, str) and len(value) <= LONGEST_TEXT)


_KINDS: dict[str, tuple[Callable[[object], bool], str]] = {
    "path": (_is_path, "a path below a folder, with slashes"),
    "pcm_sha256": (_is_hash, "64 lower-case hexadecimal digits, or null"),
    "sample_rate_hz": (_is_whole(1_000, 768_000), "a whole number from 1,000 to 768,000"),
    "bit_depth": (lambda value: value is None or _is_whole(1, 64)(value), "a whole number of bits, or null"),
    "channels": (_is_whole(1, 65_535), "a whole number from 1 on"),
    "frames": (_is_whole(0, MOST_FRAMES), "a whole number"),
    "sample_peak_dbfs": (_is_level, "a level in dB, or null"),
    "rms_dbfs": (_is_level, "a level in dB, or null"),
    "fingerprint": (lambda value: value is None or isinstance(value, str), "base64, or null"),
    "cue": (_is_text, "a text, or null"),
    "take": (_is_text, "a text, or null"),
}
