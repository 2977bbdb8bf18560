"""Judges reverb by comparison with a dry stem or an earlier take of the same sound."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.audio_file import DryStem
from audio_checks.audio.sound_files import open_sound
from audio_checks.errors import Unreadable
from audio_checks.judge import CANNOT_TELL, Judgement, truncated_score
from audio_checks.measure.response import Response, response_between

LONGEST_S = 20.0  # of each sound
MOST_FRAMES, MOST_SAMPLES = 2_000_000, 4_000_000  # of each: 20 s of stereo at 96 kHz, less of what has more
FAINTEST_DB = -30.0  # under the direct sound; what is fainter is no reverb that anyone put there
ABOVE_BEFORE_DB = 6.0  # reverb comes after the sound, and what division leaves behind on both sides alike
SAME_DB = -10.0  # before the direct sound there is next to nothing where the two are the same sound
SHORTEST_S = 0.06  # of a tail
NO_SIGNAL_DB = 200.0  # parts as far under or over a sound count as silence; equal samples divide to it


def compare_reverb_with_dry(path: str | os.PathLike[str], dry_path: str | os.PathLike[str]) -> Judgement:
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
        same sound, are of two sample rates, or what was added is too faint or too short, with `why` in words.
        Silence has no score.

    Raises
    ------
    Unreadable
        Either file breaks a rule of structure.
    """
    (mine, rate), (other, other_rate) = _read(path), _read(dry_path)
    if rate != other_rate:
        return _undecided(None, f"the one has {rate:,} Hz and the other {other_rate:,} Hz")
    response = response_between(other, mine, rate)
    if response is None:
        return _undecided(None, "one of the two is silent")
    tail_s = 0.005 * len(response.curve_db)
    wet_db, before_db = np.clip((response.wet_db, response.before_db), -NO_SIGNAL_DB, NO_SIGNAL_DB)
    margin_db = min(wet_db - before_db - ABOVE_BEFORE_DB, wet_db - FAINTEST_DB)
    score = truncated_score(float(1 / (1 + np.exp(-np.clip(margin_db, -60, 60) / 3))))
    if response.before_db > SAME_DB:
        return _undecided(score, "the two are not the same sound")
    if margin_db > 0 and response.rt60_s is not None and tail_s >= SHORTEST_S:
        verdict = "reverb"
    elif response.wet_db < FAINTEST_DB:
        verdict = "dry"
    else:
        return _undecided(score, "what lies between the two is too faint or too short")
    return Judgement(verdict, score, _figures(response, verdict), {"response": _evidence(response)})


def compared_with_dry(alone: Judgement, path: str | os.PathLike[str], dry: DryStem) -> Judgement:
    """Return the judgement of a file compared with its dry stem; of the file alone where that is inconclusive.

    Parameters
    ----------
    alone : Judgement
        Of the file alone; see `judge.reverb`.
    path : path
        The file.
    dry : DryStem
        Its dry stem, which may be anything.

    Returns
    -------
    Judgement
        See `combined_with`. Of a stem that breaks a rule of structure `stem` says so: its verdict is `unreadable`.
    """
    try:
        return combined_with(alone, compare_reverb_with_dry(path, dry.path), dry.name)
    except Unreadable as error:
        stem = {"name": dry.name, "verdict": "unreadable", "why": f"{error}; {error.fix}"}
        return replace(alone, figures={**alone.figures, "stem": stem})


def combined_with(alone: Judgement, compared: Judgement, name: str) -> Judgement:
    """Return the verdict of a comparison where it has one, else that of the file alone.

    Parameters
    ----------
    alone, compared : Judgement
        Of the file alone, and by `compare_reverb_with_dry`.
    name : str
        What the other file is called.

    Returns
    -------
    Judgement
        `stem` holds what the comparison says, `beside` the name where the verdict is the comparison's.
    """
    stem = {"name": name, "verdict": compared.verdict, **compared.figures}
    if compared.verdict == CANNOT_TELL:
        return replace(alone, figures={**alone.figures, "stem": stem})
    figures = {**compared.figures, "beside": name, "stem": stem}
    return Judgement(compared.verdict, compared.score, figures, {**alone.evidence, **compared.evidence})


def _undecided(score: float | None, why: str) -> Judgement:
    return Judgement(CANNOT_TELL, score, {"rt60_s": None, "wet_db": None, "why": why})


def _read(path: str | os.PathLike[str]) -> tuple[NDArray[np.float64], int]:
    with open_sound(Path(path)) as sound:
        most = min(MOST_FRAMES, MOST_SAMPLES // sound.layout.channels)
        blocks, left = [], min(round(LONGEST_S * sound.layout.sample_rate_hz), most)
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
