"""Two files of one sound are recognised after changes, in either order, and found among thousands."""

import numpy as np
import pytest

from audio_checks import difference_of, likely_sounds, sound_signature
from audio_checks.audit.moments import MOMENT_BYTES
from audio_checks.errors import Unreadable
from tests.support.waves import noise, silence, sine, write_wav

RATE = 48_000


def burst(seed, seconds=0.6):
    fall = np.exp(-np.linspace(0, 3, round(seconds * RATE)))[:, np.newaxis]
    return noise(dbfs=-12, seconds=seconds, rate=RATE, seed=seed) * fall


def known(tmp_path, samples, rate=RATE):
    return sound_signature(str(write_wav(tmp_path / "sound.wav", samples, rate=rate, bits=24)))


def test_gain_is_measured_in_either_order(tmp_path):
    loud, quiet = known(tmp_path, burst(1)), known(tmp_path, burst(1) / 2)
    # Half the samples' values are 20·log10(2) = 6.02 dB less.
    there, back = (
        difference_of(*pair) for pair in ((loud.fingerprint, quiet.fingerprint), (quiet.fingerprint, loud.fingerprint))
    )
    assert (there.gain_db, back.gain_db) == (pytest.approx(-6.0, abs=0.1), pytest.approx(6.0, abs=0.1))
    assert not there.is_trimmed
    assert not back.is_trimmed


@pytest.mark.parametrize("part", [slice(RATE // 50, None), slice(None, -RATE // 50)])
def test_a_cut_end_is_said_in_either_order(tmp_path, part):
    whole, cut = known(tmp_path, burst(2)), known(tmp_path, burst(2)[part])
    for first, second in ((whole, cut), (cut, whole)):
        difference = difference_of(first.fingerprint, second.fingerprint)
        assert difference.is_trimmed
        assert difference.gain_db == pytest.approx(0.0, abs=0.1)


def test_other_sounds_are_not_the_same(tmp_path):
    assert difference_of(known(tmp_path, burst(3)).fingerprint, known(tmp_path, burst(4)).fingerprint) is None


@pytest.mark.slow
def test_the_sound_is_among_the_likeliest_of_many(tmp_path):
    others = [known(tmp_path, burst(seed)).moments for seed in range(10, 40)]
    looked_for = known(tmp_path, burst(25)[RATE // 50 :] / 4)
    assert likely_sounds(looked_for.fingerprint, others)[0] == 15
    assert len(likely_sounds(looked_for.fingerprint, others * 4)) <= 12
    assert likely_sounds(looked_for.fingerprint, []) == []


def test_silence_is_recognised_by_nothing(tmp_path):
    still = known(tmp_path, silence())
    assert (still.fingerprint, still.moments) == (None, b"")


def test_a_sound_shorter_than_a_moment_has_one(tmp_path):
    assert len(known(tmp_path, burst(5, seconds=0.05)).moments) == MOMENT_BYTES


def test_the_rate_is_kept(tmp_path):
    assert known(tmp_path, sine(hz=440, rate=44_100), rate=44_100).sample_rate_hz == 44_100


def test_what_is_no_sound_is_refused(tmp_path):
    (tmp_path / "notes.wav").write_bytes(b"no sound")
    with pytest.raises(Unreadable):
        sound_signature(str(tmp_path / "notes.wav"))
