"""A pitched pattern of a cue's own: known again by ear, and the same each time it is made."""

import hashlib

import numpy as np
from numpy.typing import NDArray

from audio_checks.render.twiddles import cos_sin_pi

LOWEST_HZ = 347.0
STEPS = (1.0, 9 / 8, 5 / 4, 3 / 2, 5 / 3, 2.0, 9 / 4, 5 / 2)  # no two of them clash
NOTES = 4
NOTE_S = 0.15
ATTACK_S = 0.002
OVERTONES = ((1.0, 0.0, 0.0), (1.0, 0.5, 0.0), (1.0, 0.0, 0.33), (1.0, 0.3, 0.2))


def pattern(number: str, variation: int, frames: int, sample_rate_hz: int) -> NDArray[np.float64]:
    """Return the pattern of a cue's variation.

    Four notes and a colour come from the cue's number, and each variation begins one note later, so that
    a set is heard as one. Notes begin and end in silence, the last with the file: it loops without a click.

    Parameters
    ----------
    number : str
        Of the cue.
    variation : int
        From 1.
    frames, sample_rate_hz : int
        How long, and how many a second.

    Returns
    -------
    ndarray, shape (frames,)
        Peak 1.0 at most; the same on every machine.
    """
    digest = hashlib.sha256(number.encode("utf-8", "replace")).digest()
    melody = [STEPS[byte % len(STEPS)] for byte in digest[:NOTES]]
    overtones = OVERTONES[digest[NOTES] % len(OVERTONES)]
    count = max(1, round(frames / sample_rate_hz / NOTE_S))
    edges = [frames * note // count for note in range(count + 1)]
    sound = np.zeros(frames)
    for note in range(count):
        span = edges[note + 1] - edges[note]
        hz = LOWEST_HZ * melody[(note + variation - 1) % NOTES]
        sound[edges[note] : edges[note + 1]] = _note(hz, span, sample_rate_hz, overtones)
    return sound


def _note(hz: float, frames: int, sample_rate_hz: int, overtones: tuple[float, ...]) -> NDArray[np.float64]:
    places = np.arange(frames, dtype=np.float64)
    wave = np.zeros(frames)
    for overtone, level in enumerate(overtones, start=1):
        if level and overtone * hz < 0.45 * sample_rate_hz:
            wave = wave + level * cos_sin_pi(2.0 * overtone * hz / sample_rate_hz * places)[1]
    attack = max(1, min(round(ATTACK_S * sample_rate_hz), frames // 4))
    rise = np.minimum((places + 1.0) / attack, 1.0)
    fall = (frames - places) / (frames + 1.0)
    envelope = (1.0 - cos_sin_pi(rise)[0]) * (1.0 - cos_sin_pi(np.minimum(fall * 1.5, 1.0))[0]) / 4.0
    return np.asarray(wave * envelope / sum(overtones), dtype=np.float64)
