"""`duplicate`: no two files are the same sound.

Why: the same file under two names is usually a wrong export: of two variations that should differ,
or of the sound before. In a game it takes its memory twice.
How to fix: export the sound that was meant. If one sound should serve two cues, say so, and let the
game play one file for both.
Source: SHA-256 of the samples, whatever the name, the metadata, the sample rate in the header, and
for FLAC the packing. Placeholders are ignored. The server asks within a delivery, and returns no take for it.
"""

import os
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding

if TYPE_CHECKING:
    from audio_checks.report.judged import JudgedFile

SEVERITY = "warning"
LABEL = "Duplicate audio"
OVER_FILES = True
NOT_FIXED = "Which sound belongs here, only its designer knows: deliver the one that is meant."
FIGURES = ()
SAID = {"sample_rate_hz": "sample rate", "bit_depth": "bit depth", "channels": "number of channels"}


def check_set(files: "Sequence[JudgedFile]") -> Iterator[tuple[int, Finding]]:
    """Yield `duplicate:same-sound` for every file but the first of those that hold the same samples."""
    by_sound: dict[str, list[int]] = defaultdict(list)
    for index, file in enumerate(files):
        if file.report.pcm_sha256 is not None and not _is_placeholder(file):
            by_sound[file.report.pcm_sha256].append(index)
    for places in by_sound.values():
        first = files[places[0]]
        for index in places[1:]:
            yield index, _finding(first, files[index])


def _finding(first: "JudgedFile", same: "JudgedFile") -> Finding:
    before, now = first.report.facts or {}, same.report.facts or {}
    other = " and ".join(word for key, word in SAID.items() if before.get(key) != now.get(key))
    folder = os.path.dirname(first.path)
    shown = os.path.basename(first.path) if folder == os.path.dirname(same.path) else first.path
    return Finding(
        code="duplicate:same-sound",
        message=f"the same samples as {shown}{f', under another {other}' if other else ''}",
        fix="export the sound that was meant for this name; or let the game play one file for both",
        start_s=0.0,
        end_s=now.get("duration_s"),
    )


def _is_placeholder(file: "JudgedFile") -> bool:
    return any(finding.code == "placeholder:marked" for finding in file.report.findings)
