"""Files that a pull will write, opened in Perforce or locked in Git LFS; commands are started without a shell."""

import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from app.client.errors import Refusal
from app.client.terminal import shown

WAIT_S = 600
CHANGE_CREATED = re.compile(r"^Change (\d+) created", re.MULTILINE)
NOT_ON_CLIENT = re.compile(r"^(.*) - file\(s\) not on client\.?$", re.MULTILINE)
PERFORCE_SIGNS = {"%": "%25", "@": "%40", "#": "%23", "*": "%2A"}  # in file arguments; the percent sign first


def program(name: str) -> str:
    """Return the absolute path of a program on PATH, never one of the working directory; raise Refusal without it."""
    folders = [folder for folder in os.environ.get("PATH", os.defpath).split(os.pathsep) if os.path.isabs(folder)]
    os.environ["NoDefaultCurrentDirectoryInExePath"] = "1"  # noqa: SIM112 - Windows spells it so
    path = shutil.which(name, path=os.pathsep.join(folders))
    if path is None or not os.path.isabs(path):
        raise Refusal(f"{name} is not on PATH; install it, or leave its option out. Nothing was written")
    return path


def _run(command: Sequence[str], folder: Path, *, given: str = "") -> tuple[str, str]:
    """Return the output of a command; raise Refusal where it fails."""
    try:
        done = subprocess.run(
            list(command), cwd=folder, input=given, capture_output=True, text=True, timeout=WAIT_S, check=False
        )
    except (OSError, subprocess.TimeoutExpired, UnicodeDecodeError) as error:
        raise Refusal(f"{' '.join(command[:2])}: {error}") from None
    if done.returncode != 0:
        output = shown(
            (done.stderr.strip() or done.stdout.strip() or f"it ended with {done.returncode}").splitlines()[0]
        )
        raise Refusal(f"{Path(command[0]).name} {command[1] if len(command) > 1 else ''}: {output}")
    return done.stdout, done.stderr


class Perforce:
    """Files of a Perforce client, opened in the default changelist or in a new one."""

    def __init__(self, folder: Path) -> None:
        self._p4, self._folder = program("p4"), folder
        self.change: str | None = None

    def new_change(self, description: str) -> str:
        """Make a changelist with a description; return its number."""
        lines = "".join(f"\t{line}\n" for line in description.splitlines())
        output, _ = _run([self._p4, "change", "-i"], self._folder, given=f"Change:\tnew\n\nDescription:\n{lines}")
        match = CHANGE_CREATED.search(output)
        if match is None:
            raise Refusal(f"p4 change: made no changelist: {shown(output.strip())}")
        self.change = match[1]
        return self.change

    def edit(self, paths: Sequence[Path]) -> list[Path]:
        """Open files for edit; return those that the client does not have, which are to be added."""
        if not paths:
            return []
        output = "\n".join(self._over("edit", paths))
        unknown = set(NOT_ON_CLIENT.findall(output))
        return [path for path in paths if {str(path), _escaped(path)} & unknown]

    def add(self, paths: Sequence[Path]) -> None:
        """Open files for add, under names that may have signs of Perforce."""
        if paths:
            self._over("add", paths, "-f", escaped=False)

    def delete(self, paths: Sequence[Path]) -> None:
        """Open files for delete, which removes them."""
        if paths:
            self._over("delete", paths)

    def _over(self, verb: str, paths: Sequence[Path], *options: str, escaped: bool = True) -> tuple[str, str]:
        """Run a command over files named on its standard input, one a line."""
        of_change = ["-c", self.change] if self.change else []
        names = "".join(f"{_escaped(path) if escaped else path}\n" for path in paths)
        return _run([self._p4, "-x", "-", verb, *of_change, *options], self._folder, given=names)


def _escaped(path: Path) -> str:
    text = str(path)
    for sign, code in PERFORCE_SIGNS.items():
        text = text.replace(sign, code)
    return text


class LfsLocks:
    """Locks of Git LFS, which others see before they change the same file."""

    def __init__(self, folder: Path) -> None:
        self._git, self._folder = program("git"), folder
        program("git-lfs")  # which git starts for `git lfs`

    def lock(self, paths: Sequence[Path]) -> None:
        """Lock files; raise Refusal with the first that another person holds."""
        for path in paths:
            _run([self._git, "lfs", "lock", "--", str(path.relative_to(self._folder))], self._folder)
