"""Writes the table of planted gains in RESULTS.md: `MIDDLEWARE_DIR=... make audit-levels`.

Gains are planted at every level of the tree, in generated projects and in copies of the real ones below MIDDLEWARE_DIR.
Right means that the sound file is said to be louder by what was planted, with the property that moved; false is a file
that was not moved.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.played import with_plays, with_project
from audio_checks.audit.report import Audit, Entry
from audio_checks.middleware.project import read_project
from audio_checks.middleware.values import Project
from benchmarks.audits.apart import APART
from benchmarks.audits.projects import KINDS
from benchmarks.audits.real_projects import BY_DB, PLANTS

PAGE = Path(__file__).with_name("RESULTS.md")
BEGIN, END = (
    ("<!-- planted gains: made by `MIDDLEWARE_DIR=... make audit-levels` -->\n"),
    "<!-- end of planted gains -->\n",
)
SOUNDS, PROJECTS = 70, 4  # of each engine; the first half were looked at while the readers were written
PLANTS_OF_A_LEVEL = 6
MOST_PLANTS = 60  # of one real project
WITHIN_DB = 0.05
BY_DB_APART = -5.0
WANTED = 0.98
SUFFIXES = (".wproj", ".fspro")


@dataclass
class Count:
    planted: int = 0
    right: int = 0
    missed: int = 0
    false: int = 0
    files: int = 0
    wrong: list[str] = field(default_factory=list)


def main() -> int:
    """Plant, count, write the table; return 1 where a promise is not kept."""
    counts: dict[tuple[str, str], Count] = defaultdict(Count)
    for engine, kind in KINDS.items():
        for number in range(PROJECTS):
            _generated(engine, counts[engine, "generated"], np.random.default_rng(number))
        sys.stdout.write(f"{engine}: {len(kind.levels)} levels planted\n")
        apart(engine, counts[engine, "kept apart"])
    folder = os.environ.get("MIDDLEWARE_DIR", "")
    for path in sorted(_projects(Path(folder))) if folder else []:
        _real(path, counts)
    table = _table(counts)
    page = PAGE.read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    after = rest.partition(END)[2]
    PAGE.write_text(before + BEGIN + table + END + after, encoding="utf-8")
    for key, count in counts.items():
        for line in count.wrong[:10]:
            sys.stdout.write(f"{' '.join(key)}: {line}\n")
    kept = all(not one.false and one.right >= WANTED * (one.right + one.missed) for one in counts.values())
    sys.stdout.write(f"{PAGE} written; kept: {kept}\n")
    return 0 if kept else 1


def _projects(folder: Path) -> list[Path]:
    found = [one for one in folder.rglob("*") if one.suffix in SUFFIXES or one.name == "project.godot"]
    return [*found, *(one.parent for one in folder.rglob("ProjectSettings") if (one.parent / "Assets").is_dir())]


def _generated(engine: str, count: Count, rng: np.random.Generator) -> None:
    kind = KINDS[engine]
    places = [(level, number) for level in kind.levels for number in kind.places(level, SOUNDS)]
    gains = {place: float(round(rng.uniform(-9, 3), 1)) for place in places if rng.random() < 0.3}
    with tempfile.TemporaryDirectory() as folder:
        approved = _approved(read_project(kind.write(Path(folder, "before"), SOUNDS, gains)))
        for level in kind.levels:
            numbers = list(kind.places(level, SOUNDS))
            for number in rng.permutation(numbers)[:PLANTS_OF_A_LEVEL]:
                place = (level, int(number))
                by_db = float(rng.choice([-12.0, -3.0, 0.5, 6.0]))
                if level == "instance" and place not in gains:
                    continue  # one more way to play a sound, at a level of its own
                changed = {**gains, place: gains.get(place, 0.0) + by_db}
                place_now = Path(folder, "after")
                shutil.rmtree(place_now, ignore_errors=True)
                audit = _audit(approved, read_project(kind.write(place_now, SOUNDS, changed)))
                moved = {kind.file.format(one) for one in kind.reached(place, SOUNDS)}
                _count(count, audit, moved, by_db, f"{level} {number}")


def apart(engine: str, count: Count) -> None:
    """Plant each gain of the project of an engine that was kept apart from its reader."""
    kind = APART[engine]
    with tempfile.TemporaryDirectory() as folder:
        approved = _approved(read_project(kind.write(Path(folder, "before"), {})))
        for number, (place, moved) in enumerate(kind.moved.items()):
            gains = {place: kind.standing.get(place, 0.0) + BY_DB_APART}
            audit = _audit(approved, read_project(kind.write(Path(folder, f"after {number}"), gains)))
            _count(count, audit, set(moved), BY_DB_APART, place)


def _real(path: Path, counts: dict[tuple[str, str], Count]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        root = path if path.is_dir() else path.parent
        copy = Path(folder, "project")
        shutil.copytree(root, copy, symlinks=True, copy_function=shutil.copyfile)
        for place in copy.rglob("*"):
            place.chmod(0o755 if place.is_dir() else 0o644)
        here = copy if path.is_dir() else copy / path.name
        project = read_project(here)
        approved = _approved(project)
        used = {one.file for one in project.played if one.is_used is not False and one.is_known}
        if project.engine not in PLANTS or not used:
            return
        count = counts[project.engine, "real"]
        by_level: dict[str, list[object]] = defaultdict(list)
        begun = count.planted
        for plant in PLANTS[project.engine](copy if project.engine in ("unity", "godot") else here):
            by_level[plant.level].append(plant)
            if len(by_level[plant.level]) > MOST_PLANTS // 4:
                continue
            moved = {file for file in used if any(f"/{file.lower()}".endswith(f"/{one}") for one in plant.moved)}
            if not moved:
                continue
            whole = plant.file.read_bytes()
            plant.file.write_text(plant.text, encoding="utf-8")
            audit = _audit(approved, read_project(here))
            plant.file.write_bytes(whole)
            _count(count, audit, moved, BY_DB, f"{root.name}: {plant.level} in {plant.file.name}")
        sys.stdout.write(f"{root.name}: {count.planted - begun} gains planted\n")


def _approved(project: Project) -> list[FingerprintedFile]:
    return with_plays([FingerprintedFile(file) for file in dict.fromkeys(one.file for one in project.played)], project)


def _audit(approved: list[FingerprintedFile], project: Project) -> Audit:
    entries = tuple(Entry(one.path, "same", 0.0, 0.0, approved=one.path) for one in approved)
    return with_project(Audit(entries), approved, project)


def _count(count: Count, audit: Audit, moved: set[str], by_db: float, what: str) -> None:
    count.planted += 1
    for entry in audit.entries:
        found = entry.status == "gain"
        if entry.path in moved:
            count.files += 1
            drifts = [play.drift_db or 0.0 for play in entry.plays if play.moved]
            named = all(play.moved for play in entry.plays if abs(play.drift_db or 0.0) > WITHIN_DB)
            right = found and named and any(abs(drift_db - by_db) <= WITHIN_DB for drift_db in drifts)
            count.right += right
            count.missed += not right
            if not right:
                count.wrong.append(f"missed: {what}: {entry.path}: {entry.status} {drifts}")
        elif found:
            count.false += 1
            count.wrong.append(f"false: {what}: {entry.path}: {entry.message}")


def _table(counts: dict[tuple[str, str], Count]) -> str:
    rows = "".join(
        f"| {engine} | {kind} | {one.planted:,} | {one.files:,} | "
        f"{one.right:,} ({100 * one.right / max(1, one.files):.1f} %)"
        f" | {one.missed:,} | {one.false:,} |\n"
        for (engine, kind), one in counts.items()
    )
    return (
        "| engine | projects | gains planted | sounds moved | "
        "right | missed | false |\n|---|---|---|---|---|---|---|\n" + rows
    )


if __name__ == "__main__":
    sys.exit(main())
