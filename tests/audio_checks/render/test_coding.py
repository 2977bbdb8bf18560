"""Game files in a codec: as long as their master, within the limits, the same bytes twice, and right to `check`."""

import hashlib
import io
import struct
from dataclasses import replace

import numpy as np
import pytest
import soundfile

from audio_checks import check_file, is_placeholder, parse_spec
from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.sandbox import child
from audio_checks.errors import RenderRefused
from audio_checks.metadata.mark import marked_comment
from audio_checks.render.ogg_pages import rewrite_ogg
from audio_checks.render.render import render_master
from audio_checks.spec.delivery_spec import Target
from tests.support.any_sound import any_sound
from tests.support.waves import (
    chunk,
    extensible,
    noise,
    pcm_bytes,
    placeholder_mark,
    riff,
    silence,
    sine,
    smpl,
    write_wav,
)

SPEC = parse_spec("""
format = 1
[accept]
channels = [1, 2]
[limits]
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0
[naming]
extension = ".wav"
[targets.vorbis]
sample_rate_hz = 44100
encoding = "vorbis"
quality = 0.4
[targets.opus]
sample_rate_hz = 48000
encoding = "opus"
[targets.flac]
sample_rate_hz = 44100
bit_depth = 16
encoding = "flac"
""")
TARGETS = tuple(SPEC.targets)


@pytest.fixture(autouse=True)
def inside(monkeypatch):
    """Encode and decode in this process, as in the server's child; one test below does so in a child of its own."""
    monkeypatch.setattr(child, "_inside", True)


def rendered_to(name, master, folder, **more):
    target = SPEC.targets[name]
    limits = {"sample_peak_limit_dbfs": -0.1, "true_peak_limit_dbtp": -1.0}
    return render_master(master, target, folder / f"game{target.ending()}", **limits | more)


def samples_of(path):
    samples, rate = soundfile.read(path, always_2d=True)
    return samples, rate


def square(*, seconds=0.4, rate=96_000, channels=1):
    return np.sign(sine(hz=997, dbfs=0, seconds=seconds, rate=rate, channels=channels)) * 0.9999


SOUNDS = {
    "mono at 44.1": (lambda: sine(hz=997, dbfs=-6, seconds=0.5, rate=44_100), 44_100),
    "stereo at 48": (lambda: noise(seconds=0.5, channels=2, dbfs=-20), 48_000),
    "mono at 96": (lambda: noise(seconds=0.5, rate=96_000, dbfs=-20), 96_000),
    "one frame": (lambda: np.full((1, 1), 0.25), 48_000),
    "a loud square": (square, 96_000),
    "a loud stereo square": (lambda: square(channels=2), 96_000),
    "silence": (lambda: silence(seconds=0.3, channels=2), 48_000),
}


# Nothing is converted up.
MADE = [(name, sound) for name in TARGETS for sound in SOUNDS if SOUNDS[sound][1] >= SPEC.targets[name].sample_rate_hz]


@pytest.mark.parametrize(("name", "sound"), MADE)
def test_the_file_is_what_its_check_accepts(tmp_path, name, sound):
    make, rate = SOUNDS[sound]
    target = SPEC.targets[name]
    samples = make()
    master = write_wav(tmp_path / "a.wav", samples, rate=rate)
    rendered = rendered_to(name, master, tmp_path)
    entry = check_file(rendered.path, SPEC, target=name)
    assert [finding.code for finding in entry.findings if finding.severity == "error"] == []
    assert entry.facts["frames"] == rendered.frames == -(-len(samples) * target.sample_rate_hz // rate)
    assert entry.facts["channels"] == samples.shape[1]
    assert entry.sha256 == rendered.sha256 == hashlib.sha256(rendered.path.read_bytes()).hexdigest()
    assert entry.pcm_sha256 == rendered.pcm_sha256
    # What the report says of the game file is what a decoder finds in it.
    found = entry.measurements["sample_peak_dbfs"]
    assert found == rendered.measurements["sample_peak_dbfs"]
    assert rendered.measurements["true_peak_dbtp"] <= -0.95
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.wav", rendered.path.name]


@pytest.mark.parametrize("name", TARGETS)
def test_rendered_twice_the_bytes_are_the_same(tmp_path, name):
    master = write_wav(tmp_path / "a.wav", noise(seconds=0.5, channels=2, rate=96_000), rate=96_000)
    (tmp_path / "again").mkdir()
    first, again = rendered_to(name, master, tmp_path), rendered_to(name, master, tmp_path / "again")
    assert first.path.read_bytes() == again.path.read_bytes()
    assert first == replace(again, path=first.path)
    assert rendered_to(name, master, tmp_path, loop=True).sha256 != first.sha256


@pytest.mark.parametrize("name", TARGETS)
def test_a_child_of_its_own_writes_the_same(tmp_path, name, monkeypatch):
    master = write_wav(tmp_path / "a.wav", noise(seconds=0.2, rate=96_000), rate=96_000)
    here = rendered_to(name, master, tmp_path)
    monkeypatch.setattr(child, "_inside", False)
    (tmp_path / "child").mkdir()
    assert rendered_to(name, master, tmp_path / "child").sha256 == here.sha256


@pytest.mark.parametrize("name", ["vorbis", "opus"])
def test_peaks_that_the_codec_adds_come_down_too(tmp_path, name):
    master = write_wav(tmp_path / "a.wav", square(), rate=96_000)
    rendered = rendered_to(name, master, tmp_path)
    assert rendered.attenuation_db > 0
    assert rendered.loss.attenuation_db == rendered.attenuation_db
    with pytest.raises(RenderRefused, match="peaks") as refused:
        render_master(
            master, replace(SPEC.targets[name], over_peak="refuse"), tmp_path / "b.ogg", true_peak_limit_dbtp=-1.0
        )
    assert refused.value.code == "render:over-peak"
    assert not (tmp_path / "b.ogg").exists()
    # Without limits full scale is one: a float decoder goes beyond it, and a game clips there.
    free = render_master(master, SPEC.targets[name], tmp_path / "free.ogg")
    assert free.measurements["sample_peak_dbfs"] <= 0
    assert np.abs(samples_of(tmp_path / "free.ogg")[0]).max() <= 1


@pytest.mark.parametrize(("name", "within"), [("vorbis", 0.05), ("opus", 0.05), ("flac", 0.0001)])
def test_nothing_moves(tmp_path, name, within):
    """A swept tone stands at the same frame as in a plain render, so that loops and cues keep their places."""
    rate = SPEC.targets[name].sample_rate_hz
    seconds = np.arange(96_000) / 96_000
    sweep = 0.4 * np.sin(2 * np.pi * (200 * seconds + 3_000 * seconds**2))[:, np.newaxis]
    master = write_wav(tmp_path / "a.wav", sweep, rate=96_000)
    coded = samples_of(rendered_to(name, master, tmp_path).path)[0][:, 0]
    render_master(master, Target("plain", rate, 32, encoding="float"), tmp_path / "plain.wav")
    plain = samples_of(tmp_path / "plain.wav")[0][:, 0]
    spectrum = np.fft.rfft(coded) * np.conj(np.fft.rfft(plain))
    assert int(np.argmax(np.fft.irfft(spectrum, len(plain)))) == 0
    assert np.sqrt(np.mean((coded - plain) ** 2) / np.mean(plain**2)) < within


def test_flac_holds_the_very_samples_of_a_wav(tmp_path):
    master = write_wav(tmp_path / "a.wav", noise(seconds=0.5, channels=2, rate=96_000), rate=96_000)
    flac = rendered_to("flac", master, tmp_path)
    plain = render_master(master, Target("pc", 44_100, 16), tmp_path / "a44.wav", true_peak_limit_dbtp=-1.0)
    assert flac.pcm_sha256 == plain.pcm_sha256
    assert (flac.attenuation_db, flac.loss.requantisation_dbfs) == (
        plain.attenuation_db,
        plain.loss.requantisation_dbfs,
    )
    assert flac.measurements == plain.measurements
    eight = write_wav(tmp_path / "b.wav", sine(hz=441, seconds=0.1, rate=44_100), rate=44_100, bits=8)
    assert rendered_to("flac", eight, tmp_path).bit_depth == 8  # nothing was recalculated, so nothing is added


@pytest.mark.slow
def test_quality_is_heard_in_size_and_loss(tmp_path):
    master = write_wav(tmp_path / "a.wav", noise(seconds=1, channels=2, dbfs=-20))
    for name in ("vorbis", "opus"):
        target = replace(SPEC.targets[name], sample_rate_hz=48_000)
        low, high = (
            render_master(master, replace(target, quality=quality), tmp_path / f"{quality}.ogg")
            for quality in (0.1, 0.9)
        )
        assert low.path.stat().st_size < 0.7 * high.path.stat().st_size
        assert low.loss.requantisation_dbfs > high.loss.requantisation_dbfs + 3


class TestWhatGoesAlong:
    def test_loop_and_mark_stand_in_the_comments_of_an_ogg(self, tmp_path):
        master = write_wav(
            tmp_path / "a.wav",
            sine(hz=500, dbfs=-6, seconds=0.5, rate=96_000),
            rate=96_000,
            before=[smpl([(9_600, 28_799)], rate=96_000), placeholder_mark("12")],
        )
        rendered = rendered_to("opus", master, tmp_path)
        ((first, last),) = rendered.loop_points
        content = rendered.path.read_bytes()
        assert f"LOOPSTART={first}".encode() in content
        assert f"LOOPLENGTH={last - first + 1}".encode() in content
        assert is_placeholder(rendered.path)
        entry = check_file(rendered.path, SPEC, target="opus")
        assert "placeholder:marked" in [finding.code for finding in entry.findings if finding.severity == "error"]

    def test_names_go_along_only_where_everything_does(self, tmp_path):
        about = [chunk(b"LIST", b"INFOIART" + struct.pack("<I", 8) + b"Someone\0")]
        master = write_wav(tmp_path / "a.wav", noise(seconds=0.1), before=about)
        for name in TARGETS:
            rendered = render_master(master, replace(SPEC.targets[name], chunks="all"), tmp_path / "all.ogg")
            assert b"Someone" in rendered.path.read_bytes()
            assert b"Someone" not in rendered_to(name, master, tmp_path).path.read_bytes()

    def test_flac_keeps_loops_and_cue_points_as_its_wav_would(self, tmp_path):
        points = chunk(
            b"cue ", struct.pack("<II", 1, 1) + struct.pack("<I4s4sIII", 0, b"\0" * 4, b"data", 0, 0, 4_800)[:24]
        )
        master = write_wav(
            tmp_path / "a.wav",
            noise(seconds=0.5, rate=96_000, dbfs=-20),
            rate=96_000,
            before=[smpl([(9_600, 28_799)]), points],
        )
        flac = rendered_to("flac", master, tmp_path)
        render_master(master, Target("pc", 44_100, 16), tmp_path / "plain.wav", true_peak_limit_dbtp=-1.0)
        with AudioFile(flac.path) as coded, AudioFile(tmp_path / "plain.wav") as plain:
            assert [(loop.start, loop.end) for loop in coded.layout.loops] == list(flac.loop_points)
            assert coded.metadata.cue_points == plain.metadata.cue_points
            assert coded.metadata.cue_points


@pytest.mark.parametrize("name", ["vorbis", "opus"])
def test_a_loop_of_the_whole_file_keeps_its_length_and_its_seam(tmp_path, name):
    master = write_wav(tmp_path / "a.wav", sine(hz=480, dbfs=-6, seconds=1, rate=96_000), rate=96_000)
    rendered = rendered_to(name, master, tmp_path, loop=True)
    assert rendered.frames == SPEC.targets[name].sample_rate_hz
    assert len(samples_of(rendered.path)[0]) == rendered.frames
    assert rendered.seam_after.step_db < 6


@pytest.mark.parametrize(("name", "most"), [("vorbis", 2), ("opus", 2), ("flac", 8)])
def test_more_channels_than_the_file_holds_are_refused(tmp_path, name, most):
    target = SPEC.targets[name]
    master = write_wav(tmp_path / "a.wav", noise(seconds=0.05, channels=most + 1, rate=48_000))
    with pytest.raises(RenderRefused, match=f"holds {most} channels") as refused:
        render_master(master, target, tmp_path / "game.ogg")
    assert refused.value.code == "render:codec-channels"


def test_six_channels_of_a_flac_keep_their_places(tmp_path):
    sound = noise(seconds=0.1, channels=6, dbfs=-20)
    header = chunk(b"fmt ", extensible(channels=6, container_bits=24, mask=0x60F))
    (tmp_path / "a.wav").write_bytes(riff(header, chunk(b"data", pcm_bytes(sound))))
    rendered = rendered_to("flac", tmp_path / "a.wav", tmp_path)
    with AudioFile(rendered.path) as file:
        assert file.layout.channel_mask == 0x60F


@pytest.mark.parametrize("seed", range(200, 230))
def test_any_sound_is_rendered_or_refused(tmp_path, seed):
    master = tmp_path / "a.wav"
    sound = any_sound(seed, longest_s=0.5)
    master.write_bytes(sound.content)
    for name in TARGETS:
        low = replace(SPEC.targets[name], sample_rate_hz=48_000 if name == "opus" else 8_000, channels="master")
        out = tmp_path / f"game{low.ending()}"
        if sound.rate_hz < low.sample_rate_hz or sound.samples.shape[1] > low.coding.most_channels:
            with pytest.raises(RenderRefused, match=r"never recorded|holds"):
                render_master(master, low, out, true_peak_limit_dbtp=-1.0)
            continue
        rendered = render_master(master, low, out, true_peak_limit_dbtp=-1.0)
        assert rendered.measurements["true_peak_dbtp"] <= -0.95
        assert len(samples_of(rendered.path)[0]) == rendered.frames


def test_pages_of_long_comments_go_on_and_are_numbered_again(tmp_path):
    """Comments longer than one page, so that the codec's own header has to move; a decoder reads the same sound."""
    samples = noise(seconds=0.3, dbfs=-20)[:, 0]
    for encoding, subtype in (("vorbis", "VORBIS"), ("opus", "OPUS")):
        soundfile.write(tmp_path / "a.ogg", samples, 48_000, format="OGG", subtype=subtype)
        out = io.BytesIO()
        text = "long " * 30_000
        with (tmp_path / "a.ogg").open("rb") as source:
            rewrite_ogg(source, out, encoding=encoding, serial=7, comments=[marked_comment("3"), ("TITLE", text)])
        (tmp_path / "b.ogg").write_bytes(out.getvalue())
        with soundfile.SoundFile(tmp_path / "b.ogg") as sound:
            assert (sound.title, sound.comment) == (text, "SOUNDLIST:PLACEHOLDER 3")
            assert np.array_equal(sound.read(), samples_of(tmp_path / "a.ogg")[0][:, 0])
        pages = out.getvalue().split(b"OggS")[1:]
        assert [int.from_bytes(page[14:18], "little") for page in pages] == list(range(len(pages)))
        assert {page[10:14] for page in pages} == {b"\x07\0\0\0"}
