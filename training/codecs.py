"""Sounds that real encoders coded, and sounds that only look like it. Needs ffmpeg; no check imports it."""

import subprocess
from dataclasses import dataclass

import numpy as np
from scipy import signal

from training.shapes import Draws, Floats, log_uniform


@dataclass(frozen=True)
class Coder:
    """One way of coding.

    Attributes
    ----------
    name : str
        The codec's, and the encoder's where there are two.
    options : tuple of str
        For ffmpeg: the encoder and its container.
    kbit_s : tuple of int
        Bit rates of two channels; one has half of it.
    codec : str or None
        What the judgement calls it; None where it does not look for this codec.
    """

    name: str
    options: tuple[str, ...]
    kbit_s: tuple[int, ...]
    codec: str | None
    rate_hz: int | None = None
    is_kept_apart: bool = False


CODERS = (
    Coder("MP3 (LAME)", ("-c:a", "libmp3lame", "-f", "mp3"), (96, 128, 192, 256, 320), "MP3"),
    Coder("AAC (ffmpeg)", ("-c:a", "aac", "-f", "adts"), (96, 128, 192, 256), "AAC"),
    Coder("Vorbis", ("-c:a", "libvorbis", "-f", "ogg"), (96, 128, 192, 224), "Vorbis"),
    Coder("Opus", ("-c:a", "libopus", "-f", "ogg"), (64, 96, 128, 192), "Opus", rate_hz=48_000),
    Coder("MP3 (Shine)", ("-c:a", "libshine", "-f", "mp3"), (128, 192, 320), "MP3", is_kept_apart=True),
    Coder("AC-3", ("-c:a", "ac3", "-f", "ac3"), (192, 448), "AC-3", is_kept_apart=True),
    Coder("MP2", ("-c:a", "mp2", "-f", "mp2"), (192,), None, is_kept_apart=True),
    Coder("WMA", ("-c:a", "wmav2", "-f", "asf"), (128,), None, is_kept_apart=True),
)


def coded(x: Floats, rate_hz: int, coder: Coder, kbit_s: int) -> tuple[Floats, int]:
    """Return a sound, shape (frames, channels), after coding and decoding, and its rate then."""
    channels = x.shape[1]
    raw = ("-f", "f64le", "-ar", str(rate_hz), "-ac", str(channels), "-i", "pipe:0")
    bits = ("-b:a", f"{kbit_s * channels // 2}k", *(("-ar", str(coder.rate_hz)) if coder.rate_hz else ()))
    stream = _ffmpeg(x.astype("<f8").tobytes(), *raw, *coder.options[:2], *bits, *coder.options[2:], "pipe:1")
    out_hz = coder.rate_hz or rate_hz
    plain = _ffmpeg(stream, "-i", "pipe:0", "-f", "f64le", "-ar", str(out_hz), "-ac", str(channels), "pipe:1")
    return np.frombuffer(plain, "<f8").reshape(-1, channels), out_hz


def _ffmpeg(data: bytes, *options: str) -> bytes:
    done = subprocess.run(["ffmpeg", "-v", "error", *options], input=data, capture_output=True, check=False, timeout=60)
    if done.returncode:
        raise RuntimeError(f"ffmpeg {' '.join(options)}: {done.stderr.decode(errors='replace')}")
    return done.stdout


def low_passed(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """Cut off steeply where codecs do."""
    taps = signal.firwin(int(draws.integers(200, 800)) | 1, draws.uniform(11_000, 20_000), fs=rate_hz)
    return signal.fftconvolve(x, taps[:, np.newaxis], "same", axes=0)


def brought_up(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """As if it had been made at a lower rate."""
    from_hz = int(draws.choice([22_050, 24_000, 32_000]))
    return signal.resample(signal.resample(x, round(len(x) * from_hz / rate_hz)), len(x))


def pitched_down(draws: Draws, x: Floats, rate_hz: int) -> Floats:  # noqa: ARG001 - every way has the same form
    """Slower and deeper."""
    return signal.resample(x, round(len(x) * draws.uniform(1.1, 2.5)))


def vintage(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """Out of a sampler of 8 or 12 bits and a low rate, its steps held."""
    held = max(1, round(rate_hz / log_uniform(draws, 9_000, 32_000)))
    steps = 2.0 ** (draws.choice([8, 12]) - 1)
    return np.repeat(np.round(x[::held] * steps) / steps, held, axis=0)[: len(x)]


def gapped(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """With gaps of digital silence, all of one length now and then."""
    x, on, off = x.copy(), *(int(rate_hz * log_uniform(draws, 0.005, 0.1)) for _ in range(2))
    for start in range(on, len(x), on + off):
        x[start : start + off] = 0.0
    return x


def sparse_tones(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """A few partials, some of them in whole periods of samples, now and then squared."""
    t = np.arange(len(x))
    periods = [draws.integers(4, 400) if draws.random() < 0.5 else log_uniform(draws, 4, 800) for _ in range(5)]
    total = sum(draws.uniform(0.1, 1) * np.sin(2 * np.pi / period * t) for period in periods)
    if draws.random() < 0.4:
        total = np.sign(total)
    return (total * np.exp(-t / rate_hz / log_uniform(draws, 0.1, 3.0)))[:, None] * np.ones((1, x.shape[1]))


def looped(draws: Draws, x: Floats, rate_hz: int) -> Floats:
    """A short piece again and again, as a held sample is."""
    piece = max(64, min(len(x), round(rate_hz * log_uniform(draws, 0.004, 0.2))))
    at = int(draws.integers(0, max(1, len(x) - piece)))
    return np.resize(x[at : at + piece], x.shape)


LOOK_ALIKES = {
    "low-passed": low_passed,
    "brought up": brought_up,
    "pitched down": pitched_down,
    "8 or 12 bits": vintage,
    "gaps": gapped,
    "sparse tones": sparse_tones,
    "looped": looped,
}
