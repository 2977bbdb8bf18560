"""Browsers' needs of a sound: a file that all of them play, and its shape.

Masters are read, and game files that a codec keeps, under names that end so.
"""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.sound_files import open_sound
from audio_checks.measure.average_spectrum import AverageSpectrum, BandLevels
from audio_checks.measure.masking import Excitation
from audio_checks.measure.spectrogram import Spectrogram
from audio_checks.measure.waveform import LARGE_POINTS, SMALL_POINTS, Waveform, WaveShape
from audio_checks.render.coding import Coder
from audio_checks.render.recipe import Recipe
from audio_checks.render.render import render
from audio_checks.render.rendered import Rendered
from audio_checks.spec.delivery_spec import Target

MAX_RATE_HZ = 48_000
BIT_DEPTH = 16
LIGHT = Coder("vorbis", 0.2)  # some 95 kbit/s in stereo
LIGHT_SEED = bytes(4)  # each file has one stream alone
LEAST_CODED_RATE_HZ = 8_000
LEAST_CODED_BYTES = 600_000  # a smaller file is mostly here before it is asked for; coding costs 6 to 12 ms a second
REVERSED_BLOCK_FRAMES = 65_536
MAKE_A_PREVIEW = (  # what a target says of its files, but for their peaks
    "sample_rate_hz",
    "bit_depth",
    "encoding",
    "channels",
    "dither",
    "chunks",
    "shelf_db",
    "trim_below_dbfs",
    "fade_in_ms",
    "fade_out_ms",
)


def preview(
    path: str | os.PathLike[str],
    out_path: str | os.PathLike[str],
    *,
    backwards: bool = False,
    loop: bool = False,
    durable: bool = True,
) -> Rendered:
    """Write a preview of a master that every browser plays: 16-bit WAV of at most 48 kHz, mono or stereo.

    A render needs none as long as it is such a file itself.

    Parameters
    ----------
    path, out_path : path
        The master, and the WAV file to write.
    backwards : bool
        From the last frame to the first, to hear what was recorded before it was turned round.
    loop : bool
        The master is a loop: its preview loops without a seam too.
    durable : bool
        The file is on the disk before this returns; without, after a power cut it may be cut short.

    Returns
    -------
    Rendered
        Of the file as it plays forwards; more than two channels are mixed to mono, each at 1 / channels.

    Raises
    ------
    Unreadable
        When the master breaks a rule of structure.
    """
    out = Path(out_path)
    with open_sound(path, coded=True) as sound:
        layout = sound.layout
        recipe = Recipe(
            sample_rate_hz=playable_rate_hz(layout.sample_rate_hz),
            bit_depth=BIT_DEPTH,
            encoding="pcm",
            gains=None if layout.channels <= 2 else np.full((layout.channels, 1), 1 / layout.channels),
            dither="tpdf",
            loop=loop or None,
            measures_loss=False,
        )
        rendered = render(sound, recipe, out, durable=durable)
    if backwards:
        _turn_round(out)
    return rendered


def light_preview(preview_path: str | os.PathLike[str], out_path: str | os.PathLike[str]) -> bool:
    """Write a preview as Ogg Vorbis of the same rate and length, to begin with over a slow line; it never ships.

    Parameters
    ----------
    preview_path, out_path : path
        What `preview` made, or a file that plays as it is; and the Ogg file to write.

    Returns
    -------
    bool
        False where none is written: the file is small already, or its rate is below 8 kHz.
    """
    path = Path(preview_path)
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
    if path.stat().st_size <= LEAST_CODED_BYTES or layout.sample_rate_hz < LEAST_CODED_RATE_HZ:
        return False
    LIGHT.write(path, Path(out_path), seed=LIGHT_SEED, durable=False)
    return True


def is_preview(rendered: Rendered, target: Target, master_rate_hz: int) -> bool:
    """Return whether a game file is, byte for byte, what `preview` makes of its master, so that none need be made.

    Parameters
    ----------
    rendered : Rendered
        What was made to the target of the whole master, with no other loop points than its own.
    target : Target
        What it was made to.
    master_rate_hz : int
        Sample rate of the master.
    """
    plain = Target(target.name, playable_rate_hz(master_rate_hz), BIT_DEPTH)
    is_plain = all(getattr(target, name) == getattr(plain, name) for name in MAKE_A_PREVIEW)
    return is_plain and rendered.channels <= 2 and rendered.attenuation_db == 0


def wave_shapes(
    path: str | os.PathLike[str], points: Sequence[int] = (SMALL_POINTS, LARGE_POINTS)
) -> tuple[WaveShape, ...]:
    """Return the shape of a sound at each number of points, streaming it once.

    Raises
    ------
    Unreadable
        When the file breaks a rule of structure.
    """
    with open_sound(path, coded=True) as sound:
        layout = sound.layout
        shapes = [Waveform(layout.sample_rate_hz, layout.channels, layout.frames, count) for count in points]
        for block in wav.blocks(sound.file, layout):
            for shape in shapes:
                shape.add(block)
        return tuple(shape.result() for shape in shapes)


def average_spectrum(path: str | os.PathLike[str]) -> BandLevels:
    """Return the spread of a sound's energy over frequency, streaming it once; see `AverageSpectrum`.

    Windows last as long at every rate, as those of `Loss.spectra` do.

    Raises
    ------
    Unreadable
        When the file breaks a rule of structure.
    """
    with open_sound(path, coded=True) as sound:
        layout = sound.layout
        spectrum = AverageSpectrum(
            layout.sample_rate_hz, layout.channels, layout.frames, bands_of_hz=layout.sample_rate_hz
        )
        for block in wav.blocks(sound.file, layout):
            spectrum.add(block)
        return spectrum.result()


def spectrogram(path: str | os.PathLike[str]) -> NDArray[np.float64]:
    """Return the levels of a sound over pitch and time in dBFS of a tone, streaming it once; see `Spectrogram`.

    Returns
    -------
    ndarray, shape (128, columns)
        Rows from 20 kHz to 60 Hz in equal steps of pitch, at most 1000 columns from the first frame to
        the last; −inf for silence and above half the sample rate.

    Raises
    ------
    Unreadable
        When the file breaks a rule of structure.
    """
    with open_sound(path, coded=True) as sound:
        layout = sound.layout
        levels = Spectrogram(layout.sample_rate_hz, layout.channels, layout.frames)
        for block in wav.blocks(sound.file, layout):
            levels.add(block)
        return levels.levels()


def excitation(path: str | os.PathLike[str], *, max_s: float) -> NDArray[np.float64]:
    """Return a sound's excitation of each band of the ear, streaming it up to `max_s` seconds; see `Excitation`.

    Returns
    -------
    ndarray, shape (blocks, 37)
        A block every 40 ms.

    Raises
    ------
    Unreadable
        When the file breaks a rule of structure.
    """
    with open_sound(path, coded=True) as sound:
        layout = sound.layout
        accumulator = Excitation(layout.sample_rate_hz, layout.channels)
        left = round(max_s * layout.sample_rate_hz)
        for block in wav.blocks(sound.file, layout):
            accumulator.add(block[:left])
            left -= len(block)
            if left <= 0:
                break
        return accumulator.power()


def playable_rate_hz(sample_rate_hz: int) -> int:
    """Return a rate up to 48 kHz that a master of this rate is brought to, a whole fraction where there is one."""
    if sample_rate_hz <= MAX_RATE_HZ:
        return sample_rate_hz
    return 44_100 if sample_rate_hz % 44_100 == 0 else MAX_RATE_HZ


def _turn_round(path: Path) -> None:
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        wav.write_wav(
            path,
            _from_the_end(file, layout),
            sample_rate_hz=layout.sample_rate_hz,
            bit_depth=layout.bit_depth,
            channels=layout.channels,
            frames=layout.frames,
        )


def _from_the_end(file: BinaryIO, layout: wav.WavLayout) -> Iterator[NDArray[np.int16]]:
    end = layout.frames
    while end:
        start = max(0, end - REVERSED_BLOCK_FRAMES)
        file.seek(layout.data_offset + start * layout.frame_bytes)
        raw = file.read((end - start) * layout.frame_bytes)
        yield np.frombuffer(raw, "<i2").reshape(-1, layout.channels)[::-1]
        end = start
