"""The tutorial of the CI check: its commands give the output that it shows."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from audio_checks.cli import main

PAGE = Path(__file__).resolve().parents[2] / "docs" / "tutorials" / "first-ci-check.md"
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)


def test_each_command_gives_the_output_that_the_page_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(tmp_path)
    shown = ""
    compared = 0
    for language, block in BLOCK.findall(PAGE.read_text(encoding="utf-8")):
        if language == "python":
            exec(compile(block, PAGE.name, "exec"), {"__name__": "__main__"})  # noqa: S102 - our own page
        elif language == "" and re.match(r"(audio-checks|rm|cp) ", block):
            shown = "".join(output_of(command, capsys) for command in block.splitlines())
        elif language == "":
            assert block == shown
            compared += 1
    assert compared == 3


def output_of(command: str, capsys: pytest.CaptureFixture[str]) -> str:
    """Return the output of one line of the page, run in the working directory."""
    line, _, target = command.partition(" > ")
    program, *arguments = shlex.split(line)
    if program == "rm":
        Path(arguments[0]).unlink()
    elif program == "cp":
        shutil.copy(*arguments)
    else:
        main(arguments)
        output = capsys.readouterr().out
        if not target:
            return output
        Path(target).write_text(output, encoding="utf-8")
    return ""
