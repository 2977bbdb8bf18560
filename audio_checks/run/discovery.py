"""Finds the files that paths mean, and the spec that each of them stands under."""

import os
import stat
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import DeliverySpec, load_spec
from audio_checks.spec.files import has_spec
from audio_checks.spec.sound_list import AUDIO_SUFFIXES, SoundList, dry_stem_name, stem_of_file
from audio_checks.system.windows import reachable, unlimited

SPEC_NAMES = ("audio-checks.toml", "pyproject.toml")


@dataclass(frozen=True)
class Found:
    """A file to look at, and its place below the path that was given."""

    path: str
    relative: str


class PathNotFound(Exception):
    """A path that was given, or a folder below it, that cannot be looked into."""


def audio_files(paths: Iterable[str]) -> Iterator[Found]:
    """Yield every file that the paths mean, each once, folders in the order of their names.

    A file that is named is taken whatever its ending; in folders, those with the ending of an audio
    format are taken, hidden ones are not, and links to folders are not followed.

    Raises
    ------
    PathNotFound
        A path does not exist, or a folder cannot be listed.
    """
    seen: set[str] = set()
    for path in paths:
        for found in _below(path):
            key = os.path.normpath(found.path)
            if key not in seen:
                seen.add(key)
                yield found


def _below(path: str) -> Iterator[Found]:
    try:
        is_folder = stat.S_ISDIR(os.stat(reachable(path)).st_mode)
    except (OSError, ValueError) as error:
        if not (isinstance(error, OSError) and os.path.lexists(path)):
            raise PathNotFound(f"{path}: no such file or folder") from None
        is_folder = False  # a link that leads nowhere, or a file out of reach: the check says so
    if not is_folder:
        yield Found(path, os.path.basename(path))
        return
    start = unlimited(path)
    for folder, folders, names in os.walk(start, onerror=_refuse):
        folders[:] = sorted(one for one in folders if not one.startswith("."))
        below = "" if folder == start else os.path.relpath(folder, start)
        for name in sorted(names):
            if not name.startswith(".") and os.path.splitext(name)[1].lower() in AUDIO_SUFFIXES:
                relative = os.path.join(below, name)
                yield Found(os.path.join(path, relative), relative)


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
    return {path: stems[place] for place, path in sounds if place in stems}


def without_dry_stems(found: Sequence[Found], sound_list: SoundList | None = None) -> list[Found]:
    """Return the files that are not a dry stem of another one; see `dry_stems`."""
    stems = frozenset(dry_stems((one.path for one in found), sound_list).values())
    return [one for one in found if one.path not in stems]


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
