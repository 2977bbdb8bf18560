"""Fades: half a turn of a cosine, which begins and ends without a corner."""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from audio_checks.render.twiddles import cos_sin_pi

Block = NDArray[np.float64]


def faded(blocks: Iterable[Block], *, frames: int, fade_in: int, fade_out: int) -> Iterator[Block]:
    """Yield a sound of `frames` frames that rises over its first and falls over its last.

    Parameters
    ----------
    blocks : iterable of ndarray, shape (n, channels)
        The sound, in order.
    frames : int
        Of all blocks together.
    fade_in, fade_out : int
        Frames of each fade; longer than the sound, they begin or end outside it. The first frame of a
        rise and the last of a fall are not zero: silence there would only make the sound shorter.
    """
    at = 0
    for block in blocks:
        gains = _rise(np.arange(at, at + len(block)), fade_in)
        gains = gains * _rise(np.arange(frames - 1 - at, frames - 1 - at - len(block), -1), fade_out)
        yield block * gains[:, np.newaxis]
        at += len(block)


def _rise(places: NDArray[np.int64], frames: int) -> NDArray[np.float64]:
    done = np.minimum((places + 1) / (frames + 1), 1.0)
    gains: NDArray[np.float64] = (1.0 - cos_sin_pi(done)[0]) / 2.0
    return np.where(places < frames, gains, 1.0)
