"""A sound's spectrum over time as a small grey picture, computed while the sound streams by.

White is a tone of −12 dBFS or more, black 72 dB below; rows run from 20 kHz at the top to 60 Hz at
the bottom in equal steps of pitch. Rows above the sound's Nyquist frequency stay black.
"""

import math
import struct
import zlib

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

HEIGHT = 128
MAX_WIDTH = 1000
TOP_HZ = 20_000.0
BOTTOM_HZ = 60.0
WHITE_DBFS = -12.0
RANGE_DB = 72.0
WINDOW_S = 0.043  # 23 Hz between bins: a semitone at 400 Hz
COLUMN_S = 0.001  # columns of short sounds are no narrower
WINDOWS_AT_ONCE = 64  # bounds the memory of one step
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


class SpectrumPicture:
    """Accumulates the picture of a sound, block by block.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound, which has frames.
    """

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:
        self.width = max(1, min(MAX_WIDTH, math.ceil(frames / (sample_rate_hz * COLUMN_S))))
        self._window_frames = 1 << max(4, round(math.log2(sample_rate_hz * WINDOW_S)))
        # Single precision: its noise lies far below black, and its transforms take half the time.
        self._window = np.hanning(self._window_frames + 1)[:-1].astype(np.float32)
        per_column = max(1, math.ceil(frames / self.width / (self._window_frames / 2)))
        windows = self.width * per_column
        centres = ((np.arange(windows) + 0.5) * frames / windows).astype(np.int64)
        self._starts = centres  # in a stream with half a window of silence before it
        self._columns = np.arange(windows) // per_column
        self._next = 0
        self._held = np.zeros((channels, self._window_frames // 2), np.float32)
        self._held_from = 0
        self._power = np.zeros((self.width, HEIGHT))
        self._rows = _Rows(sample_rate_hz, self._window_frames)

    def add(self, block: NDArray[np.float64]) -> None:
        """Take in the next frames, shape (frames, channels)."""
        self._held = np.concatenate([self._held, block.T.astype(np.float32)], axis=1)
        self._measure()

    def levels(self) -> NDArray[np.float64]:
        """Return the level of every point in dBFS of a tone, shape (HEIGHT, width), and end the stream."""
        self.add(np.zeros((self._window_frames, len(self._held))))
        return 10 * np.log10(np.maximum(self._power.T, 1e-30))

    def png(self) -> bytes:
        """Return the picture, and end the stream."""
        grey = np.clip((self.levels() - WHITE_DBFS + RANGE_DB) / RANGE_DB, 0, 1) * 255
        return grey_png(np.rint(grey).astype(np.uint8))

    def _measure(self) -> None:
        held_until = self._held_from + self._held.shape[1]
        ready = int(np.searchsorted(self._starts, held_until - self._window_frames, side="right"))
        while self._next < ready:
            last = min(ready, self._next + WINDOWS_AT_ONCE)
            starts = self._starts[self._next : last] - self._held_from
            power = np.zeros((len(starts), self._window_frames // 2 + 1), np.float32)
            for channel in self._held:
                windows = sliding_window_view(channel, self._window_frames)[starts]
                spectra = np.fft.rfft(windows * self._window)
                power += spectra.real**2 + spectra.imag**2
            power *= 1 / len(self._held) / (self._window_frames / 4) ** 2
            # The loudest of a column's windows counts, so that a click in a long sound is seen.
            np.maximum.at(self._power, self._columns[self._next : last], self._rows.of(power))
            self._next = last
        needed_from = self._starts[self._next] if self._next < len(self._starts) else held_until
        drop = int(min(needed_from, held_until) - self._held_from)
        self._held = self._held[:, drop:]
        self._held_from += drop


class _Rows:
    """From equal steps of frequency to equal steps of pitch."""

    def __init__(self, sample_rate_hz: int, window_frames: int) -> None:
        bins = window_frames // 2 + 1
        edges_hz = TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** (np.arange(HEIGHT + 1) / HEIGHT)
        edges = edges_hz * window_frames / sample_rate_hz
        middles = np.sqrt(edges[:-1] * edges[1:])
        self._lit = middles <= bins - 1
        self._below = np.minimum(middles.astype(np.int64), bins - 2)
        self._share = np.clip(middles - self._below, 0, 1)
        first = np.minimum(np.ceil(edges[1:]).astype(np.int64), bins - 1)
        end = np.minimum(np.floor(edges[:-1]).astype(np.int64) + 1, bins)
        self._wide = end - first >= 2
        self._spans = np.stack([first, np.maximum(end, first + 1)], axis=1)[self._wide].ravel()

    def of(self, power: NDArray[np.float32]) -> NDArray[np.float64]:
        """Return rows for spectra of shape (windows, bins): the loudest bin of a row, or between two bins."""
        rows: NDArray[np.float64] = power[:, self._below] * (1 - self._share) + power[:, self._below + 1] * self._share
        if self._spans.size:
            silent_end = np.zeros((len(power), 1), np.float32)  # reduceat wants the end of the last span to exist
            rows[:, self._wide] = np.maximum.reduceat(np.hstack([power, silent_end]), self._spans, axis=1)[:, ::2]
        rows[:, ~self._lit] = 0
        return rows


def grey_png(values: NDArray[np.uint8]) -> bytes:
    """Return an 8-bit grey PNG of values, shape (height, width)."""
    height, width = values.shape
    lines = np.hstack([np.zeros((height, 1), dtype=np.uint8), values])  # each line begins with its filter, none
    return b"".join(
        [
            PNG_SIGNATURE,
            _png_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)),
            _png_chunk(b"IDAT", zlib.compress(lines.tobytes(), 3)),
            _png_chunk(b"IEND", b""),
        ]
    )


def _png_chunk(kind: bytes, payload: bytes) -> bytes:
    return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))
