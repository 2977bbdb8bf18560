"""Work of the sandbox's child: a sound's pictures and preview, and game files, written into a folder.

Answers are of the types that functions declare here: no other comes out of a sandbox.
"""

import tempfile
import wave
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias, TypedDict, cast

import numpy as np
from pydantic_core import to_json

from app.renders.spectrum import spectrum_png
from audio_checks import (
    AudioChecksError,
    AudioFile,
    BandLevels,
    Rendered,
    RenderRefused,
    Target,
    Unreadable,
    average_spectrum,
    ending_of,
    is_lossy,
    is_preview,
    keep_coded,
    light_preview,
    preview,
    rehearse_check,
    render_master,
    sound_signature,
    spectrogram,
    wave_shapes,
    write_rehearsal_sound,
)

THUMB_POINTS = 160
PEAKS_POINTS = 4096
THUMB_FULL_SCALE = 127
PEAKS_FULL_SCALE = 10_000  # a step is 80 dB below, less than a pixel
PLAYABLE_RATE_HZ = 48_000
MASTER = ""  # no target's name is empty
PEAKS, SPECTRUM, PREVIEW, LIGHT = "peaks.json", "spectrum.png", "preview.wav", "light.ogg"


class Facts(TypedDict):
    """The format of a sound, by its header."""

    container: str
    encoding: str
    sample_rate_hz: int
    bit_depth: int
    channels: int
    frames: int


class Thumb(TypedDict):
    """A small waveform; THUMB_FULL_SCALE is full scale."""

    points: int
    min: list[int]
    max: list[int]
    rms: list[int]


class Drawn(TypedDict):
    """The drawings of a sound."""

    duration_s: float
    facts: Facts
    thumb: Thumb
    plays_itself: bool
    preview_of: str  # the target whose file serves as the preview; empty if there is a separate preview
    has_light: bool  # a smaller preview was written, to begin with over a slow line


class Made(TypedDict):
    """A game file, and what was drawn of it."""

    rendered: Rendered
    drawing: Drawn


Outcome: TypeAlias = Made | Drawn | AudioChecksError


def prepare(
    path: str, folder: str, recipes: dict[str, dict[str, Any]], *, loop: bool, draws_master: bool
) -> dict[str, Outcome]:
    """Make game files of a master and draw them and, where asked, the master; `places` says where each goes.

    Results are by the name of the target, and MASTER; or the reason why it cannot be made, or drawn.
    """
    outcomes: dict[str, Outcome] = {}
    decoded = _Known()
    Path(folder).mkdir(exist_ok=True)
    places_of = places(folder, recipes)
    for target, recipe in recipes.items():
        target_folder = places_of[target]
        target_folder.mkdir()
        try:
            outcomes[target] = _rendered(path, target_folder, recipe, decoded)
        except (RenderRefused, Unreadable) as error:
            outcomes[target] = error.with_traceback(None)
    if draws_master:
        try:
            outcomes[MASTER] = drawing = _drawn(path, Path(folder), loop=loop, decoded=decoded)
            drawing["has_light"] = light_preview(_played(path, places_of, drawing), Path(folder) / LIGHT)
        except (RenderRefused, Unreadable) as error:
            outcomes[MASTER] = error.with_traceback(None)
    return outcomes


def game_file(encoding: str) -> str:
    """Return the name of a game file of an encoding in its folder; a codec's is read by its ending."""
    return f"render{ending_of(encoding)}"


def places(folder: str, targets: Iterable[str]) -> dict[str, Path]:
    """Return the path of each target's file in a folder, and of the master's drawing."""
    return {target: Path(folder, str(number)) for number, target in enumerate(targets)} | {MASTER: Path(folder)}


@dataclass
class _Known:
    """The results on a master from making its game files."""

    preview_of: str = ""  # the target whose file plays as the master's preview does
    preview_png: bytes = b""
    bands: BandLevels | None = None


def draw(path: str, folder: str, *, loop: bool) -> Drawn:
    """Write a sound's peaks, spectrum and preview; return its duration, facts and thumb, and what plays it."""
    return _drawn(path, Path(folder), loop=loop, decoded=_Known())


def _drawn(path: str, folder: Path, *, loop: bool, decoded: _Known) -> Drawn:
    with AudioFile(path, coded=True) as file:
        facts = file.facts
    small, large = wave_shapes(path, (THUMB_POINTS, PEAKS_POINTS))
    bands = decoded.bands or average_spectrum(path)
    shape = {
        "frames": facts.frames,
        "sample_rate_hz": facts.sample_rate_hz,
        "duration_s": facts.duration_s,
        "full_scale": PEAKS_FULL_SCALE,
        **large.in_steps(PEAKS_FULL_SCALE),
        "bands": _in_tenths(bands),
    }
    (folder / PEAKS).write_bytes(to_json(shape))
    plays_itself = _is_playable(path)
    preview_of = "" if plays_itself else decoded.preview_of
    if not plays_itself and not preview_of:
        preview(path, folder / PREVIEW, loop=loop, durable=False)
    # Of what plays: its 16 bits reach below black, and its 48 kHz above the top row.
    spectrum = decoded.preview_png if preview_of else _spectrum(path if plays_itself else folder / PREVIEW)
    (folder / SPECTRUM).write_bytes(spectrum)
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
        "thumb": cast(Thumb, small.in_steps(THUMB_FULL_SCALE)),
        "plays_itself": plays_itself,
        "preview_of": preview_of,
        "has_light": False,
    }


def _played(path: str, places_of: dict[str, Path], drawing: Drawn) -> Path:
    """Return the file that plays a master: itself, the game file of a target, or a preview of its own."""
    if drawing["plays_itself"]:
        return Path(path)
    target = drawing["preview_of"]
    return places_of[target] / (game_file("pcm") if target else PREVIEW)


def _spectrum(path: str | Path) -> bytes:
    return spectrum_png(spectrogram(path))


def _in_tenths(bands: BandLevels) -> dict[str, list[float | None]]:
    """Return the level of each band of frequency, to a tenth; null for silence."""
    return {
        "hz": [round(float(hz), 1) for hz in bands.centres_hz],
        "dbfs": [round(float(level), 1) if np.isfinite(level) else None for level in bands.levels_dbfs],
    }


def _is_playable(path: str) -> bool:
    """Whether every browser plays this readable file as it is: plain 16-bit WAV, mono or stereo, at most 48 kHz."""
    try:
        with wave.open(path) as file:
            is_narrow = file.getsampwidth() == 2 and file.getnchannels() <= 2
            return is_narrow and bool(file.getframerate() <= PLAYABLE_RATE_HZ)
    except (wave.Error, EOFError):
        return False


def _rendered(path: str, folder: Path, recipe: dict[str, Any], decoded: _Known) -> Made:
    """Make a game file and draw it; return what was made, and its drawing."""
    with AudioFile(path, coded=True) as file:
        facts = file.facts
    master_rate_hz = facts.sample_rate_hz
    if is_lossy(facts.encoding):
        out = folder / game_file(facts.encoding)
        rendered = keep_coded(path, recipe["target"], out, loop=recipe["loop"])
    else:
        out = folder / game_file(recipe["target"].encoding)
        rendered = render_master(path, out_path=out, **recipe, durable=False)  # the store syncs its copy
    decoded_render = _Known()
    if rendered.loss is not None and rendered.sample_rate_hz == master_rate_hz:
        spectra = rendered.loss.spectra
        decoded.bands = BandLevels(np.array(spectra.hz), np.array(spectra.master_dbfs))
        decoded_render.bands = BandLevels(np.array(spectra.hz), np.array(spectra.render_dbfs))
    drawing = _drawn(str(out), folder, loop=recipe["loop"], decoded=decoded_render)
    if not decoded.preview_of and drawing["plays_itself"] and is_preview(rendered, recipe["target"], master_rate_hz):
        decoded.preview_of, decoded.preview_png = recipe["target"].name, (folder / SPECTRUM).read_bytes()
    return {"rendered": rendered, "drawing": drawing}


def preload() -> None:
    """Check, draw, render and fingerprint a sound of our own once, for all the children to come."""
    recipe = {
        "target": Target(name="rehearsal", sample_rate_hz=44_100, bit_depth=16),
        "loop": False,
        "sample_peak_limit_dbfs": None,
        "true_peak_limit_dbtp": None,
        "tolerance_db": 0.05,
    }
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        sound = str(Path(folder, "sound.wav"))
        write_rehearsal_sound(sound)
        prepare(sound, folder, {"rehearsal": recipe}, loop=False, draws_master=True)
        sound_signature(sound)
    rehearse_check()
