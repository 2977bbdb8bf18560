"""Judges reverb beside a dry stem or an earlier take of the same sound: by what was added, not by guessing."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.judge import CANNOT_TELL, Judgement, kept_score
from audio_checks.measure.response import Response, response_between
from audio_checks.sound_files import open_sound

LONGEST_S = 20.0  # of each sound
FAINTEST_DB = -30.0  # under the direct sound; what is fainter is no reverb that anyone put there
ABOVE_BEFORE_DB = 6.0  # reverb comes after the sound, and what division leaves behind on both sides alike
SAME_DB = -10.0  # before the direct sound there is next to nothing where the two are the same sound
SHORTEST_S = 0.06  # of a tail
NOTHING_DB = 200.0  # what lies as far under or over a sound is no sound at all; samples that are the same divide to it


def reverb_beside(path: str | os.PathLike[str], dry_path: str | os.PathLike[str]) -> Judgement:
    """Judge whether a file is another one with reverb added.

    Parameters
    ----------
    path : path
        The file to judge.
    dry_path : path
        The same sound without: a dry stem, or an earlier take of the same cue.

    Returns
    -------
    Judgement
        `reverb` where a tail was added, with `rt60_s` and `wet_db`, the energy added over that of the sound;
        `dry` where nothing was added that is not in the other file; `cannot tell` where the two are not the
        same sound, or are of two sample rates. Silence has no score.

    Raises
    ------
    Unreadable
        Either file breaks a rule of structure.
    """
    (mine, rate), (other, other_rate) = _read(path), _read(dry_path)
    response = response_between(other, mine, rate) if rate == other_rate else None
    if response is None:
        return Judgement(CANNOT_TELL, None, {"rt60_s": None, "wet_db": None})
    tail_s = 0.005 * len(response.curve_db)
    wet_db, before_db = np.clip((response.wet_db, response.before_db), -NOTHING_DB, NOTHING_DB)
    margin_db = min(wet_db - before_db - ABOVE_BEFORE_DB, wet_db - FAINTEST_DB)
    score = kept_score(float(1 / (1 + np.exp(-np.clip(margin_db, -60, 60) / 3))))
    if response.before_db > SAME_DB:
        verdict = CANNOT_TELL
    elif margin_db > 0 and response.rt60_s is not None and tail_s >= SHORTEST_S:
        verdict = "reverb"
    else:
        verdict = "dry" if response.wet_db < FAINTEST_DB else CANNOT_TELL
    return Judgement(verdict, score, _figures(response, verdict), {"response": _evidence(response)})


def _read(path: str | os.PathLike[str]) -> tuple[NDArray[np.float64], int]:
    with open_sound(Path(path)) as sound:
        blocks, left = [], round(LONGEST_S * sound.layout.sample_rate_hz)
        for block in wav.blocks(sound.file, sound.layout):
            blocks.append(np.array(block[:left]))
            left -= len(blocks[-1])
            if left <= 0:
                break
        return np.concatenate(blocks), sound.layout.sample_rate_hz


def _figures(response: Response, verdict: str) -> dict[str, Any]:
    if verdict != "reverb":
        return {"rt60_s": None, "wet_db": None}
    return {"rt60_s": response.rt60_s and round(response.rt60_s, 2), "wet_db": round(response.wet_db, 1)}


def _evidence(response: Response) -> dict[str, Any]:
    step = max(1, -(-len(response.curve_db) // 60))
    return {"step_s": round(0.005 * step, 3), "curve_db": list(response.curve_db[::step])}
