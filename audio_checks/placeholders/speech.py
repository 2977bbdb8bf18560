"""A spoken word, where a speech engine (espeak-ng) is installed."""

import subprocess
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import Unreadable
from audio_checks.measure.edges import Edges
from audio_checks.system.isolation import installed_program

ENGINES = ("espeak-ng", "espeak")
TIMEOUT_S = 10.0
WORDS_A_MINUTE = (170, 300)  # plainly; and as fast as it can be understood, for what must be short
MOST_CHARACTERS = 120
SILENCE_DBFS = -50.0


def engine() -> str | None:
    """Return the path of the speech engine that is installed; None for none."""
    return next((program for name in ENGINES if (program := installed_program(name))), None)


def synthesize_speech(text: str, sample_rate_hz: int, most_frames: int | None) -> NDArray[np.float64] | None:
    """Return a text as it is spoken, without silence around it.

    Parameters
    ----------
    text : str
        A word or a few; what cannot be printed is left out.
    sample_rate_hz : int
        Frames per second wanted.
    most_frames : int or None
        How long it may be.

    Returns
    -------
    ndarray, shape (frames,), or None
        Peak 1.0. None where no engine is installed, it fails or takes longer than 10 s, says nothing, or
        cannot say it shortly enough.
    """
    program = engine()
    speakable = "".join(character if character.isprintable() else " " for character in text)[:MOST_CHARACTERS].strip()
    if program is None or not speakable:
        return None
    for words_a_minute in WORDS_A_MINUTE:
        sound = _said(program, speakable, words_a_minute, sample_rate_hz)
        if sound is None or most_frames is None or len(sound) <= most_frames:
            return sound
    return None


def _said(program: str, text: str, words_a_minute: int, sample_rate_hz: int) -> NDArray[np.float64] | None:
    with tempfile.TemporaryDirectory(prefix="audio-checks-") as folder:
        path = Path(folder, "said.wav")
        command = [program, "-s", str(words_a_minute), "-w", str(path), "--stdin"]
        try:
            subprocess.run(command, input=text.encode(), check=True, capture_output=True, timeout=TIMEOUT_S)
            with wav.open_regular(path) as file:
                layout = wav.read_layout(file)
                sound = np.concatenate(list(wav.blocks(file, layout)))[:, :1]
        except (OSError, subprocess.SubprocessError, Unreadable):
            return None
    edges = Edges(layout.sample_rate_hz, 1, len(sound))
    edges.add(sound)
    head, tail = (round(ms * layout.sample_rate_hz / 1000) for ms in edges.edges(SILENCE_DBFS))
    heard = sound[head : len(sound) - tail, 0]
    return at_rate(heard / np.abs(heard).max(), layout.sample_rate_hz, sample_rate_hz) if len(heard) else None


def at_rate(sound: NDArray[np.float64], sample_rate_hz: int, to_hz: int) -> NDArray[np.float64]:
    """Return speech at another rate, a higher one too: a placeholder is not a master, and says that it is none."""
    frames = max(1, round(len(sound) * to_hz / sample_rate_hz))
    moved = np.fft.irfft(np.fft.rfft(sound)[: frames // 2 + 1], frames) * (frames / len(sound))
    return np.asarray(moved / max(1.0, float(np.abs(moved).max())), dtype=np.float64)
