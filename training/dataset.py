"""The development set: sounds with and without reverb, each with what is known of it.

A sound is dry, or dry and sent to a room; both then go through the same hands (trimmed, faded, equalised, with a
noise floor, normalised, rounded to a depth), so that they differ only in reverb.
"""

import os
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy import signal

from training.rooms import ROOMS, Room
from training.shapes import Draws, Family, Floats, log_uniform
from training.sources import FAMILIES

RATE = 48_000  # of synthesis; files are brought to rates of their own at the end
LONGEST_S = 9.0
REAL_SHARE = 0.15
# Recordings without room reverb, as far as is known; every second one is kept apart.
REAL_DRY = {
    "event": "elec_beep elec_blip elec_blip2 elec_blup elec_flip elec_plip elec_pop elec_tick elec_twip elec_wood"
    " elec_ping elec_twang glitch_perc1 glitch_perc2 glitch_perc3 glitch_perc4 glitch_perc5 glitch_robot1 glitch_robot2"
    " mehackit_phone1 mehackit_phone2 mehackit_phone3 mehackit_phone4 mehackit_robot1 mehackit_robot2 mehackit_robot3"
    " mehackit_robot4 mehackit_robot5 mehackit_robot6 mehackit_robot7 perc_snap perc_snap2 perc_till vinyl_backspin"
    " vinyl_rewind vinyl_scratch misc_burp",
    "natural-decay": "elec_soft_kick elec_hollow_kick elec_snare elec_hi_snare elec_fuzz_tom elec_triangle elec_bell",
    "ambience": "ambi_soft_buzz glitch_bass_g",
}
# Their making says nothing of it, but a room can be measured in these: after the voice they fall straight by 18 to
# 37 dB, at 1.0 to 1.25 s for 60 dB, and left and right, alike by 0.47 to 0.71 in the voice, are by 0.03 to 0.07 then.
IN_A_ROOM = frozenset({"mehackit_phone1", "mehackit_phone2", "mehackit_phone3", "mehackit_phone4"})


@dataclass(frozen=True)
class Known:
    """What is known of one sound of the set."""

    source: str
    kind: str
    is_real: bool
    is_wet: bool
    room: str
    rt60_s: float
    wet_db: float  # of the reverb's energy over the dry sound's
    channels: int
    is_reversed: bool = False

    @property
    def is_audible(self) -> bool:
        """Whether the reverb is strong enough for a listener to notice."""
        return self.is_wet and self.wet_db >= -10 and self.rt60_s >= 0.5


@dataclass(frozen=True)
class Response:
    """One room's impulse response and its decay time as measured on it."""

    room: str
    samples: Floats
    rt60_s: float


def responses(rooms: list[Room], seed: int, count: int) -> list[Response]:
    """Return the responses of some families, with decay times from 0.2 to 4 s."""
    made = []
    for number, room in enumerate(rooms):
        draws = np.random.default_rng([seed, number])
        for _ in range(count):
            samples = room.make(draws, RATE, log_uniform(draws, 0.2, 4.0))
            made.append(Response(room.name, samples, decay_time_s(samples)))
    return made


def decay_time_s(response: Floats) -> float:
    """Return the time in which a response falls by 60 dB, by the line from 5 to 35 dB under all its energy."""
    energy = np.square(response).sum(axis=1)
    curve = 10 * np.log10(np.cumsum(energy[::-1])[::-1] / energy.sum() + 1e-20)
    rows = np.flatnonzero((curve < -5) & (curve > -35))
    return float(-60 / (np.polyfit(rows / RATE, curve[rows], 1)[0]))


def real_sounds(*, is_kept_apart: bool, is_dry: bool = False) -> list[tuple[str, str, Floats]]:
    """Return name, kind and samples of every second real recording, all or the dry ones; none without SOUNDS_DIR."""
    folder = os.environ.get("SOUNDS_DIR")
    if not folder:
        return []
    import soundfile

    found = []
    for kind, names in REAL_DRY.items():
        for name in names.split()[int(is_kept_apart) :: 2]:
            paths = sorted(Path(folder).rglob(f"{name}.wav"))
            if paths and not (is_dry and name in IN_A_ROOM):
                samples, rate = soundfile.read(paths[0], always_2d=True)
                found.append((name, kind, signal.resample_poly(samples, RATE, rate, axis=0)))
    return found


def made(
    count: int,
    seed: int,
    families: list[Family],
    rooms: list[Response],
    real: list[tuple[str, str, Floats]],
    *,
    reversed_share: float = 0.0,
    real_share: float = REAL_SHARE,
    cut_share: float = 0.0,
    start: int = 0,
) -> Iterator[tuple[Known, Floats, int]]:
    """Yield sounds: what is known of each, its samples, its sample rate.

    `reversed_share` of them are reversed and `cut_share` end before they have died away, in 0..1. `start` is the
    number of the first sound: the same number and seed always give the same sound.
    """
    for number in range(start, start + count):
        draws = np.random.default_rng([seed, number])
        if real and draws.random() < real_share:
            source, kind, dry = real[draws.integers(len(real))]
            is_real = True
            dry = np.repeat(dry, 2, axis=1) if dry.shape[1] == 1 and draws.random() < 0.3 else dry
            if dry.shape[1] == 2 and draws.random() < 0.4:
                dry = dry.mean(axis=1, keepdims=True)
        else:
            family = families[draws.integers(len(families))]
            source, kind, is_real = family.name, family.kind, False
            dry = _placed(draws, family)
        dry = dry[: int(LONGEST_S * RATE)]
        known = Known(source, kind, is_real, False, "", 0.0, -np.inf, dry.shape[1])
        if draws.random() < 0.5:
            known, dry = _sent(draws, known, dry, rooms)
        if reversed_share and draws.random() < reversed_share:
            known, dry = replace(known, is_reversed=True), dry[::-1]
        if cut_share and draws.random() < cut_share:
            dry = _cut(draws, dry)
        samples, rate = _finished(draws, dry)
        yield known, samples, rate


def _placed(draws: Draws, family: Family) -> Floats:
    """Return a sound of a family, one or several after another, in one channel or two."""
    parts = [family.make(draws, RATE) for _ in range(1 if draws.random() < 0.85 else draws.integers(2, 4))]
    x = parts[0]
    for part in parts[1:]:
        gap = np.zeros(int(RATE * draws.uniform(0, 0.5)))
        x = np.concatenate((x, gap, part * draws.uniform(0.3, 1)))
    x = x / (np.abs(x).max() + 1e-12)
    if draws.random() < 0.45:
        return x[:, np.newaxis]
    way = draws.integers(4)
    if way == 0:
        return np.stack((x, x), axis=1)
    if way == 1:
        side = draws.uniform(0, np.pi / 2)
        return np.stack((x * np.cos(side), x * np.sin(side)), axis=1)
    other = family.make(draws, RATE)
    other = np.pad(other, (0, max(0, len(x) - len(other))))[: len(x)]
    other = other / (np.abs(other).max() + 1e-12)
    if way == 2:  # wide: a second take of the same on the other side, mixed in by some width
        width = draws.uniform(0.2, 1)
        return np.stack((x, (1 - width) * x + width * other), axis=1)
    lag = int(RATE * draws.uniform(0.0003, 0.02))  # wide by a short delay, as a doubled voice is
    return np.stack((x, np.concatenate((np.zeros(lag), x))[: len(x)]), axis=1)


def _sent(draws: Draws, known: Known, dry: Floats, rooms: list[Response]) -> tuple[Known, Floats]:
    response = rooms[draws.integers(len(rooms))]
    wet_db = draws.uniform(-20, 0)
    late = int(RATE * draws.choice([0.0, draws.uniform(0, 0.04)]))
    if dry.shape[1] == 1:
        wet = signal.fftconvolve(dry, response.samples[:, [draws.integers(2)]], axes=0)
    elif draws.random() < 0.6:
        wet = signal.fftconvolve(dry.mean(axis=1, keepdims=True), response.samples, axes=0)
        if np.abs(wet).max() < 1e-9:
            wet = signal.fftconvolve(dry, response.samples, axes=0)
    else:
        wet = signal.fftconvolve(dry, response.samples, axes=0)
    wet = np.concatenate((np.zeros((late, wet.shape[1])), wet))
    scale = np.sqrt(np.square(dry).sum() / (np.square(wet).sum() + 1e-20)) * 10 ** (wet_db / 20)
    out = wet * scale
    out[: len(dry)] += dry
    return replace(known, is_wet=True, room=response.room, rt60_s=response.rt60_s, wet_db=wet_db), out


def _cut(draws: Draws, x: Floats) -> Floats:
    """Return a sound without its end: from where it has fallen by 15 to 45 dB, or from any frame behind its peak on."""
    loud = np.abs(x).max(axis=1)
    shortest = int(np.argmax(loud)) + RATE // 20
    if draws.random() < 0.3:
        return x[: max(shortest, int(len(x) * draws.uniform(0.3, 1)))]
    above = np.flatnonzero(loud > loud.max() * 10 ** (-draws.uniform(15, 45) / 20))
    return x[: max(shortest, above[-1] + 1)]


def _finished(draws: Draws, x: Floats) -> tuple[Floats, int]:
    if draws.random() < 0.4:
        corner = log_uniform(draws, 200, 6000)
        low = signal.sosfilt(signal.butter(1, corner, fs=RATE, output="sos"), x, axis=0)
        x = low + (x - low) * 10 ** (draws.uniform(-9, 6) / 20)
    if draws.random() < 0.2:
        x = np.tanh(x / np.abs(x).max() * draws.uniform(0.5, 3))
    if draws.random() < 0.15:
        x = _compressed(draws, x)
    loud = np.abs(x).max(axis=1)
    above = np.flatnonzero(loud > loud.max() * 10 ** (-draws.uniform(45, 90) / 20))
    x = x[: above[-1] + 1]
    if draws.random() < 0.2:  # cut before it has died away
        x = x[: int(len(x) * draws.uniform(0.5, 1))]
    fade = min(len(x), int(RATE * log_uniform(draws, 0.002, 0.3 if draws.random() < 0.4 else 0.02)))
    x = x.copy()
    x[len(x) - fade :] *= np.linspace(1, 0, fade)[:, np.newaxis]
    if draws.random() < 0.35:
        floor = draws.standard_normal(x.shape)
        if draws.random() < 0.5:
            floor = signal.lfilter([0.2], [1, -0.8], floor, axis=0)
        x = x + floor * np.abs(x).max() * 10 ** (-draws.uniform(55, 95) / 20)
    if draws.random() < 0.3:
        x = np.concatenate((np.zeros((int(RATE * draws.uniform(0, 0.1)), x.shape[1])), x))
    x = np.concatenate((x, np.zeros((int(RATE * (draws.uniform(0, 0.2) if draws.random() < 0.3 else 0)), x.shape[1]))))
    rate = int(draws.choice([48_000, 44_100, 96_000], p=[0.55, 0.37, 0.08]))
    if rate == 44_100:
        x = signal.resample_poly(x, 147, 160, axis=0)
    elif rate == 96_000:
        x = signal.resample_poly(x, 2, 1, axis=0)
    x = x / np.abs(x).max() * 10 ** (-draws.uniform(0.5, 12) / 20)
    full = 2.0 ** (15 if draws.random() < 0.4 else 23)
    return np.round(x * full) / full, rate


def _compressed(draws: Draws, x: Floats) -> Floats:
    level = np.abs(x).max(axis=1)
    follow = signal.lfilter([0.003], [1, -0.997], level) + 1e-4
    return x * (follow[:, np.newaxis] ** -draws.uniform(0.2, 0.5))


def families(*, is_kept_apart: bool) -> list[Family]:
    """Return the families of sources for development, or those kept apart."""
    return [one for one in FAMILIES if one.is_kept_apart == is_kept_apart]


def rooms(*, is_kept_apart: bool) -> list[Room]:
    """Return the families of reverbs for development, or those kept apart."""
    return [one for one in ROOMS if one.is_kept_apart == is_kept_apart]
