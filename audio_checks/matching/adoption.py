"""Adoption of a folder of shipped files: cues with categories and sets, and the files' oddities.

The names stay: a cue is named after its file, and another name is given only where a list cannot hold the file's own.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from audio_checks.matching.played_files import PlayedFile, played_files, set_name
from audio_checks.middleware.by_path import NOT_PLAYED
from audio_checks.middleware.values import Project
from audio_checks.spec.sound_names import AUDIO_SUFFIXES, dry_stem_name, slug, stem_of_file, stems_of

ADOPTED_SUFFIXES = frozenset({".wav", ".wave", ".bwf", ".flac", ".ogg", ".oga", ".opus", ".mp3"})
MOST_VARIATIONS = 99
MOST_CHARS = 160  # of a file name, so that folders before it and numbers behind it still fit into 200
CATEGORY_CHARS = 60
SHARED_PREFIX_FILES = 3  # that begin with one word, so that it names a category
ODD_SHARE = 0.1  # a rate or depth that fewer of the files have is an odd one

SkipCode = Literal["coded", "no-sound", "dry-stem", "name", "listed"]
OddityCode = Literal["renamed", "numbering", "format", "unused"]

_FORBIDDEN = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]')
_DEVICE = re.compile(r"(con|prn|aux|nul|com[0-9]|lpt[0-9])(\..*)?", re.IGNORECASE)
_NUMBERED = re.compile(r"(.*[^ _.\-])[ _.\-]+([0-9]{1,4})")


class ShippedFile(NamedTuple):
    """A file of the folder.

    Attributes
    ----------
    path : str
        Relative to the folder, with slashes.
    sha256 : str
        Of its bytes.
    sample_rate_hz, bit_depth : int or None
        As its header says; None where that was not read.
    """

    path: str
    sha256: str
    sample_rate_hz: int | None = None
    bit_depth: int | None = None


@dataclass(frozen=True)
class AdoptedCue:
    """A cue to add, and its files in the order of the variations.

    Attributes
    ----------
    name, file_name, category : str
        As the list is to have them; the category may be empty.
    paths : tuple of str
        One for a single file, one for each variation of a set.
    loop : bool
        Whether the game's project plays each of them in a loop.
    events : tuple of str
        What begins them in the project.
    """

    name: str
    file_name: str
    category: str
    paths: tuple[str, ...]
    loop: bool = False
    events: tuple[str, ...] = ()


class Oddity(NamedTuple):
    """A file that is adopted and unusual, and why."""

    path: str
    code: OddityCode
    message: str


class SkippedFile(NamedTuple):
    """A file that is not adopted, and why."""

    path: str
    code: SkipCode
    message: str


@dataclass(frozen=True)
class AdoptionPlan:
    """The effects of adopting a folder.

    Attributes
    ----------
    cues : tuple of AdoptedCue
        By path.
    duplicates : tuple of tuple of str
        Paths of adopted files that have the same bytes.
    oddities : tuple of Oddity
        Adopted files with another name or format than expected.
    skipped : tuple of SkippedFile
        Files that become nothing.
    """

    cues: tuple[AdoptedCue, ...]
    duplicates: tuple[tuple[str, ...], ...]
    oddities: tuple[Oddity, ...]
    skipped: tuple[SkippedFile, ...]


class _Named(NamedTuple):
    file: ShippedFile
    folders: tuple[str, ...]
    stem: str  # its own
    name: str  # that a list can hold


def plan_adoption(
    files: Iterable[ShippedFile],
    *,
    owned: Mapping[str, str] | None = None,
    categories: Collection[str] = (),
    project: Project | None = None,
) -> AdoptionPlan:
    """Return the plan for a folder of shipped files; the same for the same files in any order.

    Parameters
    ----------
    files : iterable of ShippedFile
        Paths are unique.
    owned : mapping of str to str
        The folded stems that the list has already, each with the label of its cue; see `folded_stem`.
    categories : collection of str
        Those that the spec names: a folder that is called like one of them says the category before others do.
    project : Project, optional
        The game's: its random containers are sets, its tree says categories before folders do, and a file that it does
        not play is named.
    """
    owned = owned or {}
    skipped: list[SkippedFile] = []
    oddities: list[Oddity] = []
    named = list(_named(sorted(files), skipped))
    played = played_files(project, [named_file.file.path for named_file in named]) if project else {}
    taken: dict[str, str] = {}  # by folded stem: the path that has it
    kept: list[tuple[str, list[_Named]]] = []
    for file_name, group in _grouped(named, played, oddities):
        listed = next((owned[key] for key in _keys(file_name, group) if key in owned), None)
        if listed is not None:
            why = f"{listed} has this name already; deliver the file for that cue"
            skipped += [SkippedFile(named_file.file.path, "listed", why) for named_file in group]
            continue
        free = _free_name(file_name, group, owned, taken)
        taken |= dict.fromkeys(_keys(free, group), group[0].file.path)
        oddities += _renamed(free, group)
        kept.append((free, group))
    cues = _with_categories(kept, played, {_category(category): category for category in categories})
    adopted = [named_file.file for _, group in kept for named_file in group]
    oddities += _odd_formats(adopted)
    if project is not None:
        oddities += _unused(adopted, played, NOT_PLAYED[project.engine])
    return AdoptionPlan(cues, _duplicates(adopted), tuple(sorted(oddities)), tuple(sorted(skipped)))


def folded_stem(stem: str) -> str:
    """Return the one key of two stems that some disks cannot hold side by side: case and composition do not count."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", stem).casefold())


def _named(files: Sequence[ShippedFile], skipped: list[SkippedFile]) -> Iterator[_Named]:
    for file in files:
        *folders, whole = re.split(r"[/\\]", file.path)
        stem = stem_of_file(whole)
        suffix = unicodedata.normalize("NFC", whole)[len(stem) :].lower()
        name = _possible_name(stem)
        if suffix not in AUDIO_SUFFIXES:
            skipped.append(SkippedFile(file.path, "no-sound", "its ending is not that of a sound file"))
        elif suffix not in ADOPTED_SUFFIXES:
            why = f"WAV, FLAC, Ogg, Opus and MP3 are adopted, found {suffix[1:]}; adopt the file that it was made from"
            skipped.append(SkippedFile(file.path, "coded", why))
        elif dry_stem_name(whole) is not None:
            why = "its name says that it is a dry stem; deliver it beside the sound that it is for"
            skipped.append(SkippedFile(file.path, "dry-stem", why))
        elif not name:
            why = "its name has no letter or digit; rename it"
            skipped.append(SkippedFile(file.path, "name", why))
        else:
            yield _Named(file, tuple(folder for folder in folders if folder not in ("", ".", "..")), stem, name)


def _possible_name(stem: str) -> str:
    """Return a stem as a list can hold it; empty where it has no letter or digit."""
    name = re.sub(r"\s+", " ", _FORBIDDEN.sub("_", stem)).strip()[:MOST_CHARS]
    name = name.lstrip("=+-@'.~ ").rstrip(". ")
    if name.lower().endswith(tuple(AUDIO_SUFFIXES)):  # the list would take it for the ending
        name = "_".join(name.rsplit(".", 1)).strip()
    if not any(character.isalnum() for character in name):
        return ""
    return f"{name}_" if _DEVICE.fullmatch(name) else name


def _grouped(
    named: Sequence[_Named], played: Mapping[str, PlayedFile], oddities: list[Oddity]
) -> list[tuple[str, list[_Named]]]:
    """Return files by cue: those of one random container are a set, then numbered ones as their names say."""
    sets = list(_random_sets(named, played))
    in_sets = {file.file.path for _, files in sets for file in files}
    by_name = _by_name([named_file for named_file in named if named_file.file.path not in in_sets], oddities)
    return sorted([*sets, *by_name], key=lambda group: group[1][0].file.path)


def _random_sets(named: Sequence[_Named], played: Mapping[str, PlayedFile]) -> Iterator[tuple[str, list[_Named]]]:
    """Yield each random container with the files that it plays, under the name that they share, else its own."""
    held: dict[str, list[_Named]] = defaultdict(list)
    for named_file in named:
        if (by := played.get(named_file.file.path)) is not None and by.random_set:
            held[by.random_set].append(named_file)
    for random_set, files in held.items():
        numbers = [match for file in files if (match := _NUMBERED.fullmatch(file.name)) is not None]
        bases = {number[1] for number in numbers}
        base, in_order = "", files
        if len(numbers) == len(files) and len(bases) == 1:
            base = bases.pop()
            in_order = [files[index] for index in sorted(range(len(files)), key=lambda at: int(numbers[at][2]))]
        name = _possible_name(base) or _possible_name(set_name(random_set))
        if 2 <= len(files) <= MOST_VARIATIONS and name:
            yield name, in_order


def _by_name(named: Sequence[_Named], oddities: list[Oddity]) -> list[tuple[str, list[_Named]]]:
    """Return files by cue: numbered ones of one folder and name that count from 1 without a gap are one set."""
    numbered: dict[tuple[tuple[str, ...], str], dict[int, list[_Named]]] = defaultdict(lambda: defaultdict(list))
    for named_file in named:
        if (match := _NUMBERED.fullmatch(named_file.name)) is not None:
            numbered[named_file.folders, match[1]][int(match[2])].append(named_file)
    groups: list[tuple[str, list[_Named]]] = []
    in_sets: set[str] = set()
    for (_, base), places in numbered.items():
        files = [file for number in sorted(places) for file in places[number]]
        if len(files) == 1:
            continue
        if sorted(places) == list(range(1, len(files) + 1)) and len(files) <= MOST_VARIATIONS and _possible_name(base):
            groups.append((_possible_name(base), files))
            in_sets.update(file.file.path for file in files)
        else:
            shown = ", ".join(str(number) for number in sorted(places)[:8])
            why = f"numbers {shown} of {base} found; a set counts 1, 2, 3 without a gap, so each file is its own cue"
            oddities += [Oddity(file.file.path, "numbering", why) for file in files]
    return [*groups, *((named_file.name, [named_file]) for named_file in named if named_file.file.path not in in_sets)]


def _keys(file_name: str, group: Sequence[_Named]) -> list[str]:
    return [folded_stem(stem) for stem in stems_of("", file_name, len(group))]


def _free_name(file_name: str, group: Sequence[_Named], owned: Mapping[str, str], taken: Mapping[str, str]) -> str:
    """Return a name that nobody has: with the folders before it, and at last with a letter behind it."""
    free = file_name
    folders = [word for folder in reversed(group[0].folders) if (word := slug(folder)[:20])]
    count = 0
    while any(key in taken or key in owned for key in _keys(free, group)):
        if folders and len(free) < MOST_CHARS:
            free = f"{folders.pop(0)}_{free}"
        else:
            count += 1
            free = f"{file_name}_other{count if count > 1 else ''}"
    return free


def _renamed(file_name: str, group: Sequence[_Named]) -> Iterator[Oddity]:
    for named_file, stem in zip(group, stems_of("", file_name, len(group)), strict=True):
        if unicodedata.normalize("NFC", named_file.stem) != stem:
            yield Oddity(named_file.file.path, "renamed", f"its name in the list is {stem}")


def _with_categories(
    kept: Sequence[tuple[str, list[_Named]]], played: Mapping[str, PlayedFile], known: Mapping[str, str]
) -> tuple[AdoptedCue, ...]:
    of_group = [
        [by for named_file in group if (by := played.get(named_file.file.path)) is not None] for _, group in kept
    ]
    trees = [next((by.containers for by in plays if by.containers), ()) for plays in of_group]
    own_folders = [group[0].folders for _, group in kept]
    shared = _shared_folders([parents for parents, tree in zip(own_folders, trees, strict=True) if not tree])
    shared_of_tree = _shared_folders([tree for tree in trees if tree])
    words = [_first_word(name) for name, _ in kept]
    counts = Counter(words)
    cues = []
    for (file_name, group), word, tree, plays in zip(kept, words, trees, of_group, strict=True):
        folders = [_category(folder) for folder in tree or group[0].folders]
        own_levels = [folder for folder in folders[shared_of_tree if tree else shared :] if folder]
        category = next((known[folder] for folder in folders if folder in known), own_levels[0] if own_levels else "")
        if not category and word and counts[word] >= SHARED_PREFIX_FILES:
            category = word
        name = re.sub(r"[\s_.\-]+", " ", file_name).strip() or file_name
        loop = len(plays) == len(group) and all(by.is_looped for by in plays)
        events = tuple(dict.fromkeys(event for by in plays for event in by.events))
        cues.append(
            AdoptedCue(name, file_name, category, tuple(named_file.file.path for named_file in group), loop, events)
        )
    return tuple(cues)


def _shared_folders(folders: Sequence[tuple[str, ...]]) -> int:
    """Return the count of outermost folders that all files are in."""
    if not folders:
        return 0
    first, last = min(folders), max(folders)
    return next((at for at, pair in enumerate(zip(first, last, strict=False)) if pair[0] != pair[1]), len(first))


def _first_word(file_name: str) -> str:
    word, separator, _ = re.match(r"([^\W\d_]*)([ _.\-]?)(.*)", file_name, re.DOTALL).groups()  # type: ignore[union-attr]  # matches any text
    return _category(word) if separator else ""


def _category(folder: str) -> str:
    """Return a folder's name as a category: lower-case letters, digits and dashes."""
    words = re.findall(r"[^\W_]+", unicodedata.normalize("NFC", folder).lower())
    return "-".join(words)[:CATEGORY_CHARS].rstrip("-")


def _duplicates(files: Sequence[ShippedFile]) -> tuple[tuple[str, ...], ...]:
    same: dict[str, list[str]] = defaultdict(list)
    for file in files:
        same[file.sha256].append(file.path)
    return tuple(sorted(tuple(sorted(paths)) for paths in same.values() if len(paths) > 1))


def _unused(files: Sequence[ShippedFile], played: Mapping[str, PlayedFile], why: str) -> Iterator[Oddity]:
    for file in files:
        if file.path not in played or played[file.path].is_used is False:
            yield Oddity(file.path, "unused", f"{why} in the project")


def _odd_formats(files: Sequence[ShippedFile]) -> Iterator[Oddity]:
    for fact, unit in (("sample_rate_hz", "Hz"), ("bit_depth", "bit")):
        counts = Counter(value for file in files if (value := getattr(file, fact)) is not None)
        if not counts:
            continue
        usual, _ = counts.most_common(1)[0]
        for file in files:
            value = getattr(file, fact)
            if value is not None and counts[value] < ODD_SHARE * counts.total():
                yield Oddity(file.path, "format", f"{value} {unit}, most files have {usual} {unit}")
