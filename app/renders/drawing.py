"""What runs in the sandbox's child: a sound's pictures and preview, and game files, written into a folder.

Answers are plain values, the only ones that may come out of a sandbox.
"""

import json
import tempfile
import wave
from pathlib import Path
from typing import Any

import numpy as np

from app.renders.spectrum import spectrum_png
from audio_checks import (
    AudioFile,
    Target,
    WaveShape,
    average_spectrum,
    preview,
    render_master,
    spectrogram,
    wave_shapes,
    write_rehearsal_sound,
)

THUMB_POINTS = 160
PEAKS_POINTS = 4096
THUMB_FULL_SCALE = 127
PLAYABLE_RATE_HZ = 48_000
PEAKS, SPECTRUM, PREVIEW, GAME_FILE = "peaks.json", "spectrum.png", "preview.wav", "render.wav"


def draw(path: str, folder: str, *, loop: bool) -> dict[str, Any]:
    """Write a sound's peaks, spectrum and preview; return its duration, facts and thumb, and what plays it."""
    with AudioFile(path) as file:
        facts = file.facts
    small, large = wave_shapes(path, (THUMB_POINTS, PEAKS_POINTS))
    shape = {"points": large.points, "duration_s": facts.duration_s, **large.to_dict(), "bands": _bands(path)}
    Path(folder, PEAKS).write_text(json.dumps(shape, separators=(",", ":")))
    plays_itself = _plays_itself(path)
    played = path if plays_itself else str(Path(folder, PREVIEW))
    if not plays_itself:
        preview(path, played, loop=loop)
    # Of what plays: its 16 bits reach below black, and its 48 kHz above the top row.
    Path(folder, SPECTRUM).write_bytes(spectrum_png(spectrogram(played)))
    return {
        "duration_s": facts.duration_s,
        "facts": {
            "container": facts.container,
            "encoding": facts.encoding,
            "sample_rate_hz": facts.sample_rate_hz,
            "bit_depth": facts.bit_depth,
            "channels": facts.channels,
            "frames": facts.frames,
        },
        "thumb": _thumb(small),
        "plays_itself": plays_itself,
    }


def _bands(path: str) -> dict[str, list[float | None]]:
    """Return the level of each band of frequency, to a tenth; null for silence."""
    found = average_spectrum(path)
    return {
        "hz": [round(float(hz), 1) for hz in found.centres_hz],
        "dbfs": [round(float(level), 1) if np.isfinite(level) else None for level in found.levels_dbfs],
    }


def _plays_itself(path: str) -> bool:
    """Whether every browser plays this readable file as it is: plain 16-bit WAV, mono or stereo, at most 48 kHz."""
    try:
        with wave.open(path) as file:
            is_narrow = file.getsampwidth() == 2 and file.getnchannels() <= 2
            return is_narrow and bool(file.getframerate() <= PLAYABLE_RATE_HZ)
    except (wave.Error, EOFError):
        return False


def _thumb(shape: WaveShape) -> dict[str, Any]:
    """Return a shape in integers; ±127 is full scale."""
    lines = {"min": shape.lowest, "max": shape.highest, "rms": shape.rms}
    whole = {name: np.rint(np.clip(line, -1, 1) * THUMB_FULL_SCALE) for name, line in lines.items()}
    return {"points": shape.points, **{name: line.astype(int).tolist() for name, line in whole.items()}}


def render(
    path: str,
    folder: str,
    target: Target,
    *,
    loop: bool,
    sample_peak_limit_dbfs: float | None,
    true_peak_limit_dbtp: float | None,
    tolerance_db: float,
) -> dict[str, Any]:
    """Make a game file and draw it; return what was made, and its drawing."""
    out = Path(folder, GAME_FILE)
    rendered = render_master(
        path,
        target,
        out,
        loop=loop,
        sample_peak_limit_dbfs=sample_peak_limit_dbfs,
        true_peak_limit_dbtp=true_peak_limit_dbtp,
        tolerance_db=tolerance_db,
    )
    return {"rendered": rendered.to_dict(), "drawing": draw(str(out), folder, loop=loop)}


def rehearse() -> None:
    """Draw and render a sound of our own once, for all the children to come."""
    target = Target(name="rehearsal", sample_rate_hz=44_100, bit_depth=16)
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        sound = str(Path(folder, "sound.wav"))
        write_rehearsal_sound(sound)
        draw(sound, folder, loop=False)
        render(
            sound,
            folder,
            target,
            loop=False,
            sample_peak_limit_dbfs=None,
            true_peak_limit_dbtp=None,
            tolerance_db=0.05,
        )
