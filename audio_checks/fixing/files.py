"""Fixes the files of one folder into another, and reports what was done to each."""

import os
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from audio_checks.errors import FixRefused
from audio_checks.fixing.fix_master import fix_master
from audio_checks.fixing.fixed import FixedMaster
from audio_checks.report.findings import SCHEMA_VERSION
from audio_checks.run.discovery import Found
from audio_checks.run.runner import printable_path
from audio_checks.run.workload import CORES, size_of
from audio_checks.spec.check_names import Severity
from audio_checks.spec.delivery_spec import DeliverySpec
from audio_checks.spec.sound_list import SoundList
from audio_checks.version import TOOL_VERSION

STATES = ("fixed", "partly", "left", "fine")


@dataclass(frozen=True)
class FixedFile:
    """One file of a run: its result, or why it was refused."""

    path: str
    fixed: FixedMaster | None
    refusal: FixRefused | None = None

    def left(self, severity: Severity) -> int:
        """Return the number of findings left of one severity; a refusal counts as an error."""
        if self.fixed is None:
            return int(severity == "error")
        return sum(unfixed.finding.severity == severity for unfixed in self.fixed.left)

    @property
    def is_our_fault(self) -> bool:
        """Whether a check or the process broke, so that nothing is known of the file."""
        if self.refusal is not None and self.refusal.code == "fix:crashed":
            return True
        return self.fixed is not None and (self.fixed.after or self.fixed.before).verdict == "unjudged"

    @property
    def state(self) -> str:
        """In a word: "fixed", "partly" fixed, "fine" as it was, or "left" as it was with what was found."""
        if self.fixed is None:
            return "left"
        if self.fixed.path is None:
            return "left" if self.fixed.left else "fine"
        return "fixed" if self.fixed.conforms else "partly"

    def to_dict(self) -> dict[str, Any]:
        """Return the file's entry in the JSON."""
        entry: dict[str, Any] = {"path": self.path, "state": self.state, "out": None, "refusal": None}
        if self.refusal is not None:
            entry["refusal"] = {"code": self.refusal.code, "message": str(self.refusal), "fix": self.refusal.fix}
        if self.fixed is None:
            return entry
        return entry | {"out": printable_path(self.fixed.path) if self.fixed.path else None} | self.fixed.to_dict()


@dataclass
class FixRun:
    """One run over masters; no two of them make the same copy."""

    folder: Path
    target: str | None = None
    category: str | None = None
    sound_list: SoundList | None = None
    files: list[FixedFile] = field(default_factory=list)

    def fix(self, master: Found, spec: DeliverySpec) -> FixedFile:
        """Fix one file into its place below the folder, and record the result."""
        try:
            fixed_file = FixedFile(printable_path(master.path), self._fixed(master, spec))
        except FixRefused as error:
            fixed_file = FixedFile(printable_path(master.path), None, error)
        self.files.append(fixed_file)
        return fixed_file

    def fix_all(
        self, tasks: Sequence[tuple[Found, DeliverySpec]], *, jobs: int = 1, done: Callable[[str], None] | None = None
    ) -> None:
        """Fix files in so many processes, 0 for one a core; those of one folder are fixed in order, by one process.

        Two copies can only get the same name where their masters lie in one folder.
        """
        folders: dict[str, list[tuple[Found, DeliverySpec]]] = defaultdict(list)
        for master, spec in tasks:
            folders[os.path.dirname(master.relative)].append((master, spec))
        jobs = min(jobs or CORES, len(folders))
        if jobs <= 1:
            for master, spec in tasks:
                self.fix(master, spec)
                if done:
                    done(master.relative)
            return
        from audio_checks.run.processes import in_processes  # a slow import that a single process does not need

        orders = [(replace(self, files=[]), folder) for folder in folders.values()]

        def report_done(made: dict[str, FixedFile]) -> None:
            if done:
                for relative in made:
                    done(relative)

        made = in_processes(_fix_folders, orders, workers=jobs, size=_bytes_of, died=_died, done=report_done)
        by_place = {relative: fixed_file for folder in made for relative, fixed_file in folder.items()}
        self.files += [by_place[master.relative] for master, _ in tasks]

    def _fixed(self, master: Found, spec: DeliverySpec) -> FixedMaster:
        out_folder = self.folder / Path(master.relative).parent
        slot = self.sound_list.slot_of_file(master.path) if self.sound_list else None
        out_folder.mkdir(parents=True, exist_ok=True)
        try:
            return fix_master(
                master.path,
                spec,
                out_folder,
                target=self.target,
                category=self.category,
                cue=slot[0] if slot else None,
                beside=[file.fixed.path for file in self.files if file.fixed and file.fixed.path],
            )
        finally:
            _remove_if_empty(out_folder, self.folder)

    def to_json(self) -> dict[str, Any]:
        """Return the run as plain values."""
        return {
            "schema_version": SCHEMA_VERSION,
            "tool": {"name": "audio-checks", "version": TOOL_VERSION},
            "files": [file.to_dict() for file in self.files],
            "summary": {"files": len(self.files), **self.counts()},
        }

    def counts(self) -> dict[str, int]:
        """Return the number of files in each state."""
        return {state: sum(file.state == state for file in self.files) for state in STATES}


def _fix_folders(orders: list[tuple[FixRun, list[tuple[Found, DeliverySpec]]]]) -> list[dict[str, FixedFile]]:
    return [{master.relative: run.fix(master, spec) for master, spec in tasks} for run, tasks in orders]


def _bytes_of(order: tuple[FixRun, list[tuple[Found, DeliverySpec]]]) -> int:
    return sum(size_of(master.path) for master, _ in order[1])


def _died(order: tuple[FixRun, list[tuple[Found, DeliverySpec]]], error: BaseException) -> dict[str, FixedFile]:
    broken = FixRefused(f"the process that repaired it died: {error}", "fix:crashed", "run again with -j 1")
    return {master.relative: FixedFile(printable_path(master.path), None, broken) for master, _ in order[1]}


def _remove_if_empty(folder: Path, top: Path) -> None:
    """Leave no folder behind in which nothing was made."""
    while folder != top.parent and folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
        folder = folder.parent
