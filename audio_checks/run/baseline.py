"""The baseline: findings that are let through, kept by the sound they were found in.

It is exported by the server (what the approver has waived), or begun by `--add-baseline` (what was
there before). It says for each sound which codes are let through:

    {"format": 1, "waived": [{"pcm_sha256": "…", "codes": ["true-peak:over"], "reason": "…"}]}

The hash is of the samples, of the master and of each render, so that a renamed or re-tagged file
keeps its waiver, and a changed sound loses it. A file that cannot be read has no samples: its entry
says `sha256`, of all its bytes, instead.

Waived findings stay in the report, marked `waived`; they count for no exit code, and change no verdict.
"""

import hashlib
import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from audio_checks import wav
from audio_checks.errors import SpecError, Unreadable
from audio_checks.report.findings import FileReport
from audio_checks.system.atomic_write import write_atomically
from audio_checks.system.text_files import read_text

DEFAULT_NAME = "audio-checks-baseline.json"
READ_BYTES = 1 << 20

Waived = Mapping[str, frozenset[str]]


def read_baseline(path: str | Path) -> Waived:
    """Return the waived codes by the hash of the sound; SpecError when the file holds no baseline."""
    where = str(path)
    waived: dict[str, frozenset[str]] = {}
    for index, entry in enumerate(_document(path)["waived"]):
        sound, codes = _entry(entry, f"{where}: waived[{index}]")
        waived[sound] = waived.get(sound, frozenset()) | codes
    return waived


def add_to_baseline(path: str | Path, entries: Iterable[FileReport]) -> int:
    """Let everything through that was found in these files; what the baseline holds already stays as it is.

    Returns
    -------
    int
        The number of findings that were added. Faults of the tool itself are never let through.

    Raises
    ------
    SpecError
        What stands there is no baseline.
    OSError
        It cannot be written.
    """
    document: dict[str, Any] = _document(path) if Path(path).exists() else {"format": 1, "waived": []}
    waived_before = read_baseline(path) if document["waived"] else {}
    added: dict[str, dict[str, Any]] = {}
    count = 0
    for entry in sorted(entries, key=lambda file: file.path):
        sound = entry.pcm_sha256 or entry.sha256
        new = sorted({finding.code for finding in entry.findings} - waived_before.get(sound or "", frozenset()))
        if sound is None or not new or entry.verdict == "unjudged":
            continue
        count += sum(finding.code in new for finding in entry.findings)
        if sound in added:  # two files of one sound
            added[sound]["codes"] = sorted({*added[sound]["codes"], *new})
        else:
            kind = "pcm_sha256" if entry.pcm_sha256 else "sha256"
            reason = "it was there when the baseline was begun"
            added[sound] = {kind: sound, "codes": new, "reason": reason, "path": entry.path}
    document["waived"] += added.values()
    write_atomically(path, json.dumps(document, indent=2) + "\n")
    return count


def known_by_its_bytes(entry: FileReport, path: str) -> FileReport:
    """Return the entry of a file that cannot be read with the hash of its bytes; any other as it is."""
    if entry.sha256 is not None or entry.verdict not in ("unreadable", "rejected"):
        return entry
    whole = hashlib.sha256()
    try:
        with wav.open_regular(path) as file:
            while block := file.read(READ_BYTES):
                whole.update(block)
    except (Unreadable, OSError):
        return entry
    return replace(entry, sha256=whole.hexdigest())


def _document(path: str | Path) -> dict[str, Any]:
    where = str(path)
    try:
        document = json.loads(read_text(Path(path)))
    except (ValueError, RecursionError) as error:
        raise SpecError(f"is not JSON: {error}", where=where) from None
    if not isinstance(document, dict) or document.get("format") != 1 or not isinstance(document.get("waived"), list):
        raise SpecError('is not a baseline: wanted {"format": 1, "waived": [...]}', where=where)
    return document


def _entry(entry: object, where: str) -> tuple[str, frozenset[str]]:
    if not isinstance(entry, dict):
        raise SpecError("wanted an object", where=where)
    key = "sha256" if "sha256" in entry and "pcm_sha256" not in entry else "pcm_sha256"
    sound, codes = entry.get(key), entry.get("codes")
    if not isinstance(sound, str) or not re.fullmatch(r"[0-9a-f]{64}", sound):
        raise SpecError(f"{key} must be 64 lower-case hexadecimal digits", where=where)
    if not isinstance(codes, list) or not all(isinstance(code, str) for code in codes):
        raise SpecError("codes must be a list of codes", where=where)
    return sound, frozenset(codes)
