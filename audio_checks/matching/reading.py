"""Reads the name of a file as tokens, and marks those that say nothing about the sound: versions, dates, copies."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import date
from typing import Literal

from audio_checks.matching.words import (
    ALTERNATE_WORDS,
    COPY_WORDS,
    FORMAT_WORDS,
    MONTHS,
    NEAR_FORMAT_WORDS,
    STATE_WORDS,
    TAKE_WORDS,
    UNITS,
    VERSION_WORDS,
    WEAK_STATE_WORDS,
)
from audio_checks.spec.format_suffixes import format_spans
from audio_checks.spec.sound_names import AUDIO_SUFFIXES, WORD_STARTS

Kind = Literal["state", "version", "take", "copy", "count", "alternate", "format", "date"]

FOLDERS_READ = 3
MOST_TOKENS = 40  # of one name; the rest of a longer one is not read
MOST_CHARS = 400
NEVER_SPLIT = STATE_WORDS | VERSION_WORDS | UNITS

_TOKEN = re.compile(r"[0-9]+|[^\W\d_]+")
_DATES = (
    re.compile(r"(?<![0-9])(?P<y>20[0-9]{2})([-_. ]?)(?P<m>[0-9]{2})\2(?P<d>[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<d>[0-9]{1,2})([-_. ])(?P<m>[0-9]{1,2})\2(?P<y>20[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<m>[0-9]{1,2})([-_. ])(?P<d>[0-9]{1,2})\2(?P<y>20[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<d>[0-9]{2})(?P<m>[0-9]{2})(?P<y>20[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<m>[0-9]{2})(?P<d>[0-9]{2})(?P<y>20[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<y>[1-3][0-9])([-.]?)(?P<m>[0-9]{2})\2(?P<d>[0-9]{2})(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<d>[0-9]{2})([-.]?)(?P<m>[0-9]{2})\2(?P<y>[1-3][0-9])(?![0-9])"),
    re.compile(r"(?<![0-9])(?P<m>[0-9]{2})([-.]?)(?P<d>[0-9]{2})\2(?P<y>[1-3][0-9])(?![0-9])"),
    re.compile(
        rf"(?<![0-9])(?P<d>[0-9]{{1,2}})[-_. ]?(?P<b>{'|'.join(MONTHS)})[-_. ]?(?P<y>(?:20)?[0-9]{{2}})(?![0-9])", re.I
    ),
)  # fmt: skip
_TIME = re.compile(
    r"[-_ T]{1,3}(?:[0-2][0-9][-.:h][0-5][0-9](?:[-.:m][0-5][0-9])?|[0-2][0-9][0-5][0-9](?:[0-5][0-9])?)(?![0-9])"
)


@dataclass(frozen=True, slots=True)
class Token:
    """A word or a number in a name.

    Attributes
    ----------
    text : str
        Its letters in lower case without accents; of a number its digits without leading zeros.
    written : str
        As written in the name.
    start, end : int
        Its place in the name.
    is_number : bool
        Whether it is made of digits.
    is_attached : bool
        Whether nothing is between it and the token before.
    part : int
        0 for the name itself, 1 for its folder, 2 for the folder of that.
    """

    text: str
    written: str
    start: int
    end: int
    is_number: bool
    is_attached: bool
    part: int = 0

    @property
    def key(self) -> str:
        """Return its part of the key of a name: numbers are marked, so that `1 2` is not `12`."""
        return f"#{self.text}" if self.is_number else self.text


@dataclass(frozen=True)
class Reading:
    """The name of a file as it was read.

    Attributes
    ----------
    stem : str
        The name without folders and ending, without accents.
    tokens : tuple of Token
        The folders' first, the outermost before the others, then the name's own.
    first : int
        The place of the name's first token.
    markers : dict
        What kind of marker a token is part of, by its place.
    groups : dict
        Which marker a token is part of, by its place; the parts of one marker have one number.
    after_marker : frozenset of int
        Numbers that may belong to the marker before them: FINAL 2.
    alternate : int or None
        Which alternate the name says it is.
    """

    stem: str
    tokens: tuple[Token, ...]
    first: int
    markers: dict[int, Kind] = field(default_factory=dict)
    groups: dict[int, int] = field(default_factory=dict)
    after_marker: frozenset[int] = frozenset()
    alternate: int | None = None


def plain(text: str) -> str:
    """Return text without accents, its case kept; letters of other scripts stay."""
    decomposed = unicodedata.normalize("NFKD", text)
    return unicodedata.normalize(
        "NFC", "".join(character for character in decomposed if not unicodedata.combining(character))
    )


def tokens_of(text: str, part: int = 0) -> list[Token]:
    """Return the words and numbers of a text that has no accents; CamelCase is split."""
    tokens: list[Token] = []
    end = 0
    for chunk in _TOKEN.finditer(text[:MOST_CHARS]):
        for start, written in _pieces(chunk, text):
            is_number = written[0] in "0123456789"
            word = written.lstrip("0") or "0" if is_number else written.casefold()
            tokens.append(
                Token(word, written, start, start + len(written), is_number, bool(tokens) and start == end, part)
            )
            end = start + len(written)
    return tokens


def _pieces(chunk: re.Match[str], text: str) -> list[tuple[int, str]]:
    """Return a run of letters or digits cut where CamelCase has a hump, and before the `v` of a version."""
    run, start = chunk[0], chunk.start()
    if run[0] in "0123456789" or run.casefold() in NEVER_SPLIT:
        return [(start, run)]
    ends_in_version = len(run) > 1 and run[-1] in "vV" and text[chunk.end() : chunk.end() + 1].isdigit()
    body = run[:-1] if ends_in_version else run
    pieces = []
    for piece in WORD_STARTS.split(body):
        pieces.append((start, piece))
        start += len(piece)
    return [*pieces, (start, run[-1])] if ends_in_version else pieces


def key_of(tokens: Sequence[Token]) -> str:
    """Return the shared key of two spellings of one name: the letters and numbers in their order."""
    return "".join(token.key for token in tokens)


def read_name(path: str) -> Reading:
    """Return the tokens of a file's name and of the folders before it, with its markers marked."""
    *folders, name = [part for part in re.split(r"[/\\]", plain(path)) if part not in ("", ".", "..")] or [""]
    stem = without_ending(name)
    near = folders[-FOLDERS_READ:]
    before = [token for index, folder in enumerate(near) for token in tokens_of(folder, len(near) - index)]
    own_tokens = tokens_of(stem)[:MOST_TOKENS]
    before = before[-MOST_TOKENS:]
    markers, groups, after, alternate = _markers(stem, own_tokens)
    first = len(before)
    return Reading(
        stem=stem,
        tokens=(*before, *own_tokens),
        first=first,
        markers={first + index: kind for index, kind in markers.items()},
        groups={first + index: group for index, group in groups.items()},
        after_marker=frozenset(first + index for index in after),
        alternate=alternate,
    )


def variation_in(path: str, variations: int) -> int | None:
    """Return the variation of a set that a file's name says: its last number, else its first; None where none fits.

    Numbers of versions, copies, dates and formats are not read: `Step 03 FINAL (2)` and `step_03_48k24` are number 3.
    """
    read = read_name(path)
    unmarked = [
        token
        for index, token in enumerate(read.tokens)
        if index >= read.first and index not in read.markers and index not in read.after_marker
    ]
    for token in (*unmarked[-1:], *unmarked[:1]):
        if token.is_number and 1 <= int(token.text) <= variations:
            return int(token.text)
    return None


def without_ending(name: str) -> str:
    """Return a name without the ending of a sound file, also one that stands twice."""
    while True:
        stem, dot, ending = name.rpartition(".")
        if not (stem and dot + ending.lower() in AUDIO_SUFFIXES):
            return name
        name = stem


class _Marks:
    def __init__(self) -> None:
        self.markers: dict[int, Kind] = {}
        self.groups: dict[int, int] = {}

    def add(self, kind: Kind, *places: int) -> None:
        group = len(set(self.groups.values()))
        for index in places:
            self.markers[index], self.groups[index] = kind, group


def _markers(stem: str, tokens: Sequence[Token]) -> tuple[dict[int, Kind], dict[int, int], set[int], int | None]:
    marks = _Marks()
    after: set[int] = set()
    alternate: int | None = None
    for start, end in _dates(stem):
        inside = [token_index for token_index, token in enumerate(tokens) if token.start >= start and token.end <= end]
        marks.add("date", *inside)
    for start, end in format_spans(stem):
        inside = [token_index for token_index, token in enumerate(tokens) if token.start >= start and token.end <= end]
        if inside and not any(token_index in marks.markers for token_index in inside):
            marks.add("format", *inside)
    index = 0
    while index < len(tokens):
        token = tokens[index]
        following = _number_after(tokens, index)
        if index in marks.markers:
            index += 1
            continue
        if token.is_number:
            index = _mark_number(stem, tokens, index, marks)
            continue
        if token.text in VERSION_WORDS and following is not None:
            places = [index, following]
            last = following + 1
            while last < len(tokens) and (
                (tokens[last].is_number and stem[tokens[last].start - 1] == ".")
                or (not tokens[last].is_number and tokens[last].is_attached and len(tokens[last].text) == 1)
            ):
                places.append(last)
                last += 1
            marks.add("version", *places)
        elif token.text in TAKE_WORDS and following is not None:
            marks.add("take", index, following)
        elif token.text in COPY_WORDS:
            is_copy_of = index + 1 < len(tokens) and tokens[index + 1].text == "of"
            marks.add("copy", index, *([index + 1] if is_copy_of else [following] if following is not None else []))
        elif (alternate_match := _alternate(tokens, index)) is not None:
            alternate, last = alternate_match
            marks.add("alternate", *range(index, last + 1))
        elif token.text in STATE_WORDS or (token.text in WEAK_STATE_WORDS and _is_aside(stem, tokens, index, marks)):
            attached = following is not None and tokens[following].is_attached
            marks.add("state", index, *([index + 1] if attached else []))
            if following is not None and not attached:
                after.add(following)
        elif token.text in FORMAT_WORDS or (
            token.text in NEAR_FORMAT_WORDS and marks.markers.get(index - 1) == "format"
        ):
            marks.add("format", index)
        index += 1
    return marks.markers, marks.groups, after, alternate


def _is_aside(stem: str, tokens: Sequence[Token], index: int, marks: _Marks) -> bool:
    """Whether a word follows a marker, or is shouted where the name is not."""
    if index == 0:
        return False
    if index - 1 in marks.markers:
        return True
    return tokens[index].written.isupper() and any(character.islower() for character in stem[: tokens[index].start])


def _number_after(tokens: Sequence[Token], index: int) -> int | None:
    following = index + 1
    return following if following < len(tokens) and tokens[following].is_number else None


def _mark_number(stem: str, tokens: Sequence[Token], index: int, marks: _Marks) -> int:
    """Mark a number that is a copy's, or has a unit; return the place to read on from."""
    token = tokens[index]
    if stem[token.start - 1 : token.start] in ("(", "[") and stem[token.end : token.end + 1] in (")", "]"):
        marks.add("count", index)
        return index + 1
    places = [index]
    following = index + 1
    if following < len(tokens) and tokens[following].is_number and stem[token.end : tokens[following].start] == ".":
        places.append(following)
        following += 1
    if following < len(tokens) and tokens[following].text in UNITS:
        unit = tokens[following]
        if unit.is_attached or unit.text in ("khz", "hz", "bit", "bits", "bpm", "lufs"):
            marks.add("format", *places, following)
            return following + 1
    return index + 1


def _alternate(tokens: Sequence[Token], index: int) -> tuple[int, int] | None:
    """Return the alternate that a name says from this place on, and the place where it has said so."""
    text = tokens[index].text
    if len(text) == 4 and text.startswith("alt") and text[3].isascii():  # altb
        return ord(text[3]) - ord("a") + 1, index
    if text not in ALTERNATE_WORDS or index + 1 >= len(tokens):
        return None
    following = tokens[index + 1]
    if following.is_number and len(following.text) <= 2 and following.text != "0":
        return int(following.text), index + 1
    if not following.is_number and len(following.text) == 1 and "a" <= following.text <= "z":
        return ord(following.text) - ord("a") + 1, index + 1
    return None


def _dates(stem: str) -> list[tuple[int, int]]:
    """Return the places of dates, each with the time of day that may follow."""
    spans: list[tuple[int, int]] = []
    for pattern in _DATES:
        for match in pattern.finditer(stem):
            start, end = match.span()
            if any(start < other_end and other_start < end for other_start, other_end in spans):
                continue
            if _is_day(match):
                time = _TIME.match(stem, end)
                spans.append((start, time.end() if time else end))
    return spans


def _is_day(match: re.Match[str]) -> bool:
    parts = match.groupdict()
    month = MONTHS[parts["b"].lower()] if "b" in parts else int(parts["m"])
    year = int(parts["y"]) % 100 + 2000
    try:
        date(year, month, int(parts["d"]))
    except ValueError:
        return False
    return 2010 <= year <= 2039
