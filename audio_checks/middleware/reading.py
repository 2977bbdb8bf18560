"""Finds and reads the text files of a project within bounds."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from xml.etree import ElementTree as ET

from audio_checks.errors import AudioChecksError, SpecError
from audio_checks.middleware.values import PlayedSound, Unread
from audio_checks.system.text_files import read_text

MOST_ENTRIES = 500_000  # of all folders below the root
MOST_FOLDERS_DEEP = 32
MOST_FILE_BYTES = 64 << 20
MOST_PROJECT_BYTES = 1 << 30
MOST_TAGS = 2_000_000  # of one file; an element costs some 150 bytes of memory
MOST_LINES = 4_000_000
MOST_DEPTH = 128  # of XML
MOST_SOUNDS = 200_000
MOST_OBJECTS = 4_000_000  # of a project
MOST_STEPS = 64  # on the way from a sound to the output, through containers and buses
SKIPPED_FOLDERS = frozenset(
    {".git", ".svn", ".hg", ".godot", ".import", "Library", "Temp", "Logs", "obj", "node_modules"}
)


class ProjectRefused(AudioChecksError):
    """A project that cannot be read at all: what was found, and what was wanted."""


class NotRead(Exception):
    """One file of a project that is left out.

    Parameters
    ----------
    message : str
        What was found and wanted.
    line : int
        Where; 0 where no line is known.
    """

    def __init__(self, message: str, line: int = 0) -> None:
        super().__init__(message)
        self.line = line


class ProjectFiles:
    """The files below a project's root, listed and read within bounds.

    Parameters
    ----------
    root : Path
        Where the project begins; links to folders are not followed.
    skipped : callable, optional
        Says of a folder's name whether it is left out.
    texts : mapping of str to str, optional
        The project's texts by their paths from the root, where they were sent: nothing is then read from a disk.
    """

    def __init__(
        self,
        root: Path,
        *,
        skipped: Callable[[str], bool] = lambda name: name in SKIPPED_FOLDERS,
        texts: Mapping[str, str] | None = None,
    ) -> None:
        self.root = root
        self.unread: list[Unread] = []
        self.files: list[str] = []
        self._bytes = 0
        self._texts = texts
        if texts is None:
            self._list(skipped)
        else:
            self.files = sorted(path for path in texts if not any(skipped(folder) for folder in path.split("/")[:-1]))

    def _list(self, skipped: Callable[[str], bool]) -> None:
        waiting, entries = [("", 0)], 0
        while waiting:
            folder, depth = waiting.pop()
            try:
                with os.scandir(self.root / folder) as scan:
                    for entry in scan:
                        entries += 1
                        if entries > MOST_ENTRIES:
                            raise ProjectRefused(
                                f"{self.root}: holds more than {MOST_ENTRIES:,} files and folders; name the folder of"
                                " the project alone"
                            )
                        path = f"{folder}/{entry.name}" if folder else entry.name
                        if entry.is_dir(follow_symlinks=False):
                            if not skipped(entry.name) and depth < MOST_FOLDERS_DEEP:
                                waiting.append((path, depth + 1))
                        elif entry.is_file():
                            self.files.append(path)
            except OSError as error:
                self.leave_out(folder or ".", f"the folder cannot be read: {error.strerror}")
        self.files.sort()

    def ending(self, *endings: str) -> list[str]:
        """Return the files whose names end so, whatever the case."""
        return [file for file in self.files if file.lower().endswith(endings)]

    def text(self, file: str) -> str:
        """Return the text of a file; NotRead where it is none, or too much."""
        try:
            text = self._text(file)
        except SpecError as error:
            raise NotRead(str(error)) from None
        if (lines := text.count("\n")) > MOST_LINES:
            raise NotRead(f"has {lines:,} lines; at most {MOST_LINES:,} are read")
        self._bytes += len(text)
        if self._bytes > MOST_PROJECT_BYTES:
            raise NotRead(f"the project's files hold more than {MOST_PROJECT_BYTES >> 20} MiB together")
        return text

    def _text(self, file: str) -> str:
        if self._texts is None:
            return read_text(self.root / file, most_bytes=MOST_FILE_BYTES)
        if file not in self._texts:
            raise SpecError("is not there", where=file)
        return self._texts[file]

    def texts(self, files: Iterable[str]) -> Iterator[tuple[str, str]]:
        """Yield each file with its text; those that cannot be read are left out."""
        for file in files:
            try:
                yield file, self.text(file)
            except NotRead as error:
                self.leave_out(file, str(error), error.line)

    def leave_out(self, file: str, message: str, line: int = 0) -> None:
        """Note that a file is not read."""
        self.unread.append(Unread(file, message, line))


def at_most(sounds: Iterable[PlayedSound], leave_out: Callable[[str, str], None]) -> Iterator[PlayedSound]:
    """Yield the first `MOST_SOUNDS` sounds, and note where more are left out."""
    for count, sound in enumerate(sounds):
        if count == MOST_SOUNDS:
            leave_out(sound.file, f"the project has more than {MOST_SOUNDS:,} sounds; the rest is left out")
            return
        yield sound


def xml_root(text: str) -> ET.Element:
    """Return the root of an XML text without a document type, so without entities; NotRead where it is none.

    The number of tags is bounded before the text is parsed; the depth is bounded where the tree is walked.
    """
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise NotRead("declares a document type; wanted plain XML without one")
    if (tags := text.count("<")) > MOST_TAGS:
        raise NotRead(f"has {tags:,} tags; at most {MOST_TAGS:,} are read")
    parser = ET.XMLParser()  # noqa: S314 - there is no document type, and expat then expands nothing
    try:
        parser.feed(text)
        return parser.close()
    except ET.ParseError as error:
        raise NotRead(f"is not XML: {str(error).partition(':')[0]}", error.position[0]) from None
    except (ValueError, LookupError) as error:  # an encoding that is none
        raise NotRead(f"is not XML: {error}") from None
