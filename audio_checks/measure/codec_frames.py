"""Traces that lossy codecs leave: spectral lines that fall silent together, on the codec's own frames and nowhere else.

An encoder codes as zero each line that it considers inaudible. Once decoded, those lines are silent again where the
sound is cut into the same frames and the same lines, and filled where it is cut anywhere else. So each place at which
the codec's frames may begin is tried, and one that stands out from all others is a trace; a filter leaves none.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel import silent_lines
from audio_checks.measure.codec_lines import Lines, all_lines

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
EXCERPT_FRAMES = 1 << 14  # a third of a second: 14 to 63 frames of a codec
LINES_AT_ONCE, PLACES_APART = 8, 8  # of the kernel
BAND_BINS = 1_024  # of EXCERPT_FRAMES: beyond, a line has less than a millionth of its energy
USUAL_RATES_HZ = (48_000, 44_100)
SILENT = 0.03  # of a line's own RMS around: chance alone leaves one in forty below
ROUNDING = 0.75  # of the depth's step: what rounding to it leaves in a line stays below, nearly always
COARSEST_DITHER = 2.0**-17  # a file of 24 bits may have been one of 16, which this is between
AUDIBLE = 5.0  # times that, else the line is not counted
FEWEST_LINES = 100
BESIDE_FRAMES = 4  # next to the best place lines are nearly as silent


@dataclass(frozen=True)
class Trace:
    """The silence of a codec's lines on its frames, at the best of all places for these to begin.

    Attributes
    ----------
    codec : str
    rate_hz : int
        The sample rate at which it was looked for.
    lines : int
        How many lines were compared, all frames together.
    silent_share : float
        Of them silent at the best place, 0..1.
    elsewhere_share : float
        The most that are silent at any place that is not next to it, 0..1.
    contrast : float
        By how much the best place stands out: the difference of the two counts, over the square root of the lesser.
    shares : ndarray, shape (frame,)
        Of them silent at each place.
    """

    codec: str
    rate_hz: int
    lines: int
    silent_share: float
    elsewhere_share: float
    contrast: float
    shares: Floats


class CodecFrames:
    """Looks for the frames of lossy codecs in the third of a second that changes most, in its loudest channel.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("codec_traces",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, step: float = 0.0) -> None:
        self._rate = sample_rate_hz
        self._step = step
        lowest_hz = min(rates_of(sample_rate_hz))
        self._size = min(frames, -(-EXCERPT_FRAMES * sample_rate_hz // lowest_hz))
        self._held = np.empty((channels, 0))
        self._best = np.empty(0)
        self._most = 0.0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        self._held = np.concatenate((self._held, block.T), axis=1)
        while self._size and self._held.shape[1] >= self._size:
            self._weigh(self._held[:, : self._size])
            self._held = self._held[:, max(1, self._size // 2) :]

    def result(self) -> dict[str, Any]:
        """Return `codec_traces`, one for each codec and rate that could be looked for; none of silence."""
        return {"codec_traces": traces_of(self._best, self._rate, self._step)}

    def _weigh(self, samples: NDArray[np.float64]) -> None:
        changes = np.square(np.diff(samples, axis=1)).sum(axis=1)
        channel = int(np.argmax(changes))
        if changes[channel] > self._most:
            self._most, self._best = float(changes[channel]), samples[channel].copy()


def rates_of(sample_rate_hz: int) -> tuple[int, ...]:
    """Return the sample rates at which a codec may have worked on a sound that is at one now."""
    usual = tuple(rate for rate in USUAL_RATES_HZ if rate != sample_rate_hz)
    if sample_rate_hz in USUAL_RATES_HZ:
        return (sample_rate_hz, *usual)
    return usual if sample_rate_hz > max(USUAL_RATES_HZ) else (sample_rate_hz,)


def traces_of(samples: Floats, sample_rate_hz: int, step: float = 0.0) -> tuple[Trace, ...]:
    """Return the traces of all codecs in a sound.

    Parameters
    ----------
    samples : ndarray, shape (frames,)
        Full scale is ±1.0. What is beyond a third of a second is left out.
    sample_rate_hz : int
        Frames per second.
    step : float
        The smallest step of the file's bit depth; 0 for float.

    Returns
    -------
    tuple of Trace
        None of a codec at a rate where too few lines stand out of the rounding to the depth: silence, no frames,
        less than two frames of the codec.
    """
    traces = []
    scale = 0.5 ** max(0, math.frexp(np.abs(samples).max(initial=0.0))[1])  # squares in single precision end at 2^127
    dither = scale * max(step, COARSEST_DITHER)
    for rate_hz in rates_of(sample_rate_hz):
        excerpt = _at_rate(scale * samples, sample_rate_hz, rate_hz)[:EXCERPT_FRAMES]
        spectrum = _spectrum(excerpt)
        for lines, bands in _filters():
            if lines.rate_hz in (None, rate_hz) and len(excerpt) >= lines.filters.shape[1] + 2 * lines.frame:
                traces.append(_trace(lines, rate_hz, spectrum, bands, len(excerpt), dither))
    return tuple(trace for trace in traces if trace is not None)


def _trace(lines: Lines, rate_hz: int, spectrum: Singles, bands: Bands, frames: int, step: float) -> Trace | None:
    first = lines.filters.shape[1] - 1  # before it a line does not lie inside the sound
    silent = np.empty(lines.frame, dtype=np.int64)
    compared = silent_lines(
        spectrum,
        *bands,
        _turns(),
        first,
        lines.frame,
        (frames - first) // lines.frame,
        SILENT,
        ROUNDING * step,
        AUDIBLE,
        silent,
    )
    if compared < FEWEST_LINES:
        return None
    best = int(np.argmax(silent))
    apart = np.abs((np.arange(lines.frame) - best + lines.frame // 2) % lines.frame - lines.frame // 2)
    elsewhere = int(silent[apart > BESIDE_FRAMES].max())
    contrast = float((silent[best] - elsewhere) / np.sqrt(max(1, elsewhere)))
    shares = silent / compared
    return Trace(lines.codec, rate_hz, compared, float(shares[best]), elsewhere / compared, contrast, shares)


def _at_rate(samples: Floats, from_hz: int, to_hz: int) -> Floats:
    """Return a sound at another rate, by its spectrum: its two ends run into one another, the rest stays in place."""
    if from_hz == to_hz or not len(samples):
        return samples
    shared = np.gcd(from_hz, to_hz)
    whole = len(samples) // (from_hz // shared)  # so that both lengths are whole
    size_in, size_out = whole * (from_hz // shared), whole * (to_hz // shared)
    if not whole:
        return samples[:0]
    resampled: Floats = np.fft.irfft(np.fft.rfft(samples[:size_in])[: size_out // 2 + 1], size_out) * size_out / size_in
    return resampled


class Bands(NamedTuple):
    """Some lines as the kernel takes them, in groups of eight, silent ones at the end."""

    spectra: Singles  # shape (groups, bins, 2, 8): what a sound's spectrum is multiplied by
    firsts: NDArray[np.int32]  # shape (groups, 8): the bin that each begins with
    taps: Singles  # shape (groups, places, 4, 8): by which two values of the envelope give the places from the first on


@cache
def _filters() -> tuple[tuple[Lines, Bands], ...]:
    """Return all lines, and the bands that correlate a sound with each."""
    return tuple((lines, bands_of(lines.filters)) for lines in all_lines())


def bands_of(filters: Floats) -> Bands:
    """Return the part of the spectrum in which each filter, shape (filters, taps), has its energy."""
    count = -(-len(filters) // LINES_AT_ONCE) * LINES_AT_ONCE
    spectra = 2 / EXCERPT_FRAMES * np.fft.rfft(filters[:, ::-1], EXCERPT_FRAMES)
    powers = np.square(np.abs(spectra))
    centres = powers @ np.arange(powers.shape[1]) / powers.sum(axis=1)
    firsts = np.clip(np.rint(centres).astype(np.int32) - BAND_BINS // 2, 0, powers.shape[1] - BAND_BINS)
    bands = np.zeros((count, BAND_BINS), np.complex64)
    for band, spectrum, first in zip(bands, spectra, firsts, strict=False):
        band[:] = spectrum[first : first + BAND_BINS]
    places = np.arange(PLACES_APART)
    shares = np.stack((1 - places / PLACES_APART, places / PLACES_APART), axis=1)
    turned = np.exp(2j * np.pi / EXCERPT_FRAMES * np.multiply.outer(centres, places[:, np.newaxis] - [0, PLACES_APART]))
    taps = np.zeros((count, PLACES_APART, 2), np.complex64)
    taps[: len(filters)] = shares * turned
    padded = np.pad(firsts, (0, count - len(filters))).astype(np.int32)
    return Bands(_in_lanes(bands), padded.reshape(-1, LINES_AT_ONCE), _in_lanes(taps.reshape(count, -1)))


def _in_lanes(values: NDArray[np.complex64]) -> Singles:
    """Return values of lines, shape (lines, values), as (groups, values, 2, 8): real and imaginary parts by lane."""
    grouped = values.reshape(-1, LINES_AT_ONCE, values.shape[1]).transpose(0, 2, 1)
    lanes: Singles = np.ascontiguousarray(np.stack((grouped.real, grouped.imag), axis=2))
    return lanes


@cache
def _turns() -> Singles:
    points = EXCERPT_FRAMES // PLACES_APART
    turns = np.exp(-2j * np.pi * np.arange(points) / points)
    singles: Singles = turns.astype(np.complex64).view(np.float32)
    return singles


def _spectrum(samples: Floats) -> Singles:
    """Return a spectrum, real and imaginary parts last, in single precision: codecs need less, and it costs half."""
    spectrum = np.fft.rfft(samples.astype(np.float32), EXCERPT_FRAMES).astype(np.complex64, copy=False)
    return spectrum.view(np.float32).reshape(*spectrum.shape, 2)
