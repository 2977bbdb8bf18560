"""What the sounds of `third_unseen_sounds` are made of: noise, bursts, rung bodies, rooms and recordings' own noise."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from benchmarks.faults.sounds import Samples

Floats = NDArray[np.float64]
Gain = Callable[[Floats, Floats], Floats]
"""Of frequencies in hertz, a row, and shares of the sound that are past, a column."""

ATTACK_S = 0.0007  # of what is knocked
AIR_DB = (-80.0, -70.0)  # of a recording's own noise, under the peak


def times(rate: int, seconds: float) -> Floats:
    return np.arange(round(seconds * rate)) / rate


def risen(since_s: Floats, length: float) -> Floats:
    """From nothing, at zero, round up to one."""
    return np.sin(np.pi / 2 * np.clip(since_s / length, 0, 1)) ** 2


def both_ends(inside: Floats, rise_s: float, fall_s: float) -> Floats:
    return risen(inside, rise_s) * risen(inside[-1] - inside, fall_s)


def place(right: float | Floats) -> Floats:
    """Gains of the left and the right channel for something so far to the right, 0 to 1."""
    return np.sqrt(np.stack((1 - np.asarray(right), np.asarray(right)), -1))


def put(sides: Samples, piece: Floats, at_s: float, rate: int, gains: Floats) -> None:
    """Add a piece to both channels at this moment; what would lie after the end is left out."""
    first = round(at_s * rate)
    there = piece[: max(0, len(sides) - first)]
    sides[first : first + len(there)] += there[:, np.newaxis] * gains


def rung(
    rng: np.random.Generator, rate: int, hz: Floats, decay_s: Floats, strong: Floats, rise_s: float = ATTACK_S
) -> Floats:
    """One knock on something with these partials; it is over after eight times its longest decay."""
    inside = times(rate, min(1.5, 8 * float(decay_s.max())))
    heard = hz < 0.42 * rate
    waves = np.sin(2 * np.pi * np.outer(hz[heard], inside) + rng.uniform(0, 6, (int(heard.sum()), 1)))
    rung: Floats = (strong[heard, np.newaxis] * waves * np.exp(-inside / decay_s[heard, np.newaxis])).sum(axis=0)
    return rung * both_ends(inside, rise_s, 0.2 * inside[-1])


def burst(
    rng: np.random.Generator, rate: int, decay_s: float, low_hz: float, high_hz: float, rise_s: float = ATTACK_S
) -> Floats:
    """Noise between two frequencies that dies away, of unit RMS before it does."""
    inside = times(rate, 8 * decay_s + 0.02)
    noise = filtered(
        rng.standard_normal((len(inside), 1)),
        rate,
        lambda hz: (hz / low_hz) ** 2 / (1 + (hz / low_hz) ** 2) / (1 + (hz / high_hz) ** 4),
    )[:, 0]
    return noise / noise.std() * np.exp(-inside / decay_s) * both_ends(inside, rise_s, 0.01)


def painted(rng: np.random.Generator, times: Floats, gain: Gain) -> Floats:
    """Noise of unit RMS whose spectrum changes at random every 10 ms."""
    hop = round(0.01 / times[1])
    count = len(times) // hop + 2
    window = np.sin(np.pi * (np.arange(2 * hop) + 0.5) / (2 * hop))
    noise = rng.standard_normal((count + 1) * hop)
    blocks = np.stack([noise[one * hop : (one + 2) * hop] for one in range(count)]) * window
    hz = np.fft.rfftfreq(2 * hop, times[1])[np.newaxis, :]
    past = np.clip(np.arange(count) * hop / len(times), 0, 1)[:, np.newaxis]
    painted = np.fft.irfft(np.fft.rfft(blocks, axis=1) * gain(hz, past), 2 * hop, axis=1) * window
    whole = np.zeros((count + 1) * hop)
    whole[: count * hop] += painted[:, :hop].ravel()
    whole[hop:] += painted[:, hop:].ravel()
    return whole[hop : hop + len(times)] / whole.std()


def course(rng: np.random.Generator, times: Floats, pace_hz: float) -> Floats:
    """A smooth course about zero, of unit RMS, that turns about so many times a second."""
    knots = rng.standard_normal(int(2 * pace_hz * times[-1]) + 6)
    at = times * 2 * pace_hz + 1 + rng.random()
    before = at.astype(int)
    share = at - before
    p0, p1, p2, p3 = (knots[np.minimum(before + shift, len(knots) - 1)] for shift in (-1, 0, 1, 2))
    curve = p1 + 0.5 * share * (p2 - p0 + share * (2 * p0 - 5 * p1 + 4 * p2 - p3 + share * (3 * (p1 - p2) + p3 - p0)))
    return curve / 0.85


def filtered(sound: Samples, rate: int, gain: Callable[[Floats], Floats]) -> Samples:
    """The sound with each frequency at its gain; nothing turns up at its other end."""
    length = 1 << (2 * len(sound) - 1).bit_length()
    hz = np.fft.rfftfreq(length, 1 / rate)
    hz[0] = 1e-3
    spectrum = np.fft.rfft(sound, length, axis=0) * gain(hz)[:, np.newaxis]
    filtered: Samples = np.fft.irfft(spectrum, length, axis=0)[: len(sound)]
    return filtered


def in_room(rng: np.random.Generator, sides: Samples, rate: int, decay_s: float, share: float) -> Samples:
    """The sound with its room: for each ear another noise that dies away, duller than the sound."""
    after = times(rate, min(1.5, 7 * decay_s))
    length = 1 << (len(sides) + len(after) - 1).bit_length()
    wet = np.zeros_like(sides)
    hz = np.fft.rfftfreq(length, 1 / rate)
    for side in range(2):
        echoes = rng.standard_normal(len(after)) * np.exp(-after / decay_s) * both_ends(after, 0.005, 0.2 * after[-1])
        spectrum = np.fft.rfft(sides.mean(axis=1), length) * np.fft.rfft(echoes, length) / (1 + (hz / 3_500) ** 2)
        wet[:, side] = np.fft.irfft(spectrum, length)[: len(sides)]
    return sides + share * wet * np.abs(sides).max() / np.abs(wet).max()


def delivered(
    rng: np.random.Generator, sides: Samples, rate: int, rise_s: float, fall_s: float, *, recorded: bool = True
) -> Samples:
    """The sound as it leaves an editor: low cut, faded at both ends, centred, two times of five in mono."""
    cut: Samples = filtered(sides, rate, lambda hz: (hz / 20) ** 4 / (1 + (hz / 20) ** 4))
    if recorded:
        cut = cut + np.abs(cut).max() * 10 ** (rng.uniform(*AIR_DB) / 20) * rng.standard_normal(cut.shape)
    fades = both_ends(np.arange(len(cut)) / rate, rise_s, fall_s)[:, np.newaxis]
    faded = cut * fades
    faded -= fades * faded.sum(axis=0) / fades.sum()
    return faded.mean(axis=1, keepdims=True) if rng.random() < 0.4 else faded
