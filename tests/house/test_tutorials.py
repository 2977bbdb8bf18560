"""The tutorials: their commands give the output that they show."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from audio_checks.cli import main
from tests.support.added_check import ROOT, copy_of_library, run

TUTORIALS = ROOT / "docs" / "tutorials"
PAGE = TUTORIALS / "first-ci-check.md"
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


@pytest.mark.slow
def test_the_check_of_the_first_change_in_python_passes_its_test_and_says_what_the_page_shows(tmp_path: Path):
    blocks = BLOCK.findall((TUTORIALS / "first-python-change.md").read_text(encoding="utf-8"))
    sound, test, check = (block for language, block in blocks if language == "python")
    outputs = [block for language, block in blocks if language == "" and "conforming" in block]
    tree = copy_of_library(tmp_path)
    (tree / "square.py").write_text(sound)
    run(tree, "square.py")
    (tree / "spec.toml").write_text(run(tree, "-m", "audio_checks.cli", "new-spec").stdout)
    checking = ("-m", "audio_checks.cli", "check", "--spec", "spec.toml", "square.wav")
    assert run(tree, *checking).stdout == outputs[0]
    (tree / "audio_checks" / "checks" / "squashed.py").write_text(check)
    assert run(tree, *checking).stdout == outputs[1]
    assert "limited until its peaks" in run(tree, "-m", "audio_checks.cli", "explain", "squashed").stdout
    (tree / "test_squashed.py").write_text(test)
    shutil.copy(ROOT / "tests/audio_checks/checks/conftest.py", tree)
    passed = run(tree, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_squashed.py")
    assert "3 passed" in passed.stdout, passed.stdout + passed.stderr
