"""Codecs' frames: their lines by theory, and what is found of sounds whose lines were silenced on such frames."""

import numpy as np
import pytest
from scipy import signal

from audio_checks.measure.codec_frames import CodecFrames, rates_of, traces_of
from audio_checks.measure.codec_lines import all_lines, mdct_lines, mp3_lines, opus_window, sine_window
from tests.support.waves import noise, silence

RATE = 44_100
ENOUGH = 5.0  # of contrast; chance leaves less than 3


def coarse(samples, window, *, silenced):
    """A sound through a codec of our own: its lines on frames from the first sample on, the weaker share silenced."""
    frame = len(window) // 2
    lines = mdct_lines(window, range(frame))
    padded = np.pad(samples[:, 0], (frame, 2 * frame))
    out = np.zeros(len(padded))
    for start in range(0, len(padded) - 2 * frame, frame):
        levels = lines @ padded[start : start + 2 * frame]
        levels[np.abs(levels) < np.quantile(np.abs(levels), silenced)] = 0.0
        out[start : start + 2 * frame] += levels @ lines  # what overlaps makes the sound whole again
    return out[frame : frame + len(samples)]


def best_of(samples, rate=RATE, **more):
    return max(traces_of(samples, rate, **more), key=lambda trace: trace.contrast)


@pytest.fixture(scope="module")
def coded():
    return coarse(noise(seconds=0.5, rate=RATE), sine_window(1_024), silenced=0.3)


class TestLines:
    @pytest.mark.slow
    @pytest.mark.parametrize("lines", all_lines()[1:4], ids=lambda lines: lines.codec)
    def test_frames_that_overlap_do_not_disturb_one_another(self, lines):
        # Princen, Johnson, Bradley 1987: a window whose squares add up to 1 makes all lines of all frames orthogonal.
        one, next_one = lines.filters[:, : lines.frame], lines.filters[:, lines.frame :]
        assert lines.filters @ lines.filters.T == pytest.approx(np.eye(len(one)), abs=1e-9)
        assert one @ next_one.T == pytest.approx(np.zeros((len(one), len(one))), abs=1e-9)

    @pytest.mark.parametrize("band", [3, 8, 21])
    def test_mp3_s_lines_lie_in_the_middle_of_their_band(self, band):
        spectra = np.abs(np.fft.rfft(mp3_lines([band]), 1 << 14, axis=1))
        tops = spectra.argmax(axis=1) / (1 << 13)  # of Nyquist
        assert sorted(tops) == pytest.approx([(18 * band + 8.5) / 576, (18 * band + 9.5) / 576], abs=0.5 / 576)

    def test_mp3_s_lines_of_one_frame_and_the_next_are_apart(self):
        lines = mp3_lines([8, 9])
        assert lines @ lines.T == pytest.approx(np.eye(4), abs=0.01)
        later = np.pad(lines, ((0, 0), (576, 0)))[:, : lines.shape[1]]
        assert lines @ later.T == pytest.approx(np.zeros((4, 4)), abs=0.01)

    def test_opus_s_lines_are_those_of_the_raised_highs(self):
        opus = next(lines for lines in all_lines() if lines.codec == "Opus")
        tops_hz = np.abs(np.fft.rfft(opus.filters, 48_000, axis=1)).argmax(axis=1)
        assert tops_hz == pytest.approx(25 * (np.arange(60, 800, 18) + 0.5), abs=26)  # 960 lines in 24 kHz
        undone = signal.lfilter([1.0], [1.0, -0.85], opus.filters[5][::-1])[::-1][1:]  # the highs lowered again
        line = mdct_lines(opus_window(), [60 + 18 * 5])[0]
        assert abs(undone @ line) / np.linalg.norm(undone) == pytest.approx(1.0, abs=1e-6)


class TestTraces:
    @pytest.mark.slow
    def test_the_codec_and_where_its_frames_begin(self, coded):
        trace = best_of(coded)
        assert (trace.codec, trace.rate_hz) == ("AAC", RATE)
        assert trace.contrast > ENOUGH
        assert trace.shares.argmax() == 0
        assert trace.silent_share == pytest.approx(trace.shares.max()) == pytest.approx(0.3, abs=0.05)

    @pytest.mark.slow
    @pytest.mark.parametrize("frames", [1, 500, 1_023])
    def test_a_trimmed_beginning_moves_the_place(self, coded, frames):
        trace = best_of(coded[frames:] * 0.37)
        assert trace.contrast > ENOUGH
        assert trace.shares.argmax() == (1_024 - frames) % 1_024

    @pytest.mark.slow
    def test_after_another_rate_it_is_found_at_the_codec_s(self, coded):
        trace = best_of(signal.resample_poly(coded, 160, 147, window=("kaiser", 12.0)), 48_000)
        assert (trace.codec, trace.rate_hz) == ("AAC", RATE)
        assert trace.contrast > ENOUGH

    def test_mp3_s_frames(self):
        lines, draws = mp3_lines(range(6, 29)), np.random.default_rng(5)
        sound = np.zeros(17_000)
        for start in range(40, 15_000, 576):
            levels = draws.standard_normal(len(lines)) * (draws.random(len(lines)) < 0.6)
            sound[start : start + lines.shape[1]] += 0.02 * levels @ lines
        trace = best_of(sound)
        assert (trace.codec, trace.shares.argmax()) == ("MP3", 40)
        assert trace.contrast > ENOUGH

    @pytest.mark.parametrize(
        "filtered",
        [
            lambda x: x,
            lambda x: signal.fftconvolve(x, signal.firwin(601, 15_000, fs=RATE), "same"),
            lambda x: np.repeat(np.round(x[::4] * 128) / 128, 4),
            lambda x: np.where(np.arange(len(x)) // 700 % 2, x, 0.0),
            lambda x: np.resize(x[:2_048], len(x)),
        ],
        ids=["as it was", "low-passed", "8 bits, held", "gaps", "looped"],
    )
    @pytest.mark.parametrize("seed", [1, 2])
    def test_what_was_never_coded_stands_out_nowhere(self, filtered, seed):
        assert best_of(filtered(noise(seconds=0.5, rate=RATE, seed=seed)[:, 0])).contrast < 3

    @pytest.mark.parametrize(
        "samples",
        [silence()[:, 0], np.zeros(0), np.ones(1), noise(seconds=0.03)[:, 0]],
        ids=["silence", "no frames", "one frame", "too short"],
    )
    def test_nothing_to_compare(self, samples):
        assert traces_of(samples, 48_000) == ()

    def test_what_is_under_the_rounding_is_not_compared(self, coded):
        assert best_of(coded * 0.01, step=2.0**-23).contrast > ENOUGH
        assert traces_of(coded * 0.01, RATE, step=2.0**-7) == ()


@pytest.mark.parametrize(
    ("now", "then"),
    [
        (44_100, (44_100, 48_000)),
        (48_000, (48_000, 44_100)),
        (96_000, (48_000, 44_100)),
        (22_050, (22_050,)),
    ],
)
def test_rates_a_codec_may_have_worked_at(now, then):
    assert rates_of(now) == then


class TestWhileStreaming:
    @pytest.mark.parametrize("block", [1, 700, 50_000])
    def test_blocks_do_not_matter(self, coded, block):
        if block == 1:
            coded = coded[:3_000]
        samples = np.stack((0.1 * coded, coded), axis=1)
        frames = CodecFrames(RATE, 2, len(samples))
        for start in range(0, len(samples), block):
            frames.add(samples[start : start + block])
        whole = CodecFrames(RATE, 2, len(samples))
        whole.add(samples)
        contrasts = [[trace.contrast for trace in one.result()["codec_traces"]] for one in (frames, whole)]
        assert contrasts[0] == contrasts[1]

    def test_it_looks_where_most_changes_and_in_the_loudest_channel(self, coded):
        quiet = noise(seconds=2.0, rate=RATE, dbfs=-50, channels=2)
        at = len(quiet) // 2
        quiet[at : at + len(coded), 1] += coded
        frames = CodecFrames(RATE, 2, len(quiet))
        frames.add(quiet)
        assert max(trace.contrast for trace in frames.result()["codec_traces"]) > ENOUGH
