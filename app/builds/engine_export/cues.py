"""The content of an engine export: cues with their files, and names that every engine accepts."""

import pkgutil
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Literal, Never

STREAMED_FROM_S = 10.0  # music, ambience and long speech
DECOMPRESSED_BELOW_S = 2.0
PCM_RATIO, ADPCM_RATIO = 1.0, 4.5  # largest `codec_ratio` of a target that means each
_NOT_ASCII_WORD = re.compile(r"[^A-Za-z0-9_]+")
_NOT_IN_FILE_NAMES = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
_NUMBERED = re.compile(r"[ _.-]*\d+$")
_EVENT_PREFIX = re.compile(r"^(event:|[/\\]+events(?=[/\\]))", re.IGNORECASE)
_BREAKS = re.compile(r"[\s\x00-\x1f\x7f-\x9f\u2028\u2029]+")


class _Engine(StrEnum):
    @classmethod
    def _missing_(cls, value: object) -> Never:
        raise ValueError(f"no engine {value!r}; write one of {', '.join(cls)}")


ENGINES = sorted(module.name for module in pkgutil.iter_modules([str(Path(__file__).with_name("engines"))]))
if TYPE_CHECKING:

    class Handoff(_Engine):
        """One value for each engine, which mypy cannot see."""

        NONE = "none"
else:
    Handoff = _Engine("Handoff", {"NONE": "none"} | {name.upper(): name for name in ENGINES}, module=__name__)
    Handoff.__doc__ = "The engine or middleware whose import files a pack contains."


@dataclass(frozen=True)
class ArchivedFile:
    """One game file of a pack, or a placeholder file, of which only the wanted length is known."""

    path: str
    sha256: str
    duration_s: float
    sample_rate_hz: int = 0
    loop_points: tuple[tuple[int, int], ...] = ()  # first and last frame of each loop that the file states

    @property
    def name(self) -> str:
        """The file name without its folders."""
        return PurePosixPath(self.path).name

    @property
    def stem(self) -> str:
        """The file name without folders and ending."""
        return PurePosixPath(self.path).stem


@dataclass(frozen=True)
class ExportedCue:
    """One cue with its files in the order of its variations; a cue with more than one is a set."""

    label: str
    name: str  # of the set: the stem of its files without their numbers; unique in the pack, upper and lower case alike
    title: str  # as the list has it
    category: str
    loop: bool
    notes: str
    files: tuple[ArchivedFile, ...]
    event: str = ""  # as the list has it; empty where it states none
    language: str = ""
    target_streamed: bool = False
    codec_ratio: float = 1.0

    @property
    def is_set(self) -> bool:
        """Whether the game picks one of several files."""
        return len(self.files) > 1

    @property
    def duration_s(self) -> float:
        """The length of its longest file."""
        return max((file.duration_s for file in self.files), default=0.0)

    @property
    def streamed(self) -> bool:
        """Whether the engine is advised to play it from disk."""
        return self.target_streamed or self.duration_s >= STREAMED_FROM_S

    @property
    def compression(self) -> Literal["pcm", "adpcm", "vorbis"]:
        """The codec that the target counts its memory by."""
        if self.codec_ratio <= PCM_RATIO:
            return "pcm"
        return "adpcm" if self.codec_ratio <= ADPCM_RATIO else "vorbis"

    @property
    def load(self) -> Literal["streaming", "compressed", "decompressed"]:
        """Return the load mode advised to the engine."""
        if self.streamed:
            return "streaming"
        return "decompressed" if self.duration_s < DECOMPRESSED_BELOW_S else "compressed"

    @property
    def stated_event(self) -> tuple[str, ...]:
        """The folders and the name of the event that the list states; empty where it states none."""
        path = _EVENT_PREFIX.sub("", self.event.strip())
        return tuple(part for part in (one_line(part) for part in re.split(r"[/\\]", path)) if part)


def one_line(text: str) -> str:
    """Return text on one line, without control characters."""
    return _BREAKS.sub(" ", text).strip()


def identifier(text: str, fallback: str = "sound") -> str:
    """Return text as ASCII letters, digits and underscores."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return _NOT_ASCII_WORD.sub("_", plain).strip("_") or _NOT_ASCII_WORD.sub("_", fallback).strip("_") or "sound"


def file_safe(text: str) -> str:
    """Return text as a file name that every system can hold."""
    return _NOT_IN_FILE_NAMES.sub("_", one_line(text)).rstrip(". ") or "sound"


def set_name(stems: Sequence[str]) -> str:
    """Return the common name of a cue's files: laser_fire of laser_fire_01 and laser_fire_02."""
    if len(stems) == 1:
        return stems[0]
    bases = {_NUMBERED.sub("", stem) for stem in stems}
    return (bases.pop() if len(bases) == 1 else "") or stems[0]


def distinct(names: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Return a name for each label: its own, or with the label behind it where an earlier label has the name.

    Upper and lower case are alike, because file systems and engines take them so.
    """
    taken: set[str] = set()
    chosen: dict[str, str] = {}
    for label, name in sorted(names):
        free, count = name, 1
        while free.casefold() in taken:
            free = f"{name}_{identifier(label)}" + ("" if count == 1 else f"_{count}")
            count += 1
        taken.add(free.casefold())
        chosen[label] = free
    return chosen


def stated(extra: Mapping[str, str], *columns: str) -> str:
    """Return the first text that a list has in one of these columns of its own, however they are spelt."""
    texts_by_column = {column.casefold().replace("_", " ").strip(): text for column, text in extra.items()}
    return next(
        (one_line(texts_by_column[column]) for column in columns if texts_by_column.get(column, "").strip()), ""
    )
