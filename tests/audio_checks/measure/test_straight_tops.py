"""Straight tops: what leans, was ridden or changed its rate after it was cut off; waves of steps are none."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import butter, resample_poly, sosfilt

from audio_checks.measure.faults import Faults

RATE = 48_000
TIMES = np.arange(RATE) / RATE
Wave = NDArray[np.float64]


def runs(wave: Wave, step: float = 2.0**-23, size: int = RATE):
    """The tops that are found, and where the first of them are, in seconds."""
    samples = (np.round(wave * 0.7 / np.abs(wave).max() / step) * step)[:, np.newaxis]
    meter = Faults(RATE, 1, len(samples), step=step, detectors=["flat_tops"])
    for start in range(0, len(samples), size):
        meter.add(samples[start : start + size])
    figures = meter.result()
    return figures["clipped_runs"], figures["clipped_spans"]


def voice(hz: float = 130.0) -> Wave:
    """Two gliding partials whose sum has crests of many heights."""
    turns = 2 * np.pi * (hz * TIMES + 6 * np.sin(2 * np.pi * 1.3 * TIMES))
    return np.sin(turns) + 0.7 * np.sin(3.02 * turns + 1)


def low_cut(wave: Wave, hz: float = 20.0) -> Wave:
    return sosfilt(butter(1, hz, "high", fs=RATE, output="sos"), wave)


def ridden(wave: Wave) -> Wave:
    return wave * 10 ** (3 * np.sin(2 * np.pi * 1.1 * TIMES) / 20)


def clipped(wave: Wave, drive_db: float = 6.0) -> Wave:
    return np.clip(wave / np.abs(wave).max() * 10 ** (drive_db / 20), -1, 1)


def converted(wave: Wave, drive_db: float | None = None) -> Wave:
    """Brought down from twice the rate, where it was cut off."""
    loud = resample_poly(wave, 2, 1)
    return resample_poly(loud if drive_db is None else clipped(loud, drive_db), 1, 2)


def tops_of(wave: Wave, drive_db: float) -> list[tuple[int, int]]:
    """First and last sample of each stretch of three or more that is cut off."""
    over = np.abs(clipped(wave, drive_db)) == 1
    over[[0, -1]] = False
    edges = np.flatnonzero(np.diff(over.astype(int)))
    pairs = [(int(first) + 1, int(last)) for first, last in edges.reshape(-1, 2)]
    return [(first, last) for first, last in pairs if last - first >= 2]


@pytest.mark.parametrize("drive_db", [3.0, 6.0, 12.0])
@pytest.mark.parametrize("after", [low_cut, ridden])
def test_tops_that_lean_or_differ_in_height_are_found_to_the_sample(after, drive_db: float):
    tops = tops_of(voice(), drive_db)
    count, spans = runs(after(clipped(voice(), drive_db)))
    assert 0.85 * len(tops) <= count <= len(tops)
    for span in spans:
        first, last = min(tops, key=lambda top: abs(top[0] - span.start_s * RATE))
        assert abs(span.start_s * RATE - first) <= 1
        assert abs(span.end_s * RATE - 1 - last) <= 1


@pytest.mark.parametrize("size", [1_000, 7_777])
def test_they_are_the_same_whatever_the_blocks(size: int):
    leaning = low_cut(clipped(voice()))
    assert runs(leaning, size=size) == runs(leaning)


def test_one_side_that_leans_is_reported_with_its_level():
    cut = low_cut(np.minimum(voice(), 0.8), 5)
    _, spans = runs(cut)
    heights = [cut[round(span.start_s * RATE)] / np.abs(cut).max() * 0.7 for span in spans]
    assert len(spans) > 50
    assert min(heights) > 0.2
    assert [span.level_dbfs for span in spans] == pytest.approx(20 * np.log10(heights), abs=1)


def test_ripples_on_the_tops_come_of_a_converter():
    tops = tops_of(voice(), 6)
    count, spans = runs(converted(voice(), 6))
    assert 0.4 * len(tops) <= count <= len(tops)
    for span in spans:
        middle = (span.start_s + span.end_s) / 2 * RATE
        assert any(first - 2 <= middle <= last + 2 for first, last in tops)


def square(hz: float) -> Wave:
    return np.where((hz * TIMES) % 1 < 0.5, 1.0, -1.0)


def held(wave: Wave, samples: int) -> Wave:
    return np.repeat(wave[::samples], samples)[: len(wave)]


SLOPE = 2 * np.abs(2 * ((97.3 * TIMES) % 1) - 1) - 1
LET_THROUGH = {
    "a voice": low_cut(voice()),
    "a ridden voice": ridden(voice()),
    "a converted voice": converted(voice()),
    "a soft voice": np.tanh(1.5 * voice()),
    "noise": np.random.default_rng(3).standard_normal(RATE),
    "a square through a low cut": low_cut(square(220.7)),
    "squares of a chord": low_cut(square(220.7) + 0.8 * square(331.9) + 0.6 * square(417.3)),
    "a sawtooth": low_cut(2 * ((97.3 * TIMES) % 1) - 1),
    "a triangle": low_cut(SLOPE),
    "a triangle of 16 steps": low_cut(np.round(SLOPE * 7.5) / 7.5),
    "a folded sine": np.abs((4 * np.sin(2 * np.pi * 110 * TIMES) - 1) % 4 - 2) - 1,
    "a voice held for 7 samples": low_cut(held(voice(), 7)),
    "a voice of 5 bits": ridden(np.round(voice() * 8) / 8),
    "a polygon": ridden(np.interp(TIMES, TIMES[::9], voice()[::9])),
    "a square through a high cut": sosfilt(butter(1, 4_000, fs=RATE, output="sos"), square(220.7)),
}


@pytest.mark.parametrize("name", LET_THROUGH)
def test_what_nothing_cut_off_is_let_through(name: str):
    assert runs(LET_THROUGH[name]) == (0, ())


def test_a_few_by_chance_are_none():
    wave = voice()
    for top in tops_of(wave, 6)[40:43]:
        wave[top[0] : top[1] + 1] = np.linspace(wave[top[0]], wave[top[1]], top[1] - top[0] + 1)
    assert runs(ridden(wave))[0] == 0
