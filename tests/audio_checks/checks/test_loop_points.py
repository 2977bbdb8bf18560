"""`loop-points`: loops inside the file, and seams that are not heard."""

import numpy as np
import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import chunk, noise, silence, sine, smpl

LOOP = CueFacts("SW-001", loop=True)


@pytest.mark.parametrize("channels", [1, 2])
def test_whole_periods_loop(codes_of, channels):
    assert codes_of("loop-points", sine(hz=480, channels=channels), cue=LOOP) == []


def test_only_loops_are_looked_at(codes_of):
    assert codes_of("loop-points", sine(hz=480, seconds=1 + 0.25 / 480)) == []
    assert codes_of("loop-points", sine(hz=480, seconds=1 + 0.25 / 480), cue=CueFacts("SW-001")) == []


STEP = 2 * np.sin(np.pi / 100)  # the largest of a tone of 480 Hz, against its crest
BEND = STEP**2  # and its largest change of slope


def jumping(size):
    """A tone of whole periods that falls by `size` of its crest up to the seam, and jumps back there."""
    return sine(hz=480) + 10 ** (-6 / 20) * np.linspace(0, -size, 48_000)[:, np.newaxis]


def test_a_jump_at_the_seam(found_by):
    (finding,) = found_by("loop-points", jumping(STEP * (10 ** (6.5 / 20) - 1)), cue=LOOP)
    assert finding.code == "loop-points:step"
    assert finding.measured == pytest.approx(6.5, abs=0.1)
    assert finding.end_s == pytest.approx(1.0)
    (finding,) = found_by("loop-points", jumping(STEP * (10 ** (5.5 / 20) - 1)), cue=LOOP)
    assert finding.code == "loop-points:bend"  # smaller jumps bend the wave


@pytest.mark.parametrize(("over_db", "codes"), [(12.5, ["loop-points:bend"]), (11.5, [])])
def test_a_bend_at_the_seam(codes_of, over_db, codes):
    assert codes_of("loop-points", jumping(BEND * 10 ** (over_db / 20)), cue=LOOP) == codes


def test_a_wave_that_turns_at_the_seam_is_bent(codes_of):
    assert codes_of("loop-points", sine(hz=480, seconds=1 + 0.5 / 480), cue=LOOP) == ["loop-points:bend"]


def test_what_is_small_against_the_wave_is_not_heard(codes_of):
    slow = sine(hz=20, dbfs=-6)  # its slope changes by less than -100 dB from frame to frame
    slow[-1] += 0.001
    assert codes_of("loop-points", slow, cue=LOOP) == []


def test_the_points_of_the_file_count_before_the_whole(codes_of):
    samples = noise(dbfs=-50)
    samples[10_000:20_000] = sine(hz=480, seconds=10_000 / 48_000)
    assert codes_of("loop-points", samples, after=[smpl([(10_000, 19_999)])]) == []
    assert codes_of("loop-points", samples, after=[smpl([(10_000, 19_975)])]) == ["loop-points:step"]
    assert codes_of("loop-points", samples, after=[smpl([(10_000, 19_975)])], cue=LOOP) == ["loop-points:step"]


def of_kind(loops, *kinds):
    """A `smpl` chunk whose loops are of these kinds: 0 forward, 1 alternating, 2 backward, 3 … a manufacturer's own."""
    content = bytearray(smpl(loops))
    for place, kind in enumerate(kinds):
        content[8 + 36 + 24 * place + 4] = kind
    return bytes(content)


ALTERNATING, BACKWARD, OWN = 1, 2, 32


@pytest.mark.parametrize(
    ("points", "codes"),
    [
        ((25, 40_025), []),  # from crest to crest, where the wave turns by itself
        ((25, 40_000), ["loop-points:bend"]),  # turned at its steepest
        ((0, 40_025), ["loop-points:bend"]),
    ],
)
def test_a_loop_that_turns_back_may_only_turn_where_the_wave_does(codes_of, points, codes):
    assert codes_of("loop-points", sine(hz=480), after=[of_kind([points], ALTERNATING)]) == codes


@pytest.mark.parametrize("kind", [0, BACKWARD, OWN])
def test_loops_of_every_other_kind_cross_the_same_seam(codes_of, kind):
    assert codes_of("loop-points", sine(hz=480), after=[of_kind([(0, 39_999)], kind)]) == []
    assert codes_of("loop-points", sine(hz=480), after=[of_kind([(0, 39_974)], kind)]) == ["loop-points:step"]


def test_every_loop_is_judged(found_by):
    (finding,) = found_by("loop-points", sine(hz=480), after=[smpl([(0, 9_999), (10_000, 19_974), (0, 39_999)])])
    assert finding.code == "loop-points:step"
    assert "loop 2" in finding.message
    assert finding.end_s == pytest.approx(19_975 / 48_000)


def test_a_loop_of_one_frame(found_by):
    (finding,) = found_by("loop-points", sine(hz=480), after=[smpl([(25, 25)])])
    assert finding.code == "loop-points:one-frame"
    assert "one frame" in finding.message


@pytest.mark.parametrize("channels", [1, 2])
def test_loops_of_two_frames_are_measured(codes_of, channels):
    assert codes_of("loop-points", silence(channels=channels), after=[of_kind([(5, 6), (8, 9)], ALTERNATING)]) == []


@pytest.mark.parametrize(("points", "words"), [([(0, 47_999)], "a loop"), ([(0, 9), (20, 29)], "2 loops")])
def test_a_loop_that_the_list_does_not_ask_for(found_by, points, words):
    (finding,) = found_by("loop-points", sine(hz=480), after=[smpl(points)], cue=CueFacts("SW-001", loop=False))
    assert finding.code == "loop-points:unwanted"
    assert words in finding.message
    unsaid = CueFacts("SW-001", says_loop=False)
    assert [one.code for one in found_by("loop-points", sine(hz=480), after=[smpl([(0, 47_999)])], cue=unsaid)] == []


@pytest.mark.parametrize(("end", "codes"), [(48_000, ["loop-points:outside"]), (47_999, [])])
def test_points_outside_the_file(codes_of, end, codes):
    assert codes_of("loop-points", sine(hz=480), after=[smpl([(0, end)])]) == codes


@pytest.mark.parametrize("samples", [silence(), silence(seconds=1 / 48_000), silence(seconds=1 / 48_000) + 0.5])
def test_silence_and_one_frame(codes_of, samples):
    assert codes_of("loop-points", samples, cue=LOOP) == []


def test_a_short_chunk_is_no_loop(codes_of):
    assert codes_of("loop-points", sine(hz=480, seconds=0.3), after=[chunk(b"smpl", bytes(10))]) == []
