"""Two versions of a text, word by word."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import Literal

from app.contracts.text import BlockKind, blocks_of, plain

_WORD = re.compile(r"\s+|[^\s]+")
ALIKE = 0.4  # paragraphs that share fewer words than this are another paragraph, not the same one changed


@dataclass(frozen=True)
class Line:
    """One paragraph, item, head or row of a text."""

    kind: BlockKind
    text: str


@dataclass(frozen=True)
class Run:
    """Words that stand in both texts, in the earlier alone, or in the later alone."""

    is_in: Literal["both", "earlier", "later"]
    text: str


@dataclass(frozen=True)
class Compared:
    """One line of the comparison; `change` says at a glance what happened to it."""

    kind: BlockKind
    change: Literal["same", "changed", "added", "removed"]
    runs: list[Run]


def lines_of(markdown: str) -> list[Line]:
    """Return a text line by line, as it is read."""
    return [Line(block.kind, said) for block in blocks_of(markdown) for said in plain(block)]


def compare(earlier: str, later: str) -> list[Compared]:
    """Return the words of two texts, told apart; what is in both or later is the later text, and so the other way."""
    old, new = lines_of(earlier), lines_of(later)
    compared: list[Compared] = []
    for deed, a, b, c, d in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if deed == "equal":
            compared += [Compared(line.kind, "same", [Run("both", line.text)]) for line in new[c:d]]
        else:
            compared += _paired(old[a:b], new[c:d])
    return compared


def _paired(old: Sequence[Line], new: Sequence[Line]) -> Iterator[Compared]:
    """Pair lines of the same kind in order where they share words; the rest was removed or added."""
    at = 0
    for line in new:
        partner = next(
            (
                place
                for place in range(at, len(old))
                if old[place].kind == line.kind and _likeness(old[place], line) >= ALIKE
            ),
            None,
        )
        if partner is None:
            yield Compared(line.kind, "added", [Run("later", line.text)])
            continue
        yield from (Compared(gone.kind, "removed", [Run("earlier", gone.text)]) for gone in old[at:partner])
        yield Compared(line.kind, "changed", words_between(old[partner].text, line.text))
        at = partner + 1
    yield from (Compared(gone.kind, "removed", [Run("earlier", gone.text)]) for gone in old[at:])


def _likeness(one: Line, other: Line) -> float:
    return SequenceMatcher(None, one.text.split(), other.text.split(), autojunk=False).ratio()


def words_between(earlier: str, later: str) -> list[Run]:
    """Return the words of two lines, told apart."""
    old, new = _WORD.findall(earlier), _WORD.findall(later)
    runs: list[Run] = []
    for deed, a, b, c, d in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if deed == "equal":
            runs.append(Run("both", "".join(new[c:d])))
            continue
        if a < b:
            runs.append(Run("earlier", "".join(old[a:b])))
        if c < d:
            runs.append(Run("later", "".join(new[c:d])))
    return runs
