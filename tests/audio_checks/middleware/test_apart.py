"""Gains planted in the projects that were kept apart from the readers, and what their sounds depend on."""

from pathlib import Path

import pytest

from audio_checks.middleware.project import read_project
from benchmarks.audits.apart import APART
from benchmarks.audits.levels import Count, apart


@pytest.mark.parametrize("engine", APART)
def test_each_planted_gain_is_found_and_no_other(engine: str) -> None:
    count = Count()
    apart(engine, count)
    assert (count.wrong, count.missed, count.false) == ([], 0, 0)
    assert count.right == count.files == sum(map(len, APART[engine].moved.values())) > 20


@pytest.mark.parametrize("engine", APART)
def test_what_else_changes_a_level_is_said(engine: str, tmp_path: Path) -> None:
    kind = APART[engine]
    project = read_project(kind.write(tmp_path, {}))
    for file, wanted in kind.depends.items():
        found = {by.on for one in project.played if one.file == file for by in one.depends}
        assert found & set(wanted) if any(wanted) else not found, f"{file}: {sorted(found)}, wanted {wanted}"
