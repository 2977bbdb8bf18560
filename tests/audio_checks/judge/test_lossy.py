"""`lossy`: what is judged of what real encoders coded, of what only looks so, and of what cannot be decided."""

import shutil

import numpy as np
import pytest
from scipy import signal

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, judge
from audio_checks.judge.lossy import low_pass_of, score_of, verdict_of, weights
from audio_checks.measure.cliff import Cliff
from tests.support.waves import noise, silence, write_wav
from training.codecs import CODERS, coded

WITH_FFMPEG = pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="no ffmpeg here to code with")
RATE = 44_100


@pytest.fixture
def judged(tmp_path):
    def judged(samples, rate=RATE):
        with AudioFile(write_wav(tmp_path / "sound.wav", samples, rate=rate)) as file:
            file.prepare(["codec_traces", "mean_spectrum"])
            return judge("lossy", file, None)

    return judged


def struck(rate=RATE, channels=2):
    """Noise that falls by 6 dB an octave and dies away, as most effects do."""
    samples = noise(rate=rate, channels=channels, dbfs=-8)
    dull = signal.lfilter(*signal.butter(1, 2_000, fs=rate), samples, axis=0)
    return dull * np.exp(-3 * np.arange(len(dull)) / rate)[:, np.newaxis]


@WITH_FFMPEG
@pytest.mark.parametrize("kbit_s", [128, 192])
@pytest.mark.parametrize("name", ["MP3 (LAME)", "MP3 (Shine)", "AAC (ffmpeg)", "Vorbis", "AC-3", "Opus"])
def test_what_an_encoder_coded_says_which(judged, name, kbit_s):
    coder = next(one for one in CODERS if one.name == name)
    samples, rate = coded(struck(channels=1), RATE, coder, 2 * kbit_s)
    found = judged(samples[777:], rate)
    assert (found.verdict, found.figures["codec"], found.figures["coded_at_hz"]) == ("lossy", coder.codec, rate)
    assert found.figures["silent_share"] > 1.5 * found.figures["elsewhere_share"]


@pytest.mark.parametrize("rate", [22_050, 44_100, 48_000, 96_000])
def test_a_sound_that_was_never_coded_is_clean(judged, rate):
    found = judged(struck(rate), rate)
    assert found.verdict == "clean"
    assert set(found.figures.values()) == {None}


def test_a_low_pass_alone_is_shown_and_proves_nothing(judged):
    found = judged(signal.fftconvolve(struck(), signal.firwin(801, 16_000, fs=RATE)[:, np.newaxis], "same", axes=0))
    assert (found.verdict, found.figures["codec"]) == (CANNOT_TELL, None)
    assert found.figures["low_pass_hz"] == pytest.approx(16_000, rel=0.03)


@pytest.mark.parametrize(
    ("edge_hz", "drop_db", "is_one"),
    [(16_000, 40, True), (16_000, 24, False), (9_900, 40, False), (10_100, 40, True), (20_700, 40, False)],
)
def test_where_and_how_steeply_a_codec_s_low_pass_ends(edge_hz, drop_db, is_one):
    assert low_pass_of(Cliff(edge_hz, drop_db, np.empty(0))) == (edge_hz if is_one else None)


def test_the_verdict_by_score():
    clean_below, lossy_above = weights()["threshold"]
    assert clean_below < lossy_above
    assert verdict_of(lossy_above, None) == verdict_of(lossy_above, 16_000.0) == "lossy"
    between = (clean_below + lossy_above) / 2
    assert verdict_of(between, None) == CANNOT_TELL
    assert verdict_of(clean_below / 2, None) == "clean"
    assert verdict_of(clean_below / 2, 16_000.0) == CANNOT_TELL


def test_the_score_rises_with_the_contrast():
    scores = [score_of(contrast) for contrast in (0.0, 1.0, 3.0, 8.0, 500.0)]
    assert scores == sorted(scores)
    assert scores[0] < 0.5 < 0.99 < scores[-1] <= 1.0


@pytest.mark.parametrize("samples", [silence(), silence(seconds=0.0001) + 0.5, noise(seconds=0.03)])
def test_nothing_to_judge(judged, samples):
    nothing = judged(samples)
    assert (nothing.verdict, nothing.score) == (CANNOT_TELL, None)
    assert nothing.figures["codec"] is None


def test_the_evidence_is_the_spectrum_and_how_silent_each_place_is(judged):
    evidence = judged(struck()).evidence
    assert set(evidence) == {"spectrum", "frames"}
    frames = evidence["frames"]
    assert len(frames["shares"]) <= 192
    assert all(0 <= share <= 1 for share in frames["shares"])
    assert frames["frame"] in (256, 576, 960, 1_024)
