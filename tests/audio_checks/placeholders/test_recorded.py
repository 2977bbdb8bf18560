"""A recorded word: trimmed, at one level, mono, and heard in the placeholder."""

import io

import numpy as np
import pytest

from audio_checks import CueFacts, RenderRefused, Unreadable, make_placeholder, new_spec, parse_spec, tidy_recording
from audio_checks.placeholders.recorded import read_recording
from tests.support.waves import silence, sine, wav_bytes

RATE = 48_000


def recorded(samples: np.ndarray, rate: int = RATE, bits: int = 16) -> bytes:
    return wav_bytes(samples, rate=rate, bits=bits)


def with_silence(word: np.ndarray, before_s: float, after_s: float, rate: int = RATE) -> np.ndarray:
    quiet = [silence(seconds=seconds, rate=rate) for seconds in (before_s, after_s)]
    return np.concatenate([quiet[0], word, quiet[1]])


def test_silence_around_a_word_is_cut_and_its_level_set():
    content, duration_s = tidy_recording(recorded(with_silence(sine(hz=500, dbfs=-30, seconds=0.5), 1.0, 2.0)))
    assert duration_s == pytest.approx(0.5 + 2 * 0.02, abs=0.005)  # 20 ms are kept on either side
    samples = read_recording(content, RATE)
    assert len(samples) == round(duration_s * RATE)
    assert 20 * np.log10(np.abs(samples).max()) == pytest.approx(-3.0, abs=0.05)


def test_another_rate_and_two_channels_become_48_khz_mono():
    word = sine(hz=500, dbfs=-12, seconds=0.4, rate=44_100)
    content, duration_s = tidy_recording(recorded(np.hstack([word, word]), rate=44_100))
    assert duration_s == pytest.approx(0.4, abs=0.001)
    spectrum = np.abs(np.fft.rfft(read_recording(content, RATE)))
    assert np.argmax(spectrum) * RATE / len(read_recording(content, RATE)) == pytest.approx(500, abs=3)


def test_an_offset_of_the_microphone_is_no_sound():
    offset = np.full((RATE, 1), 0.1)
    with pytest.raises(RenderRefused) as refused:
        tidy_recording(recorded(offset))
    assert refused.value.code == "placeholder:silent"


def test_what_is_too_long_silent_or_no_wav_is_refused():
    for samples, code in (
        (sine(hz=500, seconds=10.1), "placeholder:too-long"),
        (silence(seconds=1), "placeholder:silent"),
    ):
        with pytest.raises(RenderRefused) as refused:
            tidy_recording(recorded(samples))
        assert refused.value.code == code
    for content in (b"", b"RIFF", b"OggS" + bytes(200), recorded(sine(hz=500, seconds=0.1))[:60]):
        with pytest.raises(Unreadable):
            tidy_recording(content)


@pytest.mark.parametrize("duration_s", [None, 0.2, 2.0])
def test_a_placeholder_says_it_as_long_as_its_cue(tmp_path, duration_s):
    said, said_s = tidy_recording(recorded(sine(hz=500, dbfs=-12, seconds=0.5)))
    spec = parse_spec(new_spec("48k", name="test")).for_category(None)
    cue = CueFacts(number="SW-001", name="Door", duration_s=duration_s)
    made = make_placeholder(cue, 1, spec, tmp_path / "door.wav", said=said)
    assert made.is_spoken
    assert made.duration_s == pytest.approx(duration_s or said_s, abs=0.001)
    heard = read_recording((tmp_path / "door.wav").read_bytes(), RATE)
    spectrum = np.abs(np.fft.rfft(heard[: round(0.2 * RATE)]))
    assert np.argmax(spectrum) / 0.2 == pytest.approx(500, abs=6)
    assert io.BytesIO(said).getbuffer().nbytes > 44
