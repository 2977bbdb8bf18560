"""Mends the files of a folder into another, and tells what was done to each."""

import os
import textwrap
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from audio_checks.check_names import Severity
from audio_checks.discovery import Found
from audio_checks.errors import MendRefused
from audio_checks.findings import SCHEMA_VERSION, printable
from audio_checks.mending.mend import mend_master
from audio_checks.mending.mended import Mended
from audio_checks.runner import legible
from audio_checks.sound_list import SoundList
from audio_checks.spec import DeliverySpec
from audio_checks.terminal import BOLD, DIM, GREEN, RED, YELLOW, Ink, width
from audio_checks.version import TOOL_VERSION
from audio_checks.workload import CORES, size_of

LEVELS = {
    "sample-peak": ("sample_peak_dbfs", "sample peak", "dBFS"),
    "true-peak": ("true_peak_dbtp", "true peak", "dBTP"),
    "loudness": ("integrated_lufs", "loudness", "LUFS"),
}
"""What a gain is told by: the figure, its words and its unit, by the check that asked for it."""
STATES = ("mended", "partly", "left", "fine")
WORD_WIDTH = len("refused") + 2


@dataclass(frozen=True)
class MendedFile:
    """One file of a run: what came of it, or why it was refused."""

    path: str
    mended: Mended | None
    refusal: MendRefused | None = None

    def left(self, severity: Severity) -> int:
        """Return how many findings of one severity no mend answered; a refusal leaves an error."""
        if self.mended is None:
            return int(severity == "error")
        return sum(one.finding.severity == severity for one in self.mended.left)

    @property
    def is_our_fault(self) -> bool:
        """Whether a check or the process broke, so that nothing is known of the file."""
        if self.refusal is not None and self.refusal.code == "mend:crashed":
            return True
        return self.mended is not None and (self.mended.after or self.mended.before).verdict == "unjudged"

    @property
    def state(self) -> str:
        """In a word: "mended", "partly" mended, "fine" as it was, or "left" as it was with what was found."""
        if self.mended is None:
            return "left"
        if self.mended.path is None:
            return "left" if self.mended.left else "fine"
        return "mended" if self.mended.conforms else "partly"

    def to_dict(self) -> dict[str, Any]:
        """Return the file's entry in the JSON."""
        entry: dict[str, Any] = {"path": self.path, "state": self.state, "out": None, "refusal": None}
        if self.refusal is not None:
            entry["refusal"] = {"code": self.refusal.code, "message": str(self.refusal), "fix": self.refusal.fix}
        if self.mended is None:
            return entry
        return entry | {"out": legible(self.mended.path) if self.mended.path else None} | self.mended.to_dict()


@dataclass
class MendRun:
    """One run over masters; no two of them make the same copy."""

    folder: Path
    target: str | None = None
    category: str | None = None
    sound_list: SoundList | None = None
    files: list[MendedFile] = field(default_factory=list)

    def mend(self, found: Found, spec: DeliverySpec) -> MendedFile:
        """Mend one file into its place below the folder, and remember what came of it."""
        try:
            one = MendedFile(legible(found.path), self._mended(found, spec))
        except MendRefused as error:
            one = MendedFile(legible(found.path), None, error)
        self.files.append(one)
        return one

    def mend_all(
        self, tasks: Sequence[tuple[Found, DeliverySpec]], *, jobs: int = 1, done: Callable[[str], None] | None = None
    ) -> None:
        """Mend files in so many processes, 0 for one a core; those of one folder are mended in order, by one process.

        Two copies can only get the same name where their masters lie in one folder.
        """
        folders: dict[str, list[tuple[Found, DeliverySpec]]] = defaultdict(list)
        for found, spec in tasks:
            folders[os.path.dirname(found.relative)].append((found, spec))
        jobs = min(jobs or CORES, len(folders))
        if jobs <= 1:
            for found, spec in tasks:
                self.mend(found, spec)
                if done:
                    done(found.relative)
            return
        from audio_checks.processes import in_processes  # costs what one process need not pay

        orders = [(replace(self, files=[]), folder) for folder in folders.values()]

        def tell(made: dict[str, MendedFile]) -> None:
            if done:
                for relative in made:
                    done(relative)

        made = in_processes(_mend_folders, orders, workers=jobs, size=_bytes_of, died=_died, done=tell)
        by_place = {place: one for folder in made for place, one in folder.items()}
        self.files += [by_place[found.relative] for found, _ in tasks]

    def _mended(self, found: Found, spec: DeliverySpec) -> Mended:
        place = self.folder / Path(found.relative).parent
        slot = self.sound_list.slot_of_file(os.path.basename(found.relative)) if self.sound_list else None
        place.mkdir(parents=True, exist_ok=True)
        try:
            return mend_master(
                found.path,
                spec,
                place,
                target=self.target,
                category=self.category,
                cue=slot[0] if slot else None,
                beside=[one.mended.path for one in self.files if one.mended and one.mended.path],
            )
        finally:
            _remove_if_empty(place, self.folder)

    def to_text(self, *, colour: bool, summary: bool = True) -> str:
        """Return what was done to each file and what is left, with a line that sums up unless it is left out."""
        ink = Ink(colour)
        blocks = ["\n".join(_lines(one, ink)) + "\n" for one in self.files if one.state != "fine"]
        if not summary:
            return "\n".join(blocks)
        counts, files = self._counts(), f"{len(self.files)} file{'' if len(self.files) == 1 else 's'}"
        summed = f"{files}: {counts['mended']} mended, {counts['partly']} in part, {counts['left']} not"
        return "\n".join([*blocks, f"{summed}, {counts['fine']} had nothing to mend\n"])

    def to_json(self) -> dict[str, Any]:
        """Return the run as plain values."""
        return {
            "schema_version": SCHEMA_VERSION,
            "tool": {"name": "audio-checks", "version": TOOL_VERSION},
            "files": [one.to_dict() for one in self.files],
            "summary": {"files": len(self.files), **self._counts()},
        }

    def _counts(self) -> dict[str, int]:
        return {state: sum(one.state == state for one in self.files) for state in STATES}


def _mend_folders(orders: list[tuple[MendRun, list[tuple[Found, DeliverySpec]]]]) -> list[dict[str, MendedFile]]:
    return [{found.relative: run.mend(found, spec) for found, spec in tasks} for run, tasks in orders]


def _bytes_of(order: tuple[MendRun, list[tuple[Found, DeliverySpec]]]) -> int:
    return sum(size_of(found.path) for found, _ in order[1])


def _died(order: tuple[MendRun, list[tuple[Found, DeliverySpec]]], error: BaseException) -> dict[str, MendedFile]:
    broken = MendRefused(f"the process that repaired it died: {error}", "mend:crashed", "run again with -j 1")
    return {found.relative: MendedFile(legible(found.path), None, broken) for found, _ in order[1]}


def _remove_if_empty(place: Path, top: Path) -> None:
    """Leave no folder behind in which nothing was made."""
    while place != top.parent and place.is_dir() and not any(place.iterdir()):
        place.rmdir()
        place = place.parent


def _lines(one: MendedFile, ink: Ink) -> Iterator[str]:
    yield ink(printable(one.path), BOLD)
    if one.refusal is not None:
        yield f"  {ink('refused'.ljust(WORD_WIDTH), RED)}{printable(f'{one.refusal}; {one.refusal.fix}')}"
    if one.mended is None:
        return
    for repair in one.mended.repairs:
        told = f"{repair.words}{_figures(one.mended, repair.codes)}"
        yield f"  {ink('mended'.ljust(WORD_WIDTH), GREEN)}{printable(told)}"
    for left in one.mended.left:
        tone = RED if left.finding.severity == "error" else YELLOW
        yield f"  {ink('left'.ljust(WORD_WIDTH), tone)}{printable(left.finding.message)}  {ink(left.finding.code, DIM)}"
        indent = " " * (WORD_WIDTH + 2)
        yield textwrap.fill(printable(left.why), width(), initial_indent=indent, subsequent_indent=indent)
    if one.mended.path is not None:
        yield f"  {ink('copy'.ljust(WORD_WIDTH), DIM)}{printable(os.fspath(one.mended.path))}"


def _figures(mended: Mended, codes: tuple[str, ...]) -> str:
    """Return the levels that a gain moved, before and after."""
    if mended.after is None:
        return ""
    told = []
    for code in codes:
        figure, words, unit = LEVELS.get(code.partition(":")[0], ("", "", ""))
        before, after = mended.before.measurements.get(figure), mended.after.measurements.get(figure)
        if before is not None and after is not None:
            told.append(f"{words} {before:z.2f} to {after:z.2f} {unit}")
    return f" ({', '.join(told)})" if told else ""
