"""The pages of checks are those that their docstrings make."""

from pathlib import Path

import pytest

from audio_checks.checks import all_checks
from audio_checks.cli.pages import pages, write_pages
from audio_checks.spec import check_names

pytestmark = pytest.mark.lint

DOCS = Path(__file__).parents[2] / "docs" / "checks"


def test_the_pages_are_up_to_date():
    there = {path.name: path.read_text(encoding="utf-8") for path in DOCS.glob("*.md")}
    assert there == pages(), "run: python -m audio_checks.cli.pages docs/checks"


def test_every_check_has_its_page_and_its_test():
    tests = {path.stem for path in Path(__file__).with_name("checks").glob("test_*.py")}
    for name in all_checks():
        assert f"{name}.md" in pages()
        assert f"test_{name.replace('-', '_')}" in tests


def test_every_module_among_the_checks_bears_a_name_of_the_format():
    assert check_names.present() <= set(check_names.DEFAULT_SEVERITY)


def test_pages_of_checks_that_are_gone_are_removed(tmp_path):
    (tmp_path / "hiccup.md").write_text("old", encoding="utf-8")
    write_pages(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == set(pages())
