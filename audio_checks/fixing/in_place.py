"""Puts right in place what cannot harm the sound: names, sizes in headers, zero padding.

A file is either as it was or put right whole: a new header is written into a copy next to it, read
again by the strict reader, and moved over the old. Nothing is ever overwritten by a new name. What
a repair would have to guess, or whose samples it would change, is for `audio-checks fix`.
"""

import os
import secrets
import shutil
import stat
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from audio_checks.errors import AudioChecksError, Unreadable
from audio_checks.fixing.header import with_right_sizes
from audio_checks.fixing.names import valid_name
from audio_checks.matching.reading import key_of, plain, tokens_of
from audio_checks.report.findings import FileReport
from audio_checks.spec.format_suffixes import without_format_suffix
from audio_checks.spec.sound_list import SoundList
from audio_checks.spec.sound_names import parse_file_name, slug, stems_of

if TYPE_CHECKING:
    from audio_checks.run.runner import Task

SIZES = frozenset(
    {
        "structure:riff-size",
        "structure:stream-header",
        "structure:byte-rate",
        "structure:pad-byte",
        "structure:padding",
    }
)
NAMES = frozenset(
    f"naming:{rule}" for rule in ("pattern", "tokens", "ucs", "extension", "not-portable", "reserved", "unlisted")
)
COMPANION = ".meta"  # Unity stores a file's settings and identity next to it, under its name and this


class CannotFixInPlace(AudioChecksError):
    """A file that is left as it is, and why."""


@dataclass(frozen=True)
class Change:
    """The fixes in one file: its path before and after, and the changes to its header, in words."""

    path: str
    new_path: str
    header: tuple[str, ...] = ()


class Repairs:
    """One run of repairs; two files never get the same name.

    Parameters
    ----------
    sound_list : SoundList, optional
        Its cues own the names that files are given.
    """

    def __init__(self, sound_list: SoundList | None = None) -> None:
        self._stems: dict[str, str] = {}
        for cue in sound_list.cues if sound_list else ():
            for stem in stems_of(cue.name, cue.file_name, cue.variations) if cue.state != "cut" else ():
                for spelling in {slug(stem), _spelling(stem)}:
                    taken = spelling in self._stems  # by a stem with another spelling: the user must choose
                    self._stems[spelling] = "" if taken else stem
        self._given: set[str] = set()

    def planned(self, task: "Task", entry: FileReport) -> Change | None:
        """Return the planned fixes of a file; None when nothing found in it can be fixed.

        Raises
        ------
        CannotFixInPlace
            Something could be fixed, but a condition prevents it.
        """
        codes = {finding.code for finding in entry.findings if not finding.waived}
        name = self._name(task) if codes & NAMES and "naming:alternate" not in codes else None
        if name is None and not codes & SIZES:
            return None
        _ensure_own(task.path)
        new_path = task.path if name is None else os.path.join(os.path.dirname(task.path), name)
        if name is not None:
            if task.dry is not None:
                raise CannotFixInPlace(
                    f"under the name {name} it would lose its dry stem {task.dry.name}; rename the two together"
                )
            self._ensure_free(task.path, new_path)
        header = _fix_header(task.path, keep=False) if codes & SIZES else ()
        if name is None and not header:
            return None
        self._given.add(os.path.normcase(os.path.abspath(new_path)))
        return Change(task.path, new_path, header)

    def _name(self, task: "Task") -> str | None:
        """Return a better name for a file: the sound list's, or the one that is valid and nearest."""
        name = os.path.basename(task.path)
        if task.listed_name is not None:  # a part of its name is its folder, which stays
            start = task.listed_name.removesuffix(name)
            valid = valid_name(task.listed_name, task.spec) if task.spec else None
            return valid.removeprefix(start) if valid and valid.startswith(start) and valid != start + name else None
        parts = parse_file_name(name)
        listed = self._stems.get(slug(parts.stem)) or self._stems.get(_spelling(parts.stem))
        candidate = name
        if listed:
            mark = f"__alt{parts.alternate}" if parts.alternate is not None else ""
            candidate = f"{listed}{mark}{parts.extension}"
        valid = valid_name(candidate, task.spec) if task.spec else candidate
        return valid if valid and valid != name else None

    def _ensure_free(self, path: str, new_path: str) -> None:
        for old, new in ((path, new_path), (path + COMPANION, new_path + COMPANION)):
            if os.path.lexists(new) and not _is_same(old, new):
                raise CannotFixInPlace(f"it would be named {os.path.basename(new)}, and there is such a file already")
        if os.path.normcase(os.path.abspath(new_path)) in self._given:
            raise CannotFixInPlace(f"another file is given the name {os.path.basename(new_path)}")


def _spelling(stem: str) -> str:
    """Return the shared key of two spellings of one stem: `DoorWoodClose-1_48k24` is that of `door_wood_close_01`."""
    return f" {key_of(tokens_of(plain(without_format_suffix(stem))))}"  # the space keeps it apart from slugs


def fix_in_place(change: Change) -> None:
    """Apply the plan for one file.

    Raises
    ------
    CannotFixInPlace
        It cannot be written, or someone else was there first; the file is as it was.
    """
    try:
        if change.header:
            _fix_header(change.path, keep=True)
        if change.new_path != change.path:
            _rename(change.path, change.new_path)
            if os.path.lexists(change.path + COMPANION):
                _rename(change.path + COMPANION, change.new_path + COMPANION)
    except FileExistsError:
        raise CannotFixInPlace(f"there is a file {os.path.basename(change.new_path)} already") from None
    except OSError as error:
        raise CannotFixInPlace(f"it cannot be written: {error.strerror or error}") from None


def shown(changes: Iterable[Change]) -> Iterator[tuple[str, str]]:
    """Yield the lines of a comparison, each with its sign: "" for a path, "-" for what goes, "+" for what comes."""
    for change in changes:
        yield "", change.path
        if change.new_path != change.path:
            yield "-", f"name: {os.path.basename(change.path)}"
            yield "+", f"name: {os.path.basename(change.new_path)}"
            if os.path.lexists(change.path + COMPANION):
                yield "-", f"name: {os.path.basename(change.path)}{COMPANION}"
                yield "+", f"name: {os.path.basename(change.new_path)}{COMPANION}"
        for words in change.header:
            yield "+", words


def _ensure_own(path: str) -> None:
    file_status = os.lstat(path)
    if stat.S_ISLNK(file_status.st_mode):
        raise CannotFixInPlace("it is a link; put right the file that it leads to")
    if not file_status.st_mode & stat.S_IWUSR:
        raise CannotFixInPlace("it is read-only; make it writable first (with Perforce: p4 edit)")


def _fix_header(path: str, *, keep: bool) -> tuple[str, ...]:
    """Write a copy with right sizes next to a file, and move it over the file if it is to be kept."""
    copy = Path(path).with_name(f".audio-checks-{secrets.token_hex(8)}.part")
    try:
        words, cut_bytes = with_right_sizes(path, copy)
        if cut_bytes and not _ends_in_zeros(path, cut_bytes):
            raise CannotFixInPlace("what follows its end is not only zeros; `audio-checks fix` makes a copy without it")
        if keep:
            shutil.copymode(path, copy)
            os.replace(copy, path)
    except Unreadable as error:
        raise CannotFixInPlace(str(error)) from None
    except OSError as error:
        raise CannotFixInPlace(f"no copy can be written next to it: {error.strerror or error}") from None
    finally:
        with suppress(FileNotFoundError):
            copy.unlink()
    return words


def _ends_in_zeros(path: str, count: int) -> bool:
    with open(path, "rb") as file:
        file.seek(-count, os.SEEK_END)
        while block := file.read(1 << 16):
            if block.strip(b"\0"):
                return False
    return True


def _rename(old: str, new: str) -> None:
    """Give a file a new name that no other has; FileExistsError when one has it."""
    if _is_same(old, new):  # on a disk that takes capitals for the same
        os.rename(old, new)
        return
    try:
        os.link(old, new)  # refuses where something stands, which a rename would overwrite
    except FileExistsError:
        raise
    except (OSError, NotImplementedError):  # a disk without hard links
        if os.path.lexists(new):
            raise FileExistsError(new) from None
        os.rename(old, new)
    else:
        os.unlink(old)


def _is_same(old: str, new: str) -> bool:
    """Return whether two names that differ in their capitals at most are one file, as on Windows and macOS."""
    try:
        return old.casefold() == new.casefold() and os.path.samefile(old, new)
    except OSError:
        return False
