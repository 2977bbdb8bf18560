"""What others offer for the same work. A peer that is not installed is said to be absent, never made up."""

import shutil
import subprocess
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any


def ffmpeg() -> str | None:
    """Return the newest ffmpeg there is: the one that imageio-ffmpeg brings, else the system's."""
    if find_spec("imageio_ffmpeg"):
        return str(import_module("imageio_ffmpeg").get_ffmpeg_exe())
    return shutil.which("ffmpeg")


def ffmpeg_version() -> str:
    """Return `ffmpeg 9.0.2`, for the table."""
    program = ffmpeg()
    if program is None:
        return "ffmpeg"
    said = subprocess.run([program, "-version"], capture_output=True, text=True, check=True).stdout
    return f"ffmpeg {said.split()[2].removeprefix('n').partition('-')[0]}"


def ffmpeg_measures(path: Path) -> list[str] | None:
    """Return the command by which ffmpeg measures loudness, true peak and statistics."""
    program = ffmpeg()
    if program is None:
        return None
    filters = ["-af", "ebur128=peak=true,astats"]
    return [program, "-nostdin", "-nostats", "-hide_banner", "-i", str(path), *filters, "-f", "null", "-"]


def sox_stats(path: Path) -> list[str] | None:
    """Return the command by which SoX measures statistics."""
    program = shutil.which("sox")
    return [program, str(path), "-n", "stats"] if program else None


def loudgain(path: Path) -> list[str] | None:
    """Return the command by which loudgain (libebur128) measures loudness and true peak."""
    program = shutil.which("loudgain")
    return [program, "-q", str(path)] if program else None


def module(name: str) -> Any:
    """Return an installed module, or None."""
    return import_module(name) if find_spec(name) else None


def pyloudnorm_integrated(path: Path) -> Callable[[], object] | None:
    """Return the work of measuring integrated loudness by pyloudnorm, reading included."""
    library, soundfile = module("pyloudnorm"), module("soundfile")
    if library is None:
        return None

    def measure() -> object:
        samples, rate = soundfile.read(path)
        return library.Meter(rate).integrated_loudness(samples)

    return measure


def pydub_levels(path: Path) -> object:
    """Measure peak and level by pydub."""
    sound = import_module("pydub").AudioSegment.from_wav(str(path))
    return sound.max_dBFS, sound.dBFS
