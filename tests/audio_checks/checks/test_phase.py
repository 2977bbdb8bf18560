"""`phase`: how much may be lost in mono."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from tests.support.waves import join, noise, silence, sine

LIMIT = "limits.mono_loss_db = 6"
TONE = sine(hz=997)


def turned(degrees):
    """A tone, and beside it the same one turned: mono keeps cos²(turn / 2) of its power."""
    return np.hstack([TONE, sine(hz=997, phase=np.radians(degrees))])


def loss_db(degrees):
    return -20 * np.log10(np.cos(np.radians(degrees / 2)))


@pytest.mark.parametrize(
    ("degrees", "codes"), [(0, []), (90, []), (120.1, []), (120.5, ["phase:mono-loss"]), (150, ["phase:mono-loss"])]
)
def test_just_over_and_just_under(found_by, degrees, codes):
    found = found_by("phase", turned(degrees), LIMIT)
    assert [finding.code for finding in found] == codes
    for finding in found:
        assert finding.measured == pytest.approx(loss_db(degrees), abs=0.01)
        assert (finding.limit, finding.unit) == (6.0, "dB")


def test_opposite_channels_leave_nothing(found_by):
    (finding,) = found_by("phase", turned(180), LIMIT)
    assert finding.message == "loses all of its level when summed to mono, limit 6 dB"


def test_the_longest_stretch_is_named(found_by):
    whole = join(turned(0)[:4_800], turned(180)[:9_600], turned(0)[:4_800], turned(180))
    (finding,) = found_by("phase", whole, LIMIT)
    assert (finding.start_s, finding.end_s) == (pytest.approx(0.4), pytest.approx(1.4))


@pytest.mark.parametrize(
    "samples", [TONE, silence(channels=2), noise(channels=2), noise(channels=6), np.array([[0.5, 0.5]])]
)
def test_what_loses_nothing_to_speak_of(codes_of, samples):
    assert codes_of("phase", samples, LIMIT) == []


def test_one_frame(codes_of):
    assert codes_of("phase", np.array([[0.5, -0.5]]), LIMIT) == ["phase:mono-loss"]


def test_without_a_limit_it_is_not_asked(codes_of):
    assert codes_of("phase", turned(180)) == []
    assert codes_of("phase", turned(180), 'limits.mono_loss_db = "any"') == []


def test_real_recordings_keep_their_mono(recordings):
    for path in recordings[::6]:
        with AudioFile(path) as file:
            file.prepare(["mono_loss_db"])
            assert (file.measurements.mono_loss_db or 0.0) < 12
