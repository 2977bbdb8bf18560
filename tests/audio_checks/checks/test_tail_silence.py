"""`tail-silence`: how long the file goes on after the sound."""

import numpy as np
import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import join, silence, smpl

LIMIT = "limits.tail_silence_ms = 100"


def lingering(ms, *, channels=1):
    """A square-edged sound with `ms` of silence after it."""
    return join(np.full((4_800, channels), 0.5), silence(seconds=ms / 1000, channels=channels))


@pytest.mark.parametrize(("ms", "codes"), [(101, ["tail-silence:over"]), (100, []), (99, []), (0, [])])
@pytest.mark.parametrize("channels", [1, 2])
def test_limit(codes_of, ms, codes, channels):
    assert codes_of("tail-silence", lingering(ms, channels=channels), LIMIT) == codes


def test_the_place_is_the_end_of_the_file(found_by):
    (finding,) = found_by("tail-silence", lingering(400), LIMIT)
    assert finding.measured == pytest.approx(400.0)
    assert (finding.start_s, finding.end_s) == (pytest.approx(0.1), pytest.approx(0.5))


def test_one_channel_that_sounds_to_the_end_is_enough(codes_of):
    samples = lingering(400, channels=2)
    samples[:, 1] = 0.25
    assert codes_of("tail-silence", samples, LIMIT) == []


def test_loops_are_left_alone(codes_of):
    assert codes_of("tail-silence", lingering(400), LIMIT, cue=CueFacts("SW-1", loop=True)) == []
    assert codes_of("tail-silence", lingering(400), LIMIT, after=[smpl([(0, 4_000)])]) == []


def test_loop_points_are_no_excuse_where_the_list_asks_for_no_loop(codes_of):
    once = CueFacts("SW-001", loop=False)
    assert codes_of("tail-silence", lingering(400), LIMIT, after=[smpl([(0, 4_000)])], cue=once) == [
        "tail-silence:over"
    ]


def test_a_silent_file_is_left_to_the_silence_check(codes_of):
    assert codes_of("tail-silence", silence(), LIMIT) == []
