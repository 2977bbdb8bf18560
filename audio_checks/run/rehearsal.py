"""One-time work of a server of throw-away children, so that no child has to load it: modules, tables, weights."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import numpy as np

from audio_checks.run.runner import check_file
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from audio_checks.wav import write_wav

RATE_HZ = 48_000
FRAMES = RATE_HZ


def write_rehearsal_sound(path: str | os.PathLike[str]) -> None:
    """Write a second of fading noise, 48 kHz, 24 bit, stereo: to check and to render it takes what most sounds take.

    Parameters
    ----------
    path : path
        The WAV file to write.
    """
    noise = np.random.default_rng(1).standard_normal((FRAMES, 2))
    samples = noise * np.geomspace(0.1, 0.0001, FRAMES)[:, np.newaxis]
    steps = np.rint(samples * 2.0**23).astype(np.int64)
    write_wav(path, [steps], sample_rate_hz=RATE_HZ, bit_depth=24, channels=2, frames=FRAMES)


def rehearse_check() -> None:
    """Check a sound of our own, with every figure and judgement: the `rehearsal` of a `Sandbox` for `check_file`."""
    with tempfile.TemporaryDirectory(prefix="audio-checks-") as folder:
        sound = Path(folder, "rehearsal.wav")
        write_rehearsal_sound(sound)
        check_file(sound, parse_spec(new_spec("48k", name="rehearsal")), all_figures=True)
