"""Peak, RMS and offset of the samples as they are."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import decibels, power_decibels
from audio_checks.measure.maxima import first_reaching
from audio_checks.measure.survey import Survey

Samples = NDArray[np.float64]


def sample_peak_dbfs(samples: Samples) -> float:
    """Return the level of the largest sample, in dBFS.

    Parameters
    ----------
    samples : ndarray, shape (frames, channels)
        Full scale is ±1.0. The loudest channel counts.

    Returns
    -------
    float
        -inf for digital silence and for no frames at all.
    """
    return decibels(float(np.abs(samples).max())) if samples.size else -math.inf


def rms_dbfs(samples: Samples) -> float:
    """Return the RMS level over all channels, in dBFS.

    Parameters
    ----------
    samples : ndarray, shape (frames, channels)
        A square wave at ±1.0 is 0 dBFS, a sine is -3.01 dBFS.

    Returns
    -------
    float
        -inf for digital silence and for no frames at all.
    """
    return power_decibels(float(np.square(samples).mean())) if samples.size else -math.inf


def dc_offset_percent(samples: Samples) -> float:
    """Return the mean of the channel where it is farthest from zero, unsigned, in percent of full scale.

    Parameters
    ----------
    samples : ndarray, shape (frames, channels)
        Full scale is ±1.0.

    Returns
    -------
    float
        0 for digital silence and for no frames at all.
    """
    return float(100 * np.abs(samples.mean(axis=0)).max()) if samples.size else 0.0


class Levels:
    """Measures peak, RMS, crest and offset of blocks.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = (
        "is_silence",
        "sample_peak_dbfs",
        "sample_peak_s",
        "rms_dbfs",
        "crest_db",
        "dc_offset_percent",
        "silent_channels",
        "channel_peaks_dbfs",
    )

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        survey: Survey | None = None,
    ) -> None:
        self._rate = sample_rate_hz
        self._survey = survey or Survey()
        self._seen = 0
        self._peaks = np.zeros(channels)
        self._highest = 0.0
        self._peak_frame = 0
        self._sums = np.zeros((channels, 2))  # of each channel: sum, sum of squares

    def add(self, block: Samples) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        maxima, peaks, highest = self._survey.maxima(block), self._survey.peaks(block), self._survey.highest(block)
        if highest > self._highest:
            self._highest = highest
            self._peak_frame = self._seen + min(
                first_reaching(block[:, channel], maxima[channel], highest)
                for channel, peak in enumerate(peaks.tolist())
                if peak == highest
            )
        np.maximum(self._peaks, peaks, out=self._peaks)
        self._sums += self._survey.sums(block)
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        peaks = self._peaks.tolist()
        sums, squares = self._sums.T.tolist()
        seen = max(self._seen, 1)
        highest = self._highest
        peak = decibels(highest)
        rms = power_decibels(math.fsum(squares) / (seen * len(squares)))
        return {
            "is_silence": highest == 0,
            "sample_peak_dbfs": peak,
            "sample_peak_s": self._peak_frame / self._rate,
            "rms_dbfs": rms,
            "crest_db": peak - rms if math.isfinite(rms) else 0.0,  # squares of what is smaller than 1e-154 are 0
            "dc_offset_percent": 100 * max(abs(total) for total in sums) / seen,
            "silent_channels": tuple(channel for channel, channel_peak in enumerate(peaks, 1) if channel_peak == 0),
            "channel_peaks_dbfs": tuple(decibels(channel_peak) for channel_peak in peaks),
        }
