"""docs/reference/practice.md: every practice in it names a test that there is."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
ROW = re.compile(r"^\| (?P<practice>[^|]+) \| `(?P<file>[^`:]+)::(?P<name>[^`]+)` \|$")


def rows() -> list[str]:
    lines = (ROOT / "docs/reference/practice.md").read_text("utf-8").splitlines()
    return [line for line in lines if line.startswith("| ") and line != "| practice | test |"]


def names_a_test(row: str) -> bool:
    """Whether a row has the form of a practice with its test, and its file defines a test of this name."""
    match = ROW.match(row)
    if match is None or not (file := ROOT / match["file"]).is_file():
        return False
    text, name = file.read_text("utf-8"), match["name"]
    if file.suffix == ".py":
        return re.search(rf"^def {re.escape(name)}\(", text, re.MULTILINE) is not None
    return f"test({name.replace(chr(34), chr(39))}," in text


def test_every_practice_names_a_test_that_there_is():
    assert [row for row in rows() if not names_a_test(row)] == []
    assert rows()


@pytest.mark.parametrize(
    "row",
    [
        "| a practice | `tests/house/test_practice.py::test_of_nothing` |",
        "| a practice | `tests/house/test_nowhere.py::test_every_practice_names_a_test_that_there_is` |",
        '| a practice | `frontend/src/verdicts/hearing.test.ts::"of nothing"` |',
        "| a practice without a test | |",
    ],
)
def test_a_row_without_a_test_is_found(row: str):
    assert not names_a_test(row)
