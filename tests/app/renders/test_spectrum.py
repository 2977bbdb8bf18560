import io
import struct
import zlib

import numpy as np
import pytest
from numpy.typing import NDArray

from app.renders.spectrum import BOTTOM_HZ, HEIGHT, MAX_WIDTH, TOP_HZ, SpectrumPicture, grey_png
from tests.support.waves import Samples, click, join, silence, sine


def levels(samples: Samples, rate: int = 48_000, block: int = 1_000) -> NDArray[np.float64]:
    picture = SpectrumPicture(rate, samples.shape[1], len(samples))
    for start in range(0, len(samples), block):
        picture.add(samples[start : start + block])
    return picture.levels()


def row_of(hz: float) -> int:
    """The row that a frequency falls into: equal steps of pitch from top to bottom."""
    return int(HEIGHT * np.log(TOP_HZ / hz) / np.log(TOP_HZ / BOTTOM_HZ))


@pytest.mark.parametrize("rate", [22_050, 44_100, 48_000])
@pytest.mark.parametrize("hz", [120, 1_000, 9_000])
def test_a_tone_is_a_line_at_its_frequency_and_level(rate: int, hz: float) -> None:
    middle = levels(sine(hz=hz, dbfs=-20, rate=rate), rate)[:, 500]
    loudest = int(np.argmax(middle))
    assert abs(loudest - row_of(hz)) <= 1
    # A tone between two bins of a Hann window reads at most 1.42 dB low; between two rows as much again.
    assert -23.0 <= middle[loudest] <= -19.9
    rows_hz = TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** ((np.arange(HEIGHT) + 0.5) / HEIGHT)
    far = np.abs(rows_hz - hz) > 150 + 0.07 * hz  # more than six bins away, side lobes lie 50 dB down
    assert middle[far].max() < -60


def test_what_the_rate_cannot_hold_is_black() -> None:
    shown = levels(sine(hz=1_000, dbfs=-3, rate=22_050), 22_050)
    above_nyquist = [row for row in range(HEIGHT) if TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** ((row + 1) / HEIGHT) > 11_025]
    assert (shown[above_nyquist] <= -299).all()


def test_channels_against_each_other_do_not_cancel() -> None:
    tone = sine(hz=1_000, dbfs=-20, channels=2)
    assert levels(tone * [1, -1]).max() == pytest.approx(levels(tone).max(), abs=0.01)


def test_a_click_in_a_long_sound_is_seen_where_it_is() -> None:
    sound = join(silence(seconds=20.0), click(at_s=0.5, dbfs=0, seconds=1.0), silence(seconds=19.0))
    shown = levels(sound, block=65_536)
    assert shown.shape == (HEIGHT, MAX_WIDTH)
    lit = np.flatnonzero(shown[row_of(5_000)] > -90)
    assert lit.size
    assert np.abs(lit / MAX_WIDTH * 40.0 - 20.5).max() < 0.1


@pytest.mark.parametrize("frames", [1, 2, 47, 48, 3_000])
def test_the_shortest_sounds_are_drawn_too(frames: int) -> None:
    shown = levels(np.full((frames, 1), 0.5))
    assert shown.shape[0] == HEIGHT
    assert 1 <= shown.shape[1] <= MAX_WIDTH
    assert np.isfinite(shown).all()


def test_how_the_stream_is_cut_changes_nothing() -> None:
    sound = sine(hz=440, dbfs=-6, seconds=0.7, channels=2)
    whole = levels(sound, block=len(sound))
    assert np.allclose(levels(sound, block=77), whole)


def test_silence_is_black_and_full_scale_white() -> None:
    quiet, loud = SpectrumPicture(48_000, 1, 48_000), SpectrumPicture(48_000, 1, 48_000)
    quiet.add(silence())
    loud.add(sine(hz=1_000, dbfs=0))
    assert decoded(quiet.png()).max() == 0
    assert decoded(loud.png()).max() == 255


def decoded(png: bytes) -> NDArray[np.uint8]:
    """Read a PNG by its specification: signature, chunks with lengths and CRCs, one filter byte a line."""
    stream = io.BytesIO(png)
    assert stream.read(8) == b"\x89PNG\r\n\x1a\n"
    chunks = {}
    while head := stream.read(8):
        length, kind = struct.unpack(">I4s", head)
        payload = stream.read(length)
        assert struct.unpack(">I", stream.read(4))[0] == zlib.crc32(kind + payload)
        chunks[kind] = payload
    width, height, depth, colour, *rest = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert (depth, colour, rest) == (8, 0, [0, 0, 0])
    lines = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, width + 1)
    assert (lines[:, 0] == 0).all()
    return lines[:, 1:]


def test_a_png_holds_the_values_it_was_given() -> None:
    values = np.arange(256, dtype=np.uint8).reshape(16, 16)
    assert (decoded(grey_png(values)) == values).all()
