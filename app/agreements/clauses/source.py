"""A clause's Markdown beside its text as it was sent: which characters of the one say which of the other."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

from app.agreements.clauses.rules import FACTS, VARIABLE
from app.agreements.clauses.text import BlockKind
from app.agreements.word.document import clean

CELL_DOT = " · "  # between the cells of a row, as it is read
_INLINE = re.compile(r"\\([\\*|#\-{}.])|(\*\*)|(\*)")
_ITEM = re.compile(r"(?:-|\d+\.)\s+(.*)")
_HEAD = re.compile(r"#{1,3}\s+(.*)")
_CELL = re.compile(r"(?<!\\)\|")
_RULE = re.compile(r"[\s|:-]+")


@dataclass(frozen=True)
class Piece:
    """A stretch of a text as it was sent: written in the clause, or the value of a variable."""

    begins: int
    ends: int
    name: str = ""  # of the variable; empty for what is written


@dataclass(frozen=True)
class Letter:
    """A character as it is read, and the stretch of the text that says it."""

    letter: str
    strong: bool
    emphatic: bool
    begins: int
    ends: int


@dataclass(frozen=True)
class SourceLine:
    """A line as it is read, and the stretch of the text that says it."""

    kind: BlockKind
    begins: int
    starts: int  # behind the dash, number or signs by which it is an item or a heading
    ends: int
    letters: Sequence[Letter] = field(default_factory=tuple)

    @property
    def text(self) -> str:
        """The line without its looks."""
        return "".join(letter.letter for letter in self.letters)


def pieces_of(source: str, sent: str, fill: Callable[[str], str]) -> list[Piece] | None:
    """Return the pieces of a text that was sent, in order; None where the values of its variables are unclear.

    `fill` gives a variable its value of today. Facts may have changed since: what they said then is found between the
    words around them, where only one reading is possible.
    """
    parts = [part for part in _parts(source) if part[0] or part[1]]
    pieces = _laid_out([(text if not name else fill(f"{{{name}}}"), name) for text, name in parts])
    if "".join(text for text, _ in pieces) != sent:
        matched = _matched([(None if name in FACTS else text, name) for text, name in pieces], sent)
        if matched is None:
            return None
        pieces = matched
    laid: list[Piece] = []
    at = 0
    for text, name in pieces:
        laid.append(Piece(at, at + len(text), name))
        at += len(text)
    return laid


def _parts(source: str) -> Iterator[tuple[str, str]]:
    at = 0
    for match in VARIABLE.finditer(source):
        yield source[at : match.start()], ""
        yield "", match[1]
        at = match.end()
    yield source[at:], ""


def _laid_out(parts: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return parts without the space before the first and after the last, as a contract is written."""
    while parts and not parts[0][0].strip() and not parts[0][1]:
        parts = parts[1:]
    while parts and not parts[-1][0].strip() and not parts[-1][1]:
        parts = parts[:-1]
    if parts:
        parts = [(parts[0][0].lstrip(), parts[0][1]), *parts[1:]]
        parts = [*parts[:-1], (parts[-1][0].rstrip(), parts[-1][1])]
    return parts


def _matched(parts: Sequence[tuple[str | None, str]], sent: str) -> list[tuple[str, str]] | None:
    """Return parts with the texts that those of unknown text have; None where there is none, or more than one way."""
    fixed = [""]
    for text, _ in parts:
        if text is None:
            fixed.append("")
        else:
            fixed[-1] += text
    first, *inner = fixed
    if not inner or "" in inner[:-1]:  # two in a row: the border between them is not known
        return None
    *between, last = inner
    end = len(sent) - len(last)
    if not sent.startswith(first) or not sent.endswith(last) or len(first) > end:
        return None
    at, earliest = len(first), []
    for text in between:
        if (position := sent.find(text, at, end)) < 0:
            return None
        earliest.append(position)
        at = position + len(text)
    until, latest = end, []
    for text in reversed(between):
        until = sent.rfind(text, len(first), until)
        latest.append(until)
    if earliest != latest[::-1]:
        return None
    begins = [len(first), *(position + len(text) for position, text in zip(earliest, between, strict=True))]
    values = iter(sent[a:b] for a, b in zip(begins, [*earliest, end], strict=True))
    return [(next(values) if text is None else text, name) for text, name in parts]


def lines_with_places(sent: str) -> list[SourceLine]:
    """Return the lines of a text as `lines_of` does, each with the characters that say it."""
    lines: list[SourceLine] = []
    paragraph: list[tuple[int, int]] = []  # the physical lines of the paragraph or item that is open
    begins = 0
    kind: BlockKind = "text"

    def close() -> None:
        nonlocal paragraph, kind
        if paragraph:
            lines.append(_line(sent, kind, begins, paragraph))
        paragraph, kind = [], "text"

    at = 0
    for physical in sent.split("\n"):
        stripped = physical.strip()
        start = at + len(physical) - len(physical.lstrip())
        end = start + len(stripped)
        at += len(physical) + 1
        if not stripped:
            close()
        elif stripped.startswith("|"):
            close()
            if not _RULE.fullmatch(stripped):
                lines.append(_row(sent, start, end))
        elif head := _HEAD.fullmatch(stripped):
            close()
            lines.append(_line(sent, "head", start, [(start + head.start(1), end)]))
        elif item := _ITEM.fullmatch(stripped):
            close()
            kind, begins, paragraph = "item", start, [(start + item.start(1), end)]
        else:
            if not paragraph:
                begins = start
            paragraph.append((start, end))
    close()
    return lines


def _line(sent: str, kind: BlockKind, begins: int, stretches: Sequence[tuple[int, int]]) -> SourceLine:
    """Return a line of physical lines, which are joined by a space; bold words may go on over their ends."""
    letters = _letters(sent, stretches)
    return SourceLine(kind, begins, stretches[0][0], stretches[-1][1], _trimmed(letters))


def _row(sent: str, begins: int, ends: int) -> SourceLine:
    inner = sent[begins:ends]
    left = len(inner) - len(inner.lstrip("|"))
    inner = inner.strip("|")
    letters: list[Letter] = []
    at, bars = begins + left, [match.start() + begins + left for match in _CELL.finditer(inner)]
    ends_of = [*bars, begins + left + len(inner)]
    for number, end in enumerate(ends_of):
        cell = sent[at:end]
        start = at + len(cell) - len(cell.lstrip())
        if number:
            bar = bars[number - 1]
            dot = (Letter(" ", False, False, bar, bar), Letter("·", False, False, bar, bar + 1))
            letters += [*dot, Letter(" ", False, False, bar + 1, bar + 1)]
        letters += _trimmed(_letters(sent, [(start, start + len(cell.strip()))]))
        at = end + 1
    return SourceLine("table", begins, begins, ends, tuple(letters))


def _letters(sent: str, stretches: Sequence[tuple[int, int]]) -> list[Letter]:
    letters: list[Letter] = []
    strong = emphatic = False
    before = 0
    for number, (start, end) in enumerate(stretches):
        if number:
            letters.append(Letter(" ", strong, emphatic, before, start))
        at = start
        for match in [*_INLINE.finditer(sent[start:end]), None]:
            until = start + match.start() if match else end
            letters += [Letter(_shown(sent[index]), strong, emphatic, index, index + 1) for index in range(at, until)]
            if match is None:
                break
            at = start + match.end()
            if match[1]:
                letters.append(Letter(match[1], strong, emphatic, until, at))
            elif match[2]:
                strong = not strong
            else:
                emphatic = not emphatic
        before = end
    return letters


def _trimmed(letters: Sequence[Letter]) -> tuple[Letter, ...]:
    text = "".join(letter.letter for letter in letters)
    left = len(text) - len(text.lstrip())
    return tuple(letters[left : left + len(text.strip())])


def _shown(letter: str) -> str:
    return " " if letter in "\t\r" else clean(letter)
