"""Compares the reverb of a take with an earlier one of the same sound: which of the two has more, and by how much."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, Judgement
from audio_checks.judge.compare.dry_stem import compare_reverb_with_dry
from audio_checks.measure.decay import DecayFigures
from audio_checks.measure.tails import decay_curves

MORE, LESS, AS_MUCH = "more reverb", "less reverb", "as much reverb"


def compare_reverb_of_takes(path: str | os.PathLike[str], earlier_path: str | os.PathLike[str]) -> Judgement:
    """Judge whether a take has more reverb than an earlier one, or less.

    Parameters
    ----------
    path, earlier_path : path
        Two takes of one cue.

    Returns
    -------
    Judgement
        `more reverb` or `less reverb`, with `rt60_s` and `wet_db` of what was added or taken away, see
        `compare_reverb_with_dry`; `as much reverb`; or `cannot tell` where they are not the same sound, have two sample
        rates, or either is silent. Its evidence are the decay times by octave, in seconds, of both.

    Raises
    ------
    Unreadable
        Either file breaks a rule of structure.

    Notes
    -----
    Spectra are divided one way, since a tail that was taken away has no plain response: the sound whose energy comes
    later on the whole (centre time, ISO 3382-1, A.2.4) is compared with the other.
    """
    now, before = _decay_of(path), _decay_of(earlier_path)
    is_later = _centre_s(now) >= _centre_s(before)
    beside = compare_reverb_with_dry(path, earlier_path) if is_later else compare_reverb_with_dry(earlier_path, path)
    verdict = {"reverb": MORE if is_later else LESS, "dry": AS_MUCH}.get(beside.verdict, CANNOT_TELL)
    return Judgement(verdict, beside.score, beside.figures, {"bands": _bands(now, before)})


def _decay_of(path: str | os.PathLike[str]) -> DecayFigures:
    with AudioFile(path) as file:
        file.prepare(["decay"])
        return file.measurements.decay


def _centre_s(decay: DecayFigures) -> float:
    """Return the centre time of a sound's energy, from its beginning; 0 for silence."""
    powers = np.nansum(decay.energies, axis=1)
    total = float(powers.sum())
    return float((np.arange(len(powers)) * powers).sum()) * decay.hop_s / total if total else 0.0


def _bands(now: DecayFigures, before: DecayFigures) -> list[dict[str, Any]]:
    """Return the decay times by octave of both, where either has one."""
    times, earlier = _times_of(now), _times_of(before)
    bands = [
        {"hz": hz, "rt60_s": times.get(hz), "earlier_rt60_s": earlier.get(hz)} for hz in sorted({*times, *earlier})
    ]
    return [band for band in bands if band["rt60_s"] is not None or band["earlier_rt60_s"] is not None]


def _times_of(decay: DecayFigures) -> dict[float, float | None]:
    curves = decay_curves(decay)
    return {band["hz"]: band["rt60_s"] for band in curves["bands"]} if curves else {}
