"""Files that a change touches, as Git knows it: differences from the branching point, and new ones."""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from audio_checks.errors import AudioChecksError
from audio_checks.system.isolation import installed_program
from audio_checks.system.text_files import read_text, read_toml

# Only looking: nothing of the repository is written.
ENVIRONMENT = {"GIT_OPTIONAL_LOCKS": "0", "LC_ALL": "C"}
# A hook of Git names one repository to the programs that it starts; submodules are others.
OF_ONE_REPOSITORY = frozenset({"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_COMMON_DIR"})
# A judged tree may hold a folder that looks like a bare repository, whose configuration names programs to run.
SAFELY = ("-c", "safe.bareRepository=explicit", "-c", "core.fsmonitor=false", "-c", "core.hooksPath=/dev/null")
MOST_LINKS = 40  # of one path, as systems allow
SUBMODULE = b"160000"  # the mode under which a tree of Git records the commit of a submodule


class NoHistory(AudioChecksError):
    """Git is not there, the files are in no repository, or it knows no such commit."""


class Changes:
    """The files that differ between a commit and the working tree, in every repository that is asked about.

    Parameters
    ----------
    ref : str
        A branch, tag or commit. A change begins where it left off from it: what others did there
        meanwhile is not part of it.

    Attributes
    ----------
    notes : list of str
        What was taken for changed because it could not be known, in the order in which that was noticed.

    Notes
    -----
    `ref` belongs to the repository of the working directory. A submodule of it changed where it differs
    from the commit that the repository recorded for it when the change began. A file that is reached by
    links changed when it, or one of the links, did.
    """

    def __init__(self, ref: str) -> None:
        self._ref = ref
        self._base = _root_of(os.getcwd())
        self._roots: dict[str, str | None] = {}
        self._links: dict[str, list[str]] = {}
        self._beginnings: dict[str, str | None] = {}
        self._touched: dict[str, frozenset[str] | None] = {}
        self.notes: list[str] = []

    def touch(self, path: str | os.PathLike[str]) -> bool:
        """Return whether the change touches a file; NoHistory if that cannot be known."""
        absolute_path = os.path.abspath(path)
        links = [link for link in self._links_on(absolute_path) if self._is_of_the_change(link)]
        if any(self._touches(link) for link in links):
            return True
        target = os.path.realpath(absolute_path)
        if links and ".git" in target.split(os.sep):
            return False  # as git-annex keeps files: by their content, so another one is another link
        if links and self._root(os.path.dirname(target)) is None:
            self._note(f"{links[0]} leads to files of no Git repository, so they are judged as if they were new")
            return True
        return self._touches(target)

    def knows(self, path: str | os.PathLike[str]) -> bool:
        """Return whether a file is in a repository at all."""
        return self._root(os.path.dirname(os.path.realpath(path))) is not None

    def absent_submodules(self, paths: Iterable[str]) -> list[str]:
        """Return the submodules below the paths that the change moved, and that are not checked out."""
        absent: dict[str, None] = {}
        for path in paths:
            real_path = os.path.realpath(path)
            root = self._root(real_path if os.path.isdir(real_path) else os.path.dirname(real_path))
            for folder, touched in self._submodules(root) if root is not None else ():
                if touched and _is_within(folder, real_path) and not _is_checked_out(folder):
                    absent[folder] = None
        return list(absent)

    def _submodules(self, root: str) -> Iterator[tuple[str, bool]]:
        """Yield the submodules of a repository, and theirs, with whether the change moved them."""
        for line in (_git(root, "ls-files", "--stage", "-z") or b"").split(b"\0"):
            mode, _, name = line.partition(b"\t")
            if mode.startswith(SUBMODULE):
                folder = os.path.join(root, os.fsdecode(name))
                yield folder, self._touches(folder)
                if _is_checked_out(folder):
                    yield from self._submodules(folder)

    def _is_of_the_change(self, link: str) -> bool:
        root = self._root(os.path.dirname(link))
        return root is not None and (self._base is None or _is_within(root, self._base))

    def _links_on(self, path: str) -> list[str]:
        """Return the links on an absolute path, and those that they lead to."""
        folder = os.path.dirname(path)
        if folder not in self._links:
            self._links[folder] = _links_on(folder)
        return [*(_links_on(path, folder) if os.path.islink(path) else ()), *self._links[folder]]

    def _touches(self, path: str) -> bool:
        folder, name = os.path.split(path)
        folder = os.path.realpath(folder)  # as Git calls it
        root = self._root(folder)
        if root is None:
            raise NoHistory(f"{folder}: in no Git repository, so what has changed is not known")
        touched = self._touched_in(root)
        return touched is None or os.path.normcase(os.path.join(folder, name)) in touched

    def _root(self, folder: str) -> str | None:
        if folder not in self._roots:
            self._roots[folder] = _root_of(folder)
        return self._roots[folder]

    def _touched_in(self, root: str) -> frozenset[str] | None:
        """Return the files of a repository that the change touches; None for all of them."""
        if root not in self._touched:
            since = self._beginning(root)
            self._touched[root] = None if since is None else frozenset(self._differing(root, since))
        return self._touched[root]

    def _beginning(self, root: str) -> str | None:
        """Return the commit of a repository from which on the change is looked for; None when all of it is new."""
        if root not in self._beginnings:
            self._beginnings[root] = self._find_beginning(root)
        return self._beginnings[root]

    def _find_beginning(self, root: str) -> str | None:
        above = None if root == self._base else self._root(os.path.dirname(root))
        if above is None:
            return self._left_off(root)
        name = os.path.relpath(root, above)
        if not (_git(above, "ls-files", "--stage", "-z", "--", name) or b"").startswith(SUBMODULE):
            if self._base is None or not _is_within(root, self._base):
                return self._left_off(root)
            self._note(f"{root}: a repository of its own and no submodule, so every file of it is judged")
            return None
        since = self._beginning(above)
        recorded = (_git(above, "ls-tree", "-z", since, "--", name) or b"") if since else b""
        if not recorded.startswith(SUBMODULE):
            return None  # the submodule is new
        commit = recorded.split(b"\t")[0].split()[-1].decode()
        if _git(root, "cat-file", "-e", f"{commit}^{{commit}}") is None:
            self._note(
                f"{root}: its earlier commit {commit[:12]} was not fetched, so every file of the submodule is judged"
            )
            return None
        return commit

    def _left_off(self, root: str) -> str:
        commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{self._ref}^{{commit}}")
        if commit is None:
            raise NoHistory(
                f'no commit "{self._ref}" in {root}; a CI that clones only the newest commit must fetch it first'
            )
        commit_id = commit.decode().strip()
        left_off = _git(root, "merge-base", commit_id, "HEAD")
        return left_off.decode().split()[0] if left_off else commit_id

    def _differing(self, root: str, since: str) -> Iterator[str]:
        # Settings and .gitmodules may hide submodules from a comparison; this option outranks them.
        compared = ("--no-renames", "--diff-filter=d", "--ignore-submodules=dirty", "--no-ext-diff", "-z")
        with _copy_of_index(root) as index:
            changed = _git(root, "diff", "--name-only", *compared, since, "--", index=index)
        new = _git(root, "ls-files", "--others", "--exclude-standard", "-z")
        if changed is None or new is None:
            raise NoHistory(f"{root}: Git could not compare the working tree with {self._ref}")
        for name in (changed + new).split(b"\0"):
            if name:
                yield os.path.normcase(os.path.join(root, os.fsdecode(name)))

    def _note(self, note: str) -> None:
        if note not in self.notes:
            self.notes.append(note)


def _root_of(folder: str) -> str | None:
    """Return the top folder of the repository that a folder is in; None where it is in none."""
    top = _git(folder, "rev-parse", "--show-toplevel")
    return None if top is None else os.path.realpath(os.fsdecode(top.rstrip(b"\n")))


def _links_on(link_path: str, below: str = "") -> list[str]:
    """Return the links on an absolute path, from its end upwards to a folder, and those that they lead to."""
    links: list[str] = []
    pending = [link_path]
    while pending and len(links) < MOST_LINKS:
        path = pending.pop()
        while path not in (below, os.path.dirname(path)):
            if os.path.islink(path) and path not in links:
                links.append(path)
                pending.append(os.path.normpath(os.path.join(os.path.dirname(path), os.readlink(path))))
            path = os.path.dirname(path)
    return links


def _is_within(path: str, folder: str) -> bool:
    return os.path.join(path, "").startswith(os.path.join(folder, ""))


def _is_checked_out(folder: str) -> bool:
    return os.path.lexists(os.path.join(folder, ".git"))


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


@contextmanager
def _copy_of_index(root: str) -> Iterator[str | None]:
    """Give a copy of a repository's index: `git diff` writes down there what it learned of the files' times.

    The copy keeps the time of the index, by which Git tells files that were written in the same moment.
    """
    index_path = _git(root, "rev-parse", "--git-path", "index")
    with tempfile.TemporaryDirectory(prefix="audio-checks-", ignore_cleanup_errors=True) as folder:
        try:
            copy = shutil.copy2(os.path.join(root, os.fsdecode((index_path or b"").rstrip(b"\n"))), folder)
        except OSError:
            copy = None  # nothing was ever added
        yield copy


def _git(folder: str, *arguments: str, index: str | None = None) -> bytes | None:
    """Return Git's answer in a folder; None when it refuses."""
    git = installed_program("git")
    if git is None:
        raise NoHistory("git is not installed, so what has changed is not known")
    command = [git, *SAFELY, "-C", folder, "--no-pager", "--literal-pathspecs", *arguments]
    environment = {name: value for name, value in os.environ.items() if name not in OF_ONE_REPOSITORY}
    if index is not None:
        environment["GIT_INDEX_FILE"] = index
    done = subprocess.run(
        command, capture_output=True, check=False, stdin=subprocess.DEVNULL, env={**environment, **ENVIRONMENT}
    )
    return done.stdout if done.returncode == 0 else None
