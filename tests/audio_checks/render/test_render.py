"""From a master's bytes to a game file's: rate, depth, peaks, loops, and nothing of who made it."""

import hashlib
from dataclasses import replace

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.render.render import render_master
from audio_checks.render.work import RENDERER_VERSION
from audio_checks.spec.delivery_spec import Target
from tests.support import waves

PC = Target("pc", 44_100, 16)
HANDHELD = Target("handheld", 22_050, 16, channels=1)


def layout_of(path):
    with wav.open_regular(path) as file:
        return wav.read_layout(file)


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def level_db(samples, hz, rate):
    """Level of a tone's crest, by its correlation over whole periods."""
    turns = np.exp(-2j * np.pi * hz * np.arange(len(samples)) / rate)
    return 20 * np.log10(2 * abs(np.mean(samples * turns)))


@pytest.fixture
def out(tmp_path):
    return tmp_path / "game.wav"


class TestFormat:
    @pytest.mark.parametrize(
        ("rate", "bits", "channels", "target"),
        [
            (96_000, 24, 1, PC),
            (96_000, 24, 2, HANDHELD),
            (44_100, 16, 1, PC),
            (48_000, 24, 2, Target("film", 48_000, 24)),
            (48_000, 24, 1, Target("old", 11_025, 8)),
            (88_200, 24, 1, Target("tool", 44_100, 32, encoding="float")),
            (48_000, 24, 1, Target("wide", 32_000, 16, channels=2)),
        ],
    )
    def test_the_file_is_what_the_target_asks_for(self, tmp_path, out, rate, bits, channels, target):
        master = waves.write_wav(
            tmp_path / "laser.wav", waves.sine(hz=441, seconds=0.3, rate=rate, channels=channels), rate=rate, bits=bits
        )
        rendered = render_master(master, target, out)
        layout = layout_of(out)
        assert (layout.sample_rate_hz, layout.bit_depth, layout.encoding) == (
            target.sample_rate_hz,
            target.bit_depth,
            target.encoding,
        )
        assert layout.channels == (channels if target.channels == "master" else target.channels)
        assert layout.frames == rendered.frames == -(-round(0.3 * rate) * target.sample_rate_hz // rate)
        assert layout.warnings == ()
        assert rendered.sha256 == hashlib.sha256(out.read_bytes()).hexdigest()
        data = out.read_bytes()[layout.data_offset :][: layout.data_size]
        assert rendered.pcm_sha256 == hashlib.sha256(data).hexdigest()
        assert rendered.master_sha256 == hashlib.sha256(master.read_bytes()).hexdigest()
        assert rendered.renderer_version == RENDERER_VERSION

    @pytest.mark.slow
    def test_a_quiet_tone_keeps_its_level(self, tmp_path, out):
        # Over ten seconds the dither itself moves the reading by 0.003 dB.
        tone = waves.sine(hz=1_000, dbfs=-80, seconds=11, rate=96_000)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=96_000)
        render_master(master, PC, out)
        middle = samples_of(out)[22_050:463_050, 0]
        assert level_db(middle, 1_000, 44_100) == pytest.approx(-80, abs=0.01)

    def test_rendered_twice_the_bytes_are_the_same(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.5, channels=2), rate=96_000)
        first = render_master(master, PC, out)
        again = render_master(master, PC, tmp_path / "again.wav")
        assert out.read_bytes() == (tmp_path / "again.wav").read_bytes()
        assert first == replace(again, path=out)

    def test_the_master_is_left_alone(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1))
        before = master.read_bytes()
        render_master(master, HANDHELD, out)
        assert master.read_bytes() == before
        assert sorted(path.name for path in tmp_path.iterdir()) == ["a.wav", "game.wav"]

    @pytest.mark.parametrize("channels", [1, 2])
    @pytest.mark.parametrize("target", [PC, HANDHELD, Target("old", 11_025, 8)])
    def test_silence_stays_silent_and_one_frame_stays_one(self, tmp_path, out, channels, target):
        silence = waves.silence(seconds=0.2, rate=96_000, channels=channels)
        quiet = waves.write_wav(tmp_path / "quiet.wav", silence, rate=96_000)
        rendered = render_master(quiet, target, out)
        assert not samples_of(out).any()
        assert rendered.measurements["sample_peak_dbfs"] == -np.inf
        assert rendered.to_dict()["measurements"]["sample_peak_dbfs"] is None
        short = waves.write_wav(tmp_path / "short.wav", np.full((1, channels), 0.25), rate=96_000)
        assert render_master(short, target, out).frames == 1

    def test_what_names_its_author_stays_behind(self, tmp_path, out):
        reported = [
            waves.chunk(b"bext", b"Secret Studio".ljust(602, b"\0")),
            waves.chunk(b"iXML", b"<BWFXML><PROJECT>Shield Wing</PROJECT></BWFXML>"),
            waves.chunk(b"LIST", b"INFO" + waves.chunk(b"IART", b"Somebody\0")),
        ]
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1), before=reported[:1], after=reported[1:])
        render_master(master, PC, out)
        assert [chunk.id for chunk in layout_of(out).chunks] == ["fmt ", "data"]
        assert not any(word in out.read_bytes() for word in (b"Secret", b"Shield", b"Somebody"))


class TestDepth:
    def test_samples_that_need_no_change_are_the_masters_own(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(rate=44_100, channels=2), rate=44_100, bits=16)
        rendered = render_master(master, PC, out)
        assert np.array_equal(samples_of(out), samples_of(master))
        assert (rendered.recalculated, rendered.dither) == (False, "none")

    def test_depth_does_not_rise_by_padding(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(rate=44_100), rate=44_100, bits=16)
        assert render_master(master, Target("deep", 44_100, 24), out).bit_depth == 16
        assert layout_of(out).bit_depth == 16

    def test_depth_rises_where_samples_were_recalculated(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(rate=96_000), rate=96_000, bits=16)
        rendered = render_master(master, Target("deep", 48_000, 24), out)
        assert (rendered.bit_depth, rendered.dither, rendered.recalculated) == (24, "none", True)
        steps = samples_of(out) * 2**15
        assert np.abs(steps - np.rint(steps)).max() > 0.4

    def test_fewer_bits_at_the_same_rate_are_dithered(self, tmp_path, out):
        tone = waves.sine(hz=997, dbfs=-20, seconds=4, rate=44_100)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=44_100, bits=24)
        assert render_master(master, PC, out).dither == "tpdf"
        error = samples_of(out) - samples_of(master)
        assert 10 * np.log10(np.mean(error**2)) == pytest.approx(-96.33, abs=0.1)

    def test_shaped_dither_below_44100_is_refused(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1))
        with pytest.raises(RenderRefused) as refused:
            render_master(master, replace(HANDHELD, dither="shaped"), out)
        assert refused.value.code == "render:shaped-too-low"


class TestRefusals:
    @pytest.mark.parametrize("rate", [22_050, 44_099])
    def test_upwards(self, tmp_path, out, rate):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1, rate=rate), rate=rate)
        with pytest.raises(RenderRefused) as refused:
            render_master(master, PC, out)
        assert refused.value.code == "render:upwards"
        assert str(rate) in str(refused.value)
        assert "44100" in refused.value.fix
        assert not out.exists()

    def test_six_channels_to_two(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1, channels=6))
        with pytest.raises(RenderRefused) as refused:
            render_master(master, replace(PC, channels=2), out)
        assert refused.value.code == "render:channels"

    def test_no_wav_file(self, tmp_path, out):
        (tmp_path / "a.wav").write_bytes(b"ID3\x04 an MP3 by another name")
        with pytest.raises(Unreadable):
            render_master(tmp_path / "a.wav", PC, out)
        assert [path.name for path in tmp_path.iterdir()] == ["a.wav"]


class TestPeaks:
    @pytest.fixture
    def square(self, tmp_path):
        # Its first overtones alone overshoot the flat tops: Gibbs's 9 % of the jump, 1.4 dB over full scale.
        return waves.write_wav(
            tmp_path / "square.wav", np.where(waves.sine(hz=1_500, rate=96_000) >= 0, 0.999, -0.999), rate=96_000
        )

    @pytest.mark.parametrize("target", [replace(HANDHELD, bit_depth=bits) for bits in (8, 16, 24)])
    def test_full_scale_is_never_clipped_silently(self, square, out, target):
        rendered = render_master(square, target, out)
        assert 0.5 < rendered.attenuation_db < 2.5
        peak = np.abs(samples_of(out)).max()
        assert peak == pytest.approx(1.0, abs=2.0 / 2 ** (target.bit_depth - 1) + 1e-6)
        flat = np.count_nonzero(np.abs(samples_of(out)) == peak)
        assert flat < 0.2 * rendered.frames

    def test_attenuated_by_exactly_the_excess(self, tmp_path, out):
        # A tone at a quarter of the rate, 45° off: its crests lie 3.01 dB above its samples. An 8x meter
        # may read it up to 0.05 dB off.
        tone = waves.sine(hz=12_000, dbfs=0.4, phase=np.pi / 4, rate=48_000)
        times = np.arange(len(tone))[:, np.newaxis] / 48_000
        tone *= np.clip(times / 0.1, 0, 1) * np.clip((1 - times) / 0.1, 0, 1)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=48_000)
        rendered = render_master(master, Target("film", 48_000, 24), out, true_peak_limit_dbtp=-1.0)
        assert rendered.attenuation_db == pytest.approx(1.4, abs=0.05)
        assert rendered.measurements["true_peak_dbtp"] == pytest.approx(-1.0, abs=0.001)
        assert level_db(samples_of(out)[12_000:36_000, 0], 12_000, 48_000) == pytest.approx(
            0.4 - rendered.attenuation_db, abs=0.001
        )

    def test_a_sample_peak_limit(self, tmp_path, out):
        tone = waves.sine(hz=441, dbfs=-0.2, seconds=0.5, rate=44_100)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=44_100, bits=16)
        rendered = render_master(master, PC, out, sample_peak_limit_dbfs=-3.0)
        assert rendered.attenuation_db == pytest.approx(2.8, abs=0.001)
        assert rendered.recalculated
        assert rendered.measurements["sample_peak_dbfs"] == pytest.approx(-3.0, abs=0.001)

    @pytest.mark.parametrize(("dbfs", "touched"), [(-0.96, False), (-0.94, True)])
    def test_what_a_check_lets_pass_is_not_touched(self, tmp_path, out, dbfs, touched):
        tone = waves.sine(hz=100, dbfs=dbfs, seconds=0.5, rate=44_100)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=44_100, bits=16)
        rendered = render_master(master, PC, out, sample_peak_limit_dbfs=-1.0)
        assert (rendered.attenuation_db > 0) == touched
        assert np.array_equal(samples_of(out), samples_of(master)) != touched

    def test_refused_where_the_target_says_so(self, square, out):
        with pytest.raises(RenderRefused) as refused:
            render_master(square, replace(HANDHELD, over_peak="refuse"), out)
        assert refused.value.code == "render:over-peak"
        assert not out.exists()
        assert [path.name for path in out.parent.iterdir()] == ["square.wav"]


class TestLoops:
    def test_a_whole_loop_has_no_seam(self, tmp_path, out):
        # 441 whole turns in a second: the render must be the same tone, to its very edges.
        tone = waves.sine(hz=441, dbfs=-6, seconds=1, rate=96_000)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=96_000)
        rendered = render_master(master, Target("film", 48_000, 24), out, loop=True)
        wanted = waves.sine(hz=441, dbfs=-6, seconds=1, rate=48_000)
        assert np.abs(samples_of(out) - wanted).max() < 2.0 / 2**23
        assert rendered.loop
        assert rendered.loop_fit_frames == 0
        assert rendered.seam_before.step_db < 0.1
        assert rendered.seam_after.step_db < 0.1

    def test_a_bad_seam_shows_before_and_after(self, tmp_path, out):
        tone = waves.sine(hz=100.5, dbfs=-6, seconds=1, rate=96_000, phase=np.pi / 2)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=96_000)
        rendered = render_master(master, PC, out, loop=True)
        assert rendered.seam_before.step_db > 20
        assert rendered.seam_after.step_db > 0

    def test_a_period_is_fitted_to_whole_frames_and_recorded(self, tmp_path, out):
        loop = waves.noise(dbfs=-20, rate=96_000, seconds=641 / 96_000)
        master = waves.write_wav(tmp_path / "a.wav", loop, rate=96_000)
        rendered = render_master(master, HANDHELD, out, loop=True)
        assert rendered.frames == 147
        assert rendered.loop_fit_frames == pytest.approx(147 - 641 * 22_050 / 96_000)

    def test_loop_points_are_rescaled_and_kept(self, tmp_path, out):
        noise = waves.noise(dbfs=-20, seconds=1, rate=96_000)
        master = waves.write_wav(
            tmp_path / "a.wav", noise, rate=96_000, before=[waves.smpl([(9_601, 86_399)], rate=96_000)]
        )
        rendered = render_master(master, Target("half", 48_000, 24), out)
        layout = layout_of(out)
        assert [(loop.start, loop.end) for loop in layout.loops] == [
            (4_801, 43_200)
        ]  # 4800.5 and the period of 38399.5 round up
        assert rendered.loop_points == ((4_801, 43_200),)
        assert rendered.loop_fit_frames == 0.5
        assert [chunk.id for chunk in layout.chunks] == ["fmt ", "smpl", "data"]
        assert not rendered.loop
        assert rendered.seam_after is not None

    def test_points_around_the_whole_file_make_it_a_loop(self, tmp_path, out):
        tone = waves.sine(hz=441, dbfs=-6, seconds=1, rate=96_000)
        master = waves.write_wav(tmp_path / "a.wav", tone, rate=96_000, before=[waves.smpl([(0, 95_999)], rate=96_000)])
        rendered = render_master(master, Target("film", 48_000, 24), out)
        assert rendered.loop
        assert [(loop.start, loop.end) for loop in layout_of(out).loops] == [(0, 47_999)]
        assert np.abs(samples_of(out) - waves.sine(hz=441, dbfs=-6, seconds=1)).max() < 2.0 / 2**23

    def test_a_sound_that_plays_once_keeps_no_loop(self, tmp_path, out):
        noise = waves.noise(dbfs=-20, seconds=1, rate=96_000)
        master = waves.write_wav(tmp_path / "a.wav", noise, rate=96_000, before=[waves.smpl([(9_601, 86_399)])])
        plain = waves.write_wav(tmp_path / "b.wav", noise, rate=96_000)
        rendered = render_master(master, Target("half", 48_000, 24), out, loop=False)
        layout = layout_of(out)
        assert (layout.loops, [chunk.id for chunk in layout.chunks]) == ((), ["fmt ", "data"])
        assert (rendered.loop_points, rendered.seam_after) == ((), None)
        (warning,) = rendered.warnings
        assert warning.code == "render:loop-dropped"
        once = render_master(plain, Target("half", 48_000, 24), tmp_path / "once.wav", loop=False)
        assert (once.pcm_sha256, once.warnings) == (rendered.pcm_sha256, ())

    def test_the_note_of_a_sound_that_plays_once_stays(self, tmp_path, out):
        sampler = bytearray(waves.smpl([(100, 200)]))
        sampler[8 + 12] = 57  # the note at which it plays at its own pitch
        noise = waves.noise(dbfs=-20, seconds=0.1, rate=96_000)
        master = waves.write_wav(tmp_path / "a.wav", noise, rate=96_000, before=[bytes(sampler)])
        render_master(master, Target("half", 48_000, 24), out, loop=False)
        layout = layout_of(out)
        (kept,) = [chunk for chunk in layout.chunks if chunk.id == "smpl"]
        with wav.open_regular(out) as file:
            payload = wav.chunk_payload(file, kept)
        assert (layout.loops, payload[12]) == ((), 57)

    def test_given_points_replace_the_masters(self, tmp_path, out):
        master = waves.write_wav(tmp_path / "a.wav", waves.noise(dbfs=-20, rate=96_000), rate=96_000)
        rendered = render_master(master, Target("half", 48_000, 16), out, loop_points=(100, 200))
        assert rendered.loop_points == ((50, 100),)  # the last frame ends at 100.5, which rounds up, and is not counted
        assert len(layout_of(out).loops) == 1


@pytest.mark.parametrize("dither", ["tpdf", "shaped"])
@pytest.mark.parametrize(("rate", "channels"), [(96_000, 2), (44_100, 2), (48_000, 4)])
def test_equal_channels_stay_equal(tmp_path, out, rate, channels, dither):
    mono = waves.noise(dbfs=-20, seconds=0.3, rate=rate)
    master = waves.write_wav(tmp_path / "a.wav", np.repeat(mono, channels, axis=1), rate=rate)
    render_master(master, Target("game", 44_100, 16, dither=dither), out)
    made = samples_of(out)
    assert made.shape[1] == channels
    assert all((made[:, 0] == made[:, channel]).all() for channel in range(1, channels))


def test_stereo_to_mono_is_the_mean(tmp_path, out):
    left, right = waves.sine(hz=441, dbfs=-6, rate=44_100), waves.sine(hz=882, dbfs=-12, rate=44_100)
    master = waves.write_wav(tmp_path / "a.wav", np.concatenate([left, right], axis=1), rate=44_100)
    render_master(master, replace(HANDHELD, bit_depth=24), out, loop=True)
    mono = samples_of(out)[:, 0]
    assert level_db(mono, 441, 22_050) == pytest.approx(-12.02, abs=0.01)
    assert level_db(mono, 882, 22_050) == pytest.approx(-18.02, abs=0.01)
