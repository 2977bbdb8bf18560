"""Ogg Vorbis, Opus and MP3 of a game's tree: decoded in a child, and judged with the words that WAV is judged with."""

import os

import numpy as np
import pytest
import soundfile

from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.sandbox import child
from audio_checks.audit.fingerprinted import fingerprint_file
from audio_checks.errors import Unreadable
from audio_checks.run.runner import judge, task_for
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.coded import coded_bytes
from tests.support.mutants import damaged
from tests.support.waves import sine, write_wav

SOUND = sine(hz=997, dbfs=-6.0, seconds=1.0)
KINDS = [
    ("a.ogg", "OGG", "VORBIS", "vorbis"),
    ("a.opus", "OGG", "OPUS", "opus"),
    ("a.mp3", "MP3", "MPEG_LAYER_III", "mp3"),
]
GAME = 'format = 1\n[accept]\ncontainers = ["wav", "ogg", "mp3"]\n'


@pytest.fixture
def inside(monkeypatch):
    """Decode in this process, as a sandbox's child does."""
    monkeypatch.setattr(child, "_inside", True)


def coded(path, samples=SOUND, form="OGG", codec="VORBIS", rate=48_000):
    soundfile.write(path, samples, rate, format=form, subtype=codec)
    return path


def codes(path, text, **options):
    (entry,) = judge([task_for(path, parse_spec(text), coded=True, **options)])
    return entry, [finding.code for finding in entry.findings]


@pytest.mark.parametrize(("name", "form", "codec", "encoding"), KINDS)
def test_it_is_what_its_codec_keeps(tmp_path, name, form, codec, encoding):
    path = coded(tmp_path / name, form=form, codec=codec)
    with AudioFile(path, coded=True) as file:
        facts = file.facts
        assert (facts.container, facts.encoding) == ("mp3" if encoding == "mp3" else "ogg", encoding)
        assert (facts.sample_rate_hz, facts.channels, facts.frames) == (48_000, 1, 48_000)
        assert facts.bit_rate_kbps == pytest.approx(os.path.getsize(path) * 8 / 1_000, abs=0.06)
        assert facts.effective_bits is None
        assert file.measurements.sample_peak_dbfs == pytest.approx(-6.0, abs=2.5)


def test_the_length_is_without_the_encoders_padding(tmp_path, inside):
    for name, form, codec, _ in KINDS:
        path = coded(tmp_path / name, SOUND[:10_007], form, codec)
        with AudioFile(path, coded=True) as file:
            assert file.facts.frames == 10_007


@pytest.mark.parametrize(
    ("rule", "found"),
    [
        ("", []),
        ('encodings = ["vorbis"]', []),
        ('encodings = ["opus"]', ["encoding:not-accepted"]),
        ("bit_rate_kbps = { max = 500 }", []),
        ("bit_rate_kbps = { max = 5 }", ["encoding:bit-rate-high"]),
        ("bit_rate_kbps = { min = 500 }", ["encoding:bit-rate-low"]),
        ("sample_rates_hz = [44100]", ["sample-rate:not-accepted"]),
        ("bit_depths = [16]", []),
        ("channels = [2]", ["channels:not-accepted"]),
        ("duration_s = { max = 0.5 }", ["duration:long"]),
        ("[limits]\nsample_peak_dbfs = -20.0", ["sample-peak:over"]),
        ("[limits]\nsilence_below_dbfs = -3.0", ["silence:below"]),
    ],
)
def test_it_is_judged_with_the_same_words(tmp_path, inside, rule, found):
    _, said = codes(coded(tmp_path / "a.ogg"), GAME + rule)
    assert [code.partition(":")[0] for code in said] == [code.partition(":")[0] for code in found]


def test_bit_rates_bound_no_wav(tmp_path):
    _, said = codes(write_wav(tmp_path / "a.wav", SOUND), GAME + "bit_rate_kbps = { max = 5 }")
    assert said == []


def test_a_spec_without_its_container_does_not_decode_it(tmp_path):
    path = coded(tmp_path / "a.ogg")
    for text in ('format = 1\naccept.containers = ["wav"]', "format = 1"):
        entry, said = codes(path, text)
        assert (entry.verdict, said) == ("unreadable", ["container:ogg"])
    with pytest.raises(Unreadable):
        AudioFile(path)


def test_a_coded_file_in_a_wavs_name_stays_what_it_is(tmp_path):
    path = coded(tmp_path / "a.ogg").rename(tmp_path / "a.wav")
    entry, said = codes(path, GAME)
    assert (entry.verdict, said) == ("unreadable", ["container:ogg"])


def test_damaged_files_are_refused_with_a_reason(tmp_path, inside):
    whole = coded(tmp_path / "whole.ogg").read_bytes()
    path = tmp_path / "a.ogg"
    refused = 0
    for seed in range(60):
        path.write_bytes(damaged(np.random.default_rng(seed), whole))
        entry, _ = codes(path, GAME)
        assert entry.verdict in ("conforming", "rejected", "unreadable")
        refused += entry.verdict == "unreadable"
    assert refused > 5


def test_a_file_that_is_cut_off(tmp_path, inside):
    path = coded(tmp_path / "a.ogg")
    path.write_bytes(path.read_bytes()[:200])
    entry, said = codes(path, GAME)
    assert (entry.verdict, said) == ("unreadable", ["structure:coded-damaged"])


@pytest.mark.parametrize(("more", "is_read"), [(1, True), (9, False)])  # a frame of MP3 has 1,152 frames of sound
def test_an_mp3_whose_header_says_a_frame_too_many_is_read_and_one_that_lacks_more_is_not(tmp_path, more, is_read):
    whole = coded_bytes("mp3")
    at = whole.index(b"Xing") + 8
    said = int.from_bytes(whole[at : at + 4], "big") + more
    path = tmp_path / "a.mp3"
    path.write_bytes(whole[:at] + said.to_bytes(4, "big") + whole[at + 4 :])
    if not is_read:
        with pytest.raises(Unreadable, match="frames are missing"):
            AudioFile(path, coded=True)
        return
    with AudioFile(path, coded=True) as file, soundfile.SoundFile(path) as sound:
        assert file.facts.frames == len(sound.read()) < sound.frames
    found = fingerprint_file(str(path), "a.mp3")
    assert (found.trouble, found.frames) == ("", file.facts.frames)
    assert found.fingerprint
