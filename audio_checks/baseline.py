"""The baseline: findings that the decider has waived, kept by the sound they were found in.

It is exported by the server, and says for each sound (by the hash of its samples, of the master and
of each render, so that a renamed or re-tagged file keeps its waiver) which codes are let through:

    {"format": 1, "waived": [{"pcm_sha256": "…", "codes": ["true-peak:over"], "reason": "…"}]}

Waived findings stay in the report, marked `waived`; they count for no exit code, and change no verdict.
"""

import json
import re
from collections.abc import Mapping
from pathlib import Path

from audio_checks.errors import SpecError

Waived = Mapping[str, frozenset[str]]


def read_baseline(path: str | Path) -> Waived:
    """Return the waived codes by the hash of the samples; SpecError when the file holds no baseline."""
    where = str(path)
    try:
        document = json.loads(Path(path).read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise SpecError(f"cannot be read: {error.strerror or error}", where=where) from None
    except (ValueError, RecursionError) as error:
        raise SpecError(f"is not JSON: {error}", where=where) from None
    if not isinstance(document, dict) or document.get("format") != 1 or not isinstance(document.get("waived"), list):
        raise SpecError('is no baseline: wanted {"format": 1, "waived": [...]}', where=where)
    waived: dict[str, frozenset[str]] = {}
    for place, entry in enumerate(document["waived"]):
        sound, codes = _entry(entry, f"{where}: waived[{place}]")
        waived[sound] = waived.get(sound, frozenset()) | codes
    return waived


def _entry(entry: object, where: str) -> tuple[str, frozenset[str]]:
    if not isinstance(entry, dict):
        raise SpecError("wanted an object", where=where)
    sound, codes = entry.get("pcm_sha256"), entry.get("codes")
    if not isinstance(sound, str) or not re.fullmatch(r"[0-9a-f]{64}", sound):
        raise SpecError("pcm_sha256 must be 64 lower-case hexadecimal digits", where=where)
    if not isinstance(codes, list) or not all(isinstance(code, str) for code in codes):
        raise SpecError("codes must be a list of codes", where=where)
    return sound, frozenset(codes)
