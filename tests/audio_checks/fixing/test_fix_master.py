"""A fixed copy: what its findings ask and no more, judged again, with the master untouched."""

import hashlib
import os
import struct
from pathlib import Path

import numpy as np
import pytest

from audio_checks import CueFacts, DeliverySpec, FixRefused, fix_master, new_spec, parse_spec, wav
from tests.support.waves import (
    chunk,
    extensible,
    fmt,
    join,
    noise,
    pcm_bytes,
    riff,
    silence,
    sine,
    smpl,
    wav_bytes,
    write_wav,
)

SPEC = """
format = 1
[accept]
containers = ["wav"]
encodings = ["pcm"]
sample_rates_hz = [44100, 48000, 96000]
bit_depths = [16, 24]
[limits]
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0
head_silence_ms = 5
tail_silence_ms = 100
silence_below_dbfs = -90.0
[naming]
pattern = '[a-z0-9]+(_[a-z0-9]+)*'
extension = ".wav"
[targets.game]
sample_rate_hz = 44100
bit_depth = 16
"""


def spec(more: str = "", *, without: str = "") -> DeliverySpec:
    lines = [line for line in SPEC.splitlines() if not without or not line.startswith(without)]
    return parse_spec("\n".join(lines) + more)


@pytest.fixture
def out(tmp_path):
    folder = tmp_path / "out"
    folder.mkdir()
    return folder


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def layout_of(path):
    with wav.open_regular(path) as file:
        return wav.read_layout(file)


def kinds(fixed):
    return [repair.kind for repair in fixed.repairs]


def codes_left(fixed):
    return [one.finding.code for one in fixed.left]


class TestGain:
    def test_one_factor_of_exactly_the_excess(self, tmp_path, out):
        master = write_wav(tmp_path / "laser.wav", sine(hz=1_000, dbfs=0.0, seconds=0.2))
        fixed = fix_master(master, spec(without="true_peak"), out)
        assert (fixed.path, fixed.conforms, kinds(fixed)) == (out / "laser.wav", True, ["gain"])
        loud = samples_of(master)
        assert fixed.gain_db == pytest.approx(-0.1 - 20 * np.log10(np.abs(loud).max()), abs=1e-9)
        error = samples_of(fixed.path) - loud * 10 ** (fixed.gain_db / 20)
        assert np.abs(error).max() <= 0.5 / 2**23 + 1e-12
        assert fixed.after.measurements["sample_peak_dbfs"] == pytest.approx(-0.1, abs=1e-5)

    def test_the_true_peak_counts_too(self, tmp_path, out):
        # At a quarter of the sample rate and 45° every sample sits 3.01 dB below the crest.
        tone = sine(hz=12_000, dbfs=0.5, phase=np.pi / 4, seconds=0.2)
        fixed = fix_master(write_wav(tmp_path / "ping.wav", tone), spec(), out)
        assert fixed.gain_db == pytest.approx(-1.5, abs=0.15)
        assert fixed.after.measurements["true_peak_dbtp"] == pytest.approx(-1.0, abs=0.01)
        [repair] = fixed.repairs
        assert repair.words == f"level lowered by {-fixed.gain_db:.2f} dB"
        assert 0 <= repair.start_s < 0.2

    def test_within_the_tolerance_nothing_is_touched(self, tmp_path, out):
        fixed = fix_master(write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=-0.96)), spec(), out)
        assert (fixed.path, fixed.repairs, fixed.conforms) == (None, (), True)
        assert list(out.iterdir()) == []

    def test_at_16_bit_it_is_dithered(self, tmp_path, out):
        tone = join(sine(hz=997, dbfs=0.0, seconds=1.0), silence(seconds=0.05))
        master = write_wav(tmp_path / "laser.wav", tone, bits=16)
        fixed = fix_master(master, spec(), out)
        copy, exact = samples_of(fixed.path), samples_of(master) * 10 ** (fixed.gain_db / 20)
        error = (copy - exact)[:48_000]
        # Theory: 2/12 of a step from TPDF, 1/12 from rounding: −96.33 dBFS. The error has no tone in it.
        assert 20 * np.log10(np.sqrt(np.mean(error**2))) == pytest.approx(-96.33, abs=0.1)
        assert not copy[48_000 + 64 :].any()

    def test_a_quiet_sound_is_raised_only_where_its_peaks_allow(self, tmp_path, out):
        wanted = parse_spec(SPEC.replace("[naming]", "loudness_lufs = { min = -20.0 }\n[naming]"))
        soft = fix_master(write_wav(tmp_path / "soft.wav", sine(hz=997, dbfs=-30.0)), wanted, out)
        # A mono tone's loudness is its RMS, 3.01 dB under its crest: −33.0 LUFS.
        assert (soft.gain_db, soft.conforms) == (pytest.approx(13.0, abs=0.05), True)
        peaky = join(sine(hz=997, dbfs=-40.0), sine(hz=997, dbfs=-1.5, seconds=0.005), sine(hz=997, dbfs=-40.0))
        hard = fix_master(write_wav(tmp_path / "peaky.wav", peaky), wanted, out)
        assert (hard.path, codes_left(hard)) == (None, ["loudness:under"])
        assert "less dynamic range" in hard.left[0].why

    def test_loops_keep_their_points(self, tmp_path, out):
        master = write_wav(tmp_path / "hum.wav", sine(hz=480, dbfs=0.0), after=[smpl([(100, 47_000)])])
        fixed = fix_master(master, spec(), out)
        assert kinds(fixed) == ["gain"]
        assert [(loop.start, loop.end) for loop in layout_of(fixed.path).loops] == [(100, 47_000)]


class TestTrim:
    def test_to_the_limit_and_every_other_sample_stays(self, tmp_path, out):
        sound = join(silence(seconds=0.412), sine(hz=440, dbfs=-6.0, seconds=0.5, phase=1.0), silence(seconds=0.5))
        master = write_wav(tmp_path / "airlock.wav", sound)
        fixed = fix_master(master, spec(), out)
        assert kinds(fixed) == ["head", "tail"]
        assert fixed.cut_frames == (round(0.407 * 48_000), round(0.4 * 48_000))
        assert fixed.fade_frames == (0, 0)  # digital silence does not click
        kept = samples_of(master)[fixed.cut_frames[0] : -fixed.cut_frames[1]]
        assert np.array_equal(samples_of(fixed.path), kept)
        assert fixed.after.measurements["head_silence_ms"] == pytest.approx(5.0)
        head, tail = fixed.repairs
        assert (head.start_s, head.end_s) == (0.0, pytest.approx(0.407))
        assert (tail.start_s, tail.end_s) == (pytest.approx(1.012), pytest.approx(1.412))

    def test_at_44_1_khz_a_limit_between_frames_is_kept(self, tmp_path, out):
        sound = join(silence(seconds=0.1, rate=44_100), sine(hz=440, rate=44_100, phase=1.0))
        fixed = fix_master(write_wav(tmp_path / "laser.wav", sound, rate=44_100), spec(), out)
        assert fixed.cut_frames == (4410 - 220, 0)  # 5 ms are 220.5 frames
        assert fixed.conforms

    def test_a_fade_only_where_the_cut_would_click_and_never_in_the_sound(self, tmp_path, out):
        room = noise(dbfs=-84.0, seconds=0.3)
        sound = join(room, sine(hz=440, dbfs=-6.0, seconds=0.5, phase=1.0), room)
        master = write_wav(tmp_path / "door.wav", sound)
        fixed = fix_master(master, spec(), out)
        cut_head, cut_tail = fixed.cut_frames
        assert (fixed.fade_frames, cut_tail) == ((240, 0), 0)  # 5 ms; what hisses after the sound is no silence
        assert "with a fade of 5.0 ms" in fixed.repairs[0].words
        whole, copy = samples_of(master), samples_of(fixed.path)
        kept = whole[cut_head : len(whole) - cut_tail]
        assert np.array_equal(copy[240:], kept[240:])
        assert cut_head + 240 <= round(0.3 * 48_000)
        assert np.abs(copy[0]) < np.abs(kept[0]) / 1000 + 2**-23
        assert (np.abs(copy[:240]) <= np.abs(kept[:240]) + 2**-23).all()

    def test_a_limit_of_nothing_leaves_no_room_for_a_fade(self, tmp_path, out):
        sound = join(noise(dbfs=-84.0, seconds=0.1), sine(hz=440, dbfs=-6.0, seconds=0.5, phase=1.0))
        wanted = parse_spec(SPEC.replace("head_silence_ms = 5", "head_silence_ms = 0"))
        fixed = fix_master(write_wav(tmp_path / "door.wav", sound), wanted, out)
        assert (fixed.cut_frames[0], fixed.fade_frames) == (4800, (0, 0))
        assert abs(samples_of(fixed.path)[0, 0]) > 0.1

    def test_what_a_lower_level_makes_silent_is_trimmed_too(self, tmp_path, out):
        # Silence is 60 dB under the peak or −60 dBFS, whichever is lower: under a peak of +12 dBFS only the
        # second counts, and 13 dB lower the quiet beginning falls below it.
        sound = join(sine(hz=400, dbfs=-52.0, seconds=0.2), sine(hz=440, dbfs=12.0, seconds=0.5, phase=1.0))
        master = write_wav(tmp_path / "boom.wav", sound, encoding="float", bits=32)
        fixed = fix_master(master, spec(), out)
        assert kinds(fixed) == ["head", "gain", "depth"]
        assert fixed.conforms
        assert fixed.after.measurements["head_silence_ms"] <= 5.0

    def test_a_loop_keeps_its_edges(self, tmp_path, out):
        sound = join(silence(seconds=0.2), sine(hz=440, dbfs=-6.0))
        master = write_wav(tmp_path / "hum.wav", sound)
        assert fix_master(master, spec(), out, cue=CueFacts("1", loop=True)).path is None

    def test_silence_is_left_alone(self, tmp_path, out):
        fixed = fix_master(write_wav(tmp_path / "nothing.wav", silence()), spec(), out)
        assert (fixed.path, codes_left(fixed)) == (None, ["silence:file"])

    def test_one_frame_of_sound_survives(self, tmp_path, out):
        sound = silence(seconds=0.6)
        sound[12_000] = 0.5
        fixed = fix_master(write_wav(tmp_path / "tick.wav", sound), spec(), out)
        assert np.abs(samples_of(fixed.path)).max() == 0.5
        assert (len(samples_of(fixed.path)), fixed.conforms) == (240 + 1 + 4800, True)


class TestDepthAndHeader:
    def test_24_to_16_bit_with_dither(self, tmp_path, out):
        wanted = parse_spec(SPEC.replace("[16, 24]", "[16]"))
        master = write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=-20.0))
        fixed = fix_master(master, wanted, out)
        [repair] = fixed.repairs
        assert (repair.kind, repair.words) == ("depth", "from 24 bit to 16 bit, with TPDF dither")
        assert layout_of(fixed.path).bit_depth == 16
        error = samples_of(fixed.path) - samples_of(master)
        assert 20 * np.log10(np.sqrt(np.mean(error**2))) == pytest.approx(-96.33, abs=0.1)

    def test_float_to_24_bit(self, tmp_path, out):
        master = write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=3.0), encoding="float", bits=32)
        fixed = fix_master(master, spec(without="true_peak"), out)
        assert kinds(fixed) == ["gain", "depth"]
        assert (layout_of(fixed.path).bit_depth, layout_of(fixed.path).encoding) == (24, "pcm")
        assert fixed.conforms

    def test_full_scale_is_a_limit_where_the_spec_names_none(self, tmp_path, out):
        wanted = parse_spec("format = 1\n[accept]\nencodings = ['pcm']\nbit_depths = [16]\n")
        master = write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=3.0), encoding="float", bits=32)
        fixed = fix_master(master, wanted, out)
        assert np.abs(samples_of(fixed.path)).max() <= 1.0
        assert fixed.gain_db == pytest.approx(-3.0, abs=0.01)
        assert fixed.conforms

    def test_depth_never_rises(self, tmp_path, out):
        wanted = parse_spec(SPEC.replace("[16, 24]", "[24]"))
        fixed = fix_master(write_wav(tmp_path / "laser.wav", sine(hz=997), bits=16), wanted, out)
        assert (fixed.path, codes_left(fixed)) == (None, ["bit-depth:not-accepted"])
        assert "never raises the depth" in fixed.left[0].why

    def test_bits_that_the_header_denies_are_not_cut_off(self, tmp_path, out):
        sound = pcm_bytes(sine(hz=997, dbfs=0.0, seconds=0.1), 32)
        master = tmp_path / "laser.wav"
        master.write_bytes(riff(chunk(b"fmt ", extensible(container_bits=32, valid_bits=24)), chunk(b"data", sound)))
        with pytest.raises(FixRefused) as refused:
            fix_master(master, spec(), out)
        assert refused.value.code == "fix:valid-bits"
        assert list(out.iterdir()) == []

    def test_24_bits_in_32_stay_what_they_are(self, tmp_path, out):
        loud = sine(hz=997, dbfs=0.0, seconds=0.1)
        whole = np.round(loud * (2**23 - 1)) / 2**23
        master = tmp_path / "laser.wav"
        header = extensible(container_bits=32, valid_bits=24)
        master.write_bytes(riff(chunk(b"fmt ", header), chunk(b"data", pcm_bytes(whole, 32))))
        fixed = fix_master(master, spec(), out)
        assert (fixed.conforms, layout_of(fixed.path).bit_depth) == (True, 24)

    def test_sizes_and_padding(self, tmp_path, out):
        content = wav_bytes(sine(hz=1_000, seconds=0.1)) + bytes(512)
        master = tmp_path / "laser.wav"
        master.write_bytes(content)
        fixed = fix_master(master, spec(), out)
        assert (kinds(fixed), codes_left(fixed)) == (["header"], [])
        assert fixed.path.read_bytes() == content[:-512]

    def test_a_header_left_open_by_a_pipe(self, tmp_path, out):
        sound = pcm_bytes(sine(hz=1_000, dbfs=0.0, seconds=0.1), 24)
        data = b"data" + struct.pack("<I", 0xFFFFFFFF) + sound
        master = tmp_path / "laser.wav"
        master.write_bytes(riff(chunk(b"fmt ", fmt(bits=24)), data, size=0xFFFFFFFF))
        fixed = fix_master(master, spec(), out)
        assert (fixed.before.verdict, fixed.conforms, kinds(fixed)) == ("unreadable", True, ["header", "gain"])
        assert layout_of(fixed.path).frames == 4800

    def test_rf64_is_written_as_wav(self, tmp_path, out):
        sound = pcm_bytes(sine(hz=997, seconds=0.1), 24)
        ds64 = chunk(b"ds64", struct.pack("<QQQI", 4 + 36 + 24 + 8 + len(sound), len(sound), 4800, 0))
        body = b"data\xff\xff\xff\xff" + sound
        master = tmp_path / "laser.wav"
        master.write_bytes(riff(ds64, chunk(b"fmt ", fmt(bits=24)), body, magic=b"RF64", size=0xFFFFFFFF))
        fixed = fix_master(master, spec(), out)
        assert (kinds(fixed), fixed.conforms, layout_of(fixed.path).container) == (["header"], True, "wav")

    def test_sound_that_is_missing_is_not_made_up(self, tmp_path, out):
        master = tmp_path / "laser.wav"
        master.write_bytes(wav_bytes(sine(hz=997, seconds=0.1))[:-100])
        fixed = fix_master(master, spec(), out)
        assert (fixed.path, codes_left(fixed)) == (None, ["structure:truncated"])
        assert "missing from the file" in fixed.left[0].why


class TestWhole:
    def test_the_name_is_put_right(self, tmp_path, out):
        master = write_wav(tmp_path / "Airlock Cycle_altB.WAV", sine(hz=440))
        fixed = fix_master(master, spec(), out)
        assert (fixed.name, kinds(fixed)) == ("airlock_cycle__alt2.wav", ["name"])
        assert fixed.path.read_bytes() == master.read_bytes()

    def test_what_is_left_says_why(self, tmp_path, out):
        sound = sine(hz=440, dbfs=0.0, rate=32_000)
        fixed = fix_master(write_wav(tmp_path / "laser.wav", sound, rate=32_000), spec(), out)
        assert (kinds(fixed), fixed.conforms, codes_left(fixed)) == (["gain"], False, ["sample-rate:not-accepted"])
        assert "render" in fixed.left[0].why

    def test_renders_are_judged_by_their_target(self, tmp_path, out):
        sound = sine(hz=440, dbfs=0.0, rate=44_100, seconds=0.2)
        master = write_wav(tmp_path / "laser.wav", sound, rate=44_100, bits=24)
        fixed = fix_master(master, spec(), out, target="game")
        assert (kinds(fixed), fixed.conforms) == (["gain", "depth"], True)
        assert layout_of(fixed.path).bit_depth == 16

    @pytest.mark.slow
    def test_the_same_master_gives_the_same_bytes_and_is_only_read(self, tmp_path, out):
        sound = join(noise(dbfs=-70.0, seconds=0.2), noise(dbfs=-3.0, seconds=0.3, channels=1))
        master = write_wav(tmp_path / "Rain 1.wav", sound, bits=16)
        before = hashlib.sha256(master.read_bytes()).hexdigest()
        first = fix_master(master, spec(), out).path.read_bytes()
        again = tmp_path / "again"
        again.mkdir()
        assert fix_master(master, spec(), again).path.read_bytes() == first
        assert hashlib.sha256(master.read_bytes()).hexdigest() == before
        assert [path.name for path in out.iterdir()] == ["rain_1.wav"]

    def test_a_master_is_never_replaced(self, tmp_path):
        master = write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=0.0))
        content = master.read_bytes()
        with pytest.raises(FixRefused) as refused:
            fix_master(master, spec(), tmp_path)
        assert refused.value.code == "fix:over-master"
        assert (master.read_bytes(), [path.name for path in tmp_path.iterdir()]) == (content, ["laser.wav"])

    def test_a_category_holds_for_the_copy_wherever_it_lies(self, tmp_path, out):
        wanted = parse_spec(
            SPEC + "[files]\n'**/vo/*' = 'vo'\n[categories.vo.limits]\ntrue_peak_dbtp = -3.0\nsample_peak_dbfs = -3.0\n"
        )
        (tmp_path / "vo").mkdir()
        fixed = fix_master(write_wav(tmp_path / "vo" / "line.wav", sine(hz=440, dbfs=-1.5)), wanted, out)
        assert (fixed.gain_db, fixed.conforms) == (pytest.approx(-1.5, abs=0.02), True)
        assert fixed.after.category == "vo"

    def test_it_can_be_written_as_plain_values(self, tmp_path, out):
        reported = fix_master(write_wav(tmp_path / "A b.wav", sine(hz=997, dbfs=0.0)), spec(), out).to_dict()
        assert [one["kind"] for one in reported["repairs"]] == ["gain", "name"]
        assert (reported["conforms"], reported["before"]["verdict"], reported["after"]["verdict"]) == (
            True,
            "rejected",
            "conforming",
        )


@pytest.mark.skipif(not os.environ.get("SOUNDS_DIR"), reason="SOUNDS_DIR names no folder of real sounds")
def test_real_sounds_conform_once_fixed_or_say_why_not(out):
    wanted = parse_spec(new_spec())
    masters = sorted(Path(os.environ["SOUNDS_DIR"]).rglob("*.wav"))[::6]
    assert masters
    for master in masters:
        fixed = fix_master(master, wanted, out)
        assert fixed.conforms or all(one.why for one in fixed.left), master
        if fixed.path is not None:
            first, last = fixed.cut_frames
            whole = samples_of(master)
            assert len(samples_of(fixed.path)) == len(whole) - first - last, master
