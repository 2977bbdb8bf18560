"""Finds a sound among thousands by its loudest moments, of which a few hundred bytes are kept for each."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from audio_checks.audit.fingerprint import Wave
from audio_checks.audit.search import BANDS, MOMENT, cells_of

KEPT = 3  # moments of a sound
ASKED = 6  # moments of the sound that is looked for: a cut or a codec may change which three are the loudest
APART = 8  # frames between two moments
NEAR = 2  # frames on either side of a moment: a cut moves the frames
SCALE = 254.0  # a moment has the length 1, and no value of it is far above one half
MOMENT_BYTES = MOMENT * BANDS
LEAST = 0.6  # of real and generated sounds no changed one had less
MOST_CANDIDATES = 12

Rows = NDArray[np.float32]


def moments_of(wave: Wave) -> bytes:
    """Return the three loudest moments of a sound, 128 bytes each; fewer for a short one.

    Parameters
    ----------
    wave : ndarray, shape (frames,)
        Of a fingerprint, at 8 kHz.
    """
    windows = _windows(wave)
    rows = _normed(windows[_loudest(windows, KEPT)])
    kept: NDArray[np.int8] = np.clip(np.rint(rows * SCALE), -127, 127).astype(np.int8)
    return kept.tobytes()


def candidates(wave: Wave, moments: Sequence[bytes]) -> list[int]:
    """Return those of many sounds that may hold the same sound, the likeliest first; twelve at most.

    Parameters
    ----------
    wave : ndarray, shape (frames,)
        Of the fingerprint of the sound that is looked for.
    moments : sequence of bytes
        `moments_of` each of the others.
    """
    if not moments:
        return []
    counts = np.array([len(moment) // MOMENT_BYTES for moment in moments])
    kept = np.frombuffer(b"".join(moments), np.int8).reshape(-1, MOMENT_BYTES).astype(np.float32)
    windows = _windows(wave)
    places = [index + shift for index in _loudest(windows, ASKED) for shift in range(-NEAR, NEAR + 1)]
    asked = _normed(windows[sorted({index for index in places if 0 <= index < len(windows)})])
    likeness = (kept @ asked.T).max(axis=1) / SCALE
    best = np.maximum.reduceat(likeness, np.cumsum(counts) - counts)
    order = np.argsort(-best)[:MOST_CANDIDATES]
    return [int(index) for index in order if best[index] >= LEAST]


def _windows(wave: Wave) -> Rows:
    """Return each moment of a sound, one a row; a shorter sound is one, followed by silence."""
    cells = cells_of(wave)
    if len(cells) < MOMENT:
        cells = np.concatenate((cells, np.zeros((MOMENT - len(cells), BANDS), np.float32)))
    windows = np.lib.stride_tricks.sliding_window_view(cells, MOMENT, axis=0)
    return windows.transpose(0, 2, 1).reshape(len(windows), MOMENT_BYTES)


def _loudest(windows: Rows, most: int) -> list[int]:
    """Return the places of the loudest moments, each some frames from the others."""
    loudness = windows.sum(axis=1)
    indices: list[int] = []
    while len(indices) < most and loudness.max() > 0:
        index = int(np.argmax(loudness))
        indices.append(index)
        loudness[max(0, index - APART + 1) : index + APART] = 0
    return indices or [0]


def _normed(rows: Rows) -> Rows:
    centred = rows - rows.mean(axis=1, keepdims=True)
    return np.asarray(centred / np.maximum(np.linalg.norm(centred, axis=1, keepdims=True), 1e-12), np.float32)
