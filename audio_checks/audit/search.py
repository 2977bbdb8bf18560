"""Search of many approved sounds for a build's, by its loudest moments, before they are compared."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from audio_checks.audit.fingerprint import RATE_HZ, Wave

Cells = NDArray[np.float32]

FRAME = RATE_HZ // 100  # 10 ms
EDGES = np.array([1, 4, 8, 14, 22, 32, 44, 60])  # bins of 50 Hz; eight bands
BANDS = len(EDGES)
LOUDNESS_POWER = 0.2  # of a cell's power, as loudness grows: no cell drowns the others, and none is all noise
MOMENT = 16  # frames that are compared
MOMENTS = 3  # of a sound
MOST_ROWS = 100_000  # of approved moments at once: some 50 MB
MOST_FOUND = 12
NEAR = 0.15  # under the best: of known sounds the right one was never farther than 0.09


def cells_of(wave: Wave) -> Cells:
    """Return the loudness of eight bands every 10 ms, shape (frames, 8); at least one frame."""
    frames = max(1, len(wave) // FRAME)
    whole = np.zeros((frames + 1) * FRAME, np.float32)
    whole[: len(wave)] = wave[: len(whole)]
    windows = np.lib.stride_tricks.sliding_window_view(whole, 2 * FRAME)[::FRAME]
    spectrum = np.fft.rfft(windows * np.hanning(2 * FRAME).astype(np.float32), axis=1)
    power = np.add.reduceat(np.abs(spectrum) ** 2, EDGES, axis=1)
    return np.asarray(power**LOUDNESS_POWER, np.float32)


class Search:
    """Approved sounds, ready to be found by their moments."""

    def __init__(self, approved: Sequence[Cells]) -> None:
        self._approved = approved

    def found(self, built: Sequence[Cells]) -> list[list[int]]:
        """Return for each sound of a build which approved ones are worth comparing, the likeliest first."""
        likeness = np.full((len(built), len(self._approved)), -1.0, np.float32)
        for frames in sorted({_frames(cells) for cells in built}):
            places = [index for index, cells in enumerate(built) if _frames(cells) == frames]
            moments = [_moments(built[index], frames) for index in places]
            first = np.cumsum([0, *(len(moment) for moment in moments)])[:-1]
            rows = _normed(np.concatenate(moments))
            for columns, all_moments, starts in self._parts(frames):
                agreeing = np.maximum.reduceat(rows @ all_moments.T, starts, axis=1)
                counts = np.diff([*first, len(rows)])[:, np.newaxis]
                likeness[np.ix_(places, columns)] = np.add.reduceat(agreeing, first, axis=0) / counts
        return [_best(row) for row in likeness]

    def _parts(self, frames: int) -> Iterator[tuple[list[int], Cells, list[int]]]:
        """Yield approved sounds, all moments of theirs, and where those of each begin."""
        columns: list[int] = []
        parts: list[Cells] = []
        starts: list[int] = []
        rows = 0
        for column, cells in enumerate(self._approved):
            if columns and rows + len(cells) > MOST_ROWS:
                yield columns, _normed(np.concatenate(parts)), starts
                columns, parts, starts, rows = [], [], [], 0
            parts.append(_sliding(cells, frames))
            columns.append(column)
            starts.append(rows)
            rows += len(parts[-1])
        if columns:
            yield columns, _normed(np.concatenate(parts)), starts


def _frames(cells: Cells) -> int:
    return min(MOMENT, len(cells))


def _sliding(cells: Cells, frames: int) -> Cells:
    """Return every moment of a sound, one a row; a shorter sound is one, followed by silence."""
    if len(cells) < frames:
        cells = np.concatenate((cells, np.zeros((frames - len(cells), BANDS), np.float32)))
    windows = np.lib.stride_tricks.sliding_window_view(cells, frames, axis=0)
    return windows.transpose(0, 2, 1).reshape(len(windows), frames * BANDS)


def _moments(cells: Cells, frames: int) -> Cells:
    """Return the loudest moment of each third of a sound."""
    moments = _sliding(cells, frames)
    parts = np.array_split(np.arange(len(moments)), min(MOMENTS, len(moments)))
    return moments[[part[int(np.argmax(moments[part].sum(axis=1)))] for part in parts]]


def _normed(moments: Cells) -> Cells:
    centred = moments - moments.mean(axis=1, keepdims=True)
    return np.asarray(centred / np.maximum(np.linalg.norm(centred, axis=1, keepdims=True), 1e-12), np.float32)


def _best(row: NDArray[np.float32]) -> list[int]:
    order = np.argsort(-row)[:MOST_FOUND]
    return [int(index) for index in order if row[index] >= row[order[0]] - NEAR]
