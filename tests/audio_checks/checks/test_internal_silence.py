"""`internal-silence`: several sounds in one file."""

import numpy as np
import pytest

from audio_checks import check_file
from audio_checks.spec.delivery_spec import CueFacts, new_spec, parse_spec
from tests.support.waves import join, noise, silence, sine, smpl, write_wav

PAUSE = ["internal-silence:pause"]
HIT = sine(hz=300, seconds=0.2) * np.linspace(1, 0, 9_600)[:, np.newaxis]


def takes(count, pause_s, channels=1):
    sounds = [HIT]
    for _ in range(count - 1):
        sounds += [silence(seconds=pause_s), HIT]
    return np.repeat(join(*sounds), channels, axis=1)


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize(("pause_s", "codes"), [(0.65, PAUSE), (2.0, PAUSE), (0.55, [])])
def test_a_long_pause_divides_sounds(codes_of, pause_s, codes, channels):
    assert codes_of("internal-silence", takes(3, pause_s, channels)) == codes


def test_it_says_how_many_and_offers_to_split_them(found_by):
    (finding,) = found_by("internal-silence", takes(3, 1.0), cue=CueFacts("SW-1", variations=3))
    assert finding.message.startswith("3 sounds with silence between them (0.20 s, 1.40 s), the longest 1.00 s")
    assert finding.fix.startswith("split it at the silence or at its markers into 3 files, as the cue's 3 variations")
    assert (finding.start_s, finding.end_s) == (pytest.approx(0.2, abs=0.02), pytest.approx(1.2, abs=0.02))


def test_a_blip_after_the_sound_is_found(codes_of):
    blip = sine(hz=997, dbfs=-30, seconds=0.01)
    assert codes_of("internal-silence", join(HIT, silence(seconds=1), blip)) == PAUSE


def test_one_channel_that_goes_on_is_no_pause(codes_of):
    stereo = takes(3, 1.0, channels=2)
    stereo[:, 1] = 0.1
    assert codes_of("internal-silence", stereo) == []


@pytest.mark.parametrize("samples", [silence(), silence(seconds=1 / 48_000) + 0.5, HIT, join(HIT, silence(seconds=2))])
def test_one_sound_and_silence_have_no_pause(codes_of, samples):
    assert codes_of("internal-silence", samples) == []


def test_the_noise_of_a_recording_is_no_silence(codes_of):
    assert codes_of("internal-silence", takes(3, 1.0) + noise(dbfs=-66, seconds=2.6)) == []


def test_what_pauses_by_nature_is_left_alone(codes_of):
    assert codes_of("internal-silence", takes(3, 1.0), cue=CueFacts("SW-1", loop=True)) == []
    assert codes_of("internal-silence", takes(3, 1.0), after=[smpl([(0, 4_000)])]) == []


@pytest.mark.parametrize(("category", "codes"), [("ambience", []), ("music", []), ("vo", []), ("impact", PAUSE)])
def test_ambience_music_and_voice_pause_by_nature(tmp_path, category, codes):
    spec = parse_spec(f"{new_spec()}\n[files]\n'*' = '{category}'\n")
    report = check_file(write_wav(tmp_path / "takes.wav", takes(3, 1.0)), spec)
    assert [finding.code for finding in report.findings if finding.check == "internal-silence"] == codes
