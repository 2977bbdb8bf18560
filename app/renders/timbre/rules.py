"""Code of the sandbox's child: the timbre of a sound, computed by librosa, and its spectrum.

For comparing sounds with each other, never for judging one: it uses the preview, mixed to mono.
"""

import math
import wave
from pathlib import Path
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from audio_checks import average_spectrum, preview

MAX_DURATION_S = 30.0
WINDOW_FRAMES, HOP_FRAMES = 2_048, 1_024
LOWEST_HZ, HIGHEST_HZ = 50.0, 10_000.0  # what every sample rate in use has
MEL_BANDS = 40
COEFFICIENTS = 12  # of the cepstrum, the first after its level
CONTRAST_BANDS = 4  # octaves from 200 Hz on, and what is below
HEARD_DB = 40.0  # windows this far under the loudest one do not count
BAND_FLOOR_DB = 60.0  # under the loudest band
LOADED = "played.wav"


class Heard(TypedDict):
    """The timbre and spectrum of a sound."""

    timbre: list[float]
    bands_db: list[float]


def measure(path: str, folder: str, *, loop: bool) -> Heard | None:
    """Return a sound's `timbre` and its `bands_db`, both free of its level; None for silence.

    `timbre` holds the mean and the spread of the mel cepstrum, then the mean contrast of peaks and valleys by octave,
    scaled to decibels: see `distance_db` in app/reviews/palette_fit/rules.py.
    """
    bands = average_spectrum(path).levels_dbfs
    played = Path(folder, LOADED)
    preview(path, played, loop=loop)
    samples, rate_hz = _mono(played)
    if not samples.any() or not np.isfinite(bands).any():
        return None
    under = np.maximum(bands - bands.max(), -BAND_FLOOR_DB)
    return {"timbre": _rounded(_timbre(samples, rate_hz)), "bands_db": _rounded(under)}


def _mono(path: Path) -> tuple[NDArray[np.float32], int]:
    with wave.open(str(path)) as file:
        frames = file.readframes(min(file.getnframes(), round(MAX_DURATION_S * file.getframerate())))
        samples = np.frombuffer(frames, "<i2").reshape(-1, file.getnchannels()).mean(axis=1)
        return (samples / 32_768).astype(np.float32), file.getframerate()


def _timbre(samples: NDArray[np.float32], rate_hz: int) -> NDArray[np.float64]:
    import librosa  # takes seconds; the sandbox's server has loaded it before it forks

    windows: dict[str, Any] = {"n_fft": WINDOW_FRAMES, "hop_length": HOP_FRAMES}
    samples = np.pad(samples, (0, max(0, WINDOW_FRAMES - len(samples))))
    power = np.abs(librosa.stft(samples, **windows)) ** 2
    highest = min(HIGHEST_HZ, rate_hz / 2)
    mel = librosa.feature.melspectrogram(S=power, sr=rate_hz, n_mels=MEL_BANDS, fmin=LOWEST_HZ, fmax=highest)
    cepstrum = librosa.feature.mfcc(S=librosa.power_to_db(mel, ref=np.max), n_mfcc=COEFFICIENTS + 1)[1:]
    contrast = librosa.feature.spectral_contrast(S=np.sqrt(power), sr=rate_hz, n_bands=CONTRAST_BANDS)
    level_db = librosa.power_to_db(power.sum(axis=0), ref=np.max, top_db=None)
    heard = level_db > -HEARD_DB
    # The cepstrum's transform keeps lengths: over the bands' root its length is the RMS of the bands' decibels.
    in_bands = cepstrum[:, heard] / math.sqrt(MEL_BANDS)
    in_octaves = contrast[:, heard] / math.sqrt(len(contrast))
    timbre: NDArray[np.float64] = np.concatenate((in_bands.mean(axis=1), in_bands.std(axis=1), in_octaves.mean(axis=1)))
    return timbre


def _rounded(values: NDArray[Any]) -> list[float]:
    return [round(float(value), 2) for value in values]
