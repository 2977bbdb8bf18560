"""Reverb judged beside a dry stem or an earlier take."""

import numpy as np
import pytest

from audio_checks import Unreadable, compare_reverb_with_dry, measure_file
from tests.support.rooms import hits, in_a_room
from tests.support.waves import noise, silence, write_wav


@pytest.fixture
def beside(tmp_path):
    def beside(samples, dry, rate=48_000, dry_rate=48_000):
        mine = write_wav(tmp_path / "hit.wav", samples, rate=rate)
        return compare_reverb_with_dry(mine, write_wav(tmp_path / "dry.wav", dry, rate=dry_rate))

    return beside


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("wet_db", [0.0, -24.0])
def test_reverb_that_was_added(beside, channels, wet_db):
    dry = hits(channels=channels)
    found = beside(in_a_room(dry, rt60_s=1.2, wet_db=wet_db), dry)
    assert found.verdict == "reverb"
    assert found.figures["rt60_s"] == pytest.approx(1.2, rel=0.1)
    assert found.figures["wet_db"] == pytest.approx(wet_db, abs=1)
    assert found.score > 0.5
    assert found.evidence["response"]["curve_db"][0] == 0


@pytest.mark.slow
def test_a_burst_of_noise_is_distinguished_from_its_tail(beside):
    burst = noise(seconds=1.5, dbfs=-18) * np.exp(-np.arange(72_000) / 10_000)[:, np.newaxis]
    assert beside(burst, burst).verdict == "dry"
    assert beside(in_a_room(burst, wet_db=-10.0), burst).verdict == "reverb"


def test_the_same_louder_and_cut_is_still_dry(beside):
    assert beside(hits()[:60_000] * 1.5, hits()).verdict == "dry"


@pytest.mark.parametrize(
    ("samples", "options"),
    [(noise(seconds=2.0, dbfs=-20), {}), (hits(), {"rate": 44_100}), (silence(), {})],
    ids=["another sound", "another rate", "silence"],
)
def test_what_cannot_be_compared(beside, samples, options):
    assert beside(samples, hits(), **options).verdict == "cannot tell"


def test_what_is_no_sound(tmp_path):
    (tmp_path / "dry.wav").write_bytes(b"no sound")
    with pytest.raises(Unreadable):
        compare_reverb_with_dry(write_wav(tmp_path / "hit.wav", hits()), tmp_path / "dry.wav")


def test_measuring_beside_the_dry_sound_says_what_was_added(tmp_path):
    wet = write_wav(tmp_path / "wet.wav", in_a_room(hits(), rt60_s=0.8))
    judged = measure_file(wet, dry=write_wav(tmp_path / "dry.wav", hits())).judgements["reverb"]
    assert (judged["verdict"], judged["beside"]) == ("reverb", "dry.wav")
    assert judged["rt60_s"] == pytest.approx(0.8, rel=0.1)
    assert judged["evidence"].keys() == {"decay", "coherence", "response"}
