"""Work of the sandbox's child: sounds measured for scenes, parts of references, and differences of two sounds.

Answers are of the types that functions declare here: no other comes out of a sandbox.
"""

import math
import wave
from pathlib import Path
from typing import TypedDict, cast

import numpy as np
from numpy.typing import NDArray

from app.renders.drawing import THUMB_POINTS, Thumb
from app.scenes.excitations import packed
from app.scenes.rules import LONGEST_S
from audio_checks import RenderRefused, Unreadable, average_spectrum, excitation, preview, wave_shapes

PREVIEW, DIFFERENCE = "preview.wav", "difference.wav"
FARTHEST_S = 1.0  # that two sounds are moved against each other
LONGEST_COMPARED_S = 60.0
QUIET = 1e-12  # against the energy of the sound: nothing is left
DAMAGED = "this file cannot be decoded: it is damaged, or of a format that the server does not read"
PLAYED_BITS = 16

Samples = NDArray[np.float64]


class Measured(TypedDict):
    """The excitation of a sound, and its shape; `problem` says why there is none."""

    duration_s: float
    excitation: bytes
    thumb: Thumb
    problem: str


class Compared(TypedDict):
    """The difference of one sound from another; levels are null for silence."""

    lag_s: float
    gain_db: float
    residue_db: float | None
    hz: list[float]
    sound_dbfs: list[float | None]
    against_dbfs: list[float | None]
    difference_dbfs: list[float | None]


def measure_preview(path: str) -> Measured:
    """Return the measurements of a preview, of a scene's length at most."""
    with wave.open(path) as file:
        duration_s = file.getnframes() / file.getframerate()
    (shape,) = wave_shapes(path, (THUMB_POINTS,))
    return {
        "duration_s": duration_s,
        "excitation": packed(excitation(path, max_s=LONGEST_S)),
        "thumb": cast(Thumb, shape.in_steps(127)),
        "problem": "",
    }


def prepare_part(path: str, folder: str, start_s: float, end_s: float) -> Measured:
    """Write a part of a reference as a preview that every browser plays, and measure it."""
    import soundfile  # slow to import, and only a reference needs it

    part = Path(folder, "part.wav")
    try:
        with soundfile.SoundFile(path) as sound:
            rate_hz, first = sound.samplerate, round(start_s * sound.samplerate)
            if first >= sound.frames:
                return _nothing(
                    f"the part begins at {start_s:g} s, and the sound ends at {sound.frames / rate_hz:.1f} s"
                )
            sound.seek(first)
            frames = sound.read(round(min(LONGEST_S, end_s - start_s) * rate_hz), dtype="float64", always_2d=True)
        soundfile.write(part, np.nan_to_num(np.clip(frames, -1, 1)), rate_hz, subtype="PCM_24")
        preview(part, Path(folder, PREVIEW))
    except (soundfile.SoundFileError, Unreadable, RenderRefused, ValueError, RuntimeError):
        return _nothing(DAMAGED)
    return measure_preview(str(Path(folder, PREVIEW)))


def _nothing(problem: str) -> Measured:
    thumb: Thumb = {"points": 0, "min": [], "max": [], "rms": []}
    return {"duration_s": 0.0, "excitation": b"", "thumb": thumb, "problem": problem}


def compare(path: str, against_path: str, folder: str) -> Compared:
    """Write the rest of a preview when another, moved and brought to its level, is taken away from it."""
    sound, rate_hz = _read(path)
    against, against_rate_hz = _read(against_path)
    against = resampled(against, against_rate_hz, rate_hz)
    if sound.shape[1] != against.shape[1]:
        sound, against = sound.mean(axis=1, keepdims=True), against.mean(axis=1, keepdims=True)
    lag = lag_frames(sound, against, farthest=round(FARTHEST_S * rate_hz))
    moved = _moved(against, lag, len(sound))
    energy = float(np.square(moved).sum())
    gain = float((sound * moved).sum()) / energy if energy else 0.0
    difference = sound - gain * moved
    _write(Path(folder, DIFFERENCE), difference, rate_hz)
    whole, left = float(np.square(sound).sum()), float(np.square(difference).sum())
    bands = [average_spectrum(part_path) for part_path in (path, against_path, Path(folder, DIFFERENCE))]
    longest = max(bands, key=lambda spectrum: len(spectrum.centres_hz))
    levels = [_levels(band.levels_dbfs, len(longest.centres_hz)) for band in bands]
    return {
        "lag_s": lag / rate_hz,
        "gain_db": 20 * math.log10(abs(gain)) if gain else 0.0,
        "residue_db": 10 * math.log10(max(QUIET, left / whole)) if whole else None,
        "hz": [round(float(hz), 1) for hz in longest.centres_hz],
        "sound_dbfs": levels[0],
        "against_dbfs": levels[1],
        "difference_dbfs": levels[2],
    }


def lag_frames(sound: Samples, against: Samples, *, farthest: int) -> int:
    """Return the frames by which `against` is moved later to lie on `sound`, at their best agreement.

    Both have the shape (frames, channels); a turned polarity agrees too.
    """
    length = 1 << (len(sound) + len(against)).bit_length()
    spectrum, other = np.fft.rfft(sound.mean(axis=1), length), np.fft.rfft(against.mean(axis=1), length)
    agreement = np.abs(np.fft.irfft(spectrum * np.conj(other), length))
    near = min(farthest, length // 2 - 1)
    lags = np.arange(-near, near + 1)
    return int(lags[np.argmax(agreement[lags])])


def resampled(samples: Samples, from_hz: int, to_hz: int) -> Samples:
    """Return samples, shape (frames, channels), at another rate: what both rates hold stays as it is."""
    if from_hz == to_hz or not len(samples):
        return samples
    step = from_hz // math.gcd(from_hz, to_hz)
    padded = np.pad(samples, ((0, -len(samples) % step + step), (0, 0)))
    length = len(padded) * to_hz // from_hz
    spectrum = np.fft.rfft(padded, axis=0)
    spectrum = spectrum[: length // 2 + 1] if length < len(padded) else spectrum
    converted = np.fft.irfft(spectrum, length, axis=0) * (to_hz / from_hz)
    return np.asarray(converted[: round(len(samples) * to_hz / from_hz)])


def _moved(samples: Samples, lag: int, frames: int) -> Samples:
    moved = np.zeros((frames, samples.shape[1]))
    part = samples[max(0, -lag) : max(0, frames - lag)]
    moved[max(0, lag) : max(0, lag) + len(part)] = part
    return moved


def _levels(levels: Samples, count: int) -> list[float | None]:
    rounded = [round(float(level), 1) if np.isfinite(level) else None for level in levels]
    return rounded + [None] * (count - len(rounded))


def _read(path: str) -> tuple[Samples, int]:
    with wave.open(path) as file:
        rate_hz = file.getframerate()
        frames = file.readframes(min(file.getnframes(), round(LONGEST_COMPARED_S * rate_hz)))
        samples = np.frombuffer(frames, "<i2").reshape(-1, file.getnchannels())
    return samples / 32_768, rate_hz


def _write(path: Path, samples: Samples, rate_hz: int) -> None:
    with wave.open(str(path), "wb") as file:
        file.setnchannels(samples.shape[1])
        file.setsampwidth(PLAYED_BITS // 8)
        file.setframerate(rate_hz)
        file.writeframes(np.clip(np.rint(samples * 32_768), -32_768, 32_767).astype("<i2").tobytes())


def preload() -> None:
    """Load the decoders of sounds, for all the children to come."""
    import soundfile  # noqa: F401
