"""Mains hum: steady lines at multiples of 50 or 60 Hz under a sound."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import power_decibels

MAINS_HZ = (50.0, 60.0)
MULTIPLES = 8  # that are looked for
OFF = 0.004  # share by which mains may be off
IN_TUNE = 0.0012  # share by which the lines of one hum may be out of tune with each other
LONGEST_S, SHORTEST_S = 1.0, 0.5  # windows; a sound shorter than two of them cannot tell hum from a note
STEADY = 0.25  # the quietest quarter of the windows counts: what comes and goes with the sound is lower there
PROMINENT = 16.0  # in power, 12 dB over what lies beside the line
NEAR_HZ, FAR_HZ = 5.0, 14.0  # what lies beside it
LINES = 3  # of these multiples must be there, one of the first three among them
LEAST = 1e-7  # in power, -70 dBFS: quieter hum counts for nothing
WINDOWS_KEPT = 512  # of a long file every second, fourth, ... window is kept


class Hum:
    """Looks for hum in the sums of cells, which are the sound at 2 kHz.

    Parameters
    ----------
    channels : int
    cells_per_s : float
    cells : int
        Of the whole signal.
    cell_frames : int
        Frames of each cell.
    """

    FIGURES = ("hum_dbfs", "hum_hz")

    def __init__(self, channels: int, cells_per_s: float, cells: int, cell_frames: int) -> None:
        self._per_s = cells_per_s
        self._scale = 1 / cell_frames
        length = min(round(LONGEST_S * cells_per_s), cells // 2)
        length -= length % 16  # transforms of 2,005 would take five times as long
        self._length = length if length >= SHORTEST_S * cells_per_s else 0
        self._hop = max(1, self._length // 2)
        self._window = np.hanning(self._length + 1)[:-1]
        self._bins = math.ceil((MULTIPLES * MAINS_HZ[-1] + FAR_HZ) * self._length / cells_per_s) + 2
        self._kept = np.empty((channels, 0))
        self._spectra: list[NDArray[np.float32]] = []
        self._every, self._number = 1, 0

    def add(self, cells: Cells) -> None:
        """Take the next cells."""
        if not self._length:
            return
        kept = np.concatenate((self._kept, cells.sums), axis=1)
        start = 0
        while start + self._length <= kept.shape[1]:
            if self._number % self._every == 0:
                bins = np.fft.rfft(kept[:, start : start + self._length] * self._window, axis=1)[:, : self._bins]
                self._spectra.append(np.square(np.abs(bins)).astype(np.float32))
            if len(self._spectra) > WINDOWS_KEPT:
                self._spectra, self._every = self._spectra[::2], self._every * 2
            self._number += 1
            start += self._hop
        self._kept = kept[:, start:]

    def result(self) -> dict[str, Any]:
        """Return `hum_dbfs`, the RMS of the lines in the channel with most of them, and `hum_hz`, 50 or 60.

        -inf and None where there is none; both None for a sound too short to tell.
        """
        if not self._spectra:
            return {"hum_dbfs": None, "hum_hz": None}
        spectra = np.asarray(self._spectra, dtype=np.float64)
        steady = np.sort(spectra, axis=0)[int(STEADY * (len(spectra) - 1))]
        # A line of amplitude a has (a * length / 4)² in its bin, 1.5 times that in all three; its own power is a²/2.
        steady *= self._scale**2 * 8 / self._length**2 / 1.5
        found = [(self._lines(channel, mains), mains) for channel in steady for mains in MAINS_HZ]
        power, mains = max(found)
        return {"hum_dbfs": power_decibels(power), "hum_hz": mains if power else None}

    def _lines(self, spectrum: NDArray[np.float64], mains: float) -> float:
        """Return the power of a hum's lines; 0 where they make no hum."""
        width = self._per_s / self._length  # of a bin
        near, far = round(NEAR_HZ / width), round(FAR_HZ / width)
        found: list[tuple[int, float, float]] = []
        for multiple in range(1, MULTIPLES + 1):
            wanted = multiple * mains / width
            reach = max(1.0, OFF * wanted)
            first, last = math.floor(wanted - reach), math.ceil(wanted + reach)
            peak = first + int(spectrum[first : last + 1].argmax())
            left, power, right = spectrum[peak - 1 : peak + 2].tolist()
            if power < left or power < right:
                continue
            hz = (peak + _offset(left, power, right)) * width
            if abs(hz - multiple * mains) > OFF * multiple * mains:
                continue
            beside = (
                spectrum[max(peak - far, 1) : peak - near].tolist() + spectrum[peak + near + 1 : peak + far].tolist()
            )
            if power >= PROMINENT * sorted(beside)[len(beside) // 2]:
                found.append((multiple, hz / multiple, left + power + right))
        if not found:
            return 0.0
        base = sum(multiple * hz for multiple, hz, _ in found) / sum(multiple for multiple, _, _ in found)
        tuned = [line for line in found if abs(line[1] - base) <= IN_TUNE * base]
        power = sum(line[2] for line in tuned)
        if len(tuned) < LINES or tuned[0][0] > 3 or power < LEAST:
            return 0.0
        return power


def _offset(left: float, here: float, right: float) -> float:
    """Return where between three bins of a Hann window's spectrum the line lies, -0.5..0.5, from their powers."""
    ratio = math.sqrt(max(left, right) / here) if here else 0.5
    return math.copysign((2 * ratio - 1) / (ratio + 1), right - left)
