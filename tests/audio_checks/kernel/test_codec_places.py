"""Silent lines of codecs, counted and held to plain numpy."""

import numpy as np
import pytest

from audio_checks import kernel
from audio_checks.measure.codec_frames import AUDIBLE, EXCERPT_FRAMES, ROUNDING, SILENT, _spectrum, _turns, bands_of
from audio_checks.measure.codec_lines import mdct_lines, sine_window


@pytest.mark.parametrize(("lines", "taps", "frame"), [(1, 500, 576), (16, 2_048, 1_024), (21, 512, 256), (5, 600, 131)])
def test_counts_of_silent_lines(lines: int, taps: int, frame: int):
    rng = np.random.default_rng(lines)
    sound = rng.standard_normal(EXCERPT_FRAMES) * np.repeat(10.0 ** rng.uniform(-4, 0, 16), EXCERPT_FRAMES // 16)
    filters = mdct_lines(sine_window(taps // 2), rng.integers(taps // 20, taps // 2 - taps // 20, lines))
    step, frames = 0.05, (EXCERPT_FRAMES - taps + 1) // frame
    wanted, heard = np.zeros(frame, dtype=np.int64), 0
    for line in filters:
        sizes = np.abs(np.correlate(sound, line, "valid"))[: frames * frame].reshape(frames, frame)
        rms = np.sqrt(np.square(sizes).mean(axis=1))
        below = np.maximum(SILENT * rms, ROUNDING * step)
        is_heard = rms > AUDIBLE * below
        heard += int(is_heard.sum())
        wanted += (sizes < below[:, np.newaxis])[is_heard].sum(axis=0)
    assert 0 < heard < lines * frames  # else rounding is not tried
    out = np.empty(frame, dtype=np.int64)
    limits = (SILENT, ROUNDING * step, AUDIBLE)
    got = kernel.silent_lines(_spectrum(sound), *bands_of(filters), _turns(), taps - 1, frame, frames, *limits, out)
    assert got == pytest.approx(heard, abs=0.01 * lines * frames)  # the RMS is that of the envelope
    assert np.abs(out - wanted).mean() < 0.05 * wanted.mean()  # some values lie near the limit


@pytest.mark.parametrize(("first", "frame", "frames"), [(-1, 10, 1), (0, 0, 1), (0, 10, -1), (1, 1_024, 16)])
def test_frames_beyond_the_sound_are_refused(first: int, frame: int, frames: int):
    out, bands = np.empty(max(1, frame), dtype=np.int64), bands_of(np.ones((1, 8)))
    with pytest.raises(ValueError, match="wanted"):
        kernel.silent_lines(
            _spectrum(np.ones(9)), *bands, _turns(), first, frame, frames, SILENT, ROUNDING, AUDIBLE, out
        )


@pytest.mark.parametrize("first_bin", [-1, EXCERPT_FRAMES // 2])
def test_bands_beyond_the_spectrum_are_refused(first_bin: int):
    out, bands = np.empty(10, dtype=np.int64), bands_of(np.ones((1, 8)))
    bands.firsts[:] = first_bin
    with pytest.raises(ValueError, match="wanted"):
        kernel.silent_lines(_spectrum(np.ones(9)), *bands, _turns(), 0, 10, 1, SILENT, ROUNDING, AUDIBLE, out)
