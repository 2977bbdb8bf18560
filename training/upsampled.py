"""Learns the weights of the judgement `upsampled`, and writes them and the table of how good they are.

`make weights` (`python -m training.upsampled`) makes sounds at their own rate, and others at a lower one that steep
resamplers of several kinds bring up; it learns, sets the threshold, and tries the result on families of sources that
were kept apart and on a resampler that nothing was learned from.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import signal
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.metrics import roc_auc_score

from audio_checks.judge import upsampled as judgement
from audio_checks.measure import cliff
from audio_checks.measure.spectrum import Spectrum
from training import dataset
from training.reverb import numbers_of
from training.shapes import Draws, Family, log_uniform
from training.tables import as_table, write_tables

Floats = NDArray[np.float64]
FALSE_ALARMS = 0.01  # half of what is allowed
LONGEST_S = 3.0
FOLDS = 5
TREES = {"max_leaf_nodes": 8, "max_iter": 120, "learning_rate": 0.06, "min_samples_leaf": 20}
FROM_HZ = {44_100: (16_000, 22_050, 24_000, 32_000), 48_000: (16_000, 22_050, 24_000, 32_000, 44_100)}
FROM_HZ[96_000] = (22_050, 24_000, 32_000, 44_100, 48_000)
RESAMPLERS = ("kaiser", "fourier")
KEPT_APART_RESAMPLER = "windowed sinc"


@dataclass(frozen=True)
class Made:
    """How some sounds are made."""

    count: int
    seed: int
    is_kept_apart: bool = False


@dataclass(frozen=True)
class Known:
    """What is known of one sound."""

    source: str
    from_hz: int | None  # None: made at the file's own rate
    rate_hz: int


LEARNING = Made(1600, 71)
TRIED = {"development": Made(300, 72), "kept apart": Made(700, 73, is_kept_apart=True)}


@dataclass
class Set:
    """Some sounds: what is known of each, and the features and the place of its cliff."""

    known: list[Known]
    features: Floats
    edges_hz: Floats

    @property
    def positive(self) -> NDArray[np.bool_]:
        return np.array([one.from_hz is not None for one in self.known])

    def where(self, kept: NDArray[np.bool_]) -> "Set":
        known = [one for one, wanted in zip(self.known, kept, strict=True) if wanted]
        return Set(known, self.features[kept], self.edges_hz[kept])


def measured(made: Made) -> Set:
    """Make some sounds, and return what is known and measured of each."""
    families = dataset.families(is_kept_apart=made.is_kept_apart)
    resamplers = (KEPT_APART_RESAMPLER,) if made.is_kept_apart else RESAMPLERS
    known, features, edges = [], [], []
    for number in range(made.count):
        draws = np.random.default_rng([made.seed, number])
        one, samples, step = _made(draws, families[draws.integers(len(families))], resamplers)
        spectrum = Spectrum(one.rate_hz, 1, len(samples), step=step)
        spectrum.add(samples[:, np.newaxis])
        found = cliff.cliff_of(spectrum.result()["mean_spectrum"])
        if found is not None:
            known.append(one)
            features.append(found.features)
            edges.append(found.edge_hz)
    return Set(known, np.array(features), np.array(edges))


def _made(draws: Draws, family: Family, resamplers: Sequence[str]) -> tuple[Known, Floats, float]:
    """Return a sound, made at its own rate or brought up, and the smallest step of its file."""
    rate_hz = int(draws.choice(list(FROM_HZ)))
    from_hz = int(draws.choice(FROM_HZ[rate_hz])) if draws.random() < 0.5 else None
    x = family.make(draws, from_hz or rate_hz)[: int(LONGEST_S * (from_hz or rate_hz))]
    x = x / (np.abs(x).max() + 1e-12) * 10 ** (-draws.uniform(1, 18) / 20)
    if draws.random() < 0.5:  # a recorder's own noise
        x = x + draws.standard_normal(len(x)) * 10 ** (-draws.uniform(70, 100) / 20)
    if draws.random() < 0.3:
        corner = log_uniform(draws, 2_000, 7_000)
        x = signal.sosfilt(signal.butter(int(draws.integers(1, 5)), corner, fs=from_hz or rate_hz, output="sos"), x)
    if draws.random() < 0.7 or from_hz is None:  # it was a file before, dithered or not
        x = _rounded(draws, x, 16 if draws.random() < 0.5 else 24)
    if from_hz is not None:
        x = _brought_up(draws, x, from_hz, rate_hz, resamplers[draws.integers(len(resamplers))])
        x = x * 10 ** (draws.uniform(-6, 0) / 20)
    bits = 24 if draws.random() < 0.75 else 16
    return Known(family.name, from_hz, rate_hz), _rounded(draws, x, bits), 2.0 ** (1 - bits)


def _rounded(draws: Draws, x: Floats, bits: int) -> Floats:
    full = 2.0 ** (bits - 1)
    dither = draws.random(len(x)) - draws.random(len(x)) if draws.random() < 0.6 else 0.0
    return np.clip(np.round(x * full + dither), -full, full - 1) / full


def _brought_up(draws: Draws, x: Floats, from_hz: int, rate_hz: int, way: str) -> Floats:
    """Return a sound at a higher rate, by a resampler of a steepness of its own."""
    shared = np.gcd(from_hz, rate_hz)
    up, down = rate_hz // shared, from_hz // shared
    if way == "fourier":
        return signal.resample(x, round(len(x) * rate_hz / from_hz))
    taps = int(draws.integers(32, 128)) * 2 * max(up, down) // max(1, down // up or 1) + 1
    taps = min(taps, 40_001) | 1
    window = ("kaiser", draws.uniform(8, 14)) if way == "kaiser" else "blackman"
    cutoff = draws.uniform(0.9, 0.99) / max(up, down)
    return signal.resample_poly(x, up, down, window=signal.firwin(taps, cutoff, window=window))


def learned(some: Set) -> HistGradientBoostingClassifier:
    """Return trees that find sounds brought up."""
    trees = HistGradientBoostingClassifier(**TREES, l2_regularization=1.0, early_stopping=False, random_state=1)
    return trees.fit(some.features, some.positive)


def threshold(some: Set) -> list[float]:
    """Return below what a sound is full, and from what on upsampled; set by trees that never met the family."""
    families = np.array([one.source for one in some.known])
    names = sorted(set(families))
    scores = np.zeros(len(families))
    for fold in range(FOLDS):
        held = np.isin(families, names[fold::FOLDS])
        scores[held] = learned(some.where(~held)).predict_proba(some.features[held])[:, 1]
    high = float(np.quantile(scores[~some.positive], 1 - FALSE_ALARMS))
    low = float(np.quantile(scores[some.positive], 0.05))
    return [round(min(low, 0.5), 4), round(max(high, 0.5), 4)]


def figures_on(some: Set) -> dict[str, float]:
    """Return how good the judgement is on some sounds, as it ships."""
    truth = some.positive
    scores = np.array([judgement.score_of(feature) for feature in some.features])
    low, high = judgement.weights()["threshold"]
    positive = scores >= high
    decided = positive | (scores < low)
    rates = [cliff.rate_of(edge, one.rate_hz) for edge, one in zip(some.edges_hz, some.known, strict=True)]
    right = np.array([rate == one.from_hz for rate, one in zip(rates, some.known, strict=True)])
    return {
        "AUC": roc_auc_score(truth, scores),
        "found": positive[truth].mean(),
        "falsely called upsampled": positive[~truth].mean(),
        "right when decided": (positive == truth)[decided].mean(),
        "share decided": decided.mean(),
        "candidate rate is the true one, of those found": right[positive & truth].mean(),
    }


MUST = {"found": 0.80, "falsely called upsampled": -0.02}


def by_family(some: Set) -> str:
    """Return for each family of sources how often it is found, and falsely found."""
    names, truth = np.array([one.source for one in some.known]), some.positive
    positive = (
        np.array([judgement.score_of(feature) for feature in some.features]) >= judgement.weights()["threshold"][1]
    )
    lines = ["| source | sounds | found | falsely called upsampled |", "|---|---|---|---|"]
    for name in sorted(set(names)):
        here = names == name
        lines.append(
            f"| {name} | {here.sum()} | {positive[here & truth].mean():.3f} | {positive[here & ~truth].mean():.3f} |"
        )
    return "\n".join(lines)


def main() -> None:
    """Make, learn, write the weights, try them, and write the tables."""
    learning = measured(LEARNING)
    numbers: dict[str, Any] = {"threshold": threshold(learning), "upsampled": numbers_of(learned(learning))}
    judgement.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")
    tried = {name: measured(made) for name, made in TRIED.items()}
    write_tables(
        {
            "upsampled": as_table({name: figures_on(some) for name, some in tried.items()}, MUST),
            "upsampled by source": by_family(tried["kept apart"]),
        }
    )


if __name__ == "__main__":
    main()
