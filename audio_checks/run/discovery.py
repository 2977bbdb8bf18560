"""Finds the files that paths mean, and the spec that each of them stands under."""

import os
import stat
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import DeliverySpec, load_spec
from audio_checks.spec.files import has_spec
from audio_checks.spec.sound_list import SoundList
from audio_checks.spec.sound_names import AUDIO_SUFFIXES, dry_stem_name, stem_of_file
from audio_checks.system.windows import reachable, unlimited

SPEC_NAMES = ("audio-checks.toml", "pyproject.toml")


@dataclass(frozen=True)
class Found:
    """A file to look at, and its place below the path that was given."""

    path: str
    relative: str


class PathNotFound(Exception):
    """A path that was given, or a folder below it, that cannot be looked into."""


def audio_files(paths: Iterable[str], unvisited: list[str] | None = None) -> Iterator[Found]:
    """Yield every file that the paths mean, each once, folders in the order of their names.

    A file that is named is taken whatever its ending; in folders, those with the ending of an audio
    format are taken, and hidden ones are not. Links to folders are followed after everything else,
    each folder once, so that a circle of links ends.

    Parameters
    ----------
    paths : iterable of str
        Files and folders.
    unvisited : list of str, optional
        Receives a sentence about each folder below the paths that was not looked into: a link to a
        folder that holds the link itself, a link that leads nowhere, a Git submodule that is not checked out.

    Raises
    ------
    PathNotFound
        A path does not exist, or a folder cannot be listed.
    """
    seen: set[str] = set()
    walk = _Walk([] if unvisited is None else unvisited)
    for file in walk.files(paths):
        key = os.path.normpath(file.path)
        if key not in seen:
            seen.add(key)
            yield file


class _Walk:
    """One walk over paths: the folders that it has been in, and the links that it has yet to follow."""

    def __init__(self, unvisited: list[str]) -> None:
        self._unvisited = unvisited
        self._visited: set[tuple[int, int]] = set()
        self._links: deque[tuple[str, str, str]] = deque()  # the path given, the link below it, the folder that has it

    def files(self, paths: Iterable[str]) -> Iterator[Found]:
        for path in paths:
            try:
                is_folder = stat.S_ISDIR(os.stat(reachable(path)).st_mode)
            except (OSError, ValueError) as error:
                if not (isinstance(error, OSError) and os.path.lexists(path)):
                    raise PathNotFound(f"{path}: no such file or folder") from None
                is_folder = False  # a link that leads nowhere, or a file out of reach: the check says so
            if is_folder:
                yield from self._below(path, "", again=True)
            else:
                yield Found(path, os.path.basename(path))
        while self._links:
            path, link, holder = self._links.popleft()
            target = os.path.realpath(os.path.join(path, link))
            if os.path.join(holder, "").startswith(os.path.join(target, "")):
                if _identity(target) not in self._visited:
                    self._unvisited.append(f"{os.path.join(path, link)}: not followed: it links to a folder above it")
            elif _identity(target) not in self._visited:
                yield from self._below(path, link, again=False)

    def _below(self, path: str, link: str, *, again: bool) -> Iterator[Found]:
        """Yield the files below a path that was given, or below a link there.

        With `again`, folders count that were visited before under another of the given paths.
        """
        top = os.path.join(unlimited(path), link) if link else unlimited(path)
        for folder, folders, names in os.walk(top, onerror=_refuse):
            self._visited.add(_identity(folder))
            below = os.path.normpath(os.path.join(link, os.path.relpath(folder, top))) if folder != top else link
            if not (folders or names) and is_absent_submodule(folder):
                submodule_path = os.path.join(path, below)
                self._unvisited.append(f"{submodule_path}: not checked out: git submodule update --init --recursive")
            folders[:] = sorted(folder_name for folder_name in folders if not folder_name.startswith("."))
            linked = [folder_name for folder_name in folders if _is_link(os.path.join(folder, folder_name))]
            if linked:
                holder = os.path.realpath(folder)
                self._links += ((path, os.path.join(below, folder_name), holder) for folder_name in linked)
                folders[:] = [folder_name for folder_name in folders if folder_name not in linked]
            if not again:
                folders[:] = [
                    folder_name
                    for folder_name in folders
                    if _identity(os.path.join(folder, folder_name)) not in self._visited
                ]
            for name in sorted(names):
                if name.startswith("."):
                    continue
                suffix = os.path.splitext(name)[1].lower()
                if suffix in AUDIO_SUFFIXES:
                    relative = os.path.join(below, name)
                    yield Found(os.path.join(path, relative), relative)
                elif not suffix and not os.path.exists(os.path.join(folder, name)):
                    self._unvisited.append(f"{os.path.join(path, below, name)}: a link that leads nowhere")


def _identity(folder: str) -> tuple[int, int]:
    """Return the mark that tells a folder from every other, whatever path leads to it."""
    try:
        at = os.stat(folder)
    except OSError as error:
        raise PathNotFound(f"{error.filename}: the folder cannot be looked into: {error.strerror}") from None
    return at.st_dev, at.st_ino


def _is_link(folder: str) -> bool:
    """Return whether a folder is a link, or on Windows a junction."""
    is_junction = getattr(os.path, "isjunction", None)  # since Python 3.12; os.walk passes them over from then on
    return os.path.islink(folder) or (is_junction is not None and is_junction(folder))


def is_absent_submodule(folder: str) -> bool:
    """Return whether an empty folder is the place of a Git submodule, as `.gitmodules` above it says."""
    path = Path(folder).absolute()
    for above in path.parents:
        try:
            text = (above / ".gitmodules").read_text(encoding="utf-8", errors="surrogateescape")
        except OSError:
            continue
        places = (line.partition("=") for line in text.splitlines())
        return any(
            key.strip() == "path" and above / submodule.strip().strip('"') == path for key, _, submodule in places
        )
    return False


def _refuse(error: OSError) -> None:
    raise PathNotFound(f"{error.filename}: the folder cannot be listed: {error.strerror}")


def dry_stems(paths: Iterable[str], sound_list: SoundList | None = None) -> dict[str, str]:
    """Return the dry stem of each file that has one among the paths: `x__dry.wav` in the folder of `x.wav`.

    A name that a cue of the list owns whole is that cue's, and no stem.
    """
    stems: dict[tuple[str, str], str] = {}
    sounds: list[tuple[tuple[str, str], str]] = []
    for path in paths:
        folder, name = os.path.split(path)
        stem_of = dry_stem_name(name)
        if stem_of is None or (sound_list is not None and sound_list.slot(stem_of_file(name)) is not None):
            sounds.append(((folder, stem_of_file(name)), path))
        else:
            stems[folder, stem_of] = path
    return {path: stems[index] for index, path in sounds if index in stems}


def without_dry_stems(found: Sequence[Found], sound_list: SoundList | None = None) -> list[Found]:
    """Return the files that are not a dry stem of another one; see `dry_stems`."""
    stems = frozenset(dry_stems((file.path for file in found), sound_list).values())
    return [file for file in found if file.path not in stems]


class SpecFinder:
    """Finds the spec of a file: the given one, or the nearest, walking up from the file.

    The nearest is an audio-checks.toml, or a pyproject.toml with a table for it. A file below none
    is judged by the one that is nearest to the working directory.
    """

    def __init__(self, named: str | None = None) -> None:
        self._files: dict[int, Path] = {}
        self._named = self._load(Path(named)) if named else None
        self._by_folder: dict[Path, DeliverySpec | None] = {}

    def spec_of(self, path: str) -> DeliverySpec | None:
        """Return the spec of a file; None where there is one neither above it nor above the working directory."""
        return self._named or self._in(Path(path).absolute().parent) or self._in(Path.cwd())

    def file_of(self, spec: DeliverySpec) -> Path:
        """Return the file that a spec was read from, by this finder."""
        return self._files[id(spec)]

    def _load(self, path: Path) -> DeliverySpec:
        spec = load_spec(path)
        self._files[id(spec)] = path
        return spec

    def _in(self, folder: Path) -> DeliverySpec | None:
        if folder not in self._by_folder:
            self._by_folder[folder] = self._look(folder)
        return self._by_folder[folder]

    def _look(self, folder: Path) -> DeliverySpec | None:
        for name in SPEC_NAMES:
            path = folder / name
            if name == SPEC_NAMES[0] and os.path.lexists(path):  # a link to no file is refused in words
                return self._load(path)
            if path.is_file() and _is_ours(path):
                return self._load(path)
        return None if folder.parent == folder else self._in(folder.parent)


def _is_ours(path: Path) -> bool:
    try:
        return has_spec(path)
    except SpecError:
        return False  # another project's broken pyproject.toml
