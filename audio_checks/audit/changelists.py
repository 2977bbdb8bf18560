"""The change that set a property of a project, as Git or Perforce knows it: id, day and subject, and no person."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from audio_checks.errors import SpecError
from audio_checks.run.changed_since import ENVIRONMENT, SAFELY
from audio_checks.system.isolation import installed_program
from audio_checks.system.text_files import read_text

MOST_ASKED = 64  # questions to Git in one audit
MOST_SECONDS = 10.0
P4_NAMES = ("P4CLIENT", "P4CONFIG", "P4PORT")
MOST_LINES = 4  # from a property's name to its value, where that stands below it
LONGEST_SUBJECT = 200
_ANNOTATED = re.compile(r"(\d{1,10}): ")
_CHANGE = re.compile(r"Change (\d{1,10}) on (\d{4}/\d{2}/\d{2})")
_UNCOMMITTED = re.compile(r"0{40,64}")


@dataclass(frozen=True)
class Changelist:
    """The change that set a value: its id, its day (UTC), the first line of its message."""

    id: str
    on: str
    subject: str

    def to_dict(self) -> dict[str, Any]:
        """Return the change as JSON has it."""
        return {"id": self.id, "on": self.on, "subject": self.subject}


class Changelists:
    """The changes of one project's files; nothing where neither Git nor Perforce knows them.

    Parameters
    ----------
    root : str
        The project's folder. Perforce is asked only where the environment names a server or a client, and Git knows
        no repository.
    """

    def __init__(self, root: str) -> None:
        self._root = root
        self._texts: dict[str, str] = {}
        self._known: dict[tuple[str, int], Changelist | None] = {}
        self._git = installed_program("git")
        self._p4 = installed_program("p4") if any(os.environ.get(name) for name in P4_NAMES) else None

    def of(self, file: str, anchor: str, name: str) -> Changelist | None:
        """Return the newest change among the lines of a property; None where it is not known or not committed.

        Parameters
        ----------
        file : str
            From the root.
        anchor, name : str
            Text that begins the object, and the property's name.
        """
        if not file or Path(file).is_absolute() or ".." in Path(file).parts:
            return None
        line, count = lines_of(self._text(file), anchor, name)
        key = file, line
        if line and key not in self._known:
            self._known[key] = self._blame(file, line, count) if len(self._known) < MOST_ASKED else None
        return self._known.get(key)

    def _text(self, file: str) -> str:
        if file not in self._texts:
            try:
                self._texts[file] = read_text(Path(self._root, file))
            except SpecError:
                self._texts[file] = ""
        return self._texts[file]

    def _blame(self, file: str, line: int, count: int) -> Changelist | None:
        return self._by_git(file, line, count) or (self._by_perforce(file, line, count) if self._p4 else None)

    def _by_perforce(self, file: str, line: int, count: int) -> Changelist | None:
        """Return the newest of the changelists that `p4 annotate -c` names for the lines."""
        annotated = self._run([self._p4 or "p4", "annotate", "-c", "-q", file])
        numbers = [
            int(line_match[1])
            for line_match in map(_ANNOTATED.match, annotated[line - 1 : line - 1 + count])
            if line_match is not None
        ]
        if not numbers:
            return None
        for answer in self._run([self._p4 or "p4", "changes", "-m", "1", f"@{max(numbers)},{max(numbers)}"]):
            if match := _CHANGE.match(answer):
                day = match[2].replace("/", "-")
                return Changelist(match[1], day, "")
        return Changelist(str(max(numbers)), "", "")

    def _by_git(self, file: str, line: int, count: int) -> Changelist | None:
        if self._git is None:
            return None
        return _newest(
            self._run(
                [
                    self._git, *SAFELY, "--no-pager", "blame", "--line-porcelain", "-L", f"{line},+{count}", "--", file,
                ]
            )
        )  # fmt: skip

    def _run(self, command: list[str]) -> list[str]:
        """Return the lines that a program says in the project's folder; none where it refuses or takes too long."""
        try:
            done = subprocess.run(
                command, cwd=self._root, capture_output=True, check=False, stdin=subprocess.DEVNULL,
                timeout=MOST_SECONDS, env={**os.environ, **ENVIRONMENT},
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired):
            return []
        return done.stdout.decode("utf-8", "replace").split("\n") if done.returncode == 0 else []


def lines_of(text: str, anchor: str, name: str) -> tuple[int, int]:
    """Return the line, from 1, at which a property of an object is set, and how many it takes; 0 where it is not found.

    Parameters
    ----------
    text : str
        Of the file.
    anchor, name : str
        Text that begins the object, and the property's name. An anchor that ends in a colon, or holds the name, is the
        value's own line.
    """
    begin = text.find(anchor) if anchor else 0
    if begin < 0:
        return 0, 0
    stem = name.partition(" ")[0]
    if anchor.endswith(":") or stem in anchor:
        return text.count("\n", 0, begin) + 1, 1
    at = text.find(stem, begin + len(anchor))
    at = begin if at < 0 else at
    count = 1
    lines = text[at : at + 4_096].split("\n")[:MOST_LINES]
    if not re.search(r"[:=]\s*\"?-?\d|alue", lines[0][len(stem) :]):  # the value does not stand beside the name
        count += next((below for below, line in enumerate(lines[1:], start=1) if "alue" in line), 0)
        count += any("alueList" in line for line in lines[:count])
    return text.count("\n", 0, at) + 1, count


def _newest(lines: Iterable[str]) -> Changelist | None:
    """Return the newest change that a blame names."""
    newest, newest_at = None, -1
    commit, at = "", 0
    for line in lines:
        if re.match(r"[0-9a-f]{40,64} \d", line):
            commit = line.partition(" ")[0]
        elif line.startswith("committer-time "):
            at = int(line[15:]) if line[15:].isdigit() and len(line) < 30 else 0
        elif line.startswith("summary ") and at > newest_at:
            newest_at = at
            if _UNCOMMITTED.fullmatch(commit):
                newest = Changelist("", "", "not committed")
            else:
                day = datetime.fromtimestamp(min(at, 1 << 33), UTC).date().isoformat()
                newest = Changelist(commit[:10], day, line[8:][:LONGEST_SUBJECT])
    return newest
