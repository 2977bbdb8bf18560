"""Shells that complete what is typed, as a person at a terminal sees it."""

import os
import pty
import re
import select
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

CONTROLS = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|[\x00-\x1f]")


def installed(shell: str) -> bool:
    """Whether a shell is on this machine."""
    return shutil.which(shell) is not None


def run(shell: str, commands: str, *options: str, folder: Path, environment: dict[str, str] | None = None) -> str:
    """Return what commands print in a shell, which may print nothing else."""
    program = shutil.which(shell)
    assert program is not None
    answer = subprocess.run(
        [program, *options, "-c", commands], capture_output=True, text=True, check=True, cwd=folder, env=environment
    )
    assert answer.stderr == ""
    return answer.stdout


def offered_by_bash(script: Path, line: str, function: str) -> set[str]:
    """Return what a function of a script offers for a line, completed at its end."""
    *words, last = line.split(" ")
    ask = f"source {script}; COMP_WORDS=({' '.join(words)} '{last}'); COMP_CWORD={len(words)};"
    ask += f' {function}; printf "%s\\n" "${{COMPREPLY[@]}}"'
    return set(run("bash", ask, folder=script.parent).split())


def offered_by_fish(script: Path, line: str) -> set[str]:
    """Return what fish offers for a line once a script is loaded."""
    environment = os.environ | {"HOME": str(script.parent)}
    ask = f"source {script}; complete -C '{line}'"
    shown = run("fish", ask, "--no-config", folder=script.parent, environment=environment)
    return {splitline.partition("\t")[0] for splitline in shown.splitlines()}


@contextmanager
def zsh(script: Path, path: str) -> Iterator[int]:
    """Give a terminal on which zsh has loaded a script: the tab key is all that it completes for."""
    program = shutil.which("zsh")
    assert program is not None
    leader, follower = pty.openpty()
    home = str(script.parent)
    shell = subprocess.Popen(
        [program, "-f", "-i"],
        stdin=follower,
        stdout=follower,
        stderr=follower,
        env={"PATH": path, "HOME": home, "TERM": "dumb", "ZDOTDIR": home},
        start_new_session=True,
    )
    os.close(follower)
    try:
        os.write(leader, b"unsetopt zle_bracketed_paste; autoload -Uz compinit; compinit -D; PS1='ready> '\n")
        os.write(leader, f"eval \"$(<{script})\"; echo lo''aded\n".encode())
        until(leader, "loaded")
        yield leader
    finally:
        shell.kill()
        shell.wait()
        os.close(leader)


def complete(terminal: int, typed: str, wanted: str) -> None:
    """Type on a terminal until it shows what is wanted."""
    os.write(terminal, typed.encode())
    until(terminal, wanted)


def until(terminal: int, wanted: str) -> None:
    """Read a terminal until it shows what is wanted."""
    shown, deadline = "", time.monotonic() + 300
    while time.monotonic() < deadline:
        if select.select([terminal], [], [], 0.1)[0]:
            shown += os.read(terminal, 4096).decode(errors="replace")
            if wanted in CONTROLS.sub("", shown):
                return
    raise AssertionError(f"{wanted!r} is not in {shown!r}")
