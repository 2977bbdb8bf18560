"""`lossy`: whether a sound went through a lossy codec before.

Goes by what only a codec does: spectral lines that fall silent together on the frames of MP3, AAC, Vorbis, Opus or
AC-3, and nowhere between. How far the best place for these frames stands out of all others is the evidence; the score
and the limits were learned from sounds that real encoders coded, and sounds that were filtered, brought up, pitched
down or made with few bits (`make weights`).

A low-pass alone is not proof, since resamplers and designers make the same: it is shown, and a sound that has one and
no such lines cannot be detected. High bit rates silence little; pitching or stretching a coded sound hides its frames.
"""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path
from typing import Any

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, Judgement, truncated_score
from audio_checks.measure.cliff import SHOWN_POINTS, Cliff, cliff_of, highest_of_parts, points_of
from audio_checks.measure.codec_frames import Trace
from audio_checks.measure.spectrum import MeanSpectrum

FIGURES = ("codec_traces", "mean_spectrum")
WEIGHTS = Path(__file__).with_suffix(".json")
LOW_PASS_HZ = (10_000.0, 20_600.0)  # between which codecs end, from 64 kbit/s of MP3 to Opus and Vorbis
STEEP_DB = 25.0


def judge(file: AudioFile, kind: str | None) -> Judgement:
    """Return whether a file was coded: `lossy`, `clean` or `cannot tell`, with `codec` and `coded_at_hz` where lossy.

    Silence, what is shorter than 70 ms and what has too few lines over the rounding has no score and no verdict.
    """
    return judge_traces(file.measurements.codec_traces, file.measurements.mean_spectrum)


def judge_traces(traces: tuple[Trace, ...], spectrum: MeanSpectrum) -> Judgement:
    """Return the judgement of what was measured of a sound; see `judge`."""
    low_pass_hz = low_pass_of(cliff_of(spectrum))
    if not traces:
        return Judgement(CANNOT_TELL, None, _figures(None, low_pass_hz))
    best = max(traces, key=lambda trace: trace.contrast)
    score = score_of(best.contrast)
    verdict = verdict_of(score, low_pass_hz)
    figures = _figures(best if verdict == "lossy" else None, low_pass_hz)
    return Judgement(
        verdict, truncated_score(score), figures, {"spectrum": points_of(spectrum), "frames": _shown(best)}
    )


def verdict_of(score: float, low_pass_hz: float | None) -> str:
    """Return the verdict of a score, which is never `clean` of a sound that ends as if it had been coded."""
    clean_below, lossy_above = weights()["threshold"]
    if score >= lossy_above:
        return "lossy"
    return "clean" if score < clean_below and low_pass_hz is None else CANNOT_TELL


def low_pass_of(cliff: Cliff | None) -> float | None:
    """Return the end of a spectrum, in Hz, if it is as steep and placed as a codec's might be; else None."""
    if cliff is None or cliff.drop_db < STEEP_DB or not LOW_PASS_HZ[0] <= cliff.edge_hz <= LOW_PASS_HZ[1]:
        return None
    return cliff.edge_hz


def score_of(contrast: float) -> float:
    """Return the certainty that a sound was coded, 0..1, by the prominence of the best place for a codec's frames."""
    offset, slope = weights()["score"]
    return 1 / (1 + math.exp(-min(offset + slope * contrast, 30.0)))


@cache
def weights() -> dict[str, Any]:
    """Return the learned values: offset and slope of the score, and the threshold."""
    learned: dict[str, Any] = json.loads(WEIGHTS.read_text(encoding="ascii"))
    return learned


def _figures(trace: Trace | None, low_pass_hz: float | None) -> dict[str, Any]:
    return {
        "codec": trace and trace.codec,
        "coded_at_hz": trace and trace.rate_hz,
        "silent_share": trace and round(trace.silent_share, 3),
        "elsewhere_share": trace and round(trace.elsewhere_share, 3),
        "low_pass_hz": low_pass_hz and round(low_pass_hz),
    }


def _shown(trace: Trace) -> dict[str, Any]:
    """Return as a picture shows it: of places for the frames to begin, some in a row in each point, the most silent."""
    shares = [round(share, 3) for share in highest_of_parts(trace.shares, SHOWN_POINTS)]
    return {"codec": trace.codec, "rate_hz": trace.rate_hz, "frame": len(trace.shares), "shares": shares}
