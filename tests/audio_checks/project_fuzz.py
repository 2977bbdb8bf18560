"""Feeds the readers of middleware and engine projects damaged files: `make fuzz`, and some of them in the suite."""

import argparse
import json
import resource
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from audio_checks.middleware.project import read_project
from audio_checks.middleware.reading import ProjectRefused
from benchmarks.audits.projects import KINDS

SOUNDS = 3
MOST_SECONDS = 10.0  # of one mutant; reading a project of this size takes some milliseconds
MOST_MIB = 600  # of the whole process
PIECES = (
    "nan", "inf", "-1e308", "1e999", "9" * 400, "\0", "\x1b[2J", "é", "<", "</", "<!DOCTYPE a>", "&#0;", "{", "}", "[",
    '"', "\\", "--- !u!82 &1\n", "- {fileID: 8300000, guid: ", "ExtResource(", "\n", "\t", "  ", "true", "-0", "]]>",
    "{A}", "res://", "stripped", "null", "[" * 3_000, "{" * 3_000, "<a>" * 3_000, '"' * 3_001,
    "    - target: {fileID: 1, guid: ",
)  # fmt: skip


def damaged(rng: np.random.Generator, text: str) -> str:
    """Return a text with one to four damages."""
    for _ in range(rng.integers(1, 5)):
        at = int(rng.integers(len(text) + 1))
        other = int(rng.integers(len(text) + 1))
        length = int(rng.integers(1, 200))
        match rng.integers(6):
            case 0:
                text = text[:at] + text[at + length :]
            case 1:
                text = text[:at] + PIECES[rng.integers(len(PIECES))] + text[at:]
            case 2:
                text = text[:at] + text[other : other + length] + text[at:]
            case 3:
                text = text[:at]
            case 4:
                words = text.split(" ")
                one, two = rng.integers(len(words), size=2)
                words[one], words[two] = words[two], words[one]
                text = " ".join(words)
            case _:
                text = text[:at] + chr(int(rng.integers(1, 0x2FF))) + text[at + 1 :]
    return text


class Projects:
    """One project of each engine below a folder, of which a file is damaged and put right again."""

    def __init__(self, folder: Path) -> None:
        gains = {name: {(level, 0): 1.0 for level in kind.levels} for name, kind in KINDS.items()}
        self._paths = {name: kind.write(folder / name, SOUNDS, gains[name]) for name, kind in KINDS.items()}
        self._files = {name: sorted(one for one in (folder / name).rglob("*") if one.is_file()) for name in KINDS}

    def survives(self, number: int) -> bool:
        """Read a damaged project; return whether anything was refused. AssertionError for a refusal without words."""
        rng = np.random.default_rng(number)
        engine = list(KINDS)[number % len(KINDS)]
        files = self._files[engine]
        file = files[rng.integers(len(files))]
        whole = file.read_bytes()
        try:
            file.write_text(damaged(rng, whole.decode()), encoding="utf-8", errors="replace")
            begun = time.monotonic()
            try:
                project = read_project(self._paths[engine])
            except ProjectRefused as error:
                return len(str(error)) > 10
            assert time.monotonic() - begun < MOST_SECONDS
            json.dumps(project.to_dict(), allow_nan=False)
            assert all(one.message for one in project.unread)
            return bool(project.unread)
        finally:
            file.write_bytes(whole)


def main() -> int:
    """Run, and return 1 with the number of the first mutant that did anything but be read or refused."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mutants", type=int, default=200_000)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    refused, begun = 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        projects = Projects(Path(folder))
        for number in range(arguments.seed, arguments.seed + arguments.mutants):
            try:
                refused += projects.survives(number)
            except Exception as error:
                sys.stdout.write(f"mutant {number}: {type(error).__name__}: {error}\n")
                return 1
    peak_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10
    seconds = time.monotonic() - begun
    sys.stdout.write(
        f"{arguments.mutants} mutants of projects in {seconds:.0f} "
        f"s, {refused} refused in words, 0 failed; {peak_mib} MiB\n"
    )
    return 0 if peak_mib < MOST_MIB else 1


if __name__ == "__main__":
    sys.exit(main())
