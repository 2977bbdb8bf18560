"""Flat tops: crests that something has cut off, at full scale, under it, or softly."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.decibels import decibels
from audio_checks.measure.maxima import ROW_FRAMES
from audio_checks.measure.straight_tops import StraightTops

SHORTEST_RUN = 3  # one or two samples on one level are a crest
FULL_SCALE = 2.0**-15  # how far under 1.0 still is full scale: the largest 16-bit sample
ROUND = 1.5  # times what a parabola falls within two samples of a run's ends: a top that falls no more is round
GRAIN = 2.5  # steps of the bit depth: samples that close are on one level
SHARE = 1e-4  # of the level: the same for float
CORNER = 16.0  # of these: what the wave falls within two samples of a run's ends; a round crest does not
CEILING = 1e-3  # share of the highest crest by which others on the ceiling may be lower
FEWEST = 3  # of them in a file, under full scale: two crests may be as high by chance
SOFT_CEILING = 0.03  # the same for soft tops
SOFT_FLAT = 0.98  # a soft top is the part above this share of its crest
SOFT_WIDE, SOFT_RATIO = 0.8, 1.7  # above this share a round crest is 3.2 times as wide, and a soft top at most this
SOFT_S = 1e-4  # a soft top lasts that long, and five samples
SOFT_FEWEST, SOFT_SHARE = 8, 0.6  # of the highest crests: what happens to fewer of them is not a ceiling
SQUARE_RUN, SQUARE_EDGE = 8, 2  # a half wave of that many samples, all but so few on top, is a square's
HIGHEST = 8  # crests of a stretch: where one of them is straight, all are looked at
MAX_AT_ONCE = 4_096  # crests of one stretch of samples
MAX_KEPT = 20_000
MAX_SPANS = 1_000
START, TOP, RUN, FALL, FLAT, WIDE, AT_RAIL, HALF_WAVE, CHANNEL, SIGN, FIGURES_KEPT = range(
    11
)  # columns of the crests kept


class FlatTop(NamedTuple):
    """One flat top: from when to when, in which channel (1 is the first), and how high."""

    start_s: float
    end_s: float
    channel: int
    level_dbfs: float


class FlatTops:
    """Looks at the highest crests of each channel, above and below zero.

    Parameters
    ----------
    sample_rate_hz, channels : int
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("clipped_runs", "clipped_spans", "soft_tops", "soft_spans")

    def __init__(self, sample_rate_hz: int, channels: int, step: float) -> None:
        self._rate = sample_rate_hz
        self._grain = GRAIN * step
        self._rail = 1 - max(step, FULL_SCALE)
        self._extremes = np.zeros((channels, 2))  # above and below zero
        self._crests = np.empty((0, FIGURES_KEPT))
        self._found = np.empty((MAX_AT_ONCE, CHANNEL))
        self._straight = StraightTops(step)

    def add(
        self,
        samples: NDArray[np.float64],
        maxima: NDArray[np.float64],
        peaks: NDArray[np.float64],
        first: int,
        frame: int,
    ) -> None:
        """Take the samples from `first` on, shape (channels, n); those before came already.

        `maxima` are those of all samples, `peaks` the highest of each channel, and `first` starts one of their rows;
        `frame` is the position in the whole signal of the first of all samples.
        """
        for channel, (row, peak) in enumerate(zip(samples, peaks.tolist(), strict=True)):
            extremes = self._extremes[channel]
            if peak > extremes.min():
                kernel.extremes(row, maxima[channel], first // ROW_FRAMES, extremes)
            for sign, extreme in zip((1.0, -1.0), extremes.tolist(), strict=True):
                if extreme > 0 and peak >= extreme * (1 - SOFT_CEILING):  # else no crest here is high
                    self._look(row, maxima[channel], first, frame, channel, sign, extreme)

    def result(self) -> dict[str, Any]:
        """Return `clipped_runs` and `soft_tops`, how many there are, and the spans of the first 1,000 of each."""
        sides = (2 * self._crests[:, CHANNEL] + (self._crests[:, SIGN] < 0)).astype(np.intp)
        extremes = self._extremes.ravel()[sides]
        highest = self._crests[:, TOP] >= extremes * (1 - SOFT_CEILING)
        crests, sides, extremes = self._crests[highest], sides[highest], extremes[highest]
        square = (crests[:, FLAT] >= SQUARE_RUN) & (crests[:, HALF_WAVE] - crests[:, FLAT] <= SQUARE_EDGE)
        grains = np.maximum(self._grain, SHARE * crests[:, TOP])
        round_falls = ROUND * grains * np.square(1 + 4 / np.maximum(crests[:, RUN] - 1, 1))
        is_round = (crests[:, FALL] >= grains) & (crests[:, FALL] <= round_falls)
        hard = (crests[:, AT_RAIL] >= SHORTEST_RUN) & (crests[:, RUN] >= SHORTEST_RUN) & ~is_round
        corners = CORNER * grains
        under = (crests[:, RUN] >= SHORTEST_RUN) & (crests[:, FALL] >= corners) & ~square
        under &= crests[:, TOP] >= extremes * (1 - CEILING)
        if under.sum() >= FEWEST:
            hard |= under
        shortest = max(5, round(SOFT_S * self._rate))
        soft = (crests[:, FLAT] >= shortest) & (crests[:, WIDE] <= SOFT_RATIO * crests[:, FLAT]) & ~square
        count = self._extremes.size
        share = SOFT_SHARE * np.bincount(sides, minlength=count)
        soft &= (np.bincount(sides, weights=soft, minlength=count) >= np.maximum(SOFT_FEWEST, share))[sides] & ~hard
        clipped = crests[hard]
        straight = self._straight.result()
        if len(straight) > len(clipped):
            clipped = np.zeros((len(straight), FIGURES_KEPT))
            clipped[:, [START, RUN, TOP, SIGN, CHANNEL]] = straight
        return {
            "clipped_runs": len(clipped),
            "clipped_spans": self._spans(clipped, RUN),
            "soft_tops": int(soft.sum()),
            "soft_spans": self._spans(crests[soft], FLAT),
        }

    def _look(
        self,
        row: NDArray[np.float64],
        maxima: NDArray[np.float64],
        first: int,
        frame: int,
        channel: int,
        sign: float,
        extreme: float,
    ) -> None:
        least = extreme * (1 - SOFT_CEILING)
        shape = np.array([sign, least * SOFT_WIDE, least, self._rail, self._grain, SHARE, SOFT_FLAT, SOFT_WIDE])
        crest_count = kernel.crests(row, maxima, first, shape, self._found)
        if not crest_count:
            return
        highest = self._found[np.argsort(-self._found[:crest_count, TOP])[:HIGHEST], START]
        self._straight.add(row, maxima, highest, first, frame, channel, sign, extreme)
        if len(self._crests) >= MAX_KEPT:
            return
        crests = np.empty((crest_count, FIGURES_KEPT))
        crests[:, :CHANNEL] = self._found[:crest_count]
        crests[:, START] += frame
        crests[:, CHANNEL], crests[:, SIGN] = channel, sign
        self._crests = np.concatenate((self._crests, crests))

    def _spans(self, crests: NDArray[np.float64], length: int) -> tuple[FlatTop, ...]:
        """Return the first of these crests, `length` being the column with the length of each flat part."""
        first = crests[np.lexsort((crests[:, CHANNEL], crests[:, START]))[:MAX_SPANS]]
        return tuple(
            FlatTop(
                crest[START] / self._rate,
                (crest[START] + crest[length]) / self._rate,
                int(crest[CHANNEL]) + 1,
                decibels(crest[TOP]),
            )
            for crest in first.tolist()
        )
