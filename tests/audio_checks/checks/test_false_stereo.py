"""`false-stereo`: equal channels, nearly equal ones, and real width."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from tests.support.waves import noise, silence, sine

TONE = sine(hz=997)


def stereo(left, right):
    return np.hstack([left, right])


@pytest.mark.parametrize(
    ("right", "codes"),
    [
        (TONE, ["false-stereo:equal"]),
        (TONE * (1 - 10 ** (-60.5 / 20)), ["false-stereo:nearly"]),
        (TONE * (1 - 10 ** (-59.5 / 20)), []),
        (-TONE, []),
        (0 * TONE, []),
        (noise(), []),
    ],
    ids=["equal", "just under", "just over", "opposite", "one side", "unrelated"],
)
def test_where_it_begins(codes_of, right, codes):
    assert codes_of("false-stereo", stereo(TONE, right)) == codes


def test_dither_makes_no_width(found_by):
    rng = np.random.default_rng(1)
    twice = np.repeat(noise(dbfs=-12), 2, axis=1)
    (finding,) = found_by("false-stereo", twice + (rng.random(twice.shape) - 0.5) * 2.0**-15, bits=16)
    assert finding.code == "false-stereo:nearly"
    assert -90 < finding.measured < -75
    assert (finding.start_s, finding.end_s) == (0.0, 1.0)


@pytest.mark.parametrize("samples", [TONE, silence(channels=2), noise(channels=6)], ids=["mono", "silence", "six"])
def test_what_is_not_asked(codes_of, samples):
    assert codes_of("false-stereo", samples) == []


def test_one_frame(codes_of):
    assert codes_of("false-stereo", np.array([[0.5, 0.5]])) == ["false-stereo:equal"]
    assert codes_of("false-stereo", np.array([[0.5, 0.4]])) == []


def test_real_stereo_recordings(recordings):
    for path in recordings[::6]:
        with AudioFile(path) as file:
            file.prepare(["channel_difference_db"])
            found = file.measurements.channel_difference_db
            assert (found is None) == (file.facts.channels != 2)
