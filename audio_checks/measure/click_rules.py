"""The prediction error of a click from its surroundings, and the cells where one may be."""

from __future__ import annotations

from typing import NamedTuple

# A click can be predicted neither from the sound before it nor from that after it.
HARDER_THAN_BESIDE = 4.5  # each time so many times as badly as that sound itself
HARDER_THAN_AROUND = 1.5  # and both ways so many times as badly as any other place within 20 ms
# Without the range over 6 kHz a dull click shows that the hiss of the sound hides.
DULL_DOUBTFUL = 1.5  # times as sharp, as steep or as bent is looked at in that way, too
DULL_HARDER_THAN_BESIDE = 7.0
DULL_HARDER_THAN_AROUND = 2.0
CORE = 1  # cells beside a click that may belong to it, one of them at a time
BURST = 8  # cells, 4 ms, in which several clicks are one event: contacts of a plug, both ends of what was overwritten
BURST_HARDER_THAN_BESIDE = 7.0
BURST_HARDER_THAN_AROUND = 4.7
GLIDE_HARDER = 2.0  # times as badly as the sound on either side is enough in a tone that glides: it is predicted well


class Rule(NamedTuple):
    """The prediction of a click that may be in a cell: the data looked at there, and the error required.

    The cells before the one, and how many in all; how many times as badly as the sound beside them, and both ways as
    any other place around; whether without the highs; and from how many times as high as others on it is looked at.
    """

    before: int
    cells: int
    harder_than_beside: float
    harder_than_around: float
    without_highs: bool = False
    stands: float = 0.0


_SINGLE = Rule(CORE, 1 + 2 * CORE, HARDER_THAN_BESIDE, HARDER_THAN_AROUND)
ALONE = (
    _SINGLE,
    _SINGLE._replace(
        harder_than_beside=DULL_HARDER_THAN_BESIDE,
        harder_than_around=DULL_HARDER_THAN_AROUND,
        without_highs=True,
        stands=DULL_DOUBTFUL,
    ),
)
IN_GLIDES = (_SINGLE._replace(harder_than_beside=GLIDE_HARDER),)
IN_BURSTS = tuple(  # the sharpest cell may be the first of a burst, or the last, or between
    Rule(before, BURST + 2 * CORE, BURST_HARDER_THAN_BESIDE, BURST_HARDER_THAN_AROUND)
    for before in (CORE, CORE + BURST // 2, BURST)
)


class Candidate(NamedTuple):
    """A cell where a click may be: it is a click if any of its rules holds.

    `stands` is how many times as high it is as others, `power` that of the sound around.
    """

    channel: int
    rules: tuple[Rule, ...]
    cell: int
    stands: float
    power: float


def strongest(doubts: list[Candidate]) -> list[Candidate]:
    """Return, of doubts that one click may have raised, the one that stands out most."""
    foremost: list[Candidate] = []
    for doubt in sorted(doubts):
        last = foremost[-1] if foremost else None
        if last is None or doubt[:2] != last[:2] or doubt.cell - last.cell >= doubt.rules[0].cells:
            foremost.append(doubt)
        elif doubt.stands > last.stands:
            foremost[-1] = doubt
    return foremost
