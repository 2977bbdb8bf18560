"""Which files a change touches, as Git knows it: what differs from where a branch left off, and what is new."""

import os
import subprocess
from collections.abc import Iterable
from pathlib import Path

from audio_checks.errors import AudioChecksError
from audio_checks.system.isolation import installed_program
from audio_checks.system.text_files import read_text, read_toml

ENVIRONMENT = {"GIT_OPTIONAL_LOCKS": "0", "LC_ALL": "C"}  # only looking: nothing of the repository is written
# A judged tree may hold a folder that looks like a bare repository, whose configuration names programs to run.
SAFELY = ("-c", "safe.bareRepository=explicit", "-c", "core.fsmonitor=false", "-c", "core.hooksPath=/dev/null")


class NoHistory(AudioChecksError):
    """Git is not there, the files are in no repository, or it knows no such commit."""


class Changes:
    """The files that differ between a commit and the working tree, in every repository that is asked about.

    Parameters
    ----------
    ref : str
        A branch, tag or commit. A change begins where it left off from it: what others did there
        meanwhile is not part of it.
    """

    def __init__(self, ref: str) -> None:
        self._ref = ref
        self._root_of: dict[str, str] = {}
        self._touched: dict[str, frozenset[str]] = {}

    def touch(self, path: str | os.PathLike[str]) -> bool:
        """Return whether the change touches a file; NoHistory if that cannot be known."""
        folder, name = os.path.split(os.path.abspath(path))
        folder = os.path.realpath(folder)  # as Git calls it; the file itself may be a link, and is meant as one
        root = self._root(folder)
        if root not in self._touched:
            self._touched[root] = frozenset(self._differing(root))
        return os.path.normcase(os.path.join(folder, name)) in self._touched[root]

    def _root(self, folder: str) -> str:
        if folder not in self._root_of:
            said = _git(folder, "rev-parse", "--show-toplevel")
            if said is None:
                raise NoHistory(f"{folder}: in no Git repository, so what has changed is not known")
            self._root_of[folder] = os.path.realpath(os.fsdecode(said.rstrip(b"\n")))
        return self._root_of[folder]

    def _differing(self, root: str) -> Iterable[str]:
        commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{self._ref}^{{commit}}")
        if commit is None:
            raise NoHistory(
                f'no commit "{self._ref}" in {root}; a CI that clones only the newest commit must fetch it first'
            )
        commit_id = commit.decode().strip()
        left_off = _git(root, "merge-base", commit_id, "HEAD")
        since = left_off.decode().split()[0] if left_off else commit_id
        changed = _git(root, "diff", "--name-only", "--no-renames", "--diff-filter=d", "-z", since, "--")
        new = _git(root, "ls-files", "--others", "--exclude-standard", "-z")
        if changed is None or new is None:
            raise NoHistory(f"{root}: Git could not compare the working tree with {self._ref}")
        for name in (changed + new).split(b"\0"):
            if name:
                yield os.path.normcase(os.path.join(root, os.fsdecode(name)))


def spec_files(path: Path) -> list[Path]:
    """Return a spec's file, and those that it extends, one after the other."""
    files = [path]
    while (base := _extended_by(files[-1])) is not None and base not in files:
        files.append(base)
    return files


def _extended_by(path: Path) -> Path | None:
    document = read_toml(read_text(path), str(path))
    table = document.get("tool", {}).get("audio-checks", {}) if path.name == "pyproject.toml" else document
    return path.parent / table["extend"] if "extend" in table else None


def _git(folder: str, *arguments: str) -> bytes | None:
    """Return what Git says in a folder; None when it refuses."""
    git = installed_program("git")
    if git is None:
        raise NoHistory("git is not installed, so what has changed is not known")
    command = [git, *SAFELY, "-C", folder, "--no-pager", *arguments]
    done = subprocess.run(
        command, capture_output=True, check=False, stdin=subprocess.DEVNULL, env={**os.environ, **ENVIRONMENT}
    )
    return done.stdout if done.returncode == 0 else None
