"""Building blocks of the demo's sounds: envelopes, tones, struck metal, noise, and the last touch before a file.

Everything is plain numpy with fixed seeds, so a sound is the same bytes each time. Signals are
float64 of shape (frames,) for one channel, and full scale is ±1.0.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Signal = NDArray[np.float64]
TURN = 2 * np.pi
OVERSAMPLING = 8


@dataclass(frozen=True)
class Clock:
    """The instants of a sound's frames, and the random numbers it draws."""

    sample_rate_hz: int
    duration_s: float
    seed: int

    @property
    def frames(self) -> int:
        """Length of the sound."""
        return round(self.duration_s * self.sample_rate_hz)

    def times(self, start_s: float = 0.0) -> Signal:
        """Return seconds since `start_s`, negative before it."""
        return np.arange(self.frames) / self.sample_rate_hz - start_s

    def draws(self, stream: int = 0) -> np.random.Generator:
        """Return random numbers of this sound; each stream is its own."""
        return np.random.Generator(np.random.PCG64([self.seed, stream]))


def gain(level_db: float) -> float:
    """Return the factor of a level in dB."""
    return float(10 ** (level_db / 20))


def struck(times: Signal, attack_s: float, decay_s: float) -> Signal:
    """Return an envelope: nothing before 0, a straight attack, then an exponential decay."""
    rising: Signal = np.clip(times / attack_s, 0.0, 1.0)
    return rising * np.exp(-np.maximum(times - attack_s, 0.0) / decay_s)


def ramp(times: Signal, start_s: float, end_s: float) -> Signal:
    """Return a smooth step from 0 to 1, downwards where the end comes before the start."""
    along: Signal = np.clip((times - start_s) / (end_s - start_s), 0.0, 1.0)
    return along**2 * (3 - 2 * along)


def tone(clock: Clock, hz: float | Signal, phase: float = 0.0) -> Signal:
    """Return a sine whose frequency may glide."""
    glide = np.broadcast_to(np.asarray(hz, dtype=np.float64), (clock.frames,))
    turns = np.cumsum(glide) / clock.sample_rate_hz
    heard: Signal = np.sin(TURN * (turns - turns[0]) + phase)
    return heard


def fall(times: Signal, high_hz: float, low_hz: float, time_s: float) -> Signal:
    """Return a frequency that falls from high to low, faster at first."""
    return low_hz + (high_hz - low_hz) * np.exp(-np.maximum(times, 0.0) / time_s)


def noise(clock: Clock, stream: int, low_hz: float, high_hz: float, tilt_db: float = 0.0) -> Signal:
    """Return noise of a band, RMS 1, tilted by dB an octave; it loops without a seam."""
    spectrum = np.fft.rfft(clock.draws(stream).standard_normal(clock.frames))
    hz = np.fft.rfftfreq(clock.frames, 1 / clock.sample_rate_hz)
    octaves = np.log2(np.maximum(hz, 1.0) / low_hz)
    shape = 10 ** (tilt_db * octaves / 20)
    shape /= np.sqrt(1 + (low_hz / np.maximum(hz, 1e-3)) ** 6) * np.sqrt(1 + (hz / high_hz) ** 6)
    band = np.fft.irfft(spectrum * shape, clock.frames)
    return band / float(np.sqrt(np.mean(band**2)))


def burst(clock: Clock, stream: int, start_s: float, bands: Sequence[tuple[float, float, float, float]]) -> Signal:
    """Return a noisy blow; each band is (low Hz, high Hz, level dB, decay s), so highs can die before lows."""
    times = clock.times(start_s)
    total = np.zeros(clock.frames)
    for number, (low_hz, high_hz, level_db, decay_s) in enumerate(bands):
        total += gain(level_db) * noise(clock, stream + number, low_hz, high_hz) * struck(times, 0.0004, decay_s)
    return total


def metal(clock: Clock, stream: int, start_s: float, modes: Sequence[tuple[float, float, float]]) -> Signal:
    """Return a struck plate; each mode is (Hz, level dB, decay s), detuned a little as cast metal is."""
    draws = clock.draws(stream)
    times = clock.times(start_s)
    total = np.zeros(clock.frames)
    for hz, level_db, decay_s in modes:
        actual = hz * (1 + 0.012 * draws.standard_normal())
        beat = 1 + 0.0016 * draws.standard_normal()
        phase = TURN * draws.random()
        pair = np.sin(TURN * actual * times + phase) + 0.6 * np.sin(TURN * actual * beat * times + 1.7 * phase)
        total += gain(level_db) * pair * struck(times, 0.0006, decay_s)
    return total


def swirl(clock: Clock, cycles: int, phase: float = 0.0) -> Signal:
    """Return a slow sine with whole cycles in the sound, so a loop of it has no seam."""
    turns = cycles * np.arange(clock.frames) / clock.frames
    heard: Signal = np.sin(TURN * turns + phase)
    return heard


def around(signal: Signal, start_s: float, clock: Clock) -> Signal:
    """Return the signal begun later, its end carried round to the beginning of the loop."""
    return np.roll(signal, round(start_s * clock.sample_rate_hz))


def driven(signal: Signal, amount: float) -> Signal:
    """Return the signal with soft, warm peaks."""
    warm: Signal = np.tanh(amount * signal / np.abs(signal).max())
    return warm / float(np.tanh(amount))


def rumble_off(signal: Signal, clock: Clock, below_hz: float = 25.0) -> Signal:
    """Return the signal without DC and rumble; silence is put around it so that nothing wraps."""
    padded = np.concatenate([signal, np.zeros(clock.frames)])
    ratio = np.fft.rfftfreq(len(padded), 1 / clock.sample_rate_hz) / below_hz
    cut = ratio**2 / (ratio**2 - 1 - 1j * np.sqrt(2) * ratio)  # second-order Butterworth
    return np.fft.irfft(np.fft.rfft(padded) * cut, len(padded))[: clock.frames]


def faded(signal: Signal, clock: Clock, out_s: float, in_s: float = 0.0003) -> Signal:
    """Return the signal with its edges at zero."""
    times = clock.times()
    return signal * np.clip(times / in_s, 0.0, 1.0) * ramp(times, clock.duration_s, clock.duration_s - out_s)


def between_samples_peak(samples: Signal) -> float:
    """Return the highest point of the curve through the samples, shape (frames, channels)."""
    frames = len(samples)
    spectrum = np.fft.rfft(samples, axis=0)
    curve = np.fft.irfft(spectrum, frames * OVERSAMPLING, axis=0) * OVERSAMPLING
    return float(np.abs(curve).max())


def at_true_peak(samples: Signal, level_dbtp: float) -> Signal:
    """Return the samples at a true peak; it is never below their sample peak."""
    return samples * (gain(level_dbtp) / between_samples_peak(samples))


def at_rms(samples: Signal, level_dbfs: float) -> Signal:
    """Return the samples at an RMS level, full scale being ±1.0."""
    return samples * (gain(level_dbfs) / float(np.sqrt(np.mean(samples**2))))


def mono(signal: Signal) -> Signal:
    """Return one channel as samples, shape (frames, 1)."""
    return signal[:, np.newaxis]


def panned(signal: Signal, side: float) -> Signal:
    """Return the signal between left (−1) and right (1) at equal power, shape (frames, 2)."""
    angle = (side + 1) * np.pi / 4
    return np.stack([np.cos(angle) * signal, np.sin(angle) * signal], axis=1)


def wide(part: Callable[[int], Signal]) -> Signal:
    """Return two channels of the same part, each with different random numbers, shape (frames, 2)."""
    return np.stack([part(0), part(1)], axis=1)
