"""What a sound is known by: its wave in a band, packed small."""

import numpy as np
import pytest

from audio_checks.audit.fingerprint import (
    FINGERPRINTED_S,
    PIECE_BYTES,
    as_text,
    fingerprint,
    from_text,
    next_fast_len,
    pieces_of,
    wave_of,
)
from tests.support.waves import noise, silence, sine


@pytest.mark.parametrize("rate", [11_025, 22_050, 44_100, 44_056, 48_000, 96_000, 192_000])
@pytest.mark.parametrize("frames", [1, 79, 12_345])
def test_it_is_as_long_as_the_sound(rate, frames):
    packed = fingerprint([noise(rate=rate, seconds=2)[:frames]], rate)
    assert len(packed) == pieces_of(frames, rate) * PIECE_BYTES
    assert from_text(as_text(packed)) == packed


def test_the_wave_is_kept_to_a_twentieth():
    # 1 kHz is weighted by sqrt(1000 / 3800), and sixteen steps leave an error of some 1/16/sqrt(3) of the peak.
    wave = wave_of(fingerprint([sine(hz=1_000, dbfs=-6, seconds=0.5)], 48_000))
    wanted = 10 ** (-6 / 20) * np.sqrt(1_000 / 3_800) * np.sin(2 * np.pi * 1_000 * np.arange(len(wave)) / 8_000)
    middle = slice(400, -400)
    error = np.sqrt(np.mean((wave - wanted)[middle] ** 2) / np.mean(wanted[middle] ** 2))
    assert error < 0.07


def test_blocks_are_one_sound():
    sound = noise(channels=2)
    assert fingerprint([sound[:1_000], sound[1_000:]], 48_000) == fingerprint([sound], 48_000)


def test_a_fold_down_is_the_same_sound():
    stereo = noise(channels=2)
    mono = stereo.mean(axis=1, keepdims=True)
    assert fingerprint([stereo], 48_000) == fingerprint([mono], 48_000)


def test_opposite_channels_do_not_cancel_out():
    sound = noise()
    assert fingerprint([np.hstack((sound, -sound))], 48_000) == fingerprint([sound], 48_000)


@pytest.mark.parametrize(
    "sound", [silence(), silence(seconds=0), np.full((48_000, 1), 0.5), sine(hz=15_000)], ids="sncw"
)
def test_nothing_to_know_it_by(sound):
    assert fingerprint([sound * np.hanning(max(1, len(sound)))[:, np.newaxis]], 48_000) is None


def test_no_more_than_a_minute_is_read():
    def blocks():
        for _ in range(FINGERPRINTED_S):
            yield noise(rate=8_000)
        raise AssertionError("read on")

    assert len(fingerprint(blocks(), 8_000)) == FINGERPRINTED_S * 200 * PIECE_BYTES


@pytest.mark.parametrize("text", ["", "?", "AAAA", as_text(b"\0" * (PIECE_BYTES + 1))])
def test_what_is_none(text):
    with pytest.raises(ValueError, match=r"."):
        from_text(text)


def test_smooth_lengths():
    assert [next_fast_len(least) for least in (1, 7, 11, 97, 1_025)] == [1, 8, 12, 100, 1_080]
