"""Parts of the tests that run beside each other: who says what is seen, and a failure is never lost."""

import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint
PART = Path(__file__).resolve().parents[2] / ".ci/part"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / ".make").mkdir()
    return tmp_path


def run_part(folder: Path, script: str) -> subprocess.CompletedProcess[str]:
    command = [str(PART), "unit", "sh", "-c", script]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)


def test_each_line_carries_the_name_of_its_part(folder: Path):
    ran = run_part(folder, "echo one; echo two >&2")
    assert ran.returncode == 0
    assert ran.stdout == "unit: one\nunit: two\n"
    assert ran.stderr.startswith("unit: took ")
    assert (folder / ".make/unit.log").read_text() == "one\ntwo\n"
    assert not (folder / ".make/unit.failed").exists()


def test_a_part_that_fails_says_so_and_keeps_its_end(folder: Path):
    ran = run_part(folder, "seq 100; exit 3")
    assert ran.returncode == 1
    kept = (folder / ".make/unit.failed").read_text().splitlines()
    assert kept == ["unit FAILED; it ended with", *map(str, range(61, 101))]
