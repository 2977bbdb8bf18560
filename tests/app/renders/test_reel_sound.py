"""Takes in a row: how long, in which order, behind which slates."""

import itertools
import wave
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.renders.reels.sound import BEEP_MS, BETWEEN_BEEPS_MS, PAUSE_MS, SPEECH_RATE_HZ, Slate, make_reel
from tests.support.waves import Samples, silence, sine, wav_bytes

RATE = 44_100


def made(
    folder: Path,
    *sounds: tuple[Samples, int],
    slates: list[Slate] | None = None,
    gap_ms: int = 0,
    crossfade_ms: int = 0,
) -> tuple[dict[str, Any], Samples, int]:
    """Return what is said of a reel of these sounds, its samples and its rate."""
    paths = []
    for place, (samples, rate) in enumerate(sounds):
        path = folder / f"{place}.wav"
        path.write_bytes(wav_bytes(samples, rate=rate, bits=16))
        paths.append(str(path))
    out = folder / "reel.wav"
    reported = make_reel(paths, slates, str(out), gap_ms=gap_ms, crossfade_ms=crossfade_ms)
    with wave.open(str(out)) as file:
        assert file.getsampwidth() == 2
        data = np.frombuffer(file.readframes(file.getnframes()), "<i2").reshape(-1, file.getnchannels())
        return reported, data / 32_768, file.getframerate()


def level(frames: int, value: float, channels: int = 1) -> Samples:
    return np.full((frames, channels), value)


def beeps(count: int, rate: int) -> int:
    """Return the frames of so many beeps with what is between them and the pause behind."""
    return (count * BEEP_MS + (count - 1) * BETWEEN_BEEPS_MS + PAUSE_MS) * rate // 1000


def onsets(samples: Samples, rate: int, hz: int) -> int:
    """Return how often a tone of this frequency begins, heard in windows of 10 ms."""
    window = rate // 100
    blocks = samples[: len(samples) // window * window, 0].reshape(-1, window)
    tone = np.exp(-2j * np.pi * hz * np.arange(window) / rate)
    heard = np.abs(blocks @ tone) / window > 0.01
    return int(np.sum(heard[1:] & ~heard[:-1]) + heard[0])


def test_sounds_stand_in_order_with_the_gap_between_and_nothing_behind(tmp_path: Path) -> None:
    reported, reel, rate = made(
        tmp_path, (level(1_000, 0.25), RATE), (level(777, 0.5), RATE), (level(1, -0.5), RATE), gap_ms=20
    )
    gap = 882
    assert (rate, reel.shape) == (RATE, (1_000 + gap + 777 + gap + 1, 1))
    assert reported["starts_s"] == [0, (1_000 + gap) / RATE, (1_000 + gap + 777 + gap) / RATE]
    assert reported["duration_s"] == len(reel) / RATE
    assert (reel[:1_000] == 0.25).all()
    assert (reel[1_000 : 1_000 + gap] == 0).all()
    assert (reel[1_000 + gap : 1_777 + gap] == 0.5).all()
    assert reel[-1] == -0.5


@pytest.mark.parametrize("crossfade_ms", [7, 10, 73])
def test_a_crossfade_shortens_the_reel_by_itself(tmp_path: Path, crossfade_ms: int) -> None:
    reported, reel, _ = made(tmp_path, (level(8_820, 0.25), RATE), (level(8_843, 0.5), RATE), crossfade_ms=crossfade_ms)
    overlap = crossfade_ms * RATE // 1000
    assert len(reel) == 8_820 + 8_843 - overlap
    assert reported["starts_s"] == [0, (8_820 - overlap) / RATE]
    assert (reel[: 8_820 - overlap] == 0.25).all()
    assert (reel[8_820:] == 0.5).all()
    # At equal power both are 3 dB down in the middle.
    assert reel[8_820 - overlap // 2, 0] == pytest.approx(0.75 / np.sqrt(2), abs=0.005)


def test_a_crossfade_that_would_clip_stops_at_full_scale(tmp_path: Path) -> None:
    _, reel, _ = made(tmp_path, (level(441, 0.9), RATE), (level(441, 0.9), RATE), crossfade_ms=5)
    assert reel.min() >= 0.89
    assert reel.max() == 32_767 / 32_768


def test_a_crossfade_is_no_longer_than_what_it_joins(tmp_path: Path) -> None:
    reported, reel, _ = made(tmp_path, (level(441, 0.25), RATE), (level(4_410, 0.5), RATE), crossfade_ms=1_000)
    assert (len(reel), reported["starts_s"]) == (4_410, [0, 0])
    reported, reel, _ = made(tmp_path, (level(1, 0.25), RATE), (level(4_410, 0.5), RATE), crossfade_ms=1_000)
    assert len(reel) == 4_410  # one frame is heard along with the first of the other


def test_a_slate_counts_the_variation_low_and_the_version_high(tmp_path: Path) -> None:
    slates = [Slate(0, 1, None), Slate(0, 3, None), Slate(2, 4, None)]
    quiet = silence(rate=RATE, seconds=0.1)
    reported, reel, rate = made(tmp_path, *[(quiet, RATE)] * 3, slates=slates, gap_ms=500)
    parts = [beeps(1, rate), beeps(3, rate), beeps(2, rate) + beeps(4, rate)]
    between = len(quiet) + 22_050
    assert len(reel) == sum(parts) + 3 * len(quiet) + 2 * 22_050
    starts = [parts[0], parts[0] + between + parts[1], sum(parts) + 2 * between]
    assert reported["starts_s"] == [start / rate for start in starts]
    edges = [0, parts[0] + between, parts[0] + parts[1] + 2 * between, len(reel)]
    slots = [reel[first:last] for first, last in itertools.pairwise(edges)]
    assert [onsets(slot, rate, 1_000) for slot in slots] == [1, 3, 4]
    assert [onsets(slot, rate, 500) for slot in slots] == [0, 0, 2]
    for start in starts:
        assert (reel[start - 100 : start] == 0).all()  # the pause before a take


def test_speech_takes_the_place_of_beeps(tmp_path: Path) -> None:
    speech = (sine(hz=300, dbfs=0, rate=SPEECH_RATE_HZ, seconds=0.2) * 32_767).astype("<i2").tobytes()
    reported, reel, rate = made(tmp_path, (level(100, 0.25), SPEECH_RATE_HZ), slates=[Slate(1, 2, speech)])
    assert rate == SPEECH_RATE_HZ
    assert len(reel) == 4_410 + PAUSE_MS * rate // 1000 + 100
    assert onsets(reel, rate, 300) == 1
    assert 20 * np.log10(np.abs(reel[:4_410]).max()) == pytest.approx(-12, abs=0.1)
    assert reported["starts_s"] == [(len(reel) - 100) / rate]


def test_the_highest_rate_and_the_most_channels_are_taken(tmp_path: Path) -> None:
    tone = sine(hz=441, dbfs=-6, rate=22_050, seconds=0.5)
    _, reel, rate = made(tmp_path, (tone, 22_050), (level(480, 0.25, 2), 48_000), gap_ms=10)
    assert (rate, reel.shape[1]) == (48_000, 2)
    assert len(reel) == pytest.approx(24_000 + 480 + 480, abs=3)  # moved to another rate: to a frame or so
    assert (reel[:, 0] == reel[:, 1]).all()
    assert (reel[-480:] == 0.25).all()
    spectrum = np.abs(np.fft.rfft(reel[:24_000, 0] * np.hanning(24_000)))
    assert np.argmax(spectrum) * 2 == pytest.approx(441, abs=2)


def test_the_same_sounds_give_the_same_bytes(tmp_path: Path) -> None:
    sounds = [(sine(hz=300, rate=RATE, seconds=0.1), RATE), (sine(hz=500, rate=RATE, seconds=0.1), RATE)]
    slates = [Slate(0, 1, None), Slate(0, 2, None)]
    made(tmp_path, *sounds, slates=slates, crossfade_ms=20)
    once = (tmp_path / "reel.wav").read_bytes()
    made(tmp_path, *sounds, slates=slates, crossfade_ms=20)
    assert (tmp_path / "reel.wav").read_bytes() == once
