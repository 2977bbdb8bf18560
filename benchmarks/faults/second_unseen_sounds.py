"""Yet other whole sounds, by other means than those of `sounds`: unseen until they had been looked at once.

Nothing but forces, modes, harmonics and noise in bands, put together as the thing that sounds would do it.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from benchmarks.faults.sounds import Family, Samples

Floats = NDArray[np.float64]

FREE_DISC = np.array([1.0, 1.73, 2.33, 3.91, 4.11, 6.30, 6.71])  # modes over the lowest, after Leissa
TUNED_BAR = np.array([1.0, 3.93, 9.24])  # a marimba's, whose second mode is tuned to two octaves
SOFTEST_STROKE_S = 0.0005  # no mode is there at once, however hard what strikes it
AIR_DB = -72.0  # of the microphone's own noise in pauses, under the peak


def blades(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Two swords that clash and chatter, and at times slide along each other before they part."""
    times = _times(rate, seconds)
    meet_s = rng.uniform(0.01, 0.03) + np.cumsum([0.0, *rng.uniform(0.006, 0.035, rng.integers(0, 4))])
    clash = _force(times, meet_s, rng.uniform(0.5, 1, len(meet_s)) * 0.6 ** np.arange(len(meet_s)))
    slide = rng.uniform(0, 0.015) * _noise(rng, times, lambda hz: 1 / (1 + (hz / 5_000) ** 2))
    slide *= _hump(times, meet_s[-1], rng.uniform(0.15, 0.5)) * (rng.random() < 0.6)
    sides = np.zeros((len(times), 2))
    for place in rng.uniform(0.3, 0.7, 2):  # one blade left of the middle, one right of it
        numbers = np.arange(5, 24)
        hz = rng.uniform(28, 60) * ((2 * numbers + 1) / 3) ** 2  # of a bar with free ends
        decay_s = rng.uniform(0.25, 0.7) / (1 + hz / 1_800)
        strength = np.abs(np.sin(numbers * np.pi * rng.uniform(0.1, 0.4))) / (1 + (hz / 6_000) ** 2)
        rung = _through(clash + slide, _modes(rng, times, hz, decay_s, strength))
        sides += rung[:, np.newaxis] * np.sqrt([place, 1 - place])
    return _taken(rng, sides, rate, 0.002, 0.08)


def coin(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A coin flicked on a table, where it spins, rolls on its edge ever faster, and lies still."""
    times = _times(rate, seconds)
    rest_s = seconds * rng.uniform(0.75, 0.9)
    turn_hz = rng.uniform(7, 14) * np.maximum(1 - times / rest_s, 1e-3) ** -rng.uniform(0.35, 0.5)
    turns = np.cumsum(np.where(times < rest_s, np.minimum(turn_hz, 110), 0)) / rate
    touch_s = np.flatnonzero(np.diff(np.floor(turns + 0.9))) / rate
    touch_s = touch_s + rng.normal(0, 0.0015, len(touch_s))
    weight = rng.uniform(0.4, 1, len(touch_s)) * np.maximum(1 - touch_s / rest_s, 0) ** 0.6
    hz = rng.uniform(2_200, 4_800) * FREE_DISC
    ring = _modes(rng, times, hz, rng.uniform(0.02, 0.12) * (hz[0] / hz) ** 0.7, 1 / (1 + np.arange(len(hz)) / 3))
    wood = _modes(rng, times, rng.uniform(140, 700, 4), rng.uniform(0.006, 0.02, 4), rng.uniform(0.1, 0.5, 4))
    flick = _through(_force(times, [0.006], [1.0]), _modes(rng, times, hz, rng.uniform(0.1, 0.4) * hz[0] / hz, 1 / hz))
    rolled = _through(_force(times, touch_s, weight), ring + wood)
    return _taken(rng, rolled[:, np.newaxis] / np.abs(rolled).max() + flick[:, np.newaxis] / hz[0], rate, 0.002, 0.05)


def creak(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A door on a dry hinge: it sticks and slips, slower and faster, and the panel sounds at each slip."""
    times = _times(rate, seconds)
    swing = np.exp(0.5 * _wander(rng, times, 4)) * (0.5 + np.sin(np.pi * times / seconds))
    slips = np.cumsum(rng.uniform(22, 90) * swing * (1 + 0.15 * _wander(rng, times, 60))) / rate
    at_s = np.flatnonzero(np.diff(np.floor(slips))) / rate
    weight = np.diff(at_s, prepend=-0.02) ** 0.5 * rng.uniform(0.5, 1, len(at_s))  # the longer it stuck the more
    hz = np.exp(rng.uniform(np.log(180), np.log(4_000), 14))
    panel = _modes(rng, times, hz, rng.uniform(2, 7, 14) / hz, (300 / hz) ** rng.uniform(0.8, 1.4))
    room = _noise(rng, times, lambda hz: 1 / (1 + hz / 2_000)) * np.exp(-times / rng.uniform(0.04, 0.15))
    dry = np.diff(_through(_force(times, at_s, weight), panel), prepend=0.0)  # air hears how a panel speeds up
    wet = _through(dry, room)
    return _taken(rng, (dry / dry.std() + 0.25 * wet / wet.std())[:, np.newaxis], rate, 0.01, 0.08)


def gravel(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Boots on gravel: thousands of stones that knock against each other while a weight rolls over them."""
    times = _times(rate, seconds)
    weight = np.zeros(len(times))
    for at in np.arange(rng.uniform(0.02, 0.08), seconds - 0.15, rng.uniform(0.3, 0.6)):
        heel, toe = rng.uniform(0.05, 0.09), rng.uniform(0.1, 0.2)
        weight += rng.uniform(0.6, 1) * (_hump(times, at, heel) + 0.7 * _hump(times, at + 0.8 * heel, toe))
    thud = _noise(rng, times, lambda hz: np.exp(-(((hz - 90) / 50) ** 2))) * weight**2
    knocks = rng.random(len(times)) < rng.uniform(1_500, 5_000) / rate * weight
    sides = np.zeros((len(times), 2))
    for _ in range(3):  # sizes of stone
        force = knocks * rng.gamma(2, 1, len(times)) * weight * (rng.random(len(times)) < 0.5)
        hz = np.exp(rng.uniform(np.log(1_200), np.log(9_000), 3))
        stone = _modes(rng, times[: rate // 20], hz, rng.uniform(0.0004, 0.0018, 3), rng.uniform(0.3, 1, 3))
        sides += _through(force, stone)[:, np.newaxis] * rng.uniform(0.4, 1, 2)
    return _taken(rng, sides / sides.std() + 0.5 * thud[:, np.newaxis], rate, 0.01, 0.05)


def surf(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A wave that swells from below, breaks, and runs out as foam: each octave comes later and stays longer."""
    times = _times(rate, seconds)
    breaks = rng.uniform(0.25, 0.45)
    length = _quick(len(times))
    alike, apart = rng.standard_normal((length, 1)), rng.standard_normal((length, 2))
    water = np.fft.rfft(alike + rng.uniform(0.2, 0.6) * apart, axis=0)
    octaves = np.log2(np.fft.rfftfreq(length, times[1]) / 70 + 1e-9)[:, np.newaxis]
    sea = np.zeros((len(times), 2))
    for octave in range(8):
        since = times / seconds - breaks - 0.02 * (octave - 4)
        swell = np.where(since < 0, np.exp(since * rng.uniform(6, 14)), np.exp(-since * (5 - 0.45 * octave)))
        loud = swell * np.exp(0.35 * _wander(rng, times, 9)) * 2 ** (-octave * rng.uniform(0.5, 0.75))
        sea += (
            np.fft.irfft(water * np.exp(-(((octaves - octave) / 0.7) ** 2)), length, axis=0)[: len(times)]
            * loud[:, np.newaxis]
        )
    return _taken(rng, sea, rate, 0.08 * seconds, 0.2 * seconds)


def swarm(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Flies and gnats about the head: wings that beat at their own rate and pass by near and far."""
    times = _times(rate, seconds)
    cloud = np.zeros((len(times), 2))
    for _ in range(rng.integers(3, 11)):
        along = rng.uniform(1.5, 6) * (times - rng.uniform(0, seconds)) + 0.3 * _wander(rng, times, 3)
        away = np.hypot(along, rng.uniform(0.15, 1.2))
        doppler = 1 - np.gradient(away) * rate / 343
        beat_hz = rng.uniform(110, 520) * (1 + 0.03 * _wander(rng, times, 12)) * doppler
        numbers = np.arange(1, 25)
        weights = rng.uniform(0.3, 1, 24) * numbers ** -rng.uniform(0.4, 1) * np.exp(-numbers / rng.uniform(3, 6))
        place = 0.5 + 0.45 * along / away
        cloud += (_harmonics(beat_hz, weights, rate) / away)[:, np.newaxis] * np.sqrt(np.stack((place, 1 - place), 1))
    return _taken(rng, cloud, rate, 0.06, 0.1)


def beast(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A large animal's snarl: folds that beat unevenly, two by two, below a mouth that opens and closes."""
    times = _times(rate, seconds)
    effort = np.sin(np.pi * (times / seconds) ** rng.uniform(0.5, 1)) ** 0.7
    fold_hz = rng.uniform(48, 105) * (0.75 + 0.5 * effort) * (1 + 0.04 * _wander(rng, times, 35))
    open_share = np.clip(effort + 0.2 * _wander(rng, times, 5), 0, 1)
    half_rate = np.sin(np.pi * np.cumsum(fold_hz) / rate)  # every second beat is weaker
    uneven = 1 + rng.uniform(0.2, 0.7) * half_rate * (1 + 0.5 * _wander(rng, times, 20))
    hz = np.arange(1, 80) * fold_hz.mean()
    snarl = np.zeros(len(times))
    for share, throat in ((open_share, (650, 1_150, 2_500)), (1 - open_share, (320, 750, 2_200))):
        centres = np.array(throat) * rng.uniform(0.6, 1.1)
        snarl += share * _harmonics(fold_hz, _formants(hz, centres) / hz**0.7 * 30, rate)
        breath = _noise(rng, times, lambda hz, centres=centres: _formants(hz, centres) * np.exp(-hz / 6_000))
        snarl += rng.uniform(0.1, 0.6) * share * breath * (1 + half_rate) * snarl.std()
    return _taken(rng, (snarl * uneven * effort)[:, np.newaxis], rate, 0.02, 0.06)


def heart(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A heart heard from within: two soft thuds a beat, with the blood's rush between them."""
    times = _times(rate, seconds)
    beat = np.zeros(len(times))
    gap_s, hz = min(rng.uniform(0.5, 0.95), 1.2 * seconds), rng.uniform(38, 62)
    for at in np.arange(rng.uniform(0.02, 0.06), max(0.1, seconds - 0.36 * gap_s - 0.2), gap_s):
        for late, pitch, loud in ((0.0, 1.0, 1.0), (0.36 * gap_s, rng.uniform(1.2, 1.5), rng.uniform(0.5, 0.9))):
            since = np.maximum(times - at - late, 0)
            rise = 1 - np.exp(-((since / 0.018) ** 2))
            turns = pitch * hz * (since + 0.012 * (1 - np.exp(-since / 0.03)))
            beat += loud * rise * np.exp(-since * rng.uniform(14, 24)) * np.sin(2 * np.pi * turns)
        rush = _noise(rng, times, lambda hz: np.exp(-((np.log(hz / 180) / 0.6) ** 2)))
        beat += rng.uniform(0.01, 0.06) * rush * _hump(times, at + 0.05, 0.3 * gap_s)
    return _taken(rng, beat[:, np.newaxis], rate, 0.01, 0.08)


def spell(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Magic that gathers: many thin tones climb without end through one band, in a halo of air, and let go."""
    times = _times(rate, seconds)
    gather = (times / seconds) ** rng.uniform(1, 2)
    climb = rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 1.2) * (times + gather * seconds)  # octaves
    low_hz, octaves = rng.uniform(250, 500), 4.2
    count = rng.integers(14, 26)
    shine = np.zeros((len(times), 2))
    for start in np.arange(count) * octaves / count + rng.normal(0, 0.05, count):
        height = (start + climb) % octaves
        turns = np.cumsum(low_hz * 2**height) / rate
        loud = np.sin(np.pi * height / octaves) ** 2 * 2 ** (-0.4 * height)
        loud *= 1 + 0.6 * np.sin(2 * np.pi * (rng.uniform(2, 9) * times + rng.random()))
        side = 0.5 + 0.4 * np.sin(2 * np.pi * (rng.uniform(0.3, 1.5) * times + rng.random()))
        shine += (loud * np.sin(2 * np.pi * turns))[:, np.newaxis] * np.sqrt(np.stack((side, 1 - side), 1))
    for side in range(2):
        shine[:, side] += (
            rng.uniform(0.2, 0.8) * gather * _noise(rng, times, lambda hz: (hz / 4e3) / (1 + (hz / 4e3) ** 3))
        )
    let_go = np.exp(-np.maximum(times / seconds - rng.uniform(0.65, 0.8), 0) * rng.uniform(8, 14))
    return _taken(rng, shine * (np.sqrt(gather) * let_go)[:, np.newaxis], rate, 0.03, 0.1)


def confirm(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A menu's yes: a few soft mallets on wooden bars, in a small bright plate's reverberation."""
    times = _times(rate, seconds)
    steps = rng.permutation([0, 4, 7, 12, 16])[: rng.integers(2, 5)]
    step_s = min(rng.uniform(0.07, 0.16), 0.6 * seconds / len(steps))
    lowest_hz, ring_s = 523.25 * rng.uniform(0.8, 1.3), seconds * rng.uniform(0.07, 0.18)
    dry = np.zeros(len(times))
    for number, step in enumerate(np.sort(steps) if rng.random() < 0.7 else steps):
        hz = lowest_hz * 2 ** (step / 12) * TUNED_BAR
        bar = _modes(rng, times, hz, ring_s / TUNED_BAR**0.9, np.array([1, 0.3, 0.1]), 0.0015)
        dry += _through(_force(times, [0.005 + number * step_s], [rng.uniform(0.7, 1)]), bar)
    both = np.zeros((len(times), 2))
    for side in range(2):
        plate = _noise(rng, times, lambda hz: hz / (hz + 400) / (1 + (hz / 7e3) ** 2))
        plate *= np.exp(-times / rng.uniform(0.06, 0.25)) * (1 - np.exp(-times / 0.004))
        wet = _through(dry, plate)
        both[:, side] = dry + rng.uniform(0.1, 0.4) * wet * np.abs(dry).max() / np.abs(wet).max()
    return _taken(rng, both, rate, 0.002, min(0.25, 0.3 * seconds))


def alarm(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A ship's siren from a horn at the end of a corridor: two tones in turn, or whoops, or pulses."""
    times = _times(rate, seconds)
    low_hz, ratio, pace_hz = rng.uniform(380, 950), rng.uniform(1.15, 2.2), rng.uniform(1.2, 4)
    phase = (times * pace_hz) % 1
    kind = rng.integers(0, 3)
    turn = 0.5 + 0.5 * np.tanh(np.sin(2 * np.pi * phase) * rng.uniform(5, 15))
    rise = np.where(phase < 0.92, phase / 0.92, 0.5 + 0.5 * np.cos(np.pi * (phase - 0.92) / 0.08))
    hz = low_hz * ratio ** (turn, rise, np.zeros(len(times)))[kind]
    loud = (turn if kind == 2 else 1) * np.sin(
        np.pi / 2 * np.clip(times / 0.01, 0, 1)
    ) ** 2  # or echoes start in a step
    numbers = np.arange(1, int(0.45 * rate / hz.max()))[:40]
    horn = 1 / (1 + (500 / (numbers * low_hz)) ** 4) / (1 + (numbers * low_hz / rng.uniform(2_500, 5_000)) ** 2)
    dry = loud * _harmonics(hz, horn * rng.uniform(0.4, 1, len(numbers)) / numbers**0.5, rate)
    heard = np.stack((dry, dry), 1)
    for _ in range(rng.integers(3, 8)):  # walls, each with what it swallows
        late = round(rng.uniform(0.012, 0.12) * rate)
        dull = _low_passed(dry, rate, rng.uniform(1_200, 4_000))
        heard[late:] += dull[:-late, np.newaxis] * rng.uniform(0.05, 0.4, 2)
    return _taken(rng, heard, rate, 0.01, 0.06)


def blast(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A charge set off in a street: the pressure wave, then its echoes from ever farther, longer and duller."""
    times = _times(rate, seconds)
    sides = np.zeros((len(times), 2))
    first_s = rng.uniform(0.01, 0.02)
    length_s = rng.uniform(0.0025, 0.006)
    for far, share in enumerate((0.0, 0.08, 0.25, 0.5)):
        wave_s = length_s * 2.2**far
        count = 1 if far == 0 else rng.integers(15, 60)
        at_s = first_s + share * seconds + (0 if far == 0 else rng.exponential(0.16 * seconds, count))
        weight = (
            np.exp(-(at_s - first_s) / seconds * rng.uniform(3, 6))
            * rng.uniform(0.2, 1, count)
            * (2 if far == 0 else 1)
        )
        for side in range(2):
            late_s = at_s + rng.uniform(0, 0.0006, np.size(at_s))
            shock = _shock(rate, wave_s, max(SOFTEST_STROKE_S, 0.15 * wave_s))
            sides[:, side] += _through(_force(times, np.atleast_1d(late_s), np.atleast_1d(weight)), shock)
    since = np.maximum(times - first_s, 0)
    rumble = np.stack([_noise(rng, times, lambda hz: 1 / (1 + (hz / 110) ** 2)) for _ in range(2)], 1)
    dust = np.stack([_noise(rng, times, lambda hz: 1 / (1 + hz / 900)) for _ in range(2)], 1)
    rolling = (1 - np.exp(-since / 0.02)) * np.exp(-since / seconds * rng.uniform(3, 5))
    sides += (rng.uniform(0.1, 0.3) * rumble + rng.uniform(0.02, 0.08) * dust) * rolling[:, np.newaxis]
    return _taken(rng, sides, rate, 0.004, 0.2 * seconds)


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in (blades, coin, creak, gravel, surf, swarm, beast, heart, spell, confirm, alarm, blast)
}


def _times(rate: int, seconds: float) -> Floats:
    return np.arange(round(seconds * rate)) / rate


def _force(times: Floats, at_s: Sequence[float] | Floats, weight: Sequence[float] | Floats) -> Floats:
    """Pushes at these moments, those outside the sound left out."""
    force = np.zeros(len(times))
    frames = np.round(np.asarray(at_s) / times[1]).astype(int)
    inside = (frames >= 0) & (frames < len(times))
    np.add.at(force, frames[inside], np.asarray(weight)[inside])
    return force


def _quick(length: int) -> int:
    """The next power of two, which a Fourier transform is quick for."""
    return 1 << (length - 1).bit_length()


def _through(force: Floats, answer: Floats) -> Floats:
    """What a body that answers one push so gives to this force."""
    length = _quick(len(force) + len(answer))
    return np.fft.irfft(np.fft.rfft(force, length) * np.fft.rfft(answer, length), length)[: len(force)]


def _modes(
    rng: np.random.Generator,
    times: Floats,
    hz: Floats,
    decay_s: Floats,
    strength: Floats,
    rise_s: float = SOFTEST_STROKE_S,
) -> Floats:
    """Partials that come within `rise_s` and die away, each in its own time; none above 0.45 of the sample rate."""
    answer = np.zeros(len(times))
    for one, decay, strong in zip(hz, decay_s, strength, strict=True):
        if one < 0.45 / times[1]:
            turns = one * times + rng.uniform(-0.1, 0.1)
            answer += strong * np.exp(-times / decay) * np.sin(2 * np.pi * turns)
    return answer * np.sin(np.pi / 2 * np.clip(times / rise_s, 0, 1)) ** 2


def _harmonics(hz: Floats, weights: Floats, rate: int) -> Floats:
    """A voice of harmonics of a pitch that moves; none that would pass 0.45 of the sample rate."""
    weights = weights[: int(0.45 * rate / hz.max())]
    turn = np.exp(2j * np.pi * np.cumsum(hz) / rate)
    voice = np.zeros(len(hz), dtype=complex)
    for weight in weights[::-1]:  # Horner's rule: a power of the turn is a harmonic
        voice = (voice + weight) * turn
    return voice.imag


def _noise(rng: np.random.Generator, times: Floats, gain: Callable[[Floats], Floats]) -> Floats:
    """Noise of unit RMS whose spectrum follows `gain`."""
    length = _quick(len(times))
    hz = np.fft.rfftfreq(length, times[1])
    hz[0] = hz[1]
    noise = np.fft.irfft(np.fft.rfft(rng.standard_normal(length)) * gain(hz), length)[: len(times)]
    return noise / noise.std()


def _wander(rng: np.random.Generator, times: Floats, pace_hz: float) -> Floats:
    """A smooth course of unit RMS that goes nowhere for long."""
    knots = np.linspace(0, times[-1], round(50 * pace_hz * times[-1]) + 8)
    return np.interp(times, knots, _noise(rng, knots, lambda hz: np.exp(-((hz / pace_hz) ** 2))))


def _formants(hz: Floats, centres: Floats) -> Floats:
    """The gain of a mouth with resonances a fifth of their frequency wide."""
    total: Floats = sum(1 / (1 + ((hz - centre) / (0.1 * centre)) ** 2) for centre in centres) + np.full(len(hz), 0.03)
    return total


def _shock(rate: int, length_s: float, rise_s: float) -> Floats:
    """A pressure wave: up at once, evenly down through nothing, and back; its corners are `rise_s` long."""
    wave = np.linspace(1, -1, round(length_s * rate))
    corner = np.hanning(round(2 * rise_s * rate) + 2)
    return np.convolve(wave, corner / corner.sum())


def _low_passed(sound: Floats, rate: int, corner_hz: float) -> Floats:
    length = _quick(2 * len(sound))
    hz = np.fft.rfftfreq(length, 1 / rate)
    return np.fft.irfft(np.fft.rfft(sound, length) / (1 + (hz / corner_hz) ** 2), length)[: len(sound)]


def _hump(times: Floats, start_s: float, length_s: float) -> Floats:
    """From nothing to one and back between two moments."""
    return np.sin(np.pi * np.clip((times - start_s) / length_s, 0, 1)) ** 2


def _taken(rng: np.random.Generator, sound: Samples, rate: int, rise_s: float, fall_s: float) -> Samples:
    """The sound as an editor leaves it: without what lies under hearing, faded at both ends, at times in mono."""
    length = _quick(2 * len(sound))
    hz = np.fft.rfftfreq(length, 1 / rate)[:, np.newaxis]
    heard = np.fft.irfft(np.fft.rfft(sound, length, axis=0) * (hz / 18) ** 4 / (1 + (hz / 18) ** 4), length, axis=0)
    taken: Samples = heard[: len(sound)]
    taken += np.abs(taken).max() * 10 ** (AIR_DB / 20) * rng.standard_normal(taken.shape)
    times = np.arange(len(taken)) / rate
    fades = np.clip(times / rise_s, 0, 1) * np.clip((times[-1] - times) / fall_s, 0, 1)
    taken = taken * fades[:, np.newaxis]
    return taken.mean(axis=1, keepdims=True) if rng.random() < 0.4 else taken
