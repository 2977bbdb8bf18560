"""Held-out families of whole game sounds, made by other means: no detector was tuned on them.

Pushes into banks of resonators, a pipe that is blown, closed forms of rich tones, tape that runs at a changing speed,
and a lightning's shape in space.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates
from scipy.signal import butter, fftconvolve, lfilter, sosfilt

from benchmarks.faults.sounds import Family, Samples

Floats = NDArray[np.float64]

CONTACT_S = 0.0007  # the shortest that hard things touch here
AIR_DB = (-88.0, -74.0)  # of a recording's own noise, under the peak
SOUND_M_S = 343.0


def thunder(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Lightning heard from aside: each bend of its channel sounds when its wave arrives, the far ones dull."""
    times = _times(rate, seconds)
    bends = np.cumsum(rng.standard_normal((3_000, 3)) * [9, 9, 4] + [0, 0, 1], axis=0)
    far_m = np.linalg.norm(bends + np.array([rng.uniform(40, 250), 0, 5]), axis=1)
    loud = rng.pareto(2.2, len(far_m)) * np.abs(rng.standard_normal(len(far_m))) / far_m
    spread = rng.uniform(0.35, 0.55) * seconds / (np.quantile(far_m, 0.9) - far_m.min())
    sides = np.zeros((len(times), 2))
    for side, ear_m in enumerate((-0.1, 0.1)):
        arrives_s = 0.02 + spread * (far_m - far_m.min()) + ear_m * bends[:, 1] / far_m / SOUND_M_S
        for length_s, share in ((0.0008, 2 * np.exp(-arrives_s / 0.15)), (0.004, 1.0), (0.012, 0.6 + arrives_s)):
            wave = _ricker(rate, length_s)
            sides[:, side] += fftconvolve(_arrivals(times, arrives_s, loud * share), wave)[: len(times)] / length_s**0.5
    sides *= np.exp(-times * rng.uniform(1.5, 3.5) / seconds)[:, np.newaxis]
    return _mastered(rng, _in_space(rng, sides, rate, 0.2 * seconds, 0.5), rate, 0.008, 0.3 * seconds)


def flute(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A flute of bamboo: breath across a hole, whose jet drives the pipe and is bent by it; one to three notes."""
    times = _times(rate, seconds)
    notes = int(rng.integers(1, 4)) if seconds > 0.9 else 1
    lowest_hz, played = rng.uniform(330, 700), np.zeros(len(times))
    for number, step in enumerate(rng.choice([0, 2, 5, 7, 9], notes, replace=False)):
        start_s, length_s = 0.02 + number * (seconds - 0.1) / notes, (seconds - 0.1) / notes * rng.uniform(0.95, 1.1)
        puff = _step(times - start_s, rng.uniform(0.03, 0.08)) * _step(start_s + length_s - times, 0.08)
        vibrato = 1 + 0.06 * np.sin(2 * np.pi * rng.uniform(4, 6.5) * times) * _step(times - start_s, 0.5)
        blown = _blown_pipe(
            rng, puff * vibrato * (1 + 0.04 * _drift(rng, times, 2)), rate, lowest_hz * 2 ** (step / 12)
        )
        played += blown * puff
    both = _in_space(rng, np.repeat(played[:, np.newaxis], 2, axis=1), rate, rng.uniform(0.1, 0.4), 0.25)
    return _mastered(rng, both, rate, 0.02, 0.15 * seconds)


def motorbike(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A motorbike that pulls away: two cylinders that fire unevenly into one pipe, with a change of gear at times."""
    times = _times(rate, seconds)
    shift = rng.uniform(0.4, 0.7) * seconds
    throttle = _step(times, 0.3 * seconds) * (1 - 0.7 * _step(times - shift, 0.08) * _step(shift + 0.3 - times, 0.15))
    turn_hz = rng.uniform(11, 20) * (1 + rng.uniform(1, 2.5) * throttle * (0.5 + times / seconds))
    turns = np.cumsum(turn_hz * (1 + 0.01 * _drift(rng, times, 8))) / rate
    fires_s = np.interp(np.add.outer(np.arange(0.1, turns[-1] - 315 / 720), [0, 315 / 720]).ravel(), turns, times)
    strong = (0.5 + np.interp(fires_s, times, throttle)) * rng.uniform(0.8, 1.2, len(fires_s))
    pushed = _pushes(times, fires_s, strong, rng.uniform(0.002, 0.005))
    pipe = round(rng.uniform(0.003, 0.007) * rate)
    feed = np.zeros(pipe + 3)
    feed[0], feed[pipe:] = 1.0, rng.uniform(0.15, 0.25)
    sounded = lfilter([1.0], feed, pushed - _pushes(times, fires_s + 0.004, strong, 0.008))
    rush = _hiss(rng, times, 300, rng.uniform(2_500, 6_000))[:, 0] * lfilter([0.02], [1, -0.98], pushed)
    lifted = _pushes(times, fires_s + 0.007, strong, 0.001)
    valves = _resonated(rng, lifted, rate, rng.uniform(900, 5_000, 5), 0.004)
    ride = sounded / sounded.std() + rng.uniform(0.2, 0.7) * rush / rush.std() + 0.15 * valves / valves.std()
    both = ride[:, np.newaxis] * _sides(0.5 + rng.uniform(-0.3, 0.3) * (2 * times / seconds - 1))
    return _mastered(rng, both, rate, 0.08 * seconds, 0.2 * seconds)


def snow(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Boots in cold snow: crust and grains that break under a weight, thousands small and few large, and a squeak."""
    times = _times(rate, seconds)
    walked = 1e-4 * _hiss(rng, times, 60, 900)
    at_s = rng.uniform(0.02, 0.06)
    while at_s < max(0.1, seconds - 0.4):
        length_s = min(rng.uniform(0.25, 0.45), seconds - at_s - 0.08)
        break_s = at_s + length_s * rng.beta(1.6, 2.4, rng.poisson(rng.uniform(1_500, 4_000) * length_s))
        sizes = np.minimum(rng.pareto(1.7, len(break_s)), 12) * rng.choice([-1, 1], len(break_s))
        crust = _pushes(times, break_s, sizes, rng.uniform(0.0004, 0.0008))
        crushed = _resonated(rng, crust, rate, np.exp(rng.uniform(np.log(700), np.log(9_000), 10)), 0.0025)
        force = np.sin(np.pi * np.clip((times - at_s) / length_s, 0, 1)) ** 2
        squeak = _at_speed(_narrow(rng, times, rng.uniform(900, 1_600), 90), 0.8 + 0.5 * force)
        pressed = _hiss(rng, times, 80, rng.uniform(300, 600))[:, 0]
        step = crushed / crushed.std() + (rng.uniform(0.1, 0.7) * squeak + 0.6 * pressed) * force
        walked += step[:, np.newaxis] * _sides(rng.uniform(0.4, 0.6))
        at_s += length_s + rng.uniform(0.1, 0.3)
    return _mastered(rng, walked, rate, 0.01, 0.08)


def door(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A wooden door that falls shut: the handle, a draught, the leaf against its frame, the latch that jumps in."""
    times = _times(rate, seconds)
    shut_s = seconds * rng.uniform(0.25, 0.4)
    wood_hz = rng.uniform(55, 90) * np.sort(rng.uniform(1, 14, 14))
    metal_hz = np.exp(rng.uniform(np.log(900), np.log(7_500), 10))
    bounces_s = shut_s + np.cumsum(np.append(0.0, rng.uniform(0.03, 0.07) * rng.uniform(0.4, 0.6) ** np.arange(5)))
    slam = _pushes(times, bounces_s, 0.35 ** np.arange(6), rng.uniform(0.002, 0.004))
    leaf = _resonated(rng, slam, rate, wood_hz, 0.05 * (60 / wood_hz) ** 0.5 + 0.008)
    clacks_s = np.append([0.03, rng.uniform(0.05, 0.08)], shut_s + 0.02 + np.cumsum(rng.uniform(0.006, 0.03, 4)))
    clack = _pushes(times, clacks_s, rng.uniform(0.2, 1, 6), CONTACT_S)
    latch = _resonated(rng, clack, rate, metal_hz, rng.uniform(0.004, 0.02, 10))
    draught = _hiss(rng, times, 100, 900)[:, 0] * _step(times, shut_s) ** 2 * _step(shut_s + 0.02 - times, 0.04)
    shut = leaf / np.abs(leaf).max() + rng.uniform(0.15, 0.5) * latch / np.abs(latch).max() + 0.03 * draught
    both = shut[:, np.newaxis] * _sides(rng.uniform(0.35, 0.65))
    return _mastered(rng, _in_space(rng, both, rate, rng.uniform(0.06, 0.3), 0.3), rate, 0.01, 0.2 * seconds)


def slots(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A slot machine: reels that tick past ever slower and lock one by one, and bells for what was won."""
    times = _times(rate, seconds)
    stops_s = seconds * np.array([0.22, 0.34, 0.5]) * rng.uniform(0.9, 1.1)
    pace_hz = rng.uniform(18, 40) * np.clip(1 - 0.8 * times / stops_s[-1], 0, 1)
    ticked = np.cumsum(pace_hz) / rate
    ticks_s = np.interp(np.arange(0.5, ticked[-1] - 0.5), ticked, times)
    ticks = _pushes(times, ticks_s, rng.uniform(0.3, 0.5, len(ticks_s)), 0.0008)
    plastic = _resonated(rng, ticks, rate, rng.uniform(1_100, 5_000, 5), 0.004)
    locks = _resonated(rng, _pushes(times, stops_s, np.ones(3), 0.002), rate, rng.uniform(120, 900, 6), 0.02)
    played = 0.3 * plastic / np.abs(plastic).max() + 0.6 * locks / np.abs(locks).max()
    won_s = np.arange(stops_s[-1] + 0.04, seconds - 0.1, rng.uniform(0.06, 0.12))
    for number, at_s in enumerate(won_s):
        hz = rng.choice([523.3, 587.3, 659.3]) * 2 ** ((0, 4, 7, 12)[number % 4] / 12)
        since = np.maximum(times - at_s, 0)
        bent = rng.uniform(0.5, 2) * np.exp(-since / 0.05) * np.sin(2 * np.pi * 3.5 * hz * since)
        played += 0.35 * _step(since, 0.0015) * np.exp(-since / 0.12) * np.sin(2 * np.pi * hz * since + bent)
    both = played[:, np.newaxis] * _sides(rng.uniform(0.4, 0.6))
    return _mastered(rng, _in_space(rng, both, rate, 0.05, 0.15), rate, 0.004, 0.1, recorded=False)


def cricket(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Crickets at night: teeth that a wing is drawn over, three to five strokes a chirp, near ones and far ones."""
    times = _times(rate, seconds)
    night = 0.0008 * _hiss(rng, times, 150, 2_500)
    for far in range(int(rng.integers(2, 5))):
        tone_hz, stroke_s = rng.uniform(3_600, 5_400), rng.uniform(0.014, 0.022)
        strokes, chirp_s = int(rng.integers(3, 6)), rng.uniform(0.25, 0.5)
        sung = np.zeros(len(times))
        for first_s in np.arange(rng.uniform(0.02, 0.1), seconds - 0.1, chirp_s):
            for stroke in range(strokes):
                share = np.clip((times - first_s - stroke * 1.7 * stroke_s) / stroke_s, 0, 1)
                drawn = np.sin(np.pi * share**0.7) ** 2 * (0.5 + 0.5 * (stroke + 1) / strokes)
                turns = tone_hz * (times - 0.03 * stroke_s * share**2)
                sung += drawn * (np.sin(2 * np.pi * turns) + 0.15 * np.sin(4 * np.pi * turns))
        sung *= 1 + 0.1 * _drift(rng, times, 9)
        dull = sung if far == 0 else sosfilt(butter(1, 5_000 / (1 + far), fs=rate, output="sos"), sung)
        night += dull[:, np.newaxis] * _sides(rng.uniform(0.1, 0.9)) * (1.0 if far == 0 else rng.uniform(0.05, 0.4))
    return _mastered(rng, _in_space(rng, night, rate, 0.15, 0.1), rate, 0.03, 0.06)


def forcefield(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A wall of energy that is switched on, throbs, is struck once or twice, and breaks down."""
    times = _times(rate, seconds)
    on = _step(times - 0.02, rng.uniform(0.05, 0.2)) * _step(0.9 * seconds - times, 0.3 * seconds)
    hz = rng.uniform(65, 170) * (1 + 0.03 * _drift(rng, times, 1.5)) * (0.6 + 0.4 * on)
    struck = np.zeros(len(times))
    for at_s in seconds * rng.uniform(0.2, 0.75, rng.integers(1, 3)):
        since = np.maximum(times - at_s, 0)
        struck += _step(since, 0.003) * np.exp(-since / rng.uniform(0.05, 0.2))
    bright = 0.45 + 0.25 * np.sin(2 * np.pi * rng.uniform(1, 4) * times) + 0.2 * np.minimum(struck, 1)
    field = np.zeros((len(times), 2))
    for voice in range(6):
        phase = np.cumsum(hz * (1 + rng.normal(0, 0.006))) / rate + rng.random()
        bent = phase + bright / (2 * np.pi) * 2.5 * np.sin(2 * np.pi * phase)  # quicker through one half of each turn
        field[:, voice % 2] += np.sin(2 * np.pi * bent * rng.integers(1, 4))
    air = _hiss(rng, times, 900, rng.uniform(4_000, 9_000))
    ringing = np.sin(2 * np.pi * rng.uniform(180, 420) * times + 3 * np.sin(2 * np.pi * rng.uniform(20, 45) * times))
    field = field * (1 + 0.8 * struck)[:, np.newaxis] + air * (0.08 + struck * (1 + ringing))[:, np.newaxis]
    both = field * (on * (1 + 0.15 * _drift(rng, times, 6)))[:, np.newaxis]
    return _mastered(rng, _in_space(rng, both, rate, 0.2, 0.2), rate, 0.02, 0.1, recorded=False)


def crowd(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A crowd that cheers a goal: a score of open mouths that glide up and tire, and hands that clap."""
    times = _times(rate, seconds)
    share = times / seconds
    cheered = np.zeros((len(times), 2))
    for _ in range(int(rng.integers(14, 24))):
        late = rng.uniform(0, 0.25)
        octaves = rng.uniform(0.2, 0.7) * np.sin(np.pi * np.clip((share - late) * 1.2, 0, 1))
        hz = rng.uniform(140, 420) * 2 ** (octaves + 0.02 * _drift(rng, times, 5))
        turns, open_to = 2 * np.pi * np.cumsum(hz) / rate, rng.uniform(0.82, 0.93)
        folds = np.sin(turns) / (1 + open_to**2 - 2 * open_to * np.cos(turns))  # all harmonics, each weaker alike
        mouth_hz = np.array([650, 1_150, 2_700]) * rng.uniform(0.85, 1.2)
        sung = _resonated(rng, folds, rate, mouth_hz, np.array([0.005, 0.004, 0.003]))
        loud = (
            (1 + 0.2 * _drift(rng, times, 7))
            * _step(share - late, rng.uniform(0.08, 0.3))
            * _step(1 - share, rng.uniform(0.2, 0.6))
        )
        cheered += (sung / sung.std() * loud)[:, np.newaxis] * _sides(rng.random()) * rng.uniform(0.3, 1)
    claps_s = np.sort(rng.uniform(0.02, seconds, int(rng.uniform(20, 70) * seconds)))
    for side in range(2):
        hands = _pushes(times, claps_s, rng.uniform(0.1, 1, len(claps_s)), rng.uniform(0.0008, 0.0015))
        clapped = _resonated(rng, hands, rate, rng.uniform(700, 2_600, 5), 0.003)
        cheered[:, side] += rng.uniform(1, 2.5) * clapped / clapped.std() * _step(times, 0.3 * seconds)
    return _mastered(rng, _in_space(rng, cheered, rate, 0.3, 0.4), rate, 0.05, 0.2 * seconds)


def slime(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A slime that creeps: wet skin that sticks and lets go, played by a tape whose speed follows each pull."""
    times = _times(rate, seconds)
    crept = np.zeros((len(times), 2))
    at_s = 0.02
    while at_s < seconds - 0.15:
        length_s = min(rng.uniform(0.12, 0.4), seconds - at_s - 0.05)
        share = np.clip((times - at_s) / length_s, 0, 1)
        pull = np.sin(np.pi * share ** rng.uniform(0.6, 2)) ** rng.uniform(1, 3)
        wet = sum(_narrow(rng, times, hz, rng.uniform(40, 200)) for hz in rng.uniform(250, 1_500, 4))
        speed = rng.uniform(0.4, 0.9) * (1 + rng.uniform(0.5, 2.5) * pull) * np.exp(0.15 * _drift(rng, times, 12))
        sticky = 1 + 0.7 * np.sin(2 * np.pi * np.cumsum(rng.uniform(15, 60) * speed) / rate)
        crept += (_at_speed(wet, speed) * pull * sticky)[:, np.newaxis] * _sides(rng.uniform(0.3, 0.7))
        for pop_s in at_s + length_s * rng.uniform(0.3, 1, rng.integers(0, 4)):
            since = np.maximum(times - pop_s, 0)
            turns = rng.uniform(180, 700) * (since + rng.uniform(1, 5) * np.minimum(since, 0.1) ** 2)
            bubble = np.sin(2 * np.pi * turns) * _step(since, 0.003) * np.exp(-since / rng.uniform(0.01, 0.03))
            crept += rng.uniform(0.5, 3) * bubble[:, np.newaxis] * _sides(rng.uniform(0.3, 0.7))
        at_s += length_s * rng.uniform(0.6, 1.2)
    return _mastered(rng, crept, rate, 0.01, 0.06)


def railgun(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A weapon that charges its coils and lets them go: a whine that climbs, the shot, rails that ring and cool."""
    times = _times(rate, seconds)
    shot_s = seconds * rng.uniform(0.3, 0.5)
    charge = np.clip(times / shot_s, 0, 1)
    turns = np.cumsum(rng.uniform(60, 130) * 2 ** (rng.uniform(1, 2.5) * charge**1.5)) / rate
    inside = turns % 1  # each turn a windowed wave of its own pitch
    whine = np.sin(np.pi * inside) ** 2 * np.sin(2 * np.pi * inside * (2 + rng.uniform(4, 10) * charge**2))
    coils = np.sin(2 * np.pi * np.cumsum(rng.uniform(900, 2_000) * (0.3 + charge)) / rate) * charge
    charged = (whine + rng.uniform(0.1, 0.4) * coils) * charge * _step(shot_s - times, 0.015)
    since = np.maximum(times - shot_s, 0)
    snap = _step(since, 0.001) * np.exp(-since / rng.uniform(0.015, 0.05))
    crack = _hiss(rng, times, 250, 11_000) * snap[:, np.newaxis]
    falling = np.cumsum(38 + rng.uniform(200, 900) * np.exp(-since / 0.03)) / rate
    boom = np.sin(2 * np.pi * falling) * _step(since, 0.004) * np.exp(-since / rng.uniform(0.1, 0.3))
    hit = _pushes(times, shot_s + np.array([0.0, 0.011, 0.024]), np.array([1, 0.4, 0.3]), CONTACT_S)
    rails = _resonated(rng, hit, rate, rng.uniform(350, 6_000, 12), rng.uniform(0.02, 0.15, 12))
    fired = 0.35 * charged + 1.5 * boom + 0.4 * rails / np.abs(rails).max()
    both = fired[:, np.newaxis] * np.sqrt([0.5, 0.5]) + rng.uniform(0.3, 0.8) * crack
    return _mastered(rng, _in_space(rng, both, rate, 0.12 * seconds, 0.4), rate, 0.02, 0.25 * seconds, recorded=False)


def tally(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A score that counts up: blips that climb, thrown left and right by an echo, and a chord when it is done."""
    times = _times(rate, seconds)
    done_s, every_s = seconds * rng.uniform(0.5, 0.65), rng.uniform(0.045, 0.09)
    counted = np.zeros(len(times))
    blips_s = np.arange(0.015, done_s, every_s)
    pitches = rng.uniform(380, 800) * 2 ** np.linspace(0, rng.uniform(0.5, 1.5), len(blips_s))
    for at_s, pitch in zip(blips_s, pitches, strict=True):
        since = np.maximum(times - at_s, 0)
        blip = sum((-1) ** (odd // 2) * np.sin(2 * np.pi * odd * pitch * since) / odd**2 for odd in (1, 3, 5, 7))
        counted += 0.7 * blip * _step(since, 0.002) * np.exp(-since / (0.35 * every_s))
    since = np.maximum(times - done_s, 0)
    for step in (0, 4, 7, 12):
        turns = 2 * np.pi * (523.3 * 2 ** (step / 12) * (1 + rng.normal(0, 0.001)) * since + rng.random())
        dull = 0.6 * np.exp(-since / rng.uniform(0.1, 0.3))
        chimed = np.sin(turns) / (1 + dull**2 - 2 * dull * np.cos(turns))
        counted += 0.4 * chimed * _step(since, 0.006) * np.exp(-since * 6 / seconds)
    heard = np.stack((counted, counted), 1)
    late = round(rng.uniform(0.06, 0.16) * rate)
    for again in range(1, 5):
        heard[again * late :, again % 2] += 0.5**again * counted[: max(0, len(counted) - again * late)]
    return _mastered(rng, heard, rate, 0.003, 0.15 * seconds, recorded=False)


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in (thunder, flute, motorbike, snow, door, slots, cricket, forcefield, crowd, slime, railgun, tally)
}


def _times(rate: int, seconds: float) -> Floats:
    return np.arange(round(seconds * rate)) / rate


def _step(since_s: Floats, length_s: float) -> Floats:
    """From nothing to one within so long, without a corner."""
    share = np.clip(since_s / length_s, 0, 1)
    return share**3 * (10 - 15 * share + 6 * share**2)


def _sides(right: float | Floats) -> Floats:
    """Gains of the left and the right channel for something so far to the right, 0 to 1."""
    return np.stack((np.cos(np.pi / 2 * np.asarray(right)), np.sin(np.pi / 2 * np.asarray(right))), -1)


def _drift(rng: np.random.Generator, times: Floats, pace_hz: float) -> Floats:
    """A slow course about zero, of unit RMS or so, out of five waves that never meet twice."""
    waves = np.outer(pace_hz * np.exp(rng.uniform(-1.5, 0.3, 5)), times) + rng.random((5, 1))
    return np.sin(2 * np.pi * waves).sum(axis=0) * np.sqrt(2 / 5)


def _arrivals(times: Floats, at_s: Floats, strong: Floats) -> Floats:
    """Pushes at these moments, each shared between two frames; those outside the sound left out."""
    frames = at_s / times[1]
    first, share = np.floor(frames).astype(int), frames % 1
    inside = (first >= 0) & (first < len(times) - 1)
    first, share, strong = first[inside], share[inside], strong[inside]
    return np.bincount(first, strong * (1 - share), len(times)) + np.bincount(first + 1, strong * share, len(times))


def _pushes(times: Floats, at_s: Floats, strong: Floats, length_s: float) -> Floats:
    """Contacts at these moments, round and of this length."""
    contact = np.hanning(round(length_s / times[1]) + 2)
    pushed: Floats = fftconvolve(_arrivals(times, at_s, strong), contact)[: len(times)]
    return pushed


def _resonated(rng: np.random.Generator, pushed: Floats, rate: int, hz: Floats, ring_s: float | Floats) -> Floats:
    """What a body with resonances at these frequencies, each of which rings so long, makes of a push."""
    sounded = np.zeros(len(pushed))
    for one_hz, one_s in zip(hz, np.broadcast_to(ring_s, len(hz)), strict=True):
        radius, turn = np.exp(-1 / (one_s * rate)), 2 * np.pi * one_hz / rate
        feed = [1, -2 * radius * np.cos(turn), radius**2]
        sounded += rng.uniform(0.3, 1) * lfilter([np.sin(turn) * np.sqrt(1 - radius), 0, 0], feed, pushed)
    return sounded


def _hiss(rng: np.random.Generator, times: Floats, low_hz: float, high_hz: float) -> Samples:
    """Noise between two frequencies, another for each ear, of unit RMS."""
    band = butter(2, (low_hz, high_hz), "band", fs=round(1 / times[1]), output="sos")
    hissed: Samples = sosfilt(band, rng.standard_normal((len(times), 2)), axis=0)
    return hissed / hissed.std()


def _narrow(rng: np.random.Generator, times: Floats, hz: float, width_hz: float) -> Floats:
    """Noise of unit RMS about one frequency."""
    band = butter(2, (hz - width_hz / 2, hz + width_hz / 2), "band", fs=round(1 / times[1]), output="sos")
    heard: Floats = sosfilt(band, rng.standard_normal(len(times)))
    return heard / heard.std()


def _at_speed(taped: Floats, speed: Floats) -> Floats:
    """A tape played at this speed, over again from its end backwards."""
    played: Floats = map_coordinates(taped, [np.cumsum(speed)], order=3, mode="reflect")
    return played


def _ricker(rate: int, length_s: float) -> Floats:
    """A wave of pressure up and down, three times its length in all."""
    at = np.arange(-1.5 * length_s, 1.5 * length_s, 1 / rate) / length_s * np.pi
    wave: Floats = (1 - 0.5 * at**2) * np.exp(-(at**2) / 2) * np.hanning(len(at))
    return wave - np.hanning(len(at)) * wave.sum() / np.hanning(len(at)).sum()


def _blown_pipe(rng: np.random.Generator, puff: Floats, rate: int, hz: float) -> Floats:
    """A pipe after P. Cook: its breath reaches the edge after a third of a turn, bent by what comes back."""
    bore = round(1.5 * rate / hz)  # it sounds at its third mode
    jet = max(2, round(rng.uniform(0.28, 0.36) * bore))
    pole = 0.7 - 0.1 * 22_050 / rate
    breath = puff * (
        1 + rng.uniform(0.02, 0.12) * sosfilt(butter(2, 5_000, fs=rate, output="sos"), rng.standard_normal(len(puff)))
    )
    back, jets, pipe = np.zeros(1), np.zeros(len(puff) + 2 * jet), np.zeros(len(puff) + bore + 2 * jet)
    for first in range(0, len(puff) - jet, jet):  # nothing within one jet's flight hears what it makes
        there = slice(first, first + jet)
        turned, back = lfilter([-(1 - pole)], [1, -pole], pipe[there], zi=back)
        jets[first + jet : first + 2 * jet] = breath[there] - 0.5 * turned
        flown = np.clip(jets[there], -1.2, 1.2)
        pipe[first + bore : first + bore + jet] = flown * (flown**2 - 1) + 0.5 * turned
    through = butter(1, (2 * hz, rng.uniform(3_500, 6_000)), "band", fs=rate, output="sos")
    outside: Floats = sosfilt(through, pipe[: len(puff)])
    return outside


def _in_space(rng: np.random.Generator, sides: Samples, rate: int, decay_s: float, share: float) -> Samples:
    """The sound with its space: a thousand echoes a second for each ear, ever weaker, behind a wall's dullness."""
    length_s = min(1.5, 6 * decay_s)
    after = _times(rate, length_s)
    at_s = rng.uniform(0.004, length_s, (2, round(1_000 * length_s)))
    heard = sosfilt(butter(1, 4_000, fs=rate, output="sos"), sides.mean(axis=1))
    signs = (
        rng.choice([-1, 1], at_s.shape) * np.exp(-at_s / decay_s) * np.clip((length_s - at_s) / (0.3 * length_s), 0, 1)
    )
    wet = np.stack(
        [fftconvolve(heard, _arrivals(after, *echoes))[: len(sides)] for echoes in zip(at_s, signs, strict=True)], 1
    )
    return sides + share * wet * np.abs(sides).max() / np.abs(wet).max()


def _mastered(
    rng: np.random.Generator, sides: Samples, rate: int, rise_s: float, fall_s: float, *, recorded: bool = True
) -> Samples:
    """The sound as it is delivered: low cut, faded at both ends, centred, every third one in mono."""
    cut: Samples = sosfilt(butter(2, 22, "high", fs=rate, output="sos"), sides, axis=0)
    if recorded:
        cut = cut + np.abs(cut).max() * 10 ** (rng.uniform(*AIR_DB) / 20) * rng.standard_normal(cut.shape)
    frames = np.arange(len(cut)) / rate
    fades = (_step(frames, rise_s) * _step(frames[-1] - frames, fall_s))[:, np.newaxis]
    faded = cut * fades
    faded -= fades * faded.sum(axis=0) / fades.sum()
    return faded.mean(axis=1, keepdims=True) if rng.random() < 0.35 else faded
