"""The differences of two sequences, in a time that grows with their length and not with its square.

Patience diff: elements that occur once in each are anchors where their order is the same, and what is between two
anchors is compared recursively. A short stretch without anchors is compared exactly; a long one counts as replaced.
"""

from bisect import bisect_left
from collections import Counter
from collections.abc import Hashable, Iterator, Sequence
from typing import NamedTuple

MAX_CELLS = 1_600  # of a stretch that is compared exactly: forty words with forty
MAX_LEVELS = 12


class Stretch(NamedTuple):
    """A stretch of both sequences, the same or different; one side of a different one may be empty."""

    is_same: bool
    old_from: int
    old_to: int
    new_from: int
    new_to: int


class _Range(NamedTuple):
    old_from: int
    old_to: int
    new_from: int
    new_to: int


def differences(old: Sequence[Hashable], new: Sequence[Hashable]) -> Iterator[Stretch]:
    """Yield the stretches that two sequences consist of, in order; the same and the different alternate."""
    at_old = at_new = 0
    same_old = same_new = 0  # where the same stretch that is being gathered began
    for i, j in [*sorted(_pairs(old, new)), (len(old), len(new))]:
        if (i, j) != (at_old, at_new) or (i == len(old) and j == len(new)):
            if same_old < at_old:
                yield Stretch(True, same_old, at_old, same_new, at_new)
            if at_old < i or at_new < j:
                yield Stretch(False, at_old, i, at_new, j)
            same_old, same_new = i, j
        at_old, at_new = i + 1, j + 1


def _pairs(old: Sequence[Hashable], new: Sequence[Hashable]) -> Iterator[tuple[int, int]]:
    """Yield the places of what is the same in both; the pairs do not cross."""
    ranges = [(_Range(0, len(old), 0, len(new)), 0)]
    while ranges:
        (a, b, c, d), level = ranges.pop()
        while a < b and c < d and old[a] == new[c]:
            yield a, c
            a, c = a + 1, c + 1
        while a < b and c < d and old[b - 1] == new[d - 1]:
            b, d = b - 1, d - 1
            yield b, d
        if a == b or c == d:
            continue
        if (b - a) * (d - c) <= MAX_CELLS:
            yield from _exactly(old, new, _Range(a, b, c, d))
        elif level < MAX_LEVELS:
            anchors = _anchors(old, new, _Range(a, b, c, d))
            for (i, j), (k, m) in zip([(a, c), *((i + 1, j + 1) for i, j in anchors)], [*anchors, (b, d)], strict=True):
                if anchors:
                    ranges.append((_Range(i, k, j, m), level + 1))
            yield from anchors


def _anchors(old: Sequence[Hashable], new: Sequence[Hashable], within: _Range) -> list[tuple[int, int]]:
    """Return the places of what stands once in each, as many as keep their order."""
    a, b, c, d = within
    once_old = {item for item, times in Counter(old[a:b]).items() if times == 1}
    once_new = {item for item, times in Counter(new[c:d]).items() if times == 1}
    places = {old[i]: i for i in range(a, b) if old[i] in once_old}
    anchors = [(places[new[j]], j) for j in range(c, d) if new[j] in once_new and new[j] in places]
    return _rising(anchors)


def _rising(pairs: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the longest run of pairs, taken in their order, whose first numbers rise."""
    ends: list[int] = []  # the smallest first number that ends a run of each length
    last: list[int] = []  # which pair that is
    before: list[int] = []
    for pair_index, (i, _) in enumerate(pairs):
        length = bisect_left(ends, i)
        before.append(last[length - 1] if length else -1)
        if length == len(ends):
            ends.append(i)
            last.append(pair_index)
        else:
            ends[length], last[length] = i, pair_index
    chosen: list[tuple[int, int]] = []
    index = last[-1] if last else -1
    while index >= 0:
        chosen.append(pairs[index])
        index = before[index]
    return chosen[::-1]


def _exactly(old: Sequence[Hashable], new: Sequence[Hashable], within: _Range) -> Iterator[tuple[int, int]]:
    """Yield a longest common subsequence, by the table of all lengths."""
    a, b, c, d = within
    longest = [[0] * (d - c + 1) for _ in range(b - a + 1)]
    for i in range(b - a - 1, -1, -1):
        row, below = longest[i], longest[i + 1]
        for j in range(d - c - 1, -1, -1):
            row[j] = below[j + 1] + 1 if old[a + i] == new[c + j] else max(below[j], row[j + 1])
    i = j = 0
    while i < b - a and j < d - c:
        if old[a + i] == new[c + j]:
            yield a + i, c + j
            i, j = i + 1, j + 1
        elif longest[i + 1][j] >= longest[i][j + 1]:
            i += 1
        else:
            j += 1
