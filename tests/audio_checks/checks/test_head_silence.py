"""`head-silence`: how long it takes until the sound starts."""

import numpy as np
import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import join, silence, sine, smpl

LIMIT = "limits.head_silence_ms = 5"


def late(ms, *, level=0.5, channels=1):
    """A square-edged sound after `ms` of silence."""
    return join(silence(seconds=ms / 1000, channels=channels), np.full((4_800, channels), level))


@pytest.mark.parametrize(("ms", "codes"), [(5.5, ["head-silence:over"]), (5.0, []), (4.5, []), (0.0, [])])
@pytest.mark.parametrize("channels", [1, 2])
def test_limit(codes_of, ms, codes, channels):
    assert codes_of("head-silence", late(ms, channels=channels), LIMIT) == codes


def test_the_fix_and_the_place_are_named(found_by):
    (finding,) = found_by("head-silence", late(20), LIMIT)
    assert finding.measured == pytest.approx(20.0)
    assert (finding.start_s, finding.end_s) == (0.0, pytest.approx(0.020))
    assert finding.fix.startswith("trim 15.0 ms")


def test_what_counts_as_silence_follows_the_peak(codes_of):
    # A head at -70 dBFS is silence under a sound at 0 dBFS, and part of one whose peak is at -40 dBFS.
    for level, codes in ((1.0, ["head-silence:over"]), (10 ** (-40 / 20), [])):
        samples = late(20, level=level * 0.999)
        samples[:960] = 10 ** (-70 / 20)
        assert codes_of("head-silence", samples, LIMIT) == codes


def test_the_spec_says_what_silence_is(codes_of):
    samples = late(20)
    samples[:960] = 10 ** (-70 / 20)
    assert codes_of("head-silence", samples, f"{LIMIT}\nlimits.edge_silence_below_dbfs = -80") == []


def test_loops_are_left_alone(codes_of):
    assert codes_of("head-silence", late(20), LIMIT, cue=CueFacts("SW-1", loop=True)) == []
    assert codes_of("head-silence", late(20), LIMIT, after=[smpl([(0, 4_000)])]) == []


def test_loop_points_are_no_excuse_where_the_list_asks_for_no_loop(codes_of):
    once = CueFacts("SW-001", loop=False)
    assert codes_of("head-silence", late(20), LIMIT, after=[smpl([(2_000, 4_000)])], cue=once) == ["head-silence:over"]


def test_a_silent_file_is_left_to_the_silence_check(codes_of):
    assert codes_of("head-silence", silence(), LIMIT) == []


def test_one_frame(codes_of):
    assert codes_of("head-silence", sine(hz=1, seconds=1 / 48_000, phase=1.0), LIMIT) == []
