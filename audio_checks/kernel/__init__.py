"""The hot loops of measuring, compiled from the C files in this folder.

Every function has a plain numpy reference in `tests/audio_checks/kernel`, which holds it to the same
answers. Blocks are float64 of shape (channels, frames), each channel contiguous, full scale ±1.0.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel.sources import digest_of

try:
    from audio_checks.kernel._kernel import (
        bends,
        bursts,
        cells,
        convert,
        crests,
        decay_rows,
        decode_float,
        decode_pcm,
        encode_pcm,
        extremes,
        fourier,
        gliding_segments,
        group_sums,
        hash_add,
        hash_begin,
        hash_end,
        hashes_two,
        highest,
        hop_energies,
        loud_frames,
        low_runs,
        lulls,
        made_from,
        maxima,
        outstanding_amid,
        pitch_rows,
        power_sums,
        powers,
        products,
        records,
        recurrences,
        restore_silence,
        rounded_steps,
        shape_points,
        shaped_steps,
        silent_lines,
        silent_runs,
        steady_segments,
        stereo_products,
        straight_tops,
        sums,
        survey,
        true_peak,
        unforeseen,
        unforeseen_both_ways,
        window_loudness,
    )
except ImportError as error:
    raise ImportError(
        f"the compiled part of audio-checks cannot be loaded ({error}): it is missing, or older than the rest;"
        " install audio-checks again where there is a C compiler (in a checkout: make setup)"
    ) from error

# An installed package has no sources next to it; in a checkout the kernel may be older or newer than they are.
if (_WANTED := digest_of(Path(__file__).parent)) not in (None, made_from()):
    raise ImportError(
        "the compiled part of audio-checks was not made from the C files next to it; rebuild it: make setup"
        " (or, without make: pip install --no-deps --editable .)"
    )

__all__ = [
    "bends",
    "bursts",
    "by_channel",
    "cells",
    "convert",
    "crests",
    "decay_rows",
    "decode_float",
    "decode_pcm",
    "encode_pcm",
    "extremes",
    "fourier",
    "gliding_segments",
    "group_sums",
    "hash_add",
    "hash_begin",
    "hash_end",
    "hashes_two",
    "highest",
    "hop_energies",
    "loud_frames",
    "low_runs",
    "lulls",
    "maxima",
    "outstanding_amid",
    "pitch_rows",
    "power_sums",
    "powers",
    "products",
    "records",
    "recurrences",
    "restore_silence",
    "rounded_steps",
    "shape_points",
    "shaped_steps",
    "silent_lines",
    "silent_runs",
    "steady_segments",
    "stereo_products",
    "straight_tops",
    "sums",
    "survey",
    "true_peak",
    "unforeseen",
    "unforeseen_both_ways",
    "window_loudness",
]


def by_channel(block: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return samples of shape (frames, channels) as the kernel takes them; a scattered channel is copied."""
    rows = block.T
    return rows if rows.strides[1] == rows.itemsize else np.ascontiguousarray(rows)
