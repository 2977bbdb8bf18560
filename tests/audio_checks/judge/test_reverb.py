"""`reverb`: what is judged of dry hits, of the same in a room, and of what cannot be decided."""

import numpy as np
import pytest

from audio_checks import measure_file
from audio_checks.audio.audio_file import AudioFile
from audio_checks.cli.commands.measure import KINDS
from audio_checks.judge import CANNOT_TELL, judge, names
from audio_checks.judge.reverb import KNEE, Limits, calibrated, limits_of, logistic
from tests.support.rooms import hits, in_a_room
from tests.support.waves import noise, silence, sine, write_wav


@pytest.fixture
def judged(tmp_path):
    def judged(samples, kind=None, rate=48_000):
        with AudioFile(write_wav(tmp_path / "sound.wav", samples, rate=rate)) as file:
            file.prepare(["decay"])
            return judge("reverb", file, kind)

    return judged


def test_it_is_found_by_being_there():
    assert "reverb" in names()


@pytest.mark.parametrize("kind", ["event", None])
@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("rate", [44_100, 48_000, 96_000])
def test_dry_hits_and_the_same_in_a_room(judged, kind, channels, rate):
    dry = hits(rate=rate, channels=channels)
    assert judged(dry, kind, rate).verdict == "dry"
    wet = judged(in_a_room(dry, rate=rate), kind, rate)
    assert wet.verdict in {1: ("likely reverb", "reverb"), 2: ("reverb",)}[channels]  # in mono a thing may ring so
    assert wet.figures["rt60_s"] == pytest.approx(1.5, rel=0.3)


def test_a_burst_of_noise_may_be_its_own_tail(judged):
    burst = noise(seconds=1.5, dbfs=-12) * 10 ** (-3 * np.arange(72_000) / 48_000 / 1.2)[:, np.newaxis]
    assert judged(burst, "natural-decay").verdict == CANNOT_TELL
    assert judged(burst).verdict == CANNOT_TELL


@pytest.mark.parametrize("samples", [silence(), silence(seconds=0.0001) + 0.5, sine(hz=997, seconds=0.03)])
def test_nothing_to_judge(judged, samples):
    nothing = judged(samples)
    assert (nothing.verdict, nothing.score, nothing.figures) == (CANNOT_TELL, None, {"rt60_s": None})


def test_the_evidence_is_what_is_drawn(judged):
    wet = judged(in_a_room(hits(channels=2), rt60_s=1.0))
    decay, coherence = wet.evidence["decay"], wet.evidence["coherence"]
    assert {"start_s", "step_s", "bands"} == set(decay)
    falls = [band["rt60_s"] for band in decay["bands"] if band["hz"] >= 500]
    assert np.median(falls) == pytest.approx(1.0, rel=0.25)
    assert all(band["tail"] < band["head"] for band in coherence if band["hz"] >= 500)
    assert judged(hits()).evidence["coherence"] is None


@pytest.mark.slow
def test_surer_of_more_reverb(judged):
    dry = hits(channels=2)
    scores = [judged(dry).score, *(judged(in_a_room(dry, wet_db=wet_db)).score for wet_db in (-20.0, -6.0))]
    assert scores == sorted(scores)
    assert 0 <= scores[0] < scores[-1] <= 1


@pytest.mark.parametrize("layout", ["mono", "stereo"])
@pytest.mark.parametrize("rt60_s", [0.3, 2.0])
def test_every_kind_has_its_limits_and_none_said_is_the_most_cautious(layout, rt60_s):
    found = {kind: limits_of(kind, layout, rt60_s) for kind in (*KINDS, None)}
    assert all(0 <= limits.dry_below < limits.likely_from <= limits.reverb_from <= 1 for limits in found.values())
    assert found[None].reverb_from == max(limits.reverb_from for limits in found.values())


def test_a_score_has_four_levels():
    limits = Limits(dry_below=0.1, likely_from=0.8, reverb_from=0.95)
    scores = (0.0, 0.09, 0.1, 0.79, 0.8, 0.94, 0.95, 1.0)
    assert [limits.verdict(score) for score in scores] == [
        *["dry"] * 2, *[CANNOT_TELL] * 2, *["likely reverb"] * 2, *["reverb"] * 2,
    ]  # fmt: skip


def test_no_score_of_a_more_certain_logit_is_lower_and_it_bends_at_the_knee():
    line = (-0.5, 0.8, 0.7)
    scores = [calibrated(logit, line) for logit in np.linspace(-4, 4, 33)]
    assert scores == sorted(scores)
    assert calibrated(KNEE, line) == pytest.approx(logistic(-0.5 + 0.8 * KNEE))
    assert calibrated(KNEE + 1, line) == pytest.approx(logistic(-0.5 + 0.8 * KNEE + 1.5))


def test_measuring_a_file_says_it(tmp_path):
    entry = measure_file(write_wav(tmp_path / "room.wav", in_a_room(hits(channels=2))), kind="event").to_measured()
    assert entry["judgements"]["reverb"]["verdict"] == "reverb"
    assert entry["judgements"]["reverb"]["evidence"]["decay"]["bands"]
    assert "decay" not in entry["measurements"]
