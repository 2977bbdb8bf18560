"""A word that a person said into a microphone, made into the sound of a placeholder."""

import io
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.measure.edges import Edges
from audio_checks.placeholders.speech import at_rate
from audio_checks.render.twiddles import gain_of

SAMPLE_RATE_HZ, BIT_DEPTH = 48_000, 24
LONGEST_S = 10.0
PEAK_DBFS = -3.0
QUIETEST_PEAK_DBFS = -50.0  # a microphone that is turned off stays below
BELOW_PEAK_DB = 36.0  # how far under its peak a word begins and ends
KEPT_MS = 20.0  # before and after it, so that no consonant is cut
FADE_MS = 5.0


def tidy_recording(content: bytes) -> tuple[bytes, float]:
    """Return a recorded word without the silence around it, at one level, in mono.

    Parameters
    ----------
    content : bytes
        A WAV file of at most 10 s, of any rate, depth and number of channels.

    Returns
    -------
    content : bytes
        A WAV file of 48 kHz and 24 bit whose peak is -3 dBFS.
    duration_s : float
        Of it.

    Raises
    ------
    Unreadable
        It is not a WAV file.
    RenderRefused
        `placeholder:too-long`: it is longer than 10 s. `placeholder:silent`: its peak is below -50 dBFS.
    """
    file = io.BytesIO(content)
    layout = wav.read_layout(file)
    if layout.frames > LONGEST_S * layout.sample_rate_hz:
        message = f"the recording is longer than {LONGEST_S:g} s"
        raise RenderRefused(message, "placeholder:too-long", "say a word or two")
    mono = np.concatenate([block.mean(axis=1) for block in wav.blocks(file, layout)] or [np.zeros(0)])
    mono = mono - mono.mean() if len(mono) else mono
    peak = float(np.abs(mono).max(initial=0.0))
    if peak < gain_of(QUIETEST_PEAK_DBFS):
        message = f"nothing was heard: the recording stays below {QUIETEST_PEAK_DBFS:g} dBFS"
        raise RenderRefused(message, "placeholder:silent", "choose another microphone, or speak closer to it")
    word = at_rate(_trimmed(mono, peak, layout.sample_rate_hz), layout.sample_rate_hz, SAMPLE_RATE_HZ)
    leveled = _faded(word * (gain_of(PEAK_DBFS) / float(np.abs(word).max())))
    return _written(leveled), len(leveled) / SAMPLE_RATE_HZ


def read_recording(content: bytes, sample_rate_hz: int) -> NDArray[np.float64]:
    """Return the samples of a tidied recording at a rate, shape (frames,)."""
    file = io.BytesIO(content)
    layout = wav.read_layout(file)
    recording = np.concatenate([block[:, 0] for block in wav.blocks(file, layout)])
    return at_rate(recording, layout.sample_rate_hz, sample_rate_hz)


def _trimmed(mono: NDArray[np.float64], peak: float, sample_rate_hz: int) -> NDArray[np.float64]:
    edges = Edges(sample_rate_hz, 1, len(mono))
    edges.add(mono[:, np.newaxis])
    head_ms, tail_ms = edges.edges(20 * float(np.log10(peak)) - BELOW_PEAK_DB)
    head, tail = (round(max(0.0, ms - KEPT_MS) * sample_rate_hz / 1000) for ms in (head_ms, tail_ms))
    return mono[head : len(mono) - tail]


def _faded(sound: NDArray[np.float64]) -> NDArray[np.float64]:
    frames = min(round(FADE_MS * SAMPLE_RATE_HZ / 1000), len(sound) // 2)
    rise = np.linspace(0.0, 1.0, frames, endpoint=False)
    faded = sound.copy()
    faded[:frames] *= rise
    faded[len(faded) - frames :] *= rise[::-1]
    return faded


def _written(sound: NDArray[np.float64]) -> bytes:
    """Return a plain WAV file; no file is written, since a confined child may write none."""
    steps = np.round(sound * (2 ** (BIT_DEPTH - 1) - 1)).astype("<i4")
    samples = steps.view(np.uint8).reshape(-1, 4)[:, :3].tobytes()
    return b"".join(_chunks(samples))


def _chunks(samples: bytes) -> Iterator[bytes]:
    block = BIT_DEPTH // 8
    form = (1).to_bytes(2, "little") + (1).to_bytes(2, "little") + SAMPLE_RATE_HZ.to_bytes(4, "little")
    form += (SAMPLE_RATE_HZ * block).to_bytes(4, "little") + block.to_bytes(2, "little")
    form += BIT_DEPTH.to_bytes(2, "little")
    padding = b"\0" * (len(samples) % 2)
    size = 4 + 8 + len(form) + 8 + len(samples) + len(padding)
    yield b"RIFF" + size.to_bytes(4, "little") + b"WAVE"
    yield b"fmt " + len(form).to_bytes(4, "little") + form
    yield b"data" + len(samples).to_bytes(4, "little") + samples + padding
