"""`tail-silence`: how long the file goes on after the sound."""

import numpy as np
import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import join, noise, silence, sine, smpl

LIMIT = "limits.tail_silence_ms = 100"
OVER = ["tail-silence:over"]


def lingering(ms, *, channels=1, sound_s=0.1):
    """A square-edged sound with `ms` of silence after it."""
    sound = np.full((round(48_000 * sound_s), channels), 0.5)
    return join(sound, silence(seconds=ms / 1000, channels=channels))


@pytest.mark.parametrize(("ms", "codes"), [(251, OVER), (250, []), (101, []), (0, [])])
@pytest.mark.parametrize("channels", [1, 2])
def test_a_quarter_of_a_second_costs_too_little_to_matter(codes_of, ms, codes, channels):
    assert codes_of("tail-silence", lingering(ms, channels=channels), LIMIT) == codes


@pytest.mark.parametrize(("ms", "codes"), [(401, OVER), (400, [])])
def test_a_limit_above_that_counts(codes_of, ms, codes):
    assert codes_of("tail-silence", lingering(ms), "limits.tail_silence_ms = 400") == codes


@pytest.mark.parametrize(("ms", "codes"), [(540, OVER), (520, [])])
def test_a_long_sound_may_end_in_a_twentieth_of_silence(codes_of, ms, codes):
    assert codes_of("tail-silence", lingering(ms, sound_s=10.0), LIMIT) == codes


def test_the_place_is_the_end_of_the_file(found_by):
    (finding,) = found_by("tail-silence", lingering(400), LIMIT)
    assert finding.measured == pytest.approx(400.0)
    assert (finding.start_s, finding.end_s) == (pytest.approx(0.1), pytest.approx(0.5))
    assert finding.message == "400.0 ms of silence after the sound, over 250 ms"
    assert (finding.limit, finding.fix) == (100.0, "trim 300.0 ms or more from the end")


@pytest.mark.parametrize("bits", [16, 24])
@pytest.mark.parametrize("tau_s", [0.05, 0.2])
def test_a_natural_decay_is_no_silence(codes_of, bits, tau_s):
    # Dies away by 8.7 dB each `tau_s`: for a second or more it lies below -60 dBFS, and ends above a step.
    times = np.arange(round(9.5 * tau_s * 48_000)) / 48_000
    decay = 0.5 * np.exp(-times / tau_s)[:, np.newaxis] * sine(hz=300, dbfs=0.0, seconds=len(times) / 48_000)
    assert codes_of("tail-silence", decay, LIMIT, bits=bits) == []


@pytest.mark.parametrize("dbfs", [-100.0, -75.0])
def test_the_noise_of_a_recording_is_no_silence(codes_of, dbfs):
    assert codes_of("tail-silence", join(sine(hz=300), noise(dbfs=dbfs)), LIMIT) == []


@pytest.mark.parametrize(("ms", "codes"), [(600, OVER), (400, [])])
def test_dithered_silence_of_16_bit_is_silence(codes_of, ms, codes):
    draws = np.random.default_rng(3).integers(-1, 2, (48 * ms, 1)) / 2**15
    assert codes_of("tail-silence", join(sine(hz=300), draws), LIMIT, bits=16) == codes


def test_one_channel_that_sounds_to_the_end_is_enough(codes_of):
    samples = lingering(400, channels=2)
    samples[:, 1] = 0.25
    assert codes_of("tail-silence", samples, LIMIT) == []


def test_loops_are_left_alone(codes_of):
    assert codes_of("tail-silence", lingering(400), LIMIT, cue=CueFacts("SW-1", loop=True)) == []
    assert codes_of("tail-silence", lingering(400), LIMIT, after=[smpl([(0, 4_000)])]) == []


def test_loop_points_are_no_excuse_where_the_list_asks_for_no_loop(codes_of):
    once = CueFacts("SW-001", loop=False)
    assert codes_of("tail-silence", lingering(400), LIMIT, after=[smpl([(0, 4_000)])], cue=once) == OVER


def test_a_silent_file_is_left_to_the_silence_check(codes_of):
    assert codes_of("tail-silence", silence(), LIMIT) == []
