"""Rendering beside soxr's best: speed, and what is left at the edge of the band."""

from pathlib import Path

import numpy as np

from audio_checks.render.resample import resample
from benchmarks import peers
from benchmarks.rows import Row
from benchmarks.timing import in_turns, own_cpu
from tests.support.waves import noise, sine


def rows(_folder: Path, quick: bool) -> list[Row]:
    """Bring noise and a tone from 96 to 44.1 kHz."""
    soxr = peers.module("soxr")
    if soxr is None:
        return [Row("96 → 44.1 kHz", None, must=0.5, stretch=1, missing="soxr is not installed")]
    samples = noise(seconds=20, dbfs=-12, rate=96_000)
    works = {
        "ours": own_cpu(lambda: resample(samples, 96_000, 44_100)),
        "soxr": own_cpu(lambda: soxr.resample(samples, 96_000, 44_100, quality="VHQ")),
    }
    took = in_turns(works, 3 if quick else 7)
    ours, theirs = (f"{took[name]:.3f} s" for name in works)
    edge = sine(hz=0.95 * 22_050, dbfs=-6, seconds=2, rate=96_000)
    kept = _level_db(resample(edge, 96_000, 44_100)) + 6
    by_soxr = _level_db(soxr.resample(edge, 96_000, 44_100, quality="VHQ")) + 6
    what = "96 → 44.1 kHz, 20 s mono in float64"
    return [
        Row(what, took["soxr"] / took["ours"], "×", 0.5, 1, "more", ours, f"soxr VHQ: {theirs}"),
        Row("gain at 0.95 of the new Nyquist", kept, "dB", -0.001, None, "more", "", f"soxr VHQ: {by_soxr:.3f} dB"),
    ]


def _level_db(samples: np.ndarray) -> float:
    middle = samples[len(samples) // 4 : 3 * len(samples) // 4]
    return float(20 * np.log10(np.sqrt(2 * np.mean(middle**2))))
