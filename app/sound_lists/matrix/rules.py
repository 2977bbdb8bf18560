"""Several cues written as one line: "deck, sand × walk, run × 6" is four cues of six variations."""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import audio_checks
from app.sound_lists.kits.rules import KitCue, Token, file_name_of
from app.sound_lists.rules import MAX_VARIATIONS, folded, tidy_line

MAX_LINE_CHARS = 4_000
MAX_CUES = 500
_BETWEEN_GROUPS = re.compile(r" ?[×✕*] ?| x ", re.IGNORECASE)
_BETWEEN_PARTS = re.compile(r"[,;]")


@dataclass(frozen=True)
class Matrix:
    """The content of a line: parts that are combined each with each, and the variations of every cue."""

    groups: Sequence[Sequence[str]]
    variations: int


@dataclass(frozen=True)
class MatrixCue:
    """One cue that a line makes."""

    name: str
    file_name: str  # empty: that of its name
    variations: int

    @property
    def stems(self) -> list[str]:
        """The file names, without ending, that it will own."""
        return audio_checks.stems_of(self.name, self.file_name, self.variations)


def read_matrix(line: str) -> Matrix:
    """Return the content of a line; raise ValueError that names the part found and the part wanted."""
    if len(line) > MAX_LINE_CHARS:
        raise ValueError(f"{len(line):,} characters; a line may have {MAX_LINE_CHARS:,}")
    groups = _BETWEEN_GROUPS.split(tidy_line(re.sub(r"[\r\n]+", ",", line.strip())))
    variations = 1
    if len(groups) > 1 and re.fullmatch(r"[0-9]{1,9}", groups[-1].strip(), re.ASCII):
        variations = int(groups.pop())
        if not 1 <= variations <= MAX_VARIATIONS:
            raise ValueError(f"{variations} variations; a cue may have 1 to {MAX_VARIATIONS}")
    named = [[part for text in _BETWEEN_PARTS.split(group) if (part := text.strip())] for group in groups]
    for parts in named:
        if not parts:
            raise ValueError("a part is missing before or after ×; write lists such as deck, sand × walk, run × 6")
        words = [" ".join(_words(part)).casefold() for part in parts]
        if twice := next((part for part, key in zip(parts, words, strict=True) if words.count(key) > 1), None):
            raise ValueError(f'"{twice}" is there twice; write it once')
    count = math.prod(map(len, named))
    if count > MAX_CUES:
        shape = " × ".join(str(len(parts)) for parts in named)
        raise ValueError(f"{shape} makes {count:,} cues; a line makes {MAX_CUES} at most, write it as several lines")
    return Matrix(named, variations)


def _words(part: str) -> list[str]:
    stems = audio_checks.stems_of(part, "", 1)
    if not stems:
        raise ValueError(f'"{part}" has no letter or digit for a file name')
    return stems[0].split("_")


def matrix_cues(matrix: Matrix, category: str, tokens: Sequence[Token], separator: str) -> list[MatrixCue]:
    """Return the cues of a line under the names that a spec asks for; raise ValueError where two get one name."""
    cues = list(_combined(matrix, category, tokens, separator))
    seen: dict[str, MatrixCue] = {}
    for cue in cues:
        for stem in cue.stems:
            other = seen.setdefault(folded(stem), cue)
            if other is not cue:
                raise ValueError(f'{other.name} and {cue.name} would both own the file name "{stem}"; rename a part')
    return cues


def _combined(matrix: Matrix, category: str, tokens: Sequence[Token], separator: str) -> Iterator[MatrixCue]:
    for parts in product(*matrix.groups):
        words = tuple(word for part in parts for word in _words(part))
        name = "_".join(words)
        kit_cue = KitCue(name, words, category, 1.0, loop=False, variations=matrix.variations, use="", description="")
        file_name = file_name_of(kit_cue, tokens, separator)
        yield MatrixCue(name, "" if file_name == name else file_name, matrix.variations)
