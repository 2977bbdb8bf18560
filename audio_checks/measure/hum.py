"""Mains hum: steady lines at multiples of 50 or 60 Hz under a sound."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.in_phase import LONGEST_S, lines_in_phase
from audio_checks.measure.window_powers import hann_powers

MAINS_HZ = (50.0, 60.0)
MULTIPLES = 8  # that are looked for
OFF = 0.01  # share by which mains may be off, those of a generator too; the nearest notes are 2 % off
IN_TUNE = 0.0012  # share by which the lines of one hum may be out of tune with each other,
OF_A_BIN = 0.06  # and the resolution of a window
WINDOWS_S = (1.0, 0.2)  # long ones find what is faint, short ones what is heard between strokes
SHORTEST_S = 1.0  # in a shorter sound, hum and a note cannot be distinguished
STEADY = 0.25  # the quietest quarter of the windows counts: what comes and goes with the sound is lower there
PROMINENT = 16.0  # in power, 12 dB over the level next to the line
NEAR_HZ, FAR_HZ = 5.0, 14.0  # the range next to it,
NEAR_BINS, FAR_BINS = 2.5, 6.0  # and no nearer than so many bins
LINES = 3  # of these multiples must be there, one of the first LOW among them,
LOW = 3
NEUTRAL = (1, 3, 9, 15)  # or as many of these, the first among them: what three phases leave in their neutral
LOOSER = 2.0  # or one more, so many times less in tune: noise moves faint lines
FAINTEST = 1e-5  # in power, 50 dB under the strongest line: what is fainter may be the window's own
LEAST = 1e-7  # in power, -70 dBFS: quieter hum counts for nothing
KEPT = 512  # windows; of a long file, or of many channels, only every second, fourth, ... window is looked at

_Line = tuple[int, float, float]  # which multiple, where in Hz, its power


class Hum:
    """Looks for hum in the sums of cells, which are the sound at 2 kHz.

    Parameters
    ----------
    channels : int
    cells_per_s : float
    cells : int
        Of the whole signal; one more comes, which ends in silence.
    cell_frames : int
        Frames of each cell.
    """

    FIGURES = ("hum_dbfs", "hum_hz")

    def __init__(self, channels: int, cells_per_s: float, cells: int, cell_frames: int) -> None:
        self._windows: list[_Windows] = []
        self._cells_per_s, self._cell = cells_per_s, cell_frames
        self._seen = 0  # cells
        self._begin = np.empty((channels, 0))  # the first sums, for a closer look
        self.back = 0  # cells before the new ones that are looked at again
        if cells >= SHORTEST_S * cells_per_s:
            # Whole sixteens: transforms of 2,005 would take five times as long as those of 2,000.
            lengths = [min(round(seconds * cells_per_s), cells // 2) // 16 * 16 for seconds in WINDOWS_S]
            self._windows = [_Windows(channels, cells_per_s, length, cell_frames, cells) for length in lengths]
            self._begin = np.empty((channels, min(round(LONGEST_S * cells_per_s), cells + 1)))
            self.back = max(lengths)

    def add(self, sums: NDArray[np.float64], new: int) -> None:
        """Take the sums of the next cells, shape (channels, n), the last `new` of these; `back` others come before."""
        if not self._windows:
            return
        begins = self._begin[:, self._seen : self._seen + new]
        begins[:] = sums[:, sums.shape[1] - new :][:, : begins.shape[1]]
        self._seen += new
        for windows in self._windows:
            windows.add(sums, self._seen - sums.shape[1])

    def result(self) -> dict[str, Any]:
        """Return `hum_dbfs`, the RMS of the lines in the channel with most of them, and `hum_hz`, 50 or 60.

        -inf and None where there is none; both None for a sound that is too short.
        """
        if not self._windows:
            return {"hum_dbfs": None, "hum_hz": None}
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
            there = len(lines.multiples) >= LINES and lines.multiples[0] <= LOW
            if not there and not set(lines.multiples).isdisjoint(NEUTRAL[:2]):
                lines = lines_in_phase(means, self._cells_per_s, mains_hz, NEUTRAL[-1], OFF)
                there = 1 in lines.multiples and len(set(lines.multiples).intersection(NEUTRAL)) >= LINES
            if there and lines.power >= LEAST:
                loudest = max(loudest, (lines.power, mains_hz))
        return loudest


class _Windows:
    """The spectra of Hann windows of one length that overlap by half, and the lines in them."""

    def __init__(self, channels: int, cells_per_s: float, length: int, cell_frames: int, cells: int) -> None:
        self._length = length
        self._window_powers = hann_powers(length)
        self._bin_hz = cells_per_s / length
        bins = min(length // 2, math.ceil((MULTIPLES * MAINS_HZ[-1] + 2 * FAR_HZ) / self._bin_hz) + 2)
        self._near = round(max(NEAR_HZ / self._bin_hz, NEAR_BINS))
        self._far = round(max(FAR_HZ / self._bin_hz, FAR_BINS))
        # A line of amplitude a has (a * length / 4)² in its bin, 1.5 times that in all three; its own power is a²/2.
        self._scale = 8 / (cell_frames * length) ** 2 / 1.5
        most = max(8, KEPT // channels)
        self._hop = length // 2
        while (count := (cells + 1 - length) // self._hop + 1) > most:
            self._hop *= 2
        self._powers = np.empty((channels * bins, count))
        self.spectra = self._powers.reshape(channels, bins, count)
        self._known = 0  # windows
        self.doubtful: set[tuple[int, float]] = set()  # channels, and the mains of which lines are found there

    def add(self, sums: NDArray[np.float64], first: int) -> None:
        """Take sums of which the first is that of the cell `first`; all that a window still needs are among them."""
        complete_windows = max(0, (first + sums.shape[1] - self._length) // self._hop + 1)
        if complete_windows > self._known:
            start = self._known * self._hop - first
            self._window_powers.by_bin(
                sums, first=start, hop=self._hop, powers=self._powers[:, self._known : complete_windows]
            )
            self._known = complete_windows

    def loudest(self) -> tuple[float, float]:
        """Return the power of the loudest hum of any channel, 0 without one, and its mains frequency."""
        steady_index = int(STEADY * (self.spectra.shape[2] - 1))
        self.spectra.partition(steady_index, axis=2)
        steady = (self.spectra[:, :, steady_index] * self._scale).tolist()
        return max(
            (self._hum(channel, spectrum, mains), mains)
            for channel, spectrum in enumerate(steady)
            for mains in MAINS_HZ
        )

    def _hum(self, channel: int, spectrum: list[float], mains: float) -> float:
        """Return the power of a hum's lines; 0 where they make no hum."""
        lines = [
            (multiple, *line)
            for multiple in range(1, MULTIPLES + 1)
            if (line := self._line(spectrum, multiple * mains))
        ]
        if not lines:
            return 0.0
        self.doubtful.add((channel, mains))
        strongest = max(line[2] for line in lines)
        strong_lines = [line for line in lines if line[2] >= FAINTEST * strongest]
        # A line of something else is not a line of this hum: the most lines that agree on a frequency count.
        exact = max((self._in_tune(strong_lines, hz / multiple, 1.0) for multiple, hz, _ in strong_lines), key=_weight)
        loose = max(
            (self._in_tune(strong_lines, hz / multiple, LOOSER) for multiple, hz, _ in strong_lines), key=_weight
        )
        tuned = exact if len(exact) >= LINES else loose if len(loose) > LINES else []
        power = sum(line[2] for line in tuned)
        return power if tuned and tuned[0][0] <= LOW and power >= LEAST else 0.0

    def _in_tune(self, lines: list[_Line], base_hz: float, times: float) -> list[_Line]:
        """Return the lines that are multiples of a frequency, as exactly as such a window resolves."""
        blur = OF_A_BIN * self._bin_hz
        return [
            line for line in lines if abs(line[1] - line[0] * base_hz) <= times * max(IN_TUNE * line[0] * base_hz, blur)
        ]

    def _line(self, spectrum: list[float], wanted_hz: float) -> tuple[float, float] | None:
        """Return the position of a line near a frequency, and its power; None if nothing stands out."""
        bin_position = wanted_hz / self._bin_hz
        reach = max(1.0, OFF * bin_position)
        first, last = math.floor(bin_position - reach), math.ceil(bin_position + reach)
        if last + 2 > len(spectrum):
            return None
        power = max(spectrum[first : last + 1])
        peak = spectrum.index(power, first)
        left, right = spectrum[peak - 1], spectrum[peak + 1]
        if power < left or power < right:
            return None
        beside = spectrum[max(peak - self._far, 1) : peak - self._near]
        beside += spectrum[peak + self._near + 1 : peak + self._far]
        if power < PROMINENT * sorted(beside)[len(beside) // 2]:
            return None
        hz = (peak + _offset(left, power, right)) * self._bin_hz
        if abs(hz - wanted_hz) > OFF * wanted_hz + OF_A_BIN * self._bin_hz:
            return None
        return hz, left + power + right


def _weight(lines: list[_Line]) -> tuple[int, float]:
    """Return the evidence for a hum: the number of lines, then their power."""
    return len(lines), sum(line[2] for line in lines)


def _offset(left: float, here: float, right: float) -> float:
    """Return the line's position between three bins of a Hann window's spectrum, -0.5..0.5, from their powers."""
    ratio = math.sqrt(max(left, right) / here) if here else 0.5
    return math.copysign((2 * ratio - 1) / (ratio + 1), right - left)
