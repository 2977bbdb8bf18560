"""Still runs of a low noise are ruled out together, and never one that might be a hole."""

import numpy as np
import pytest

from audio_checks.measure import dropouts
from audio_checks.measure.faults import Faults

RATE = 44_100
STEP = 2.0**-15


def low_noise(seconds, seed=3):
    """Noise of the last three bits of 16, with a hit every two seconds."""
    draws = np.random.default_rng(seed)
    samples = np.round(draws.standard_normal((RATE * seconds, 1)) * 1.5)
    for second in range(0, seconds, 2):
        hit = draws.standard_normal((RATE // 3, 1)) * np.exp(-np.arange(RATE // 3) / 2_000)[:, np.newaxis]
        samples[second * RATE : second * RATE + len(hit)] += np.round(hit * 6_000)
    return samples * STEP


@pytest.mark.parametrize("seed", range(20))
def test_none_is_ruled_out_that_goes_on_beside(seed):
    draws = np.random.default_rng(seed)
    figures = draws.exponential(1.0, 4_000) * draws.choice([1.0, 1e-4], 4_000, p=[0.9, 0.1])
    starts = np.sort(draws.choice(np.arange(30, 3_900, 60), 50, replace=False))
    runs = np.column_stack((starts, starts + draws.integers(2, 20, len(starts))))
    for start, end in runs[::2]:
        figures[start:end] *= 1e-4
    may = dropouts._may_go_on_beside(figures, runs)
    does = [dropouts._goes_on_beside(figures, figures, np.square(figures), *run) for run in runs.tolist()]
    assert any(does)
    assert not np.any(does & ~may)
    assert not may.all()


def test_a_low_noise_is_not_looked_at_run_by_run(monkeypatch):
    asked = []
    real = dropouts._goes_on_beside
    monkeypatch.setattr(dropouts, "_goes_on_beside", lambda *given: asked.append(given) or real(*given))
    following = Faults(RATE, 1, RATE * 12, step=STEP, detectors=["dropouts"])
    following.add(low_noise(12))
    assert following.result()["dropouts"] == 0
    assert len(asked) < 50  # of some thousand still runs


def test_the_longest_held_part_of_each_run_is_found():
    steps = np.ones(200)
    steps[50:60] = [0, 0, 1e-3, 0, 0, 0, 1e-3, 0, 0, 1e-3]  # the longest has three cells
    steps[90:93] = 0  # held throughout: the run itself was looked at
    steps[120:124] = [0, 1e-3, 0, 1e-3]  # never held for two cells
    steps[150:153] = [1e-3, 0, 0]
    steps[153:] = 1e-3  # no sound goes on after it
    runs = np.array([[50, 60], [90, 93], [120, 124], [150, 153]])
    assert dropouts._longest_held(steps, runs, 1e-3) == {50: (53, 56)}
    assert dropouts._longest_held(steps, runs[:0], 1e-3) == {}
