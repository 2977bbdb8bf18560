"""Dry strikes on things that ring: steps on a deck, tools put down, crates, pans, panes, bouncing objects.

Such a thing rings by its modes, and its material sets how long each of them takes to die. In a game they are events,
and their ring is as long as a small room's tail: from these the models learn to distinguish the two.
"""

from dataclasses import dataclass

import numpy as np

from training.shapes import Draws, Family, Floats, band_noise, gated, log_uniform, placed, struck, times


@dataclass(frozen=True)
class Thing:
    """The modes of one thing: where they lie, how strong they are, and how long each takes to fall to 1/e."""

    hz: Floats
    levels: Floats
    decays_s: Floats

    @classmethod
    def drawn(cls, draws: Draws, rate: int) -> "Thing":
        """Return a bar, a plate, a shell or a lump, of anything from wood to steel."""
        lowest = log_uniform(draws, 60, 1500)
        count = int(log_uniform(draws, 3, 60))
        shape = draws.integers(3)
        order = np.arange(1, count + 1)
        if shape == 0:  # a bar: far apart, and ever farther
            hz = lowest * ((2 * order + 1) / 3) ** 2
        elif shape == 1:  # a plate: about as many in every hertz
            hz = lowest * (1 + np.cumsum(draws.exponential(log_uniform(draws, 0.1, 1.2), count)))
        else:
            hz = lowest * np.exp(draws.uniform(0, np.log(30), count))
        hz = hz[hz < min(14_000, 0.45 * rate)]
        hz = hz if len(hz) else np.array([lowest])
        # Losses of the material grow with pitch, those to what it stands on do not.
        longest_s, slant = log_uniform(draws, 0.02, 0.9), draws.uniform(0, 1.3)
        decays_s = longest_s / (1 + (hz / log_uniform(draws, 300, 8000)) ** slant) * draws.uniform(0.5, 1.5, len(hz))
        levels = draws.uniform(0.05, 1, len(hz)) * (hz[0] / hz) ** draws.uniform(-0.2, 1.2)
        return cls(hz, levels, decays_s)

    def hit(self, draws: Draws, rate: int) -> Floats:
        """Return one strike at a place of its own: the modes it wakes, and the noise of the touch."""
        t = times(rate, min(3.0, 6 * float(self.decays_s.max()) + 0.05))
        contact_s = log_uniform(draws, 0.0002, 0.004)
        woken = self.levels * np.abs(np.sin(np.pi * draws.uniform(0, 1, len(self.hz))))
        woken = woken * np.exp(-((self.hz * contact_s) ** 2))
        total = np.zeros(len(t))
        is_paired = draws.random() < 0.4  # nothing cast or bent is quite even: its modes come in pairs that beat
        for hz, level, decay_s in zip(self.hz, woken, self.decays_s, strict=True):
            heard = t[: int(9 * decay_s * rate) + 1]  # it falls by 78 dB
            wave = np.sin(2 * np.pi * hz * heard + draws.uniform(0, 6.28))
            if is_paired:
                wave = wave + draws.uniform(0, 0.9) * np.sin(2 * np.pi * hz * draws.uniform(0.997, 1.003) * heard)
            total[: len(heard)] += level * wave * np.exp(-heard / decay_s)
        total = total / (np.abs(total).max() + 1e-12) * np.clip(t / contact_s, 0, 1)
        for _ in range(draws.integers(1, 4)):
            low = log_uniform(draws, 60, 5000)
            touch = band_noise(draws, rate, len(t), low, low * log_uniform(draws, 1.5, 10))
            total += log_uniform(draws, 0.02, 1.5) * touch / 4 * struck(t, contact_s, log_uniform(draws, 0.002, 0.06))
        return total


def stepping(draws: Draws, rate: int) -> Floats:
    """One to four strikes on the same thing."""
    thing = Thing.drawn(draws, rate)
    apart_s = log_uniform(draws, 0.06, 0.7)
    hits = [
        (number * apart_s * draws.uniform(0.8, 1.2), thing.hit(draws, rate) * draws.uniform(0.3, 1))
        for number in range(draws.integers(1, 5))
    ]
    return gated(draws, placed(rate, 0.05, hits), rate)


def handled(draws: Draws, rate: int) -> Floats:
    """Some things that touch one another within a moment: a latch, a tool, a crate set down."""
    things = [Thing.drawn(draws, rate) for _ in range(draws.integers(2, 4))]
    length_s = log_uniform(draws, 0.03, 0.6)
    hits = [
        (length_s * draws.random(), things[draws.integers(len(things))].hit(draws, rate) * log_uniform(draws, 0.1, 1))
        for _ in range(draws.integers(2, 8))
    ]
    return gated(draws, placed(rate, 0.05, hits), rate)


def dropped(draws: Draws, rate: int) -> Floats:
    """A thing that bounces, each time sooner and softer, until it lies."""
    thing = Thing.drawn(draws, rate)
    gap_s, spring = log_uniform(draws, 0.08, 0.5), draws.uniform(0.4, 0.85)
    hits, at = [], 0.0
    for number in range(draws.integers(3, 9)):
        hits.append((at, thing.hit(draws, rate) * spring**number * draws.uniform(0.6, 1)))
        at += gap_s * spring**number
    return gated(draws, placed(rate, 0.05, hits), rate)


FAMILIES = [Family(one.__name__, "event", one) for one in (stepping, handled, dropped)]
