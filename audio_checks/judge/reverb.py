"""`reverb`: whether reverb has been put on a sound.

Goes by how the bands of the sound fall (never faster than a room lets them), by what its tail is made of
compared with its head (smoother, alike in spectrum, less alike left and right), and by how full its gaps are.
Boosted trees and small nets weigh these, learned from sounds and rooms made by our own code; further trees, learned
from recordings in measured rooms, weigh the same and what the first models say (`make weights`). The score is the
share of such recordings that have reverb. How sure it must be is set for each kind of sound, and higher for the layout
and length of decay of dry sounds that would be named otherwise.

A single burst of noise may be its own tail: for mono bursts and long natural decays the answer is often
"cannot tell". `docs/reference/judgements.md` has the table of how often it is right, and where it fails.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, Judgement, truncated_score
from audio_checks.judge.compare.dry_stem import compared_with_dry
from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure.decay import DecayFigures
from audio_checks.measure.tails import decay_curves, features_of, likeness_of_sides

FIGURES = ("decay",)
WEIGHTS = Path(__file__).with_suffix(".json")
REVERB, LIKELY, DRY = "reverb", "likely reverb", "dry"
SHORTEST_RT60_S, LONGEST_RT60_S = 0.1, 6.0
KNEE = 1.0  # of the logit: beyond, the share of sounds with reverb rises faster
LONG_FROM_S = 0.8  # of a decay time that is long


def judge(file: AudioFile, kind: str | None) -> Judgement:
    """Return whether a file carries reverb: `reverb`, `likely reverb`, `cannot tell` or `dry`, `rt60_s` unless dry.

    Silence, and what is shorter than 40 ms, has no score and no verdict. Where the file has a dry stem, it is
    compared with that; see `compared_with_dry`.
    """
    judgement = judge_decay(file.measurements.decay, kind)
    return judgement if file.dry is None else compared_with_dry(judgement, file.path, file.dry)


def judge_decay(decay: DecayFigures, kind: str | None) -> Judgement:
    """Return the judgement of what was measured of a sound; see `judge`."""
    features = features_of(decay)
    if features is None:
        return Judgement(CANNOT_TELL, None, {"rt60_s": None})
    score, rt60_s = score_of(features), rt60_of(features)
    verdict = limits_of(kind, "mono" if decay.sides is None else "stereo", rt60_s).verdict(score)
    figures = {"rt60_s": None if verdict == DRY else round(rt60_s, 2)}
    return Judgement(verdict, truncated_score(score), figures, evidence_of(decay))


class Limits(NamedTuple):
    """Scores under which a sound is dry, from which on it likely has reverb, and from which on it has."""

    dry_below: float
    likely_from: float
    reverb_from: float

    def verdict(self, score: float) -> str:
        """Return the meaning of a score, 0..1."""
        if score >= self.reverb_from:
            return REVERB
        if score >= self.likely_from:
            return LIKELY
        return DRY if score < self.dry_below else CANNOT_TELL


def limits_of(kind: str | None, layout: str, rt60_s: float) -> Limits:
    """Return the limits of a sound's score.

    `kind` None is unknown, `layout` is "mono" or "stereo", and `rt60_s` what `rt60_of` says, in seconds.
    """
    length = "long" if rt60_s >= LONG_FROM_S else "short"
    return Limits(*weights()["thresholds"][kind or "unknown"][layout][length])


def score_of(features: NDArray[np.float64]) -> float:
    """Return the certainty that a sound of these features has reverb, 0..1."""
    first = logit_by(_trees("reverb"), _nets(), weights()["nets_share"], features)
    logit = logit_on_top(_trees("recorded"), weights()["recorded_share"], first, features)
    return calibrated(logit, weights()["score_line"])


def logit_on_top(trees: Trees, share: float, first: float, features: NDArray[np.float64]) -> float:
    """Return the logit to which the trees add their share (0..1) and the first models the rest."""
    return (1 - share) * first + share * trees.sum(np.append(features, first))


def calibrated(logit: float, line: Sequence[float]) -> float:
    """Return the share of sounds of such a logit that have reverb, 0..1.

    `line` has the offset and slope of that share's logit, and what is added to the slope beyond the knee.
    """
    offset, slope, beyond = line
    return logistic(offset + slope * logit + beyond * max(0.0, logit - KNEE))


def logit_by(trees: Trees, nets: Nets, nets_share: float, features: NDArray[np.float64]) -> float:
    """Return the logit of the first models, to which the nets add their share (0..1) and the trees the rest."""
    return (1 - nets_share) * trees.sum(features) + nets_share * nets.mean(features)


def logistic(logit: float) -> float:
    """Return a logit as a score, 0..1."""
    return 1 / (1 + math.exp(-logit))


def rt60_of(features: NDArray[np.float64]) -> float:
    """Return the time in which the reverb of a sound of these features falls by 60 dB, in seconds."""
    return rt60_by(_trees("rt60"), weights()["rt60_line"], features)


def rt60_by(trees: Trees, line: Sequence[float], features: NDArray[np.float64]) -> float:
    """Return the decay time that the trees estimate, within the range of reverb, in seconds.

    `line` has offset and slope of what is estimated of recordings, as a power of two.
    """
    offset, slope = line
    return float(np.clip(2 ** (offset + slope * trees.sum(features)), SHORTEST_RT60_S, LONGEST_RT60_S))


def evidence_of(decay: DecayFigures) -> dict[str, Any]:
    """Return a picture's content: energy decay curves by octave, their decay times, the likeness of left and right."""
    return {"decay": decay_curves(decay), "coherence": likeness_of_sides(decay)}


@cache
def weights() -> dict[str, Any]:
    """Return the learned values: trees, nets and thresholds."""
    learned: dict[str, Any] = json.loads(WEIGHTS.read_text(encoding="ascii"))
    return learned


@cache
def _trees(name: str) -> Trees:
    return Trees(weights()[name])


@cache
def _nets() -> Nets:
    return Nets(weights()["nets"])
