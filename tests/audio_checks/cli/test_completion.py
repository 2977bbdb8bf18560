"""Completion, asked of the shells themselves."""

import os
import pty
import re
import select
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from audio_checks.checks import all_checks
from audio_checks.cli import COMMANDS, main, reporters

CONTROLS = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|[\x00-\x1f]")
BIN = str(Path(sys.executable).parent)


def script(shell, capsys):
    assert main(["completion", shell]) == 0
    return capsys.readouterr().out


def installed(shell):
    return pytest.mark.skipif(shutil.which(shell) is None, reason=f"{shell} is not installed")


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
        ("audio-checks check --spec ", set()),  # nothing of ours: bash goes on with paths
    ],
)
def test_bash(line, wanted, tmp_path, capsys):
    (tmp_path / "script").write_text(script("bash", capsys))
    words = line.split(" ")
    ask = f"source {tmp_path}/script; COMP_WORDS=({' '.join(words[:-1])} '{words[-1]}'); COMP_CWORD={len(words) - 1};"
    ask += ' _audio_checks; printf "%s\\n" "${COMPREPLY[@]}"'
    said = subprocess.run([shutil.which("bash"), "-c", ask], capture_output=True, text=True, check=True)
    assert said.stderr == ""
    assert set(said.stdout.split()) == wanted


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
def test_fish(line, wanted, unwanted, tmp_path, monkeypatch, capsys):
    (tmp_path / "sounds.csv").touch()
    (tmp_path / "script").write_text(script("fish", capsys))
    monkeypatch.setenv("HOME", str(tmp_path))
    ask = f"source {tmp_path}/script; complete -C '{line}'"
    said = subprocess.run(
        [shutil.which("fish"), "--no-config", "-c", ask], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    offered = {one.partition("\t")[0] for one in said.stdout.splitlines()}
    assert said.stderr == ""
    assert wanted <= offered
    assert not unwanted & offered


@installed("zsh")
def test_zsh(tmp_path, capsys):
    """Typed on a terminal: the tab key is all that zsh completes for."""
    (tmp_path / "script").write_text(script("zsh", capsys))
    leader, follower = pty.openpty()
    environment = {
        "PATH": f"{BIN}:{os.environ['PATH']}",
        "HOME": str(tmp_path),
        "TERM": "dumb",
        "ZDOTDIR": str(tmp_path),
    }
    shell = subprocess.Popen(
        [shutil.which("zsh"), "-f", "-i"],
        stdin=follower,
        stdout=follower,
        stderr=follower,
        env=environment,
        start_new_session=True,
    )
    os.close(follower)
    try:
        os.write(leader, b"unsetopt zle_bracketed_paste; autoload -Uz compinit; compinit -D; PS1='ready> '\n")
        os.write(leader, f"source {tmp_path}/script; echo lo''aded\n".encode())
        until(leader, "loaded")
        for typed, completed in (
            ("audio-checks expl\t", "explain"),
            ("true\t", "true-peak"),
            ("\x15audio-checks check --fail-l\t", "--fail-level"),
            ("w\t", "warning"),
            ("\x15audio-checks measure --format jsonl --categ\t", "--category"),
        ):
            os.write(leader, typed.encode())
            until(leader, completed)
    finally:
        shell.kill()
        shell.wait()
        os.close(leader)


def until(terminal, wanted):
    """Read a terminal until it shows what is wanted."""
    shown, deadline = "", time.monotonic() + 120
    while time.monotonic() < deadline:
        if select.select([terminal], [], [], 0.1)[0]:
            shown += os.read(terminal, 4096).decode(errors="replace")
            if wanted in CONTROLS.sub("", shown):
                return
    raise AssertionError(f"{wanted!r} is not in {shown!r}")
