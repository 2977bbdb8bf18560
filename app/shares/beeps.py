"""Work of the sandbox's child: a preview copied for guests, without metadata, with quiet beeps where wanted."""

import math
import wave

import numpy as np
from numpy.typing import NDArray

from audio_checks import true_peak_dbtp

BEEPS_VERSION = 1  # counts up when the same preview would sound otherwise
BEEP_HZ = 1_000.0
BEEP_S, EDGE_S = 0.15, 0.01
FIRST_S, EVERY_S = 0.5, 4.0
BEEP_DBFS = -30.0
CEILING_DBTP = -1.0
FULL_SCALE = 32_768


def copy_for_guests(path: str, out: str, *, has_beeps: bool) -> None:
    """Write a preview (16-bit WAV) again: its frames alone, as many as they are, with beeps or as they were."""
    with wave.open(path) as file:
        rate_hz, channels = file.getframerate(), file.getnchannels()
        if file.getsampwidth() != 2:
            raise ValueError(f"a preview of {8 * file.getsampwidth()} bits; 16 were wanted")
        frames = np.frombuffer(file.readframes(file.getnframes()), "<i2").reshape(-1, channels)
    if has_beeps and len(frames):
        mixed = with_beeps(frames / FULL_SCALE, rate_hz)
        frames = np.clip(np.round(mixed * FULL_SCALE), -FULL_SCALE, FULL_SCALE - 1).astype("<i2")
    with wave.open(out, "wb") as copy:
        copy.setnchannels(channels)
        copy.setsampwidth(2)
        copy.setframerate(rate_hz)
        copy.writeframes(frames.tobytes())


def with_beeps(samples: NDArray[np.float64], rate_hz: int) -> NDArray[np.float64]:
    """Return samples, shape (frames, channels), with a beep every few seconds, lowered to −1 dBTP where above it.

    A sound that is shorter than the time before the first beep has one at its beginning.
    """
    mixed = samples.copy()
    beep = _beep(rate_hz)
    length_s = len(samples) / rate_hz
    first_s = FIRST_S if length_s > FIRST_S + BEEP_S else 0.0
    for start_s in np.arange(first_s, max(length_s, first_s + EVERY_S / 2), EVERY_S):
        start = round(start_s * rate_hz)
        part = mixed[start : start + len(beep)]
        part += beep[: len(part), np.newaxis]
    peak = true_peak_dbtp(mixed, rate_hz)
    if peak > CEILING_DBTP:
        mixed *= 10 ** ((CEILING_DBTP - peak - 0.01) / 20)  # the hundredth pays for rounding to 16 bits
    return mixed


def _beep(rate_hz: int) -> NDArray[np.float64]:
    times_s = np.arange(round(BEEP_S * rate_hz)) / rate_hz
    edges = np.minimum(1.0, np.minimum(times_s, BEEP_S - times_s) / EDGE_S)
    return 10 ** (BEEP_DBFS / 20) * edges * np.sin(2 * math.pi * BEEP_HZ * times_s)
