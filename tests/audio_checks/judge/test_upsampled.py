"""`upsampled`: what is judged of noise at its own rate, of the same brought up, and of what cannot be decided."""

import numpy as np
import pytest
from scipy import signal

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import CANNOT_TELL, judge
from audio_checks.judge.upsampled import weights
from tests.support.waves import noise, silence, sine, write_wav


@pytest.fixture
def judged(tmp_path):
    def judged(samples, rate=48_000):
        with AudioFile(write_wav(tmp_path / "sound.wav", samples, rate=rate)) as file:
            file.prepare(["mean_spectrum"])
            return judge("upsampled", file, None)

    return judged


def hiss(rate, channels=1):
    """Noise that falls by 6 dB an octave from 1 kHz on, as most sounds do."""
    return signal.lfilter(*signal.butter(1, 1_000, fs=rate), noise(rate=rate, channels=channels), axis=0)


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize(
    ("from_hz", "rate"), [(22_050, 44_100), (32_000, 48_000), (44_100, 96_000), (48_000, 96_000), (24_000, 48_000)]
)
def test_what_was_brought_up_says_from_where(judged, from_hz, rate, channels):
    samples = signal.resample(hiss(from_hz, channels), rate, axis=0)
    found = judged(samples, rate)
    assert found.verdict == "upsampled"
    assert found.figures["from_hz"] == from_hz
    assert found.figures["edge_hz"] == pytest.approx(from_hz / 2, rel=0.06)
    assert found.figures["drop_db"] > 30


@pytest.mark.parametrize("rate", [44_100, 48_000, 96_000])
def test_a_sound_at_its_own_rate_is_not(judged, rate):
    found = judged(hiss(rate), rate)
    assert found.verdict == "full"
    assert found.figures["from_hz"] is None


def test_a_dark_sound_is_not_accused(judged):
    dark = signal.sosfilt(signal.butter(4, 3_000, fs=96_000, output="sos"), noise(rate=96_000), axis=0)
    assert judged(dark, 96_000).verdict != "upsampled"


@pytest.mark.parametrize("samples", [silence(), silence(seconds=0.0001) + 0.5, sine(hz=997, seconds=0.005)])
def test_nothing_to_judge(judged, samples):
    nothing = judged(samples)
    assert (nothing.verdict, nothing.score) == (CANNOT_TELL, None)
    assert set(nothing.figures.values()) == {None}


def test_the_evidence_is_the_spectrum(judged):
    spectrum = judged(signal.resample(hiss(24_000), 48_000, axis=0)).evidence["spectrum"]
    levels, step_hz = np.array(spectrum["dbfs"]), spectrum["step_hz"]
    assert len(levels) * step_hz == pytest.approx(24_000, rel=0.001)
    at = lambda hz: levels[int(hz / step_hz)]  # noqa: E731 - read where it is used
    assert at(11_000) - at(13_000) > 30


def test_the_threshold_is_a_pair():
    low, high = weights()["threshold"]
    assert 0 <= low <= high <= 1
