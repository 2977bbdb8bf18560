"""A section of a WAV file, read in place."""

from collections.abc import Iterator
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav


def stretch(file: BinaryIO, layout: wav.WavLayout, first: int, end: int) -> Iterator[NDArray[np.float64]]:
    """Yield the frames of a stretch in blocks; nothing before it is read.

    Parameters
    ----------
    file : binary file
        Open.
    layout : WavLayout
        What its header says.
    first, end : int
        From frame `first` up to, and without, frame `end`; frames outside the sound are left out.

    Yields
    ------
    ndarray, shape (n, channels)
        Full scale ±1.0.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile; R7, for a float sample that is not a finite number or too large.
    """
    first, end = max(first, 0), min(end, layout.frames)
    if end > first:
        yield from wav.blocks(file, wav.stretch_of(layout, first, end))
