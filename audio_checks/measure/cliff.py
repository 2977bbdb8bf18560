"""The end of a spectrum, and its steepness: features of a sound that was upsampled."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.spectrum import MeanSpectrum

Floats = NDArray[np.float64]
RATES_HZ = (8_000, 11_025, 16_000, 22_050, 24_000, 32_000, 44_100, 48_000, 88_200, 96_000)
LOWEST_HZ = 2_500.0  # below, a cliff is a filter of the designer's
GAP, SPAN = 0.04, 0.06  # of the edge's frequency: what the cliff itself takes, and what is looked at on either side
COMES_BACK_DB = 6.0  # over the shelf above the edge: then it is a notch, and no end
FEWEST_BINS = 256
SHOWN_POINTS = 192
# A resampler's pass band ends between 0.86 and just over 1 of the lower Nyquist frequency.
PASS_BAND, USUAL_END = (0.86, 1.02), 0.99


@dataclass(frozen=True)
class Cliff:
    """The steepest end that a spectrum has.

    Attributes
    ----------
    edge_hz : float
        Where it is.
    drop_db : float
        From the level just below it to the level just above.
    """

    edge_hz: float
    drop_db: float
    features: Floats


def cliff_of(spectrum: MeanSpectrum) -> Cliff | None:
    """Return the steepest end of a spectrum; None for silence, and for what is too short for 256 bins.

    Its features, in this order: the drop in dB; how far the edge lies below the file's own Nyquist frequency; how much
    the spectrum falls on its own just below the edge; how uneven the shelf above is; how far the shelf lies over the
    dither, and what lies below the edge; how near the edge is to where a common rate would put it.
    """
    if len(spectrum.levels_db) < FEWEST_BINS or not np.isfinite(spectrum.levels_db).any():
        return None
    levels = _smooth(spectrum.levels_db)
    nyquist_hz = spectrum.sample_rate_hz / 2
    bin_hz = nyquist_hz / (len(levels) - 1)
    places = np.arange(math.ceil(LOWEST_HZ / bin_hz), int(len(levels) / (1 + GAP + SPAN)))
    rest = np.maximum.accumulate(levels[::-1])[::-1]  # the most that any higher bin has
    all_below, all_above = _beside(levels, places)
    ends = rest[places + _reach(places, GAP)] <= all_above + COMES_BACK_DB
    if not ends.any():
        return None
    best = int(np.argmax(np.where(ends, all_below - all_above, -math.inf)))
    edge_bin, below, above = int(places[best]), float(all_below[best]), float(all_above[best])
    drop_db = below - above
    edge_hz = edge_bin * bin_hz
    gap = int(_reach(edge_bin, GAP))
    start = edge_bin - int(_reach(edge_bin, 0.3))
    further = float(levels[start : max(start + 1, edge_bin - int(_reach(edge_bin, 0.2)))].mean())
    shelf = levels[edge_bin + gap :]
    features = np.array(
        [
            drop_db,
            edge_hz / nyquist_hz,
            further - below,
            float(shelf.std()),
            above - spectrum.dither_db,
            below - spectrum.dither_db,
            _off_a_rate(edge_hz, spectrum.sample_rate_hz),
            float(levels.max()) - above,
        ]
    )
    return Cliff(_half_way(levels, edge_bin, gap, (below + above) / 2) * bin_hz, drop_db, features)


def rate_of(edge_hz: float, sample_rate_hz: int) -> int | None:
    """Return the common rate, below the file's own, whose resampler would end nearest to where a spectrum does."""
    fitting = {
        abs(edge_hz / (rate_hz / 2) - USUAL_END): rate_hz
        for rate_hz in RATES_HZ
        if rate_hz < sample_rate_hz * 0.95 and PASS_BAND[0] <= edge_hz / (rate_hz / 2) <= PASS_BAND[1]
    }
    return fitting[min(fitting)] if fitting else None


def points_of(spectrum: MeanSpectrum) -> dict[str, Any]:
    """Return a spectrum as a picture shows it: the level of equal steps of frequency, from 0 Hz to Nyquist."""
    levels = highest_of_parts(spectrum.levels_db, min(SHOWN_POINTS, len(spectrum.levels_db)))
    step_hz = spectrum.sample_rate_hz / 2 / len(levels)
    return {"step_hz": round(step_hz, 2), "dbfs": [round(max(level, -160.0), 1) for level in levels]}


def highest_of_parts(values: Floats, count: int) -> list[float]:
    """Return the highest value of each of as many parts, as alike in length as `np.array_split` makes them."""
    each, longer = divmod(len(values), count)
    starts = np.arange(count) * each + np.minimum(np.arange(count), longer)
    highest: list[float] = np.maximum.reduceat(values, starts).tolist()
    return highest


def _smooth(levels: Floats) -> Floats:
    """Return levels without the ripple of single bins."""
    power = np.convolve(10 ** (np.maximum(levels, -300.0) / 10), np.ones(5) / 5, mode="same")
    smooth: Floats = 10 * np.log10(power + 1e-30)
    return smooth


def _reach(places: int | NDArray[np.int64], share: float) -> NDArray[np.int64]:
    """Return a share of each place in whole bins, at least one."""
    return np.maximum(1, np.rint(places * np.float64(share)).astype(np.int64))


def _beside(levels: Floats, places: NDArray[np.int64]) -> tuple[Floats, Floats]:
    """Return the mean levels just below and just above each place."""
    sums = np.concatenate(((0.0,), np.cumsum(levels)))
    gap, span = _reach(places, GAP / 2), _reach(places, SPAN)
    below = (sums[places - gap] - sums[places - gap - span]) / span
    above = (sums[places + gap + span] - sums[places + gap]) / span
    return below, above


def _half_way(levels: Floats, edge_bin: int, gap: int, middle_db: float) -> int:
    """Return the last bin around a cliff that is above its middle."""
    start = edge_bin - gap
    above = np.flatnonzero(levels[start : edge_bin + gap + 1] > middle_db)
    return start + int(above[-1]) if len(above) else edge_bin


def _off_a_rate(edge_hz: float, sample_rate_hz: int) -> float:
    """Return the distance of an edge from 0.95 of the nearest lower Nyquist frequency, as a share."""
    lower = [rate / 2 for rate in RATES_HZ if rate < sample_rate_hz * 0.95]
    return min((abs(edge_hz / nyquist - 0.95) for nyquist in lower), default=1.0)
