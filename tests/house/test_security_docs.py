"""docs/reference/security.md has a row for each chapter, and each row a test, a reason, or an open mark."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs/reference/security.md").read_text()
ROWS = re.findall(r"^\| ((?:V?\d)[^|]*) \| ([^|]+) \| ([^|]+) \|$", TEXT, re.MULTILINE)


def test_every_chapter_is_there():
    chapters = set(re.findall(r"^## V(\d+) ", TEXT, re.MULTILINE)) | set(
        re.findall(r"^\| V(\d+) \|", TEXT, re.MULTILINE)
    )
    assert sorted(map(int, chapters)) == list(range(1, 18))
    assert len(ROWS) > 90


def test_every_row_says_why():
    for numbers, requirement, why in ROWS:
        assert len(requirement) > 3, numbers
        assert len(why.strip()) >= 3, numbers


def test_every_file_that_is_named_is_there():
    named = re.findall(
        r"`((?:tests|deploy|docs|frontend|\.github)/[\w./-]+)`", TEXT + (ROOT / "SECURITY.md").read_text()
    )
    assert len(set(named)) > 25
    assert [name for name in sorted(set(named)) if not (ROOT / name).exists()] == []


def test_every_attack_that_is_named_is_one():
    from tests.attack.attacks import ATTACKS

    named = re.findall(r'`tests/attack/attacks.py`, "([^"]+)"', TEXT)
    assert named
    assert set(named) <= set(ATTACKS)
