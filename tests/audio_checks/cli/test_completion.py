"""Completion, asked of the shells themselves."""

import os
import sys
from pathlib import Path

import pytest

from audio_checks.checks import all_checks
from audio_checks.cli import COMMANDS, completion, main, reporters
from tests.support import shells

BIN = str(Path(sys.executable).parent)


def script(shell, capsys):
    assert main(["completion", shell]) == 0
    return capsys.readouterr().out


def installed(shell):
    return pytest.mark.skipif(not shells.installed(shell), reason=f"{shell} is not installed")


def test_the_scripts_are_those_of_the_commands_as_they_are(capsys):
    assert {shell: script(shell, capsys) for shell in completion.SHELLS} == completion.scripts(), "run make completions"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("audio-checks ", set(COMMANDS)),
        ("audio-checks che", {"check"}),
        ("audio-checks check --fa", {"--fail-level"}),
        ("audio-checks check --fail-level ", {"error", "warning"}),
        ("audio-checks check --format ", set(reporters.formats())),
        ("audio-checks measure --format ", set(reporters.measured_formats())),
        ("audio-checks explain true", {"true-peak"}),
        ("audio-checks explain ", set(all_checks())),
        ("audio-checks schema ", {"spec", "report", "manifest", "audit"}),
        ("audio-checks completion z", {"zsh"}),
        ("audio-checks check --spec scr", {"script"}),
        ("audio-checks check scr", {"script"}),
    ],
)
def test_bash(line, wanted, tmp_path, capsys):
    (tmp_path / "script").write_text(script("bash", capsys))
    assert shells.offered_by_bash(tmp_path / "script", line, "_shtab_audio_checks") == wanted


@pytest.mark.slow
@installed("fish")
@pytest.mark.parametrize(
    ("line", "wanted", "unwanted"),
    [
        ("audio-checks che", {"check"}, {"measure"}),
        ("audio-checks check --fail-level ", {"error", "warning"}, {"check"}),
        ("audio-checks explain ", {"true-peak", "naming"}, {"sounds.csv"}),
        ("audio-checks check --list ", {"sounds.csv"}, {"true-peak"}),
        ("audio-checks render --target x --ou", {"--out"}, {"--spec"}),
    ],
)
def test_fish(line, wanted, unwanted, tmp_path, capsys):
    (tmp_path / "sounds.csv").touch()
    (tmp_path / "script").write_text(script("fish", capsys))
    offered = shells.offered_by_fish(tmp_path / "script", line)
    assert wanted <= offered
    assert not unwanted & offered


@pytest.mark.slow
@installed("zsh")
def test_zsh(tmp_path, capsys):
    """Typed on a terminal: the tab key is all that zsh completes for."""
    (tmp_path / "script").write_text(script("zsh", capsys))
    with shells.zsh(tmp_path / "script", f"{BIN}:{os.environ['PATH']}") as terminal:
        for typed, completed in (
            ("audio-checks expl\t", "explain"),
            ("true\t", "true-peak"),
            ("\x15audio-checks check --fail-l\t", "--fail-level"),
            ("w\t", "warning"),
            ("\x15audio-checks measure --format jsonl --categ\t", "--category"),
        ):
            shells.complete(terminal, typed, completed)
