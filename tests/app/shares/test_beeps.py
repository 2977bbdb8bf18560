"""Copies of previews for guests: the frames alone, or with beeps that change neither length nor ceiling."""

import io
import math
import wave
from pathlib import Path

import numpy as np
import pytest

from app.shares import beeps
from audio_checks import true_peak_dbtp
from tests.support.waves import sine, wav_bytes

RATE = 48_000


def frames_of(path: Path) -> np.ndarray:
    with wave.open(str(path)) as file:
        return np.frombuffer(file.readframes(file.getnframes()), "<i2").reshape(-1, file.getnchannels())


def level_at(samples: np.ndarray, hz: float) -> float:
    """Return the level of one frequency, as the amplitude of a sine in dBFS."""
    times_s = np.arange(len(samples)) / RATE
    turning = np.exp(-2j * math.pi * hz * times_s)
    return 20 * math.log10(max(1e-9, 2 * abs((samples * turning).mean())))


def test_a_beep_comes_every_four_seconds_and_nothing_between() -> None:
    mixed = beeps.with_beeps(np.zeros((10 * RATE, 2)), RATE)
    assert mixed.shape == (10 * RATE, 2)
    heard_s = np.flatnonzero(np.abs(mixed).max(axis=1) > 1e-6) / RATE
    starts_s = heard_s[np.flatnonzero(np.diff(heard_s, prepend=-9) > 1)]
    assert starts_s == pytest.approx([0.5, 4.5, 8.5], abs=0.001)
    middle = mixed[round(4.53 * RATE) : round(4.62 * RATE), 0]  # 90 periods of 1 kHz, between the edges
    assert level_at(middle, beeps.BEEP_HZ) == pytest.approx(beeps.BEEP_DBFS, abs=0.01)


@pytest.mark.parametrize("frames", [0, 1, 10, 100, RATE // 4])
def test_a_short_sound_keeps_its_length_and_has_its_beep_at_the_beginning(frames: int) -> None:
    mixed = beeps.with_beeps(np.zeros((frames, 1)), RATE)
    assert mixed.shape == (frames, 1)
    assert not mixed.any() or np.flatnonzero(mixed[:, 0])[0] <= 1


def test_the_true_peak_stays_under_the_ceiling_although_no_sample_is_above_it() -> None:
    times_s = np.arange(2 * RATE) / RATE
    loud = 0.99 * np.sin(2 * math.pi * 12_000 * times_s + math.pi / 4)[:, np.newaxis]  # its crests lie between samples
    assert np.abs(loud).max() < 0.71
    assert true_peak_dbtp(loud, RATE) > -0.2
    assert true_peak_dbtp(beeps.with_beeps(loud, RATE), RATE) <= beeps.CEILING_DBTP


def test_a_quiet_sound_is_not_lowered() -> None:
    quiet = sine(hz=440, dbfs=-40, rate=RATE, seconds=1).reshape(-1, 1)
    mixed = beeps.with_beeps(quiet, RATE)
    assert np.allclose(mixed[: RATE // 4], quiet[: RATE // 4])


@pytest.mark.parametrize("has_beeps", [False, True])
def test_the_copy_has_the_frames_and_none_of_what_stands_beside_them(tmp_path: Path, has_beeps: bool) -> None:
    sound = wav_bytes(sine(hz=440, dbfs=-0.1, rate=RATE, seconds=1.5), rate=RATE, bits=16)
    source, out = tmp_path / "preview.wav", tmp_path / "copy.wav"
    source.write_bytes(
        sound + b"LIST" + (18).to_bytes(4, "little") + b"INFOIART" + (6).to_bytes(4, "little") + b"Studio"
    )
    beeps.copy_for_guests(str(source), str(out), has_beeps=has_beeps)
    assert b"Studio" not in out.read_bytes()
    with wave.open(io.BytesIO(sound)) as file:
        assert len(frames_of(out)) == file.getnframes()
    assert np.array_equal(frames_of(out), frames_of(source)) is not has_beeps
    if has_beeps:
        assert true_peak_dbtp(frames_of(out) / 32_768, RATE) <= beeps.CEILING_DBTP
