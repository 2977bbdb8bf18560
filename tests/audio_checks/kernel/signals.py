"""Signals that hypothesis makes: any number of channels, odd lengths, plain and awkward samples."""

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

Samples = NDArray[np.float64]
AWKWARD = [0.0, -0.0, 1.0, -1.0, 0.5, 2.0**-23, -(2.0**-31), 0.016, 1e-9, 5e-324, 4.0]


@st.composite
def signals(draw: st.DrawFn, most_frames: int = 700, most_channels: int = 8) -> Samples:
    """Samples of shape (frames, channels): noise of some level, silences and awkward values among it."""
    frames, channels = draw(st.integers(0, most_frames)), draw(st.integers(1, most_channels))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    samples = rng.standard_normal((frames, channels)) * 10.0 ** -draw(st.integers(0, 6))
    if frames:
        for _ in range(draw(st.integers(0, 4))):
            start = draw(st.integers(0, frames - 1))
            samples[start : start + draw(st.integers(1, 60)), rng.integers(channels)] = draw(st.sampled_from(AWKWARD))
    return samples


def cut(samples: Samples, rng: np.random.Generator) -> list[Samples]:
    """The signal in blocks of any length, some of them empty."""
    places = np.sort(rng.integers(0, len(samples) + 1, rng.integers(0, 6)))
    return np.split(samples, places)
