"""The exactness of the meters compared with others': true peak of tones, loudness in closed form."""

import math
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from audio_checks.measure.loudness import Loudness
from audio_checks.measure.true_peak import true_peak_dbtp
from benchmarks import peers
from benchmarks.rows import Row
from tests.support.waves import wav_bytes

TONES = ((48_000, 0.4), (48_000, 0.45), (96_000, 0.25), (96_000, 0.4), (192_000, 0.45))
PHASES = 16
TRUE_PEAK_MODE = 0b110001  # of libebur128: EBUR128_MODE_TRUE_PEAK


def rows(folder: Path, quick: bool) -> list[Row]:
    """Measure tones of known crest and known loudness."""
    return [*_true_peaks(4 if quick else PHASES), *_loudness(folder)]


def faded(rate: int, per_frame: float, phase: float) -> np.ndarray:
    """A tone at full scale that comes and goes slowly, half a second."""
    frame = np.arange(rate // 2)
    fade = np.clip(np.minimum(frame, frame[::-1]) / (rate / 20), 0, 1)
    return (np.sin(np.pi / 2 * fade) ** 2 * np.sin(2 * np.pi * per_frame * frame + phase))[:, np.newaxis]


def _true_peaks(phases: int) -> list[Row]:
    found = []
    libebur128 = peers.module("pyebur128")
    for rate, per_frame in TONES:
        tones = [faded(rate, per_frame, phase) for phase in np.linspace(0, np.pi, phases, endpoint=False)]
        ours = [true_peak_dbtp(tone, rate) for tone in tones]
        theirs = [_by_libebur128(libebur128, tone, rate) for tone in tones] if libebur128 else []
        peer = f"libebur128: {min(theirs):.3f} dB" if theirs else "libebur128 is not installed"
        what = f"lowest reading of a full-scale tone of {per_frame:g} fs at {rate / 1000:g} kHz, of {phases} phases"
        found.append(Row(what, min(ours), "dB", -0.14, None, "more", f"highest: {max(ours):.3f} dB", peer))
    return found


def _by_libebur128(library: Any, samples: np.ndarray, rate: int) -> float:
    state = library.R128State(1, rate, TRUE_PEAK_MODE)
    state.add_frames(np.ascontiguousarray(samples[:, 0]), len(samples))
    return 20 * math.log10(library.get_true_peak(state, 0))


def _loudness(folder: Path) -> list[Row]:
    found = []
    for rate in (44_100, 48_000, 96_000, 192_000):
        times = np.arange(10 * rate) / rate
        tone = np.repeat((10 ** (-23 / 20) * np.sin(2 * np.pi * 997 * times))[:, np.newaxis], 2, axis=1)
        meter = Loudness(rate, 2, len(tone))
        meter.add(tone)
        off = abs(meter.result()["integrated_lufs"] + 23.0)
        path = folder / f"tone_{rate}.wav"
        path.write_bytes(wav_bytes(tone, rate=rate, bits=32, encoding="float"))
        what = f"997 Hz at -23 dBFS in stereo, {rate / 1000:g} kHz: off -23.00 LUFS"
        found.append(Row(what, off, "LU", 0.03, None, "less", "", _others(path)))
    return found


def _others(path: Path) -> str:
    said = []
    if library := peers.module("pyloudnorm"):
        samples, rate = peers.module("soundfile").read(path)
        said.append(f"pyloudnorm: {abs(library.Meter(rate).integrated_loudness(samples) + 23):.3f} LU")
    if command := peers.ffmpeg_measures(path):
        shown = subprocess.run(command, capture_output=True, text=True, check=True).stderr
        level = float(shown.rpartition("I:")[2].split()[0])
        said.append(f"{peers.ffmpeg_version()}, to a decimal: {abs(level + 23):.1f} LU")
    return "; ".join(said) or "no peer is installed"
