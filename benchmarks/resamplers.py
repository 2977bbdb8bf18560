"""Other resamplers, each at its best setting that is documented, brought to one call: float64 in, float64 out."""

import shutil
import subprocess
from collections.abc import Callable
from math import gcd
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from audio_checks.render.resample import resample
from benchmarks import peers

Samples = NDArray[np.float64]
Resampler = Callable[[Samples, int, int], Samples]

SOXR_33 = "resampler=soxr:precision=33:cutoff=0.95"
SWR = "internal_sample_fmt=dblp"


def all_of_them() -> dict[str, Resampler]:
    """Return ours first, then those that are installed, by name; all take and give one channel."""
    found: dict[str, Resampler | None] = {
        "ours": lambda samples, high, low: resample(samples[:, np.newaxis], high, low)[:, 0],
        "soxr VHQ": _soxr(),
        "ffmpeg, soxr at precision 33": _ffmpeg(SOXR_33),
        "ffmpeg, swr": _ffmpeg(SWR),
        "sox, rate -v": _sox(),
        "libsamplerate, sinc best": _libsamplerate(),
        "scipy, resample_poly": _scipy(),
        "pydub": _pydub(),
    }
    return {name: one for name, one in found.items() if one is not None}


def ffmpeg_command(path: Path, high: int, low: int, filters: str | None) -> list[str] | None:
    """Return the command by which ffmpeg reads raw float64 and throws away what it made; None without ffmpeg."""
    program = peers.ffmpeg()
    if program is None:
        return None
    how = ["-af", f"aresample={low}:{filters}"] if filters else []
    read = ["-f", "f64le", "-ar", str(high), "-ac", "1", "-i", str(path)]
    return [program, "-nostdin", "-v", "error", *read, *how, "-f", "f64le", "-y", "/dev/null"]


def _soxr() -> Resampler | None:
    library = peers.module("soxr")
    if library is None:
        return None
    return lambda samples, high, low: library.resample(samples, high, low, quality="VHQ")


def _ffmpeg(filters: str) -> Resampler | None:
    program = peers.ffmpeg()
    if program is None:
        return None

    def work(samples: Samples, high: int, low: int) -> Samples:
        raw = ["-f", "f64le", "-ar", str(high), "-ac", "1", "-i", "pipe:"]
        made = ["-af", f"aresample={low}:{filters}", "-f", "f64le", "pipe:"]
        return _piped([program, "-v", "error", *raw, *made], samples)

    return work


def _sox() -> Resampler | None:
    program = shutil.which("sox")
    if program is None:
        return None

    def work(samples: Samples, high: int, low: int) -> Samples:
        raw = ["-t", "raw", "-e", "float", "-b", "64", "-c", "1"]
        return _piped([program, "-V1", *raw, "-r", str(high), "-", *raw, "-", "rate", "-v", str(low)], samples)

    return work


def _piped(command: list[str], samples: Samples) -> Samples:
    done = subprocess.run(command, input=samples.astype("<f8").tobytes(), capture_output=True, check=True, timeout=60)
    return np.frombuffer(done.stdout, "<f8")


def _libsamplerate() -> Resampler | None:
    library = peers.module("samplerate")
    if library is None:
        return None
    return lambda samples, high, low: library.resample(samples, low / high, "sinc_best").astype(np.float64)


def _scipy() -> Resampler | None:
    library = peers.module("scipy")
    if library is None:
        return None
    from scipy.signal import resample_poly

    def work(samples: Samples, high: int, low: int) -> Samples:
        common = gcd(high, low)
        return np.asarray(resample_poly(samples, low // common, high // common), dtype=np.float64)

    return work


def _pydub() -> Resampler | None:
    library = peers.module("pydub")
    if library is None:
        return None

    def work(samples: Samples, high: int, low: int) -> Samples:
        whole = np.clip(np.rint(samples * 2**31), -(2**31), 2**31 - 1).astype("<i4").tobytes()
        sound = library.AudioSegment(data=whole, sample_width=4, frame_rate=high, channels=1).set_frame_rate(low)
        return np.frombuffer(sound.raw_data, "<i4") / 2.0**31

    return work
