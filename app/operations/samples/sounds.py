"""The sounds of the sample project: struck tones, written as 24-bit masters at 48 kHz."""

import io
import wave
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SAMPLE_RATE_HZ = 48_000
ATTACK_S, FADE_S = 0.001, 0.02
PEAK = 0.5  # -6 dBFS
FULL_SCALE = 1 << 23


@dataclass(frozen=True)
class Note:
    """One decaying tone."""

    start_s: float
    frequency_hz: float
    decay_s: float
    level: float = 1.0


SOUNDS: dict[str, tuple[float, tuple[Note, ...]]] = {
    "ui_confirm": (0.4, (Note(0, 880, 0.06), Note(0.07, 1318.5, 0.08))),
    "ui_back": (0.4, (Note(0, 987.8, 0.06), Note(0.07, 659.3, 0.08))),
    "coin_pickup": (0.6, (Note(0, 1975.5, 0.05), Note(0.06, 2637, 0.14), Note(0.06, 5274, 0.05, 0.3))),
    "shield_hit": (0.8, (Note(0, 310, 0.2), Note(0, 752, 0.15, 0.6), Note(0, 1420, 0.08, 0.4), Note(0, 96, 0.1, 0.8))),
    "door_close": (
        0.9,
        (Note(0, 140, 0.12), Note(0, 233, 0.09, 0.5), Note(0.25, 88, 0.16), Note(0.25, 410, 0.04, 0.3)),
    ),
    "radar_ping": (1.2, (Note(0, 1046.5, 0.3), Note(0, 2093, 0.18, 0.25))),
}


def sample_master(name: str) -> bytes:
    """Return the WAV file of one sound, the same bytes each time."""
    duration_s, notes = SOUNDS[name]
    times = np.arange(round(duration_s * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    samples: NDArray[np.float64] = np.zeros(len(times))
    for note in notes:
        since_s = times - note.start_s
        envelope = np.clip(since_s / ATTACK_S, 0, 1) * np.exp(-np.maximum(since_s, 0) / note.decay_s)
        samples += note.level * envelope * np.sin(2 * np.pi * note.frequency_hz * since_s)
    samples *= np.clip((duration_s - times) / FADE_S, 0, 1)
    samples *= PEAK / np.max(np.abs(samples))
    steps = np.round(samples * FULL_SCALE).astype("<i4")
    file = io.BytesIO()
    with wave.open(file, "wb") as writer:
        writer.setnchannels(1)
        writer.setsampwidth(3)
        writer.setframerate(SAMPLE_RATE_HZ)
        writer.writeframes(steps.view(np.uint8).reshape(-1, 4)[:, :3].tobytes())
    return file.getvalue()
