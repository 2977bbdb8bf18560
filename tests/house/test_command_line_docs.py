"""What the documents say of the command line is what it understands."""

import argparse
import re
import shlex
from pathlib import Path

import pytest

from audio_checks.cli import COMMANDS, parser_of, reporters

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
GUIDE = (ROOT / "docs" / "reference" / "command-line.md").read_text()


def lines_of(document):
    """The commands in a document's blocks of code, without their comments and substitutions."""
    for block in re.findall(r"```[a-z]*\n(.*?)```", document.read_text(), re.DOTALL):
        for line in re.findall(r"^ *(audio-checks .*)$", block, re.MULTILINE):
            yield line.partition(" #")[0].partition(" | ")[0].partition(" > ")[0]


LINES = [(document.name, line) for document in DOCUMENTS for line in lines_of(document)]


@pytest.mark.parametrize(("document", "line"), LINES)
def test_every_command_of_the_documents_is_understood(document, line):
    parser_of().parse_args(shlex.split(line)[1:])


def test_there_are_such_commands():
    assert len(LINES) > 10


def flags():
    (group,) = [action for action in parser_of()._actions if isinstance(action, argparse._SubParsersAction)]
    return {flag for command in group.choices.values() for action in command._actions for flag in action.option_strings}


def test_every_flag_that_the_guide_names_is_one():
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", GUIDE))
    assert named <= flags()


def test_every_flag_of_check_every_command_and_every_format_stands_in_the_guide():
    (group,) = [action for action in parser_of()._actions if isinstance(action, argparse._SubParsersAction)]
    of_check = {action.option_strings[-1] for action in group.choices["check"]._actions if action.option_strings} - {
        "--help"
    }
    missing = {flag for flag in of_check if flag not in GUIDE and flag != "--jobs"}
    assert missing == set()
    assert all(f"`{name}`" in GUIDE for name in (*COMMANDS, *reporters.formats()))
