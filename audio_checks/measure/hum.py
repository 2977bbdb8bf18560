"""Mains hum: steady lines at multiples of 50 or 60 Hz under a sound."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.in_phase import LONGEST_S, lines_in_phase
from audio_checks.measure.window_powers import hann_powers

MAINS_HZ = (50.0, 60.0)
MULTIPLES = 8  # that are looked for
OFF = 0.004  # share by which mains may be off
IN_TUNE = 0.0012  # share by which the lines of one hum may be out of tune with each other,
OF_A_BIN = 0.06  # and what a window cannot tell more exactly
WINDOWS_S = (1.0, 0.2)  # long ones find what is faint, short ones what is heard between strokes
SHORTEST_S = 1.0  # a sound that is shorter cannot tell hum from a note
STEADY = 0.25  # the quietest quarter of the windows counts: what comes and goes with the sound is lower there
PROMINENT = 16.0  # in power, 12 dB over what lies beside the line
NEAR_HZ, FAR_HZ = 5.0, 14.0  # what lies beside it,
NEAR_BINS, FAR_BINS = 2.5, 6.0  # and no nearer than so many bins
LINES = 3  # of these multiples must be there, one of the first LOW among them,
LOW = 3
LOOSER = 2.0  # or one more, so many times less in tune: noise moves faint lines
FAINTEST = 1e-5  # in power, 50 dB under the strongest line: what is fainter may be the window's own
LEAST = 1e-7  # in power, -70 dBFS: quieter hum counts for nothing
AT_ONCE = 8_192  # cells that are looked at together
KEPT = 512  # windows; of a long file, or of many channels, every second, fourth, ... window is kept

_Line = tuple[int, float, float]  # which multiple, where in Hz, its power


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
        self._windows: list[_Windows] = []
        self._channels = channels
        self._sums = np.empty((channels, 0))  # what some window still needs, and what waits to be looked at
        self._waiting = 0  # how many of them
        self._cells_per_s, self._cell = cells_per_s, cell_frames
        self._begin = np.empty((channels, 0))  # the first sums, for a closer look
        if cells >= SHORTEST_S * cells_per_s:
            # Whole sixteens: transforms of 2,005 would take five times as long as those of 2,000.
            lengths = (min(round(seconds * cells_per_s), cells // 2) // 16 * 16 for seconds in WINDOWS_S)
            self._windows = [_Windows(channels, cells_per_s, length, cell_frames, cells) for length in lengths]

    def add(self, cells: Cells, new: int) -> None:
        """Take the next cells, the last `new` of these."""
        if not self._windows:
            return
        self._sums = np.concatenate((self._sums, cells.sums[:, cells.sums.shape[1] - new :]), axis=1)
        self._waiting += new
        if self._waiting >= AT_ONCE:
            self._look()

    def result(self) -> dict[str, Any]:
        """Return `hum_dbfs`, the RMS of the lines in the channel with most of them, and `hum_hz`, 50 or 60.

        -inf and None where there is none; both None for a sound too short to tell.
        """
        if not self._windows:
            return {"hum_dbfs": None, "hum_hz": None}
        self._look()
        for windows in self._windows:
            power, mains_hz = windows.loudest()
            if power:
                return {"hum_dbfs": power_decibels(power), "hum_hz": mains_hz}
        power, mains_hz = self._in_phase()
        return {"hum_dbfs": power_decibels(power), "hum_hz": mains_hz if power else None}

    def _in_phase(self) -> tuple[float, float]:
        """Return the same of what keeps its phase, where the windows show a line or two but no hum."""
        loudest = 0.0, MAINS_HZ[0]
        for channel, mains_hz in sorted(set().union(*(windows.doubtful for windows in self._windows))):
            means = self._begin[channel] / self._cell
            lines = lines_in_phase(means, self._cells_per_s, mains_hz, MULTIPLES, OFF)
            if len(lines.multiples) >= LINES and lines.multiples[0] <= LOW and lines.power >= LEAST:
                loudest = max(loudest, (lines.power, mains_hz))
        return loudest

    def _look(self) -> None:
        if not self._begin.shape[1]:
            self._begin = self._sums[:, : round(LONGEST_S * self._cells_per_s)].copy()
        for windows in self._windows:
            windows.add(self._sums)
        done = min(windows.next for windows in self._windows)
        for windows in self._windows:
            windows.next -= done
        self._sums, self._waiting = self._sums[:, done:], 0


class _Windows:
    """The spectra of Hann windows of one length that overlap by half, and the lines in them."""

    def __init__(self, channels: int, cells_per_s: float, length: int, cell_frames: int, cells: int) -> None:
        self._length = length
        self._hop = max(1, length // 2)
        self._window_powers = hann_powers(length)
        self._bin_hz = cells_per_s / length
        self._bins = min(length // 2, math.ceil((MULTIPLES * MAINS_HZ[-1] + 2 * FAR_HZ) / self._bin_hz) + 2)
        # A line of amplitude a has (a * length / 4)² in its bin, 1.5 times that in all three; its own power is a²/2.
        self._scale = 8 / (cell_frames * length) ** 2 / 1.5
        self._most = max(8, KEPT // channels)
        self.next = 0  # where among the sums the next window starts
        self._spectra: list[NDArray[np.float64]] = []  # of some windows each, (channels, bins, windows)
        self._kept = 0  # windows
        self._every, self._number = 1, 0
        self.doubtful: set[tuple[int, float]] = set()  # channels, and the mains of which lines are found there
        while -(-((cells - length) // self._hop + 1) // self._every) > self._most:  # would be left out in the end
            self._every *= 2

    def add(self, sums: NDArray[np.float64]) -> None:
        """Take all sums from the first on that a window may need; `next` then tells which are still needed."""
        count = max(0, (sums.shape[1] - self.next - self._length) // self._hop + 1)
        first = -self._number % self._every
        if first < count:
            start = self.next + first * self._hop
            self._keep(self._powers(sums, start, len(range(first, count, self._every))))
        while self._kept > self._most:
            thinner = self.spectra()[:, :, ::2]
            self._spectra, self._kept, self._every = [], 0, self._every * 2
            self._keep(thinner)
        self._number += count
        self.next += count * self._hop

    def spectra(self) -> NDArray[np.float64]:
        """Return the power of the lowest bins of the windows that are kept, shape (channels, bins, windows)."""
        return np.concatenate(self._spectra, axis=2)

    def _keep(self, spectra: NDArray[np.float64]) -> None:
        self._spectra.append(spectra)
        self._kept += spectra.shape[2]

    def _powers(self, sums: NDArray[np.float64], start: int, count: int) -> NDArray[np.float64]:
        """Return the power of the lowest bins of windows from a start on, shape (channels, bins, count)."""
        hop = self._hop * self._every
        return self._window_powers.by_bin(sums, first=start, hop=hop, count=count, bins=self._bins)

    def loudest(self) -> tuple[float, float]:
        """Return the power of the loudest hum of any channel, 0 without one, and its mains frequency."""
        spectra = self.spectra()
        place = int(STEADY * (self._kept - 1))
        spectra.partition(place, axis=2)
        steady = spectra[:, :, place] * self._scale
        return max(
            (self._hum(channel, spectrum, mains), mains)
            for channel, spectrum in enumerate(steady)
            for mains in MAINS_HZ
        )

    def _hum(self, channel: int, spectrum: NDArray[np.float64], mains: float) -> float:
        """Return the power of a hum's lines; 0 where they make no hum."""
        found = [
            (multiple, *line)
            for multiple in range(1, MULTIPLES + 1)
            if (line := self._line(spectrum, multiple * mains))
        ]
        if not found:
            return 0.0
        self.doubtful.add((channel, mains))
        strongest = max(line[2] for line in found)
        found = [line for line in found if line[2] >= FAINTEST * strongest]
        # A line of something else is no line of this hum: the most lines that agree on a frequency count.
        exact = max((self._in_tune(found, hz / multiple, 1.0) for multiple, hz, _ in found), key=_weight)
        loose = max((self._in_tune(found, hz / multiple, LOOSER) for multiple, hz, _ in found), key=_weight)
        tuned = exact if len(exact) >= LINES else loose if len(loose) > LINES else []
        power = sum(line[2] for line in tuned)
        return power if tuned and tuned[0][0] <= LOW and power >= LEAST else 0.0

    def _in_tune(self, lines: list[_Line], base_hz: float, times: float) -> list[_Line]:
        """Return the lines that are multiples of a frequency, as exactly as such a window can tell."""
        blur = OF_A_BIN * self._bin_hz
        return [
            line for line in lines if abs(line[1] - line[0] * base_hz) <= times * max(IN_TUNE * line[0] * base_hz, blur)
        ]

    def _line(self, spectrum: NDArray[np.float64], wanted_hz: float) -> tuple[float, float] | None:
        """Return where a line near a frequency lies, and its power; None where nothing stands out."""
        wanted = wanted_hz / self._bin_hz
        reach = max(1.0, OFF * wanted)
        last = math.ceil(wanted + reach)
        if last + 2 > len(spectrum):
            return None
        first = math.floor(wanted - reach)
        peak = first + int(spectrum[first : last + 1].argmax())
        left, power, right = spectrum[peak - 1 : peak + 2].tolist()
        if power < left or power < right:
            return None
        hz = (peak + _offset(left, power, right)) * self._bin_hz
        if abs(hz - wanted_hz) > OFF * wanted_hz + OF_A_BIN * self._bin_hz:
            return None
        near = round(max(NEAR_HZ / self._bin_hz, NEAR_BINS))
        far = round(max(FAR_HZ / self._bin_hz, FAR_BINS))
        beside = spectrum[max(peak - far, 1) : peak - near].tolist() + spectrum[peak + near + 1 : peak + far].tolist()
        if power < PROMINENT * sorted(beside)[len(beside) // 2]:
            return None
        return hz, left + power + right


def _weight(lines: list[_Line]) -> tuple[int, float]:
    """Return how much speaks for a hum: how many lines, then their power."""
    return len(lines), sum(line[2] for line in lines)


def _offset(left: float, here: float, right: float) -> float:
    """Return where between three bins of a Hann window's spectrum the line lies, -0.5..0.5, from their powers."""
    ratio = math.sqrt(max(left, right) / here) if here else 0.5
    return math.copysign((2 * ratio - 1) / (ratio + 1), right - left)
