"""FLAC masters: the same sound as their WAV in every figure, and damaged ones refused in words."""

import gc
import hashlib
import io
import os
import signal
import tempfile
from pathlib import Path

import numpy as np
import pytest

from audio_checks import check_file, check_files, measure_file, render_master, wav, wave_shapes
from audio_checks.audio import flac
from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.sandbox import Sandbox, child
from audio_checks.audio.sound_files import open_sound
from audio_checks.errors import Unreadable
from audio_checks.spec.delivery_spec import parse_spec
from tests.support import chunks, flacs
from tests.support.mutants import damaged
from tests.support.waves import noise, pcm_bytes, sine, smpl, wav_bytes, write_wav

ACCEPTS = parse_spec('format = 1\naccept.containers = ["wav", "flac"]')
WAV_ONLY = parse_spec('format = 1\naccept.containers = ["wav"]')


@pytest.fixture
def inside(monkeypatch):
    """Decode in this process, as a sandbox's child does: a test of the decoding needs no child."""
    monkeypatch.setattr(child, "_inside", True)


def write(path, content):
    path.write_bytes(content)
    return path


def sound_of(path):
    """Return the samples as a FLAC is read."""
    with open_sound(path) as sound:
        return b"".join(wav.raw_blocks(sound.file, sound.layout))


@pytest.mark.parametrize("bits", [8, 16, 24])
@pytest.mark.parametrize("channels", [1, 2, 6])
@pytest.mark.parametrize("rate", [11_025, 96_000])
def test_unpacked_it_is_the_wav_byte_for_byte(tmp_path, inside, bits, channels, rate):
    samples = noise(seconds=70_000 / rate, rate=rate, channels=channels)
    path = write(tmp_path / "a.flac", flacs.flac_bytes(samples, rate=rate, bits=bits))
    assert sound_of(path) == pcm_bytes(samples, bits)


def test_it_says_what_its_wav_says(tmp_path, inside):
    samples = noise(seconds=1, channels=2)
    packed = measure_file(write(tmp_path / "a.flac", flacs.flac_bytes(samples)))
    plain = measure_file(write_wav(tmp_path / "a.wav", samples))
    assert packed.measurements == plain.measurements
    assert packed.pcm_sha256 == plain.pcm_sha256 == hashlib.sha256(pcm_bytes(samples)).hexdigest()
    assert packed.sha256 == hashlib.sha256((tmp_path / "a.flac").read_bytes()).hexdigest()
    assert packed.facts["container"] == "flac"
    same = ("encoding", "sample_rate_hz", "bit_depth", "effective_bits", "channels", "frames", "duration_s")
    assert {key: packed.facts[key] for key in same} == {key: plain.facts[key] for key in same}
    assert packed.facts["chunks"][:2] == ["STREAMINFO", "VORBIS_COMMENT"]


def test_decoding_happens_in_a_child(tmp_path, monkeypatch):
    path = write(tmp_path / "a.flac", flacs.flac_bytes(noise(seconds=0.2)))
    monkeypatch.setattr(flac, "unpack", flac.unpack)
    monkeypatch.setattr(flac, "_decoded", lambda *_: pytest.fail("decoded in this process"))
    entry = check_file(path, ACCEPTS)
    assert (entry.verdict, entry.facts["frames"]) == ("conforming", 9_600)


@pytest.mark.slow
def test_within_a_child_there_is_no_other(tmp_path):
    path = write(tmp_path / "a.flac", flacs.flac_bytes(noise(seconds=0.2)))
    with Sandbox(timeout_s=20).child(reads=[path]) as child:  # where no process may be started
        entry = child.call(check_file, path, ACCEPTS)
    assert entry.verdict == "conforming"


@pytest.mark.parametrize(
    ("spec", "name", "verdict"),
    [
        (ACCEPTS, "a.flac", "conforming"),
        (ACCEPTS, "a.FLAC", "conforming"),
        (WAV_ONLY, "a.flac", "rejected"),
        (None, "a.flac", "conforming"),
        (parse_spec("format = 1"), "a.flac", "conforming"),
        (ACCEPTS, "a.wav", "unreadable"),
        (ACCEPTS, "a", "unreadable"),
    ],
)
def test_where_it_is_accepted(tmp_path, inside, spec, name, verdict):
    entry = check_file(write(tmp_path / "stored", flacs.flac_bytes(noise(seconds=0.1))), spec, name=name)
    assert entry.verdict == verdict
    assert (entry.facts is not None) == (verdict == "conforming")
    if verdict != "conforming":
        assert entry.findings[0].code == "container:flac"


def test_where_another_container_only_warns(tmp_path, inside):
    spec = parse_spec('format = 1\naccept.containers = ["wav"]\nchecks.container = "warning"')
    entry = check_file(write(tmp_path / "a.flac", flacs.flac_bytes(noise(seconds=0.1))), spec, checks=["container"])
    assert [finding.message for finding in entry.findings] == ["container FLAC, accepted WAV"]
    assert entry.verdict == "conforming"


def test_a_render_is_never_flac(tmp_path, inside):
    spec = parse_spec(
        'format = 1\naccept.containers = ["flac"]\ntargets.game = { sample_rate_hz = 48000, bit_depth = 16 }'
    )
    path = write(tmp_path / "a.flac", flacs.flac_bytes(noise(seconds=0.1), bits=16))
    assert check_file(path, spec).verdict == "conforming"
    assert check_file(path, spec, target="game").verdict == "rejected"


def test_the_same_sound_in_both_is_a_duplicate(tmp_path, inside):
    samples = noise(seconds=0.1)
    paths = [write_wav(tmp_path / "a.wav", samples), write(tmp_path / "b.flac", flacs.flac_bytes(samples))]
    assert "duplicate:same-sound" in [finding.code for finding in check_files(paths, ACCEPTS).files[1].findings]


def test_metadata_and_loops_that_were_kept(tmp_path, inside):
    kept = [
        flacs.comments({"TITLE": "Laser", "comment": "layered", "empty": ""}),
        flacs.riff(chunks.bext(originator="Mara Lind")),
        flacs.riff(smpl([(100, 4_799)])),
        flacs.riff(b"data\x04\0\0\0abcd"),
    ]
    path = write(tmp_path / "a.flac", flacs.flac_bytes(noise(seconds=0.1), blocks=kept))
    with AudioFile(path) as file:
        assert (
            file.metadata.fields.items()
            >= {
                "Vorbis.TITLE": "Laser",
                "Vorbis.COMMENT": "layered",
                "bext.Originator": "Mara Lind",
            }.items()
        )
        assert [(loop.start, loop.end) for loop in file.layout.loops] == [(100, 4_799)]
        assert file.facts.chunks == ("STREAMINFO", "VORBIS_COMMENT", *["APPLICATION"] * 3, "PADDING")


def test_layouts(tmp_path, inside):
    quad = write(tmp_path / "quad.flac", flacs.flac_bytes(noise(seconds=0.01, channels=4)))
    reported = flacs.comments({"WAVEFORMATEXTENSIBLE_CHANNEL_MASK": "0x0107"})
    other = write(tmp_path / "other.flac", flacs.flac_bytes(noise(seconds=0.01, channels=4), blocks=[reported]))
    spec = parse_spec('format = 1\naccept.layouts = ["quad"]')
    assert check_file(quad, spec).verdict == "conforming"
    assert check_file(other, spec).findings[0].code == "channels:layout"


def test_a_render_of_it_is_that_of_its_wav(tmp_path, inside):
    samples = sine(hz=997, rate=96_000, seconds=0.3)
    packed = write(tmp_path / "a.flac", flacs.flac_bytes(samples, rate=96_000))
    plain = write_wav(tmp_path / "a.wav", samples, rate=96_000)
    target = parse_spec("format = 1\ntargets.game = { sample_rate_hz = 48000, bit_depth = 24 }").targets["game"]
    ours = render_master(packed, target, tmp_path / "ours.wav")
    theirs = render_master(plain, target, tmp_path / "theirs.wav")
    assert ours.pcm_sha256 == theirs.pcm_sha256
    assert ours.master_sha256 == hashlib.sha256(packed.read_bytes()).hexdigest()
    assert [wave_shape.to_dict() for wave_shape in wave_shapes(packed)] == [
        wave_shape.to_dict() for wave_shape in wave_shapes(plain)
    ]


GOOD = flacs.flac_bytes(noise(seconds=0.2), bits=16)
WRONG_SUM = bytes(range(1, 17))
DAMAGED = {
    "cut in its header": (GOOD[:30], "structure:truncated"),
    "cut before its sound": (GOOD[:42][:4] + flacs.block(0, GOOD[8:42], last=True), "structure:truncated"),
    "cut in its sound": (GOOD[: len(GOOD) // 2], "structure:flac-damaged"),
    "another checksum": (flacs.with_info(GOOD, md5=WRONG_SUM), "structure:flac-damaged"),
    "announced too long": (flacs.with_info(GOOD, frames=9_700), "structure:flac-damaged"),
    "announced too short": (flacs.with_info(GOOD, frames=9_500), "structure:flac-damaged"),
    "length left open": (flacs.with_info(GOOD, frames=0), "structure:stream-header"),
    "a whole day of it": (flacs.with_info(GOOD, frames=(1 << 36) - 1), "structure:flac-header"),
    "no rate": (flacs.with_info(GOOD, rate=0), "structure:flac-header"),
    "20 bits": (flacs.with_info(GOOD, bits=20), "structure:flac-header"),
    "no STREAMINFO": (b"fLaC" + flacs.block(1, bytes(40), last=True) + bytes(99), "structure:flac-header"),
    "two of them": (flacs.with_blocks(GOOD, [flacs.block(0, GOOD[8:42])]), "structure:flac-header"),
    "a short one": (b"fLaC" + flacs.block(0, bytes(20), last=True) + bytes(99), "structure:flac-header"),
    "nothing but the name": (b"fLaC", "structure:truncated"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_damage_is_refused_with_a_reason(tmp_path, inside, name):
    content, code = DAMAGED[name]
    entry = check_file(write(tmp_path / "a.flac", content), ACCEPTS)
    assert (entry.verdict, entry.findings[0].code) == ("unreadable", code)
    assert entry.findings[0].message.isprintable()


def test_without_a_checksum_it_is_read(tmp_path, inside):
    path = write(tmp_path / "a.flac", flacs.with_info(GOOD, md5=bytes(16)))
    assert check_file(path, ACCEPTS).verdict == "conforming"


def test_a_decoder_that_dies_takes_only_its_file_with_it_and_is_our_fault(tmp_path, monkeypatch):
    broken, whole = write(tmp_path / "a.flac", GOOD), write_wav(tmp_path / "b.wav", noise(seconds=0.2))
    monkeypatch.setattr(flac, "unpack", die)
    first, second = check_files([broken, whole], ACCEPTS).files
    assert (first.verdict, first.findings[0].code) == ("unjudged", "audio-checks:crashed")
    assert "SIGSEGV" in first.findings[0].message
    assert second.verdict == "conforming"


def die(_path, _out):
    os.kill(os.getpid(), signal.SIGSEGV)


@pytest.mark.slow
def test_nothing_is_left_behind(tmp_path, inside, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "tmp"))
    (tmp_path / "tmp").mkdir()
    check_file(write(tmp_path / "a.flac", GOOD), ACCEPTS)
    check_file(write(tmp_path / "b.flac", flacs.with_info(GOOD, md5=WRONG_SUM)), ACCEPTS)
    gc.collect()
    assert list((tmp_path / "tmp").iterdir()) == []


def test_wav_loads_nothing_of_it(tmp_path, monkeypatch):
    monkeypatch.setattr(flac, "read_layout", lambda _: pytest.fail("a WAV was taken for FLAC"))
    assert check_file(write(tmp_path / "a.wav", wav_bytes(noise(seconds=0.1))), ACCEPTS).verdict == "conforming"


@pytest.mark.slow
def test_thousands_of_headers_are_read_or_refused():
    rng = np.random.default_rng(20261121)
    whole = flacs.flac_bytes(
        noise(seconds=0.01), blocks=[flacs.comments({"TITLE": "x"}), flacs.riff(chunks.bext(originator="y"))]
    )
    outcomes = {"read": 0, "refused in words": 0, "refused": 0}
    for _ in range(20_000):
        content = damaged(rng, whole)
        try:
            flac.read_layout(io.BytesIO(content))
        except Unreadable as refusal:
            outcomes["refused in words" if str(refusal).isprintable() and refusal.fix else "refused"] += 1
        else:
            outcomes["read"] += 1
    assert outcomes["refused"] == 0
    assert min(outcomes["read"], outcomes["refused in words"]) > 2_000


def test_hundreds_of_mutants_are_decoded_or_refused(tmp_path):
    rng = np.random.default_rng(7)
    whole = flacs.flac_bytes(noise(seconds=0.05, channels=2), bits=16)
    verdicts = set()
    for number in range(100):
        path = write(tmp_path / f"{number}.flac", damaged(rng, damaged(rng, whole)))
        entry = check_file(path, ACCEPTS)
        assert entry.verdict != "unjudged", entry.findings
        verdicts.add(entry.verdict)
    assert "unreadable" in verdicts


def test_real_recordings_packed(tmp_path, inside):
    folder = os.environ.get("SOUNDS_DIR")
    if not folder:
        pytest.skip("SOUNDS_DIR does not name a folder of real recordings")
    import soundfile

    for path in sorted(Path(folder, "masters").glob("*.wav"))[::12]:
        samples, rate = soundfile.read(path, dtype="int16")
        soundfile.write(tmp_path / "a.flac", samples, rate, subtype="PCM_16")
        assert measure_file(tmp_path / "a.flac").pcm_sha256 == measure_file(path).pcm_sha256
