"""Two versions of a text, word by word."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from app.agreements.clauses.text import BlockKind, blocks_of, plain
from app.agreements.drafts.differences import differences
from app.agreements.errors import TooLongToCompare

_WORD = re.compile(r"\s+|[^\s]+")
ALIKE = 0.4  # paragraphs that share fewer words than this are another paragraph, not the same one changed
NEAR = 12  # lines of the earlier text that one of the later is held against
MAX_PAIRED = 1_000  # lines of one stretch; where more differ in a row, they are other lines
MAX_CHARS = 400_000  # of both texts; a contract of a hundred pages has 200,000
MAX_LINES = 20_000  # of both texts
_SHORTER = "compare their PDFs, or cut the contract into several"


@dataclass(frozen=True)
class Line:
    """One paragraph, item, head or row of a text."""

    kind: BlockKind
    text: str


@dataclass(frozen=True)
class Run:
    """Words in both texts, in the earlier alone, or in the later alone."""

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
    return [Line(block.kind, text) for block in blocks_of(markdown) for text in plain(block)]


def ensure_comparable(earlier: str, later: str) -> None:
    """Raise TooLongToCompare for two texts that would keep others waiting."""
    chars = len(earlier) + len(later)
    if chars > MAX_CHARS:
        raise TooLongToCompare(
            f"the two versions have {chars:,} characters together; versions of up to {MAX_CHARS:,} are compared",
            fix=_SHORTER,
        )
    lines = earlier.count("\n") + later.count("\n") + 2
    if lines > MAX_LINES:
        raise TooLongToCompare(
            f"the two versions have {lines:,} lines together; versions of up to {MAX_LINES:,} are compared",
            fix=_SHORTER,
        )


def compare(earlier: str, later: str) -> list[Compared]:
    """Return the words of two texts, compared; what is in both or later is the later text, and so the other way."""
    ensure_comparable(earlier, later)
    old, new = lines_of(earlier), lines_of(later)
    compared: list[Compared] = []
    for is_same, a, b, c, d in differences(old, new):
        if is_same:
            compared += [Compared(line.kind, "same", [Run("both", line.text)]) for line in new[c:d]]
        else:
            compared += _paired(old[a:b], new[c:d])
    return compared


def _paired(old: Sequence[Line], new: Sequence[Line]) -> Iterator[Compared]:
    """Pair lines of the same kind in order where they share words; the rest was removed or added."""
    bags = [Counter(line.text.split()) for line in old[:MAX_PAIRED]]
    at = 0
    for line in new:
        bag = Counter(line.text.split())
        near = range(at, min(at + NEAR, len(bags)))
        partner = next(
            (index for index in near if old[index].kind == line.kind and _likeness(bags[index], bag) >= ALIKE), None
        )
        if partner is None:
            yield Compared(line.kind, "added", [Run("later", line.text)])
            continue
        yield from (Compared(gone.kind, "removed", [Run("earlier", gone.text)]) for gone in old[at:partner])
        yield Compared(line.kind, "changed", words_between(old[partner].text, line.text))
        at = partner + 1
    yield from (Compared(gone.kind, "removed", [Run("earlier", gone.text)]) for gone in old[at:])


def _likeness(bag: Counter[str], other: Counter[str]) -> float:
    """Return the share of words that two lines have in common."""
    whole = bag.total() + other.total()
    return 2 * (bag & other).total() / whole if whole else 1.0


def words_between(earlier: str, later: str) -> list[Run]:
    """Return the words of two lines, compared."""
    old, new = _WORD.findall(earlier), _WORD.findall(later)
    runs: list[Run] = []
    for is_same, a, b, c, d in differences(old, new):
        if is_same:
            runs.append(Run("both", "".join(new[c:d])))
            continue
        if a < b:
            runs.append(Run("earlier", "".join(old[a:b])))
        if c < d:
            runs.append(Run("later", "".join(new[c:d])))
    return runs
