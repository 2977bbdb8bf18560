"""Sounds as codecs keep them, as games ship them."""

import io
from typing import Any

import numpy as np
import soundfile
from numpy.typing import NDArray

FORMATS = {
    "ogg": ("OGG", "VORBIS"),
    "opus": ("OGG", "OPUS"),
    "mp3": ("MP3", "MPEG_LAYER_III"),
    "flac": ("FLAC", "PCM_16"),
}


def coded_bytes(ending: str, *, seed: int = 1, rate: int = 44_100, seconds: float = 0.4, channels: int = 1) -> bytes:
    """Return a fading noise in the codec of an ending: ogg, opus, mp3 or flac."""
    form, subtype = FORMATS[ending]
    frames = round(rate * seconds)
    fade: NDArray[Any] = np.linspace(1, 0, frames)[:, None]
    samples = np.random.default_rng(seed).normal(0, 0.05, (frames, channels)) * fade
    content = io.BytesIO()
    soundfile.write(content, samples, rate, format=form, subtype=subtype)
    return content.getvalue()
