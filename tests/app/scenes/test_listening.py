"""What the sandbox's child finds: excitations, parts of references, differences."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from app.scenes import listening
from app.scenes.excitations import as_text, packed, placed, unpacked
from audio_checks import BLOCK_S, CENTRES_HZ
from tests.support.waves import noise, silence, sine, swelling, wav_bytes

RATE = 48_000


def written(path: Path, samples: np.ndarray, rate: int = RATE) -> str:
    path.write_bytes(wav_bytes(samples, rate=rate, bits=16))
    return str(path)


def compared(tmp_path: Path, sound: np.ndarray, against: np.ndarray, rate: int = RATE) -> listening.Compared:
    return listening.compare(
        written(tmp_path / "a.wav", sound), written(tmp_path / "b.wav", against, rate), str(tmp_path)
    )


def test_an_excitation_is_kept_to_a_quarter_of_a_decibel():
    levels = np.linspace(0, -120, 37)[np.newaxis]
    kept = unpacked(as_text(packed(10 ** (levels / 10))))
    assert 10 * np.log10(kept) == pytest.approx(levels, abs=0.26)
    assert (unpacked(as_text(packed(np.zeros((2, 37))))) == 0).all()
    assert unpacked(as_text(packed(np.zeros((0, 37))))).shape == (0, 37)


def test_a_sound_is_placed_at_each_start_and_at_its_level():
    power = np.full((3, len(CENTRES_HZ)), 0.5)
    found = placed(power, starts_s=[0.4, 1.0], loops=False, length_s=1.04, gain_db=-10.0)
    assert found.shape == (26, len(CENTRES_HZ))
    assert (np.flatnonzero(found[:, 0]) * BLOCK_S).round(2).tolist() == [0.4, 0.44, 0.48, 1.0]
    assert found.max() == pytest.approx(0.05)


def test_a_loop_plays_to_the_end_and_starts_that_overlap_add_up():
    power = np.arange(1.0, 4.0)[:, np.newaxis] * np.ones(len(CENTRES_HZ))
    looped = placed(power, starts_s=[0.0], loops=True, length_s=0.28, gain_db=0.0)
    assert looped[:, 0].tolist() == [1, 2, 3, 1, 2, 3, 1]
    twice = placed(power, starts_s=[0.0, 0.04], loops=False, length_s=0.2, gain_db=0.0)
    assert twice[:, 0].tolist() == [1, 3, 5, 3, 0]


def test_a_start_after_the_end_is_not_heard():
    power = np.ones((3, len(CENTRES_HZ)))
    assert not placed(power, starts_s=[9.0], loops=False, length_s=1.0, gain_db=0.0).any()
    assert not placed(power[:0], starts_s=[0.0], loops=True, length_s=1.0, gain_db=0.0).any()


@pytest.mark.parametrize(("form", "subtype"), [("WAV", "PCM_24"), ("FLAC", "PCM_16"), ("OGG", "VORBIS"), ("MP3", None)])
def test_the_part_of_a_reference_plays_in_every_browser(tmp_path: Path, form: str, subtype: str | None):
    music = sine(hz=440, dbfs=-12.0, seconds=3.0, rate=44_100, channels=2)
    soundfile.write(tmp_path / "music", music, 44_100, format=form, subtype=subtype)
    found = listening.prepare_part(str(tmp_path / "music"), str(tmp_path), 0.5, 2.0)
    assert found["problem"] == ""
    assert found["duration_s"] == pytest.approx(1.5, abs=0.001)
    with soundfile.SoundFile(tmp_path / listening.PREVIEW) as made:
        assert (made.samplerate, made.channels, made.subtype) == (44_100, 2, "PCM_16")
    kept = unpacked(as_text(found["excitation"]))
    assert int(kept[10].argmax()) == int(np.argmin(np.abs(CENTRES_HZ - 440)))


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"", "cannot be decoded"),
        (b"RIFF\x10\0\0\0WAVEjunk", "cannot be decoded"),
        (b"fLaC" + bytes(200), "cannot be decoded"),
        (wav_bytes(sine(hz=440, seconds=0.2)), "the part begins at 0.5 s, and the sound ends at 0.2 s"),
    ],
)
def test_a_reference_that_cannot_be_played_says_so(tmp_path: Path, content: bytes, problem: str):
    (tmp_path / "sound").write_bytes(content)
    found = listening.prepare_part(str(tmp_path / "sound"), str(tmp_path), 0.5, 2.0)
    assert problem in found["problem"]
    assert found["excitation"] == b""


def test_a_sound_against_its_softer_and_later_copy_leaves_nothing(tmp_path: Path):
    sound = swelling(noise(dbfs=-20.0, seconds=1.0))
    late = np.concatenate((silence(seconds=0.0125), sound * 10 ** (-6 / 20)))
    found = compared(tmp_path, sound, late)
    assert found["lag_s"] == pytest.approx(-0.0125, abs=0.5 / RATE)
    assert found["gain_db"] == pytest.approx(6.0, abs=0.01)
    assert found["residue_db"] is not None
    assert found["residue_db"] < -60


def test_a_turned_polarity_is_taken_away_too(tmp_path: Path):
    sound = swelling(noise(dbfs=-20.0, seconds=0.5, channels=2))
    found = compared(tmp_path, sound, -sound)
    assert found["residue_db"] is not None
    assert found["residue_db"] < -60


@pytest.mark.slow
def test_what_was_added_is_all_that_is_left(tmp_path: Path):
    sound, added = swelling(noise(dbfs=-20.0, seconds=1.0)), sine(hz=1_000, dbfs=-40.0)
    found = compared(tmp_path, sound + added, sound)
    # −43 dBFS of tone in −20 dBFS of noise.
    assert found["residue_db"] == pytest.approx(-23.0, abs=0.3)
    left, rate = soundfile.read(tmp_path / listening.DIFFERENCE)
    assert rate == RATE
    assert left == pytest.approx(added[:, 0], abs=0.002)
    loudest = max(range(len(found["hz"])), key=lambda place: found["difference_dbfs"][place] or -999)
    assert found["hz"][loudest] == pytest.approx(1_000, rel=0.06)


def test_a_game_file_of_a_lower_rate_leaves_what_it_cannot_hold(tmp_path: Path):
    low, high = sine(hz=1_000, dbfs=-20.0), sine(hz=15_000, dbfs=-40.0)
    game_file = sine(hz=1_000, dbfs=-20.0, rate=22_050)
    found = compared(tmp_path, low + high, game_file, rate=22_050)
    assert found["residue_db"] == pytest.approx(-20.0, abs=0.5)
    loudest = max(range(len(found["hz"])), key=lambda place: found["difference_dbfs"][place] or -999)
    assert found["hz"][loudest] == pytest.approx(15_000, rel=0.06)
    assert len(found["against_dbfs"]) == len(found["hz"])
    assert found["against_dbfs"][-1] is None


@pytest.mark.slow
@pytest.mark.parametrize(("from_hz", "to_hz"), [(44_100, 48_000), (48_000, 44_100), (22_050, 48_000), (48_000, 24_000)])
def test_another_rate_keeps_a_tone(from_hz: int, to_hz: int):
    tone = swelling(sine(hz=1_000, rate=from_hz), from_hz // 10)
    found = listening.resampled(tone, from_hz, to_hz)
    expected = swelling(sine(hz=1_000, rate=to_hz), to_hz // 10)
    assert len(found) == len(expected)
    assert found == pytest.approx(expected, abs=0.001)


@pytest.mark.parametrize("lag", [-3_000, -1, 0, 1, 777])
def test_the_lag_is_found_to_the_frame(lag: int):
    sound = noise(seconds=0.5)
    other = np.roll(sound, -lag, axis=0)
    assert listening.lag_frames(sound, other, farthest=RATE) == lag


@pytest.mark.parametrize(("sound", "against"), [("silence", "noise"), ("noise", "silence"), ("silence", "silence")])
def test_silence_has_figures_too(tmp_path: Path, sound: str, against: str):
    made = {"silence": silence(seconds=0.2), "noise": noise(seconds=0.2)}
    found = compared(tmp_path, made[sound], made[against])
    assert found["residue_db"] == (None if sound == "silence" else pytest.approx(0.0))
    assert found["gain_db"] == 0.0


def test_mono_against_stereo_is_compared_in_mono(tmp_path: Path):
    sound = swelling(noise(dbfs=-20.0, seconds=0.5))
    found = compared(tmp_path, np.repeat(sound, 2, axis=1), sound)
    assert found["residue_db"] is not None
    assert found["residue_db"] < -60
