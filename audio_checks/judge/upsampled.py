"""`upsampled`: whether a sound was brought up from a lower sample rate.

Goes by where its spectrum ends and how steeply, by how even and how near the dither the rest above is, and by whether
the end is where the resampler of a common rate would put it. Boosted trees weigh these; they were learned from sounds
made at their own rate and others brought up by steep resamplers (`make weights`).

A dark sound whose spectrum ends long before any resampler would cut it has no verdict. A library sound pitched down, or
a vintage source, ends as steeply, somewhere else: the candidate rate is None there, and it is a question, not a fault.
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
from audio_checks.measure.cliff import cliff_of, points_of, rate_of
from audio_checks.measure.spectrum import MeanSpectrum

FIGURES = ("bandwidth_hz", "mean_spectrum")
WEIGHTS = Path(__file__).with_suffix(".json")


def judge(file: AudioFile, kind: str | None) -> Judgement:
    """Return whether a file was brought up: `upsampled`, `full` or `cannot tell`, with `from_hz`, the candidate rate.

    Silence, and what is shorter than 512 frames, has no score and no verdict.
    """
    return judge_spectrum(file.measurements.mean_spectrum)


def judge_spectrum(spectrum: MeanSpectrum) -> Judgement:
    """Return the judgement of what was measured of a sound; see `judge`."""
    cliff = cliff_of(spectrum)
    if cliff is None:
        return Judgement(CANNOT_TELL, None, {"from_hz": None, "edge_hz": None, "drop_db": None})
    score = score_of(cliff.features)
    full_below, upsampled_above = weights()["threshold"]
    verdict = "upsampled" if score >= upsampled_above else "full" if score < full_below else CANNOT_TELL
    from_hz = rate_of(cliff.edge_hz, spectrum.sample_rate_hz) if verdict == "upsampled" else None
    figures = {"from_hz": from_hz, "edge_hz": round(cliff.edge_hz), "drop_db": round(cliff.drop_db, 1)}
    return Judgement(verdict, truncated_score(score), figures, {"spectrum": points_of(spectrum)})


def score_of(features: NDArray[np.float64]) -> float:
    """Return the certainty that a spectrum with a cliff of these features was brought up, 0..1."""
    return 1 / (1 + math.exp(-_trees().sum(features)))


@cache
def weights() -> dict[str, Any]:
    """Return the learned values: trees and the threshold."""
    learned: dict[str, Any] = json.loads(WEIGHTS.read_text(encoding="ascii"))
    return learned


@cache
def _trees() -> Trees:
    return Trees(weights()["upsampled"])
