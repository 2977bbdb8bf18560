"""Straight tops: crests that were cut off, and then leaned, were ridden up and down, or changed their sample rate."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel

HIGH = 0.5  # of the highest crest of its side: what reaches this is looked at
ROUNDED = 4.0  # steps of the bit depth: what a straight top may bend by rounding
FLOAT = 1e-6  # of the highest crest: the same for float
FEWEST = 4  # straight tops in a file
SHARE = 0.2  # of them and of the crests near by that lie higher
MOST_STEPPED = 0.3  # as many tops of steps as there are others: more, and the wave is made of steps
MOST_ROWS = 1 << 13  # looked at without a straight top
MOST_AT_ONCE = 4_096
MOST_KEPT = 20_000


class StraightTops:
    """Looks for crests that are straight between two corners, each as high as it may be.

    What is cut off is straight, and stays so when slow filters make it lean, or a hand rides its level: the wave
    bends at both ends of the top and not between them. A converter of sample rates adds ripples as fast as it can.
    Waves of steps have such tops as well, but straight stretches lower down too.

    Parameters
    ----------
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    def __init__(self, step: float) -> None:
        self._step = step
        self._counts = np.zeros(3)  # straight, others that lie higher, and stepped
        self._found = np.empty((MOST_AT_ONCE, 3))
        self._tops = [np.empty((0, 5))]

    def add(
        self,
        row: NDArray[np.float64],
        maxima: NDArray[np.float64],
        places: NDArray[np.float64],
        first: int,
        frame: int,
        channel: int,
        sign: float,
        extreme: float,
    ) -> None:
        """Take the samples of a channel from `first` on, where one of the highest crests is straight.

        Their `places` are among these samples, and `extreme` is the highest of all so far; `maxima` are those of all
        samples, and `frame` is the position in the whole signal of the first of them.
        """
        rounded = max(ROUNDED * self._step, FLOAT * extreme)
        shape = np.array([sign, HIGH * extreme, rounded, max(self._step, FLOAT / ROUNDED * extreme)])
        scratch = np.zeros(3)
        for index in places.tolist():
            if kernel.straight_tops(row, maxima, int(index), shape, 1, scratch, self._found):
                break
        else:
            return
        count = kernel.straight_tops(row, maxima, first, shape, MOST_ROWS, self._counts, self._found)
        if sum(map(len, self._tops)) < MOST_KEPT:
            tops = np.empty((count, 5))
            tops[:, :3] = self._found[:count]
            tops[:, 0] += frame
            tops[:, 3:] = sign, channel
            self._tops.append(tops)

    def result(self) -> NDArray[np.float64]:
        """Return start, samples, height, sign and channel of the tops; none where they are by chance or by design."""
        straight, higher, stepped = self._counts.tolist()
        tops = np.concatenate(self._tops)
        if straight < FEWEST or stepped > MOST_STEPPED * straight or straight <= SHARE * (straight + higher):
            return tops[:0]
        return tops
