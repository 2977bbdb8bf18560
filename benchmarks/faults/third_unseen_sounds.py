"""Further whole sounds of games, by other means again: unseen until they had been looked at once.

Noise whose spectrum is painted over time, voices whose brightness follows their force, and single knocks set in place.
"""

from itertools import pairwise

import numpy as np

from benchmarks.faults import third_unseen_shapes as shapes
from benchmarks.faults.sounds import Family, Samples
from benchmarks.faults.third_unseen_shapes import Floats


def glass(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A pane that is knocked in: it cracks, bursts, and its shards ring as they fall and as they land."""
    times = shapes.times(rate, seconds)
    broken = np.zeros((len(times), 2))
    crack_s = rng.uniform(0.008, 0.02)
    count, landing_s = int(rng.integers(30, 90)), crack_s + seconds * rng.uniform(0.2, 0.4)
    falls_s = crack_s + rng.exponential(0.05 * seconds, count)
    lands_s = landing_s + rng.exponential(0.12 * seconds, count)
    for at_s, loud in [(at_s, 0.35) for at_s in falls_s] + [(at_s, 0.25) for at_s in lands_s]:
        ring_s = rng.uniform(0.006, 0.04)
        hz = np.exp(rng.uniform(np.log(2_200), np.log(13_000), 3))
        shard = shapes.rung(rng, rate, hz, ring_s * 3_000 / hz, rng.uniform(0.3, 1, 3))
        shapes.put(broken, shard, at_s, rate, loud * rng.beta(1, 3) * np.sqrt(shapes.place(rng.uniform(0.15, 0.85))))
    pane = shapes.rung(rng, rate, rng.uniform(350, 2_500, 6), rng.uniform(0.02, 0.09, 6), rng.uniform(0.2, 0.6, 6))
    shapes.put(broken, pane, crack_s, rate, np.full(2, 0.4))
    for at_s in crack_s + np.append(0.0, rng.uniform(0.004, 0.04, 3)):
        shapes.put(
            broken,
            shapes.burst(rng, rate, rng.uniform(0.008, 0.03), 1_500, 7_000),
            at_s,
            rate,
            rng.uniform(0.2, 0.8, 2),
        )
    return shapes.delivered(rng, shapes.in_room(rng, broken, rate, 0.12, 0.12), rate, 0.002, 0.25 * seconds)


def helicopter(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A helicopter that passes: each blade slaps the air, the turbine whines, and all of it comes and goes."""
    times = shapes.times(rate, seconds)
    speed = 1 + 0.02 * shapes.course(rng, times, 3) - rng.uniform(0, 0.08) * np.tanh(4 * (times / seconds - 0.5))
    beats = np.cumsum(rng.uniform(9, 19) * speed) / rate
    slap = np.exp(rng.uniform(3, 9) * (np.cos(2 * np.pi * beats) - 1))
    uneven = 1 + 0.15 * np.cos(np.pi * beats) + 0.15 * shapes.course(rng, times, 8)
    dark, lows = rng.uniform(300, 900), rng.uniform(45, 90)
    air = shapes.painted(rng, times, lambda hz, _: hz / (hz + 60) / (1 + (hz / dark) ** 2))
    thump = shapes.painted(rng, times, lambda hz, _: np.exp(-(((hz - lows) / 40) ** 2)))
    wash = shapes.painted(rng, times, lambda hz, share: 1 / (1 + (hz / (1_500 + 3_500 * np.sin(np.pi * share))) ** 2))
    flown = (0.9 * air + 0.8 * thump) * slap * uneven + rng.uniform(0.06, 0.2) * wash * (0.5 + 0.5 * slap)
    for whine_hz in rng.uniform(1_700, 5_200, 2):
        turns = np.cumsum(whine_hz * speed**1.5) / rate
        flown += rng.uniform(0.01, 0.08) * (1 + 0.3 * shapes.course(rng, times, 6)) * np.sin(2 * np.pi * turns)
    near = 1 / (1 + (rng.uniform(0.5, 2.5) * (2 * times / seconds - rng.uniform(0.8, 1.2))) ** 2)
    place = 0.5 + 0.35 * np.tanh(rng.uniform(-3, 3) * (times / seconds - 0.5))
    return shapes.delivered(
        rng, (flown * near)[:, np.newaxis] * shapes.place(place), rate, 0.12 * seconds, 0.2 * seconds
    )


def splash(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Something heavy thrown into water: the slap, the hole that closes over it with a gulp, and what rains back."""
    times = shapes.times(rate, seconds)
    hit_s = rng.uniform(0.01, 0.03)
    since = np.maximum(times - hit_s, 0)
    height, spread = rng.uniform(2_500, 5_000), rng.uniform(3, 6)
    spray = shapes.painted(rng, times, lambda hz, share: 1 / (1 + (hz / (400 + height * np.exp(-4 * share))) ** 2))
    water = (
        spray
        * (1 - np.exp(-since / 0.004))
        * np.exp(-since / seconds * spread)
        * np.exp(0.2 * shapes.course(rng, times, 25))
    )
    gulp_s = hit_s + rng.uniform(0.05, 0.16)
    closing = np.maximum(times - gulp_s, 0)
    hz = rng.uniform(70, 180) * (1 + rng.uniform(0.5, 2) * np.clip(closing / 0.15, 0, 1))
    gulp = np.sin(2 * np.pi * np.cumsum(hz * (times > gulp_s)) / rate) * np.exp(-closing / rng.uniform(0.04, 0.1))
    water += rng.uniform(0.6, 2) * gulp * shapes.risen(closing, 0.02)
    pool = water[:, np.newaxis] * np.sqrt(shapes.place(rng.uniform(0.4, 0.6)))
    shapes.put(
        pool, shapes.burst(rng, rate, rng.uniform(0.02, 0.06), 200, 2_800, 0.002), hit_s, rate, rng.uniform(0.8, 2, 2)
    )
    for at_s in hit_s + 0.1 + rng.gamma(2, 0.12 * seconds, rng.integers(15, 70)):
        inside = shapes.times(rate, rng.uniform(0.02, 0.06))
        rise = rng.uniform(500, 3_500) * (inside + rng.uniform(1, 6) * inside**2)
        drop = np.sin(2 * np.pi * rise) * np.exp(-5 * inside / inside[-1]) * shapes.both_ends(inside, 0.002, 0.005)
        shapes.put(pool, drop, at_s, rate, 0.5 * rng.beta(1, 3) * np.sqrt(shapes.place(rng.uniform(0.2, 0.8))))
    return shapes.delivered(rng, pool, rate, 0.004, 0.2 * seconds)


def cloth(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A coat or a cloak that moves: rustles of folds that rub on each other, near the microphone."""
    times = shapes.times(rate, seconds)
    stiff = rng.uniform(900, 3_500)
    moved = np.zeros((len(times), 2))
    for share in np.append([0.03, 0.97], rng.random(rng.integers(1, 5))):
        length_s = rng.uniform(0.12, 0.4) * min(1.0, seconds)
        start_s = share * (seconds - length_s)
        force = np.sin(np.pi * np.clip((times - start_s) / length_s, 0, 1)) ** rng.uniform(1, 2.5)
        folds = np.exp(0.5 * shapes.course(rng, times, rng.uniform(30, 70)))
        rubbed = shapes.painted(
            rng,
            times,
            lambda hz, share: (
                (hz / stiff) / (1 + (hz / (stiff * (1 + share))) ** 2.6) / (1 + (hz / 14_000) ** 4)
                + 0.25 * np.exp(-hz / 250)
            ),
        )
        moved += (force * folds * rubbed)[:, np.newaxis] * rng.uniform(0.3, 1, 2)
    return shapes.delivered(rng, moved, rate, 0.03, 0.06)


def whoosh(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """What a menu slides in with, or a staff is swung with: a band of air that sweeps up and down as it passes by."""
    times = shapes.times(rate, seconds)
    passes, low_hz, octaves = rng.uniform(0.3, 0.65), rng.uniform(150, 450), rng.uniform(2.5, 4.5)
    wide, tone = rng.uniform(0.35, 1.1), rng.uniform(0, 0.5)

    def near(share: Floats) -> Floats:
        return np.exp(-((np.log(np.maximum(share, 1e-3) / passes) / 0.8) ** 2))

    def gain(hz: Floats, share: Floats) -> Floats:
        away = np.log2(np.maximum(hz, 1) / low_hz) - octaves * near(share)
        return (
            np.exp(-((away / wide) ** 2)) + tone * np.exp(-(((away - 1) / 0.12) ** 2)) + 0.02 / (1 + (hz / 3_000) ** 2)
        )

    course = near(times / seconds)
    aside = 0.5 + rng.uniform(-0.45, 0.45) * np.tanh(5 * (times / seconds - passes))
    both = shapes.painted(rng, times, gain)[:, np.newaxis] * shapes.place(aside)
    both += 0.3 * np.stack([shapes.painted(rng, times, gain) for _ in range(2)], 1)
    return shapes.delivered(rng, both * (course**1.5)[:, np.newaxis], rate, 0.02, 0.05, recorded=False)


def servo(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A robot's joint: gears that wind up, run and brake, in one to three moves with a rest after each."""
    times = shapes.times(rate, seconds)
    moves = int(rng.integers(1, 4))
    edges = np.linspace(0.02, seconds - 0.04, moves + 1)
    ratio, fastest_hz = rng.uniform(2.5, 7), rng.uniform(250, 850)
    run = np.zeros(len(times))
    for first_s, last_s in pairwise(edges):
        length_s = (last_s - first_s) * rng.uniform(0.65, 0.9)
        ramp = rng.uniform(0.15, 0.35)
        share = np.clip((times - first_s) / length_s, 0, 1)
        run += rng.uniform(0.5, 1) * shapes.risen(share, ramp) * shapes.risen(1 - share, ramp)
    speed = run * (1 + 0.01 * shapes.course(rng, times, 20))
    mesh = np.cumsum(fastest_hz * speed) / rate
    whirr = np.zeros(len(times))
    for number, strong in enumerate(rng.uniform(0.2, 1, 14), 1):
        if number * fastest_hz * 1.1 < 0.4 * rate:
            whirr += strong / number**0.7 * np.sin(2 * np.pi * number * mesh + rng.uniform(0, 6))
    whirr *= 1 + 0.25 * np.sin(2 * np.pi * mesh / 17)  # the wheel is not quite round
    whirr += 0.4 * np.sin(2 * np.pi * ratio * mesh + 0.8 * np.sin(2 * np.pi * mesh))
    brushes = shapes.painted(rng, times, lambda hz, _: hz / 3_000 / (1 + (hz / 3_500) ** 3))
    moved = (whirr + rng.uniform(0.1, 0.5) * brushes) * run**1.5
    body = shapes.in_room(rng, np.repeat(moved[:, np.newaxis], 2, axis=1), rate, 0.03, 0.25)
    return shapes.delivered(rng, body, rate, 0.01, 0.02)


def radio(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Chatter on a two-way radio: a voice in three kilohertz, static with it, and a tail as the key is let go."""
    times = shapes.times(rate, seconds)
    phrases = 1 if seconds < 1.2 else 2
    sent, tail, words = np.zeros(len(times)), np.zeros(len(times)), np.zeros(len(times))
    for start_s in np.arange(phrases) * (seconds - 0.05) / phrases + 0.02:
        end_s = start_s + (seconds - 0.05) / phrases * rng.uniform(0.7, 0.8)
        squelch_s = rng.uniform(0.04, 0.1) * min(1.0, seconds)
        sent += shapes.risen(times - start_s, 0.006) * shapes.risen(end_s - times, 0.006)
        tail += shapes.risen(times - end_s + 0.004, 0.004) * shapes.risen(end_s + squelch_s - times, 0.02)
        at_s = start_s + 0.04
        while at_s < end_s - 0.1:
            length_s = rng.uniform(0.09, 0.2)
            words += rng.uniform(0.5, 1) * np.sin(np.pi * np.clip((times - at_s) / length_s, 0, 1)) ** 1.2
            at_s += length_s * rng.uniform(0.75, 1.2)
    hz = rng.uniform(85, 190) * (1 + 0.12 * shapes.course(rng, times, 2.5)) * (1.1 - 0.2 * times / seconds)
    throat = [centre * (1 + 0.25 * shapes.course(rng, times, 4)) for centre in (rng.uniform(450, 650), 1_450, 2_500)]
    turns = 2 * np.pi * np.cumsum(hz) / rate
    synthesize_speech = np.zeros(len(times))
    for number in range(2, int(3_600 / hz.min())):
        open_to = sum(1 / (1 + ((number * hz - centre) / (0.09 * centre)) ** 2) for centre in throat)
        synthesize_speech += open_to / number**0.6 * np.sin(number * turns)
    hissed = shapes.painted(rng, times, lambda hz, _: np.exp(-(((hz - 2_600) / 500) ** 2)))
    synthesize_speech = words * synthesize_speech / synthesize_speech.std() + 0.25 * hissed * np.maximum(
        shapes.course(rng, times, 4) - 0.5, 0
    ) * (words > 0.05)
    pressed = synthesize_speech / np.sqrt(1 + np.square(synthesize_speech))  # the transmitter's limiter, round all over
    static = shapes.painted(rng, times, lambda hz, _: np.ones_like(hz))
    heard = (pressed + rng.uniform(0.03, 0.1) * static) * sent + rng.uniform(0.2, 0.5) * static * tail
    through = shapes.filtered(
        heard[:, np.newaxis], rate, lambda hz: (hz / 350) ** 3 / (1 + (hz / 350) ** 3) / (1 + (hz / 3_000) ** 6)
    )
    return shapes.delivered(rng, np.repeat(through, 2, axis=1), rate, 0.01, 0.02)


def arrow(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A bow let go: the string's twang, the arrow's flight, and the target it sticks in and shivers."""
    times = shapes.times(rate, seconds)
    loose_s, hit_s = rng.uniform(0.01, 0.03), seconds * rng.uniform(0.3, 0.5)
    shot = np.zeros((len(times), 2))
    numbers = np.arange(1, 22)
    hz = rng.uniform(75, 150) * numbers * np.sqrt(1 + 4e-4 * numbers**2)
    twang = shapes.rung(rng, rate, hz, 0.16 / numbers**0.7, np.abs(np.sin(numbers * 0.9)) / numbers, 0.002)
    shapes.put(shot, twang, loose_s, rate, np.array([0.9, 0.7]))
    shapes.put(shot, shapes.burst(rng, rate, 0.03, 250, 2_500, 0.002), loose_s, rate, np.array([0.3, 0.3]))
    high = rng.uniform(1_200, 3_000)
    flight = shapes.painted(
        rng, times, lambda hz, share: np.exp(-((np.log2(np.maximum(hz, 1) / (high * (1 - 0.6 * share)))) ** 2))
    )
    flown = np.clip((times - loose_s) / (hit_s - loose_s), 0, 1)
    place = 0.5 + rng.uniform(-0.4, 0.4) * (2 * flown - 1)
    shot += rng.uniform(0.08, 0.2) * (flight * np.sin(np.pi * flown) ** 1.5)[:, np.newaxis] * shapes.place(place)
    end = np.sqrt(shapes.place(place[-1]))
    wood = shapes.rung(rng, rate, rng.uniform(90, 900, 6), rng.uniform(0.015, 0.06, 6), rng.uniform(0.3, 1, 6))
    shapes.put(shot, wood, hit_s, rate, 0.7 * end)
    shapes.put(shot, shapes.burst(rng, rate, 0.012, 300, 5_000), hit_s, rate, 0.8 * end)
    since = np.maximum(times - hit_s, 0)
    shiver = np.sin(2 * np.pi * rng.uniform(140, 300) * since) * np.sin(2 * np.pi * rng.uniform(18, 32) * since) ** 2
    shot += rng.uniform(0.1, 0.4) * (shiver * np.exp(-since / rng.uniform(0.06, 0.15)))[:, np.newaxis] * end
    return shapes.delivered(rng, shapes.in_room(rng, shot, rate, 0.08, 0.1), rate, 0.003, 0.15 * seconds)


def teleport(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A body beamed away: glides that wind up through a flanger, then fall in on themselves into a long space."""
    times = shapes.times(rate, seconds)
    gone = rng.uniform(0.45, 0.65)
    share = times / seconds
    wound = np.clip(share / gone, 0, 1)
    rising = np.zeros(len(times))
    for step in rng.uniform(1, 4, 5):
        turns = np.cumsum(rng.uniform(110, 260) * step * 2 ** (rng.uniform(1.5, 3) * wound**2)) / rate
        bent = turns + rng.uniform(0.1, 0.5) * np.sin(2 * np.pi * np.cumsum(6 + 24 * wound) / rate)
        rising += np.sin(2 * np.pi * bent) * (1 + 0.5 * np.sin(2 * np.pi * rng.uniform(3, 12) * times)) / step
    rising = rising / 3 + 0.3 * shapes.painted(
        rng, times, lambda hz, past: np.exp(-((np.log2(np.maximum(hz, 1) / (800 + 4_000 * past))) ** 2))
    )
    late = 0.0004 + 0.004 * (0.5 + 0.5 * np.cos(2 * np.pi * rng.uniform(0.4, 1.5) * times))
    rising += 0.7 * np.interp(times - late, times, rising)
    rising *= wound**1.5 * shapes.risen(gone - share, 0.05)
    since = np.maximum(times - (gone - 0.03) * seconds, 0)
    turns = np.cumsum(41 + rng.uniform(500, 1_400) * np.exp(-since / rng.uniform(0.04, 0.1))) / rate
    falling = np.sin(2 * np.pi * turns) * np.exp(-since / seconds * 6) * shapes.risen(since, 0.01)
    both = (rising + rng.uniform(0.8, 1.5) * falling)[:, np.newaxis] * np.sqrt(shapes.place(rng.uniform(0.4, 0.6)))
    return shapes.delivered(
        rng, shapes.in_room(rng, both, rate, 0.25 * seconds, 0.5), rate, 0.03, 0.25 * seconds, recorded=False
    )


def horn(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A fanfare of brass in a hall: two to four notes, one voice or three, brighter the harder they are blown."""
    times = shapes.times(rate, seconds)
    blown = np.zeros((len(times), 2))
    notes = int(rng.integers(2, 5)) if seconds > 0.9 else 1
    starts_s = 0.02 + np.arange(notes) * 0.62 * seconds / notes
    lowest_hz, chord = rng.uniform(110, 330), (np.array([0, 4, 7]) if rng.random() < 0.5 else np.array([0]))
    for start_s, step in zip(starts_s, np.sort(rng.choice([0, 5, 7, 12, 3], notes, replace=False)), strict=True):
        length_s = (0.62 * seconds / notes) * (rng.uniform(0.8, 0.95) if start_s < starts_s[-1] else 1.1)
        since = times - start_s
        force = (
            shapes.risen(since, rng.uniform(0.025, 0.07))
            * shapes.risen(length_s - since, 0.06)
            * (0.85 + 0.15 * np.exp(-8 * since.clip(0)))
        )
        for voice in chord:
            scoop = 1 - 0.02 * np.exp(-since.clip(0) / 0.03) + 0.004 * np.sin(2 * np.pi * rng.uniform(4.5, 6) * times)
            hz = lowest_hz * 2 ** ((step + voice) / 12) * (1 + rng.normal(0, 0.001)) * scoop
            turns = 2 * np.pi * np.cumsum(hz) / rate
            bright = 1 + rng.uniform(2.5, 6) * force
            tone = sum(
                np.exp(-number / bright) * np.sin(number * turns + 0.3 * number)
                for number in range(1, min(28, int(0.42 * rate / hz.max())))
            )
            blown += (force * tone)[:, np.newaxis] * np.sqrt(shapes.place(rng.uniform(0.3, 0.7)))
    return shapes.delivered(
        rng, shapes.in_room(rng, blown, rate, 0.12 * seconds, 0.3), rate, 0.01, 0.2 * seconds, recorded=False
    )


def reload(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A weapon that is loaded: a magazine slides out and snaps in, a bolt is drawn and runs forward."""
    times = shapes.times(rate, seconds)
    handled = np.zeros((len(times), 2))
    metal_hz = np.exp(rng.uniform(np.log(450), np.log(6_500), 9))
    snaps_s = seconds * (np.arange(4) + rng.uniform(0.25, 0.6, 4)) / 4.8 + 0.01
    for at_s, weight in zip(snaps_s, rng.uniform(0.35, 1, 4), strict=True):
        for late_s, loud in ((0.0, rng.uniform(0.3, 0.8)), (rng.uniform(0.012, 0.035), 1.0)):  # it touches, then locks
            hz = metal_hz * rng.uniform(0.9, 1.1, 9)
            knock = shapes.rung(
                rng, rate, hz, rng.uniform(4, 30) / (hz + 400), rng.uniform(0.1, 0.6, 9) * 900 / (900 + hz)
            )
            sides = weight * loud * np.sqrt(shapes.place(rng.uniform(0.35, 0.65)))
            shapes.put(handled, knock, at_s + late_s, rate, sides)
            shapes.put(
                handled,
                shapes.burst(rng, rate, rng.uniform(0.003, 0.009), 700, 5_500),
                at_s + late_s,
                rate,
                0.5 * sides,
            )
    scraped = shapes.painted(
        rng, times, lambda hz, _: sum(np.exp(-(((hz - one) / (0.15 * one)) ** 2)) for one in metal_hz[:5])
    )
    for at_s in snaps_s[1:]:
        length_s = rng.uniform(0.06, 0.14) * seconds
        slide = np.sin(np.pi * np.clip((times - at_s + length_s) / length_s, 0, 1)) ** 2
        handled += rng.uniform(0.02, 0.08) * (slide * scraped)[:, np.newaxis]
    return shapes.delivered(rng, shapes.in_room(rng, handled, rate, 0.05, 0.12), rate, 0.003, 0.08)


def cart(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A mine cart on old rails: wheels that rumble, knock at each joint of the rails, and squeal in a bend."""
    times = shapes.times(rate, seconds)
    dark, planks = rng.uniform(180, 500), rng.uniform(15, 40)
    rough = np.exp(0.3 * shapes.course(rng, times, planks))
    rolled = shapes.painted(
        rng, times, lambda hz, _: hz / (hz + 70) / (1 + (hz / dark) ** 2) + 0.02 / (1 + (hz / 4_000) ** 2)
    )
    ridden = (rolled * rough)[:, np.newaxis] * np.array([0.8, 0.7])
    at_s, gap_s, axle_s = rng.uniform(0.1, 0.2), rng.uniform(0.25, 0.55), rng.uniform(0.05, 0.12)
    rail_hz = np.exp(rng.uniform(np.log(140), np.log(2_600), 8))
    while at_s < seconds - 0.25:
        for late_s, loud in ((0.0, 1.0), (axle_s, rng.uniform(0.5, 0.9))):
            knock = shapes.rung(
                rng, rate, rail_hz, 14 / (rail_hz + 150), rng.uniform(0.2, 0.7, 8) * 400 / (400 + rail_hz), 0.001
            )
            shapes.put(ridden, knock, at_s + late_s, rate, 3 * loud * np.array([0.7, 0.8]))
            shapes.put(
                ridden, shapes.burst(rng, rate, 0.01, 200, 3_000, 0.001), at_s + late_s, rate, np.full(2, 1.5 * loud)
            )
        at_s += gap_s * rng.uniform(0.97, 1.03)
    turns = np.cumsum(rng.uniform(1_300, 3_200) * (1 + 0.01 * shapes.course(rng, times, 9))) / rate
    squeal = sum(np.sin(2 * np.pi * number * turns) / number**1.5 for number in (1, 2, 3))
    bend = np.clip(shapes.course(rng, times, 1.5) * (1 + 0.3 * shapes.course(rng, times, 30)), 0, 2)
    ridden += (rng.uniform(0, 0.5) * bend * squeal)[:, np.newaxis] * np.array([0.5, 0.6])
    return shapes.delivered(rng, shapes.in_room(rng, ridden, rate, 0.15, 0.15), rate, 0.08, 0.2 * seconds)


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in (glass, helicopter, splash, cloth, whoosh, servo, radio, arrow, teleport, horn, reload, cart)
}
