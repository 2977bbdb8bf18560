"""Reverbs, by family: each gives an impulse response of two channels with the decay time that was asked for.

Families for development: exponential noise, a feedback delay network, a shoebox by image sources, combs with
all-passes, two coupled rooms. Kept apart: a plate by its modes, velvet noise, a tank of crossed delays.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy import signal

from training.shapes import Draws, Floats, log_uniform


@dataclass(frozen=True)
class Room:
    """One way of making impulse responses."""

    name: str
    make: Callable[[Draws, int, float], Floats]  # draws, rate, rt60_s -> shape (frames, 2)
    is_kept_apart: bool = False


def _length(rate: int, rt60_s: float) -> int:
    return int(rate * min(rt60_s * 1.1 + 0.05, 4.5))


def _damped(draws: Draws, ir: Floats, rate: int, rt60_s: float) -> Floats:
    """Let highs die sooner, as air and walls do: bands with decays of their own, put together again."""
    t = np.arange(len(ir)) / rate
    high_hz = log_uniform(draws, 2500, 7000)
    ratio = draws.uniform(0.35, 0.95)
    sos = signal.butter(1, high_hz, "low", fs=rate, output="sos")
    low = signal.sosfilt(sos, ir, axis=0)
    return low + (ir - low) * np.exp(-6.91 * t / rt60_s * (1 / ratio - 1))[:, np.newaxis]


def exponential_noise(draws: Draws, rate: int, rt60_s: float) -> Floats:
    frames = _length(rate, rt60_s)
    t = np.arange(frames) / rate
    ir = draws.standard_normal((frames, 2)) * np.exp(-6.91 * t / rt60_s)[:, np.newaxis]
    ir *= np.clip(t / log_uniform(draws, 0.001, 0.03), 0, 1)[:, np.newaxis] ** draws.uniform(0, 1)
    return _damped(draws, ir, rate, rt60_s)


def delay_network(draws: Draws, rate: int, rt60_s: float) -> Floats:
    frames = _length(rate, rt60_s)
    count = 8
    size = log_uniform(draws, 0.4, 1.6)
    delays = np.unique((np.exp(draws.uniform(np.log(0.011), np.log(0.067), count)) * size * rate).astype(int))
    count = len(delays)
    matrix = np.linalg.qr(draws.standard_normal((count, count)))[0] * 10 ** (-3 * delays / rate / rt60_s)
    damp = draws.uniform(0.0, 0.45)
    hop = int(delays.min())
    lines = np.zeros((count, frames + int(delays.max()) + hop))
    lines[:, 0] = draws.choice([-1.0, 1.0], count)
    state = np.zeros((count, 1))
    heard = np.zeros((count, frames))
    feed = np.zeros((count, frames + hop))
    for start in range(0, frames, hop):
        stop = min(frames, start + hop)
        out = np.stack(
            [
                feed[n, max(0, start - d) : max(0, stop - d)]
                if stop - d > 0 and start - d >= 0
                else _before(feed[n], start - d, stop - d)
                for n, d in enumerate(delays)
            ]
        )
        if start == 0:
            out[:, 0] += lines[:, 0]
        heard[:, start:stop] = out
        low, state = signal.lfilter([1 - damp], [1, -damp], out, axis=1, zi=state)
        feed[:, start:stop] = matrix @ low
    sides = draws.standard_normal((2, count))
    return (sides @ heard).T


def _before(line: Floats, start: int, stop: int) -> Floats:
    out = np.zeros(stop - start)
    if stop > 0:
        out[-stop:] = line[:stop]
    return out


def shoebox(draws: Draws, rate: int, rt60_s: float) -> Floats:
    """Image sources of a box up to some order, then noise that follows on at their density."""
    sides = np.exp(draws.uniform(np.log(2.5), np.log(20), 3))
    absorb = np.clip(
        0.161 * sides.prod() / (rt60_s * 2 * (sides[0] * sides[1] + sides[1] * sides[2] + sides[0] * sides[2])),
        0.01,
        0.9,
    )
    bounce = np.sqrt(1 - absorb)
    source, ear = sides * draws.uniform(0.15, 0.85, 3), sides * draws.uniform(0.15, 0.85, 3)
    frames = _length(rate, rt60_s)
    reach = range(-5, 6)
    grid = np.array([(x, y, z) for x in reach for y in reach for z in reach])
    ir = np.zeros((frames, 2))
    for side in (0, 1):
        ears = ear + np.array([0.2 * (side - 0.5), 0, 0])
        for flips in range(8):
            flip = np.array([flips & 1, flips >> 1 & 1, flips >> 2 & 1])
            images = (1 - 2 * flip) * source + 2 * grid * sides - ears
            far = np.sqrt(np.square(images).sum(axis=1))
            order = np.abs(2 * grid - flip).sum(axis=1)
            at = (far / 343 * rate).astype(int)
            known = at < frames
            np.add.at(
                ir[:, side],
                at[known],
                (bounce ** order[known] / np.maximum(far[known], 0.3))
                * draws.choice([-1, 1], known.sum()) ** (order[known] > 2),
            )
    first = int(np.argmax(np.abs(ir).sum(axis=1) > 0))
    ir = ir[first:]
    ir[0] = 0  # what comes straight is the dry sound
    t = np.arange(len(ir)) / rate
    join = 9 * sides.min() / 343
    reached = (t > join * 0.7) & (t < join)
    level = np.sqrt(np.mean(ir[reached] ** 2)) * np.exp(6.91 * join / rt60_s) if reached.any() else 0.0
    late = (
        draws.standard_normal(ir.shape)
        * level
        * np.exp(-6.91 * t / rt60_s)[:, np.newaxis]
        * np.clip((t - join * 0.6) / (join * 0.4), 0, 1)[:, np.newaxis]
    )
    ir = ir * np.clip((1.1 * join - t) / (0.1 * join), 0, 1)[:, np.newaxis] + late
    return _damped(draws, ir, rate, rt60_s)


def echoed(x: Floats, delay: int, gain: float, damp: float = 0.0) -> Floats:
    """Return the signal with echoes of echoes, each duller and by `gain` quieter than the one before."""
    out = x.copy()
    state = np.zeros(1)
    for start in range(delay, len(x), delay):
        before = out[start - delay : min(len(x), start)][: len(x) - start]
        dull, state = signal.lfilter([gain * (1 - damp)], [1, -damp], before, zi=state)
        out[start : start + len(dull)] += dull
    return out


def all_pass(x: Floats, delay: int, gain: float) -> Floats:
    inner = echoed(x, delay, gain)
    out = -gain * inner
    out[delay:] += inner[: len(x) - delay]
    return out


def combs(draws: Draws, rate: int, rt60_s: float) -> Floats:
    frames = _length(rate, rt60_s)
    ir = np.zeros((frames, 2))
    size = log_uniform(draws, 0.6, 1.6)
    damp = draws.uniform(0.05, 0.5)
    start = np.zeros(frames)
    start[0] = 1
    for side in (0, 1):
        for ms in (25.3, 26.9, 29.0, 30.7, 32.2, 33.8, 35.3, 36.7):
            delay = int((ms * size + side * 0.52) * rate / 1000)
            ir[:, side] += echoed(start, delay, 10 ** (-3 * delay / rate / rt60_s), damp)
        ir[0, side] = 0
        for ms in (5.1, 12.6, 10.0, 7.7):
            ir[:, side] = all_pass(ir[:, side], int((ms * size + side * 0.5) * rate / 1000), 0.5)
    return ir


def two_rooms(draws: Draws, rate: int, rt60_s: float) -> Floats:
    """A few early echoes, then noise that falls in two steps, as where a small room opens into a larger one."""
    frames = _length(rate, rt60_s)
    t = np.arange(frames) / rate
    first = rt60_s * draws.uniform(0.15, 0.6)
    share = 10 ** (-draws.uniform(5, 20) / 20)
    fall = np.exp(-6.91 * t / first) + share * np.exp(-6.91 * t / rt60_s)
    ir = (
        signal.lfilter([1.0], [1, -draws.uniform(0, 0.6)], draws.standard_normal((frames, 2)), axis=0)
        * fall[:, np.newaxis]
    )
    ir[: int(draws.uniform(0.005, 0.03) * rate)] *= 0.1
    for _ in range(draws.integers(3, 15)):
        at = int(draws.uniform(0.002, 0.08) * rate)
        ir[at] += draws.uniform(-1, 1, 2) * 6 * fall[at]
    return _damped(draws, ir, rate, rt60_s)


def plate(draws: Draws, rate: int, rt60_s: float) -> Floats:
    """The modes of a thin steel plate, heard at two places."""
    frames = _length(rate, rt60_s)
    wide, high = draws.uniform(1.2, 2.2), draws.uniform(0.7, 1.2)
    bend = log_uniform(draws, 0.6, 1.6)
    m, n = np.meshgrid(np.arange(1, 90), np.arange(1, 60))
    hz = (np.pi / 2 * bend * ((m / wide) ** 2 + (n / high) ** 2)).ravel() * 1.0
    picked = (hz > 60) & (hz < min(9000, 0.45 * rate))
    hz = hz[picked]
    m, n = m.ravel()[picked], n.ravel()[picked]
    if len(hz) > 600:
        some = np.sort(draws.choice(len(hz), 600, replace=False))
        hz, m, n = hz[some], m[some], n[some]

    def shape(at: tuple[float, float]) -> Floats:
        return np.sin(np.pi * m * at[0]) * np.sin(np.pi * n * at[1])

    drive = shape((draws.uniform(0.1, 0.9), draws.uniform(0.1, 0.9)))
    rt = rt60_s * (1 / (1 + (hz / log_uniform(draws, 3000, 12000)) ** 1.2))
    ir = np.zeros((frames, 2))
    heard = [drive * shape((draws.uniform(0.1, 0.9), draws.uniform(0.1, 0.9))) for _ in range(2)]
    poles = np.exp(-6.91 / rt / rate + 2j * np.pi * hz / rate)
    # In blocks: all modes turn on by a matrix of one block's steps.
    block = 512
    steps = poles[:, np.newaxis] ** np.arange(block)
    state = np.ones(len(hz), complex)
    leap = poles**block
    weights = np.stack(heard)
    for start in range(0, frames, block):
        part = ((weights * state) @ steps).imag.T
        ir[start : start + block] = part[: frames - start]
        state = state * leap
    return ir


def velvet(draws: Draws, rate: int, rt60_s: float) -> Floats:
    frames = _length(rate, rt60_s)
    ir = np.zeros((frames, 2))
    spacing = rate / log_uniform(draws, 1500, 4000)
    for side in (0, 1):
        at = ((np.arange(int(frames / spacing)) + draws.random(int(frames / spacing))) * spacing).astype(int)
        at = at[at < frames]
        ir[at, side] = draws.choice([-1.0, 1.0], len(at))
    t = np.arange(frames) / rate
    ir *= np.exp(-6.91 * t / rt60_s)[:, np.newaxis]
    return _damped(draws, ir, rate, rt60_s)


def tank(draws: Draws, rate: int, rt60_s: float) -> Floats:
    """Two delays behind all-passes that feed each other in turn; each pass is duller than the one before."""
    frames = _length(rate, rt60_s)
    size = log_uniform(draws, 0.5, 1.2)

    def ms(milliseconds: float) -> int:
        return int(milliseconds * size * rate / 1000)

    start = np.zeros(frames)
    start[0] = 1
    for late, gain in ((4.8, 0.75), (3.6, 0.75), (12.7, 0.625), (9.3, 0.625)):
        start = all_pass(start, ms(late), gain)
    halves = (((22.6, 60.5), 45.0), ((30.5, 89.2), 37.0))
    damp = draws.uniform(0.05, 0.4)
    ir = np.zeros((frames, 2))
    for side in (0, 1):
        wave, which, passed = start, side, 0.0
        while passed < rt60_s * 1.2 and np.abs(wave).max() > 1e-5:
            (first, second), late = halves[which]
            for delay in (first, second):
                wave = all_pass(wave, ms(delay), 0.5)
            lag = ms(late)
            turn = (
                (late + (first + second) * 0.75) * size / 1000
            )  # what one pass takes, all-passes counted by their mean
            wave = signal.lfilter([1 - damp], [1, -damp], wave) * 10 ** (-3 * turn / rt60_s)
            wave = np.concatenate((np.zeros(lag), wave))[:frames]
            ir[:, which] += wave
            passed += turn
            which = 1 - which
    return ir


ROOMS = (
    Room("exponential noise", exponential_noise),
    Room("delay network", delay_network),
    Room("shoebox", shoebox),
    Room("combs", combs),
    Room("two rooms", two_rooms),
    Room("plate", plate, is_kept_apart=True),
    Room("velvet noise", velvet, is_kept_apart=True),
    Room("tank", tank, is_kept_apart=True),
)
