"""Reverb of a take beside an earlier one: which has more."""

import numpy as np
import pytest

from audio_checks import Unreadable, compare_reverb_of_takes
from tests.support.rooms import hits, in_a_room
from tests.support.waves import noise, silence, write_wav


@pytest.fixture
def between(tmp_path):
    def between(samples, earlier, rate=48_000):
        mine = write_wav(tmp_path / "take_2.wav", samples, rate=rate)
        return compare_reverb_of_takes(mine, write_wav(tmp_path / "take_1.wav", earlier))

    return between


DRY = hits()
WET = in_a_room(DRY, rt60_s=1.2, wet_db=-6.0)


@pytest.mark.parametrize(("samples", "earlier", "verdict"), [(WET, DRY, "more reverb"), (DRY, WET, "less reverb")])
def test_which_of_two_has_more(between, samples, earlier, verdict):
    found = between(samples, earlier)
    assert found.verdict == verdict
    assert found.figures["rt60_s"] == pytest.approx(1.2, rel=0.1)  # of what was added, or taken away
    assert found.figures["wet_db"] == pytest.approx(-6.0, abs=1)


@pytest.mark.slow
def test_the_octaves_die_away_slower_by_what_was_added(between):
    bands = between(WET, DRY).evidence["bands"]
    assert bands
    reported = [band for band in bands if None not in (band["rt60_s"], band["earlier_rt60_s"])]
    assert all(band["rt60_s"] > 2 * band["earlier_rt60_s"] for band in reported)
    assert np.median([band["rt60_s"] for band in bands if band["rt60_s"]]) == pytest.approx(1.2, rel=0.2)


def test_a_sound_beside_itself_has_as_much_for_certain(between):
    tone = np.sin(2 * np.pi * 440 * np.arange(9_600) / 48_000) * np.hanning(9_600)
    found = between(tone, tone)
    assert (found.verdict, found.score) == ("as much reverb", 0.0)


def test_the_same_sound_at_another_level_has_as_much(between):
    found = between(0.5 * WET, WET)
    assert (found.verdict, found.figures) == ("as much reverb", {"rt60_s": None, "wet_db": None})


@pytest.mark.parametrize(
    ("samples", "options"),
    [(noise(seconds=2.0, dbfs=-20), {}), (DRY, {"rate": 44_100}), (silence(), {})],
    ids=["another sound", "another rate", "silence"],
)
def test_what_cannot_be_compared(between, samples, options):
    assert between(samples, DRY, **options).verdict == "cannot tell"


def test_what_is_no_sound(tmp_path):
    (tmp_path / "take_1.wav").write_bytes(b"no sound")
    with pytest.raises(Unreadable):
        compare_reverb_of_takes(write_wav(tmp_path / "take_2.wav", DRY), tmp_path / "take_1.wav")
