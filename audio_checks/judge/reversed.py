"""`reversed`: whether a sound is played backwards.

Goes by how each octave rises against how it falls: what is struck, shot or spoken begins sooner than it ends, in all
octaves at once, and its highs die first. Boosted trees weigh these; they were learned from sounds made by our own code,
half of them turned round (`make weights`).

A sound that is alike from both ends (wind, an engine, a rustle) has no direction, and a riser or a
suck-in that was made to swell looks turned round; `docs/reference/judgements.md` has the table of how often it is
right.
"""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, Judgement, truncated_score
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure.decay import DecayFigures
from audio_checks.measure.turning import features_of, rises_and_falls

FIGURES = ("decay",)
WEIGHTS = Path(__file__).with_suffix(".json")


def judge(file: AudioFile, kind: str | None) -> Judgement:
    """Return whether a file plays backwards: `reversed`, `forwards` or `cannot tell`.

    Silence, and what is shorter than 40 ms, has no score and no verdict.
    """
    return judge_decay(file.measurements.decay, kind)


def judge_decay(decay: DecayFigures, kind: str | None) -> Judgement:
    """Return the judgement of what was measured of a sound; see `judge`."""
    features = features_of(decay)
    if features is None:
        return Judgement(CANNOT_TELL, None)
    score = score_of(features)
    forwards_below, reversed_above = weights()["thresholds"][kind or "unknown"]
    verdict = "reversed" if score >= reversed_above else "forwards" if score < forwards_below else CANNOT_TELL
    return Judgement(verdict, truncated_score(score), evidence={"bands": rises_and_falls(decay)})


def score_of(features: NDArray[np.float64]) -> float:
    """Return the certainty that a sound of these features plays backwards, 0..1."""
    return 1 / (1 + math.exp(-_trees().sum(features)))


@cache
def weights() -> dict[str, Any]:
    """Return the learned values: trees and thresholds."""
    learned: dict[str, Any] = json.loads(WEIGHTS.read_text(encoding="ascii"))
    return learned


@cache
def _trees() -> Trees:
    return Trees(weights()["reversed"])
