"""`reversed`: what is judged of hits, of the same turned round, and of what has no direction."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, judge
from audio_checks.judge.reversed import weights
from tests.support.rooms import hits, in_a_room, knell
from tests.support.waves import noise, silence, sine, swelling, write_wav


@pytest.fixture
def judged(tmp_path):
    def judged(samples, kind=None, rate=48_000):
        with AudioFile(write_wav(tmp_path / "sound.wav", samples, rate=rate)) as file:
            file.prepare(["decay"])
            return judge("reversed", file, kind)

    return judged


@pytest.mark.parametrize("rate", [44_100, 48_000, 96_000])
@pytest.mark.parametrize("kind", ["event", "natural-decay", None])
def test_a_struck_sound_and_the_same_turned_round(judged, kind, rate):
    struck = knell(rate=rate)
    assert judged(struck, kind, rate).score < 0.1
    turned = judged(struck[::-1], kind, rate)
    assert turned.verdict == "reversed"
    assert turned.score > 0.9


def test_hits_in_a_room(judged):
    wet = in_a_room(hits(channels=2))
    assert judged(wet).verdict == "forwards"
    assert judged(wet[::-1]).verdict == "reversed"


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_is_alike_from_both_ends_is_called_nothing(judged, seed):
    assert judged(swelling(noise(seconds=2, seed=seed))).verdict != "reversed"


@pytest.mark.parametrize("samples", [silence(), silence(seconds=0.0001) + 0.5, sine(hz=997, seconds=0.02)])
def test_nothing_to_judge(judged, samples):
    nothing = judged(samples)
    assert (nothing.verdict, nothing.score, nothing.evidence) == (CANNOT_TELL, None, {})


def test_the_evidence_says_which_way_each_octave_leans(judged):
    bands = {band["hz"]: band for band in judged(knell()).evidence["bands"]}
    assert bands[1_000.0]["rise_db_s"] > 3 * bands[1_000.0]["fall_db_s"]
    # By 60 dB in ln(1000) * 0.15 s.
    assert bands[1_000.0]["fall_db_s"] == pytest.approx(60 / (np.log(1000) * 0.15), rel=0.35)
    turned = {band["hz"]: band for band in judged(knell()[::-1]).evidence["bands"]}
    assert turned[1_000.0]["fall_db_s"] == pytest.approx(bands[1_000.0]["rise_db_s"], rel=0.1)


def test_every_kind_has_its_thresholds_and_none_said_is_the_most_cautious():
    table = weights()["thresholds"]
    assert set(table) == {"event", "natural-decay", "ambience", "voice", "music", "unknown"}
    assert all(0 <= low <= high <= 1 for low, high in table.values())
    assert table["unknown"][1] == max(high for _, high in table.values())
