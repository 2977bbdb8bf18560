"""Placeholders keep to the spec like the sounds that they replace, are marked, and harm no sound."""

import stat
import sys

import numpy as np
import pytest

from audio_checks import RenderRefused, check_file, is_placeholder, make_placeholders, new_spec, parse_spec, wav
from audio_checks.cli import main
from audio_checks.placeholders import speech
from audio_checks.placeholders.pattern import pattern
from audio_checks.spec.delivery_spec import CueFacts
from audio_checks.spec.sound_list import SoundList, read_sound_list
from tests.support.waves import noise, write_wav

SPEC = parse_spec(new_spec("44k1"))
LIST = """\
number,name,file_name,category,duration_s,loop,variations,state
SW-001,Shield up,shield_up,weapon,0.8,no,1,locked
SW-002,Footstep gravel,footstep_gravel,foley,0.2,no,3,locked
SW-003,Cave drip,,ambience,4,yes,1,locked
SW-004,Welcome,vo_welcome,vo,,no,1,concept
SW-005,Gone,gone,ui,1,no,1,cut
"""


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def made(tmp_path, text=LIST, spec=SPEC, **more):
    return list(make_placeholders(read_sound_list(text), spec, tmp_path, voice=False, **more))


class TestToSpec:
    @pytest.mark.parametrize("target", [None, "game", "handheld"])
    def test_they_conform_except_for_being_placeholders(self, tmp_path, target):
        cues = read_sound_list(LIST)
        for one in made(tmp_path, target=target):
            cue, variation = cues.slot_of_file(one.path.name)
            assert (cue.number, variation) == (one.number, one.variation)
            entry = check_file(one.path, SPEC, target=target, cue=cue)
            findings = [(found.severity, found.code) for found in entry.findings]
            assert findings == [("error" if target else "warning", "placeholder:marked")]
            assert one.number in entry.findings[0].message

    def test_a_cue_gets_its_length_and_every_variation_its_file(self, tmp_path):
        found = {one.path.name: one.duration_s for one in made(tmp_path)}
        assert found == {
            "shield_up.wav": 0.8,
            **{f"footstep_gravel_0{place}.wav": 0.2 for place in (1, 2, 3)},
            "cave_drip.wav": 4.0,
            "vo_welcome.wav": 1.0,
        }

    def test_loudness_and_peaks_are_held(self, tmp_path):
        held = parse_spec(
            "format = 1\naccept.channels = [2]\naccept.sample_rates_hz = [44100]\naccept.bit_depths = [16]\n"
            "[limits]\nsample_peak_dbfs = -1.0\ntrue_peak_dbtp = -1.0\nloudness_lufs = { min = -16, max = -14 }\n"
        )
        for one in made(tmp_path, spec=held):
            assert check_file(one.path, held, checks=["loudness", "true-peak", "sample-peak"]).findings == ()

    @pytest.mark.parametrize("limit", ["sample_peak_dbfs", "true_peak_dbtp"])
    def test_a_low_limit_of_peaks_is_held_alone(self, tmp_path, limit):
        held = parse_spec(f"format = 1\n[limits]\n{limit} = -20.0\n")
        for one in made(tmp_path, spec=held):
            assert check_file(one.path, held, checks=["true-peak", "sample-peak"]).findings == ()

    @pytest.mark.parametrize(
        ("accept", "facts"),
        [
            ('encodings = ["float"]', ("float", 32, 1)),
            ("bit_depths = [16]", ("pcm", 16, 1)),
            ('layouts = ["5.1"]', ("pcm", 24, 6)),
            ("channels = [2]", ("pcm", 24, 2)),
        ],
    )
    def test_the_form_is_one_that_is_accepted(self, tmp_path, accept, facts):
        spec = parse_spec(f"format = 1\n[accept]\n{accept}")
        (one,) = made(tmp_path, "number,name\n1,door", spec)
        entry = check_file(one.path, spec)
        assert entry.verdict == "conforming"
        assert (entry.facts["encoding"], entry.facts["bit_depth"], entry.facts["channels"]) == facts

    def test_where_no_wav_is_accepted(self, tmp_path):
        (refused,) = made(tmp_path, "number,name\n1,door", parse_spec('format = 1\naccept.containers = ["flac"]'))
        assert isinstance(refused, RenderRefused)
        assert refused.code == "placeholder:container"


class TestOfAKind:
    @pytest.mark.slow
    def test_the_same_each_time_and_left_where_nothing_changed(self, tmp_path):
        first = made(tmp_path)
        stamps = [one.path.stat().st_mtime_ns for one in first]
        again = made(tmp_path)
        assert [one.is_new for one in first] == [True] * 6
        assert [one.is_new for one in again] == [False] * 6
        assert [one.path.stat().st_mtime_ns for one in again] == stamps

    @pytest.mark.slow
    def test_cues_and_variations_are_distinguished(self):
        sounds = [pattern(f"SW-{number:03}", 1, 9_600, 16_000) for number in range(60)]
        sounds += [pattern("SW-000", variation, 9_600, 16_000) for variation in (2, 3, 4)]
        prints = [tuple(np.argmax(np.abs(np.fft.rfft(part))) for part in np.split(sound, 4)) for sound in sounds]
        assert len(set(prints)) == 63  # of these; two cues in a large list may sound alike
        notes = prints[0] * 2
        assert prints[60:] == [notes[begin : begin + 4] for begin in (1, 2, 3)]  # each begins one note later

    def test_it_begins_and_ends_in_silence(self):
        for frames in (100, 4_800, 7_001, 48_000):
            sound = pattern("SW-014", 1, frames, 48_000)
            assert np.abs(sound).max() <= 1.0
            assert abs(sound[0]) < 0.01
            assert abs(sound[-1]) < 0.01
            assert np.abs(sound).max() > 0.2

    def test_one_frame(self):
        assert pattern("SW-014", 1, 1, 48_000).shape == (1,)


class TestNoHarm:
    def test_a_cue_with_a_take_needs_none(self, tmp_path):
        found = made(tmp_path, taken={"shield_up", "footstep_gravel_02"})
        assert [one.path.stem for one in found] == [
            "footstep_gravel_01",
            "footstep_gravel_03",
            "cave_drip",
            "vo_welcome",
        ]

    def test_a_sound_is_never_overwritten(self, tmp_path):
        real = write_wav(tmp_path / "shield_up.wav", noise(seconds=0.1))
        before = real.read_bytes()
        found = made(tmp_path)
        assert [one.code for one in found if isinstance(one, RenderRefused)] == ["placeholder:over-sound"]
        assert len(found) == 6
        assert real.read_bytes() == before
        assert sorted(path.suffix for path in tmp_path.iterdir()) == [".wav"] * 6

    def test_a_cue_without_a_name(self, tmp_path):
        found = list(make_placeholders(SoundList((CueFacts("SW-1"),)), SPEC, tmp_path, voice=False))
        assert [one.code for one in found] == ["placeholder:no-name"]


ENGINE = """#!{python} -S
import math, sys, wave
words, speed = sys.stdin.read(), int(sys.argv[sys.argv.index("-s") + 1])
assert words.strip(), "nothing to say"
{more}
tone = [round(16000 * math.sin(2 * math.pi * 500 * n / 22050)) for n in range(round(6615 * 170 / speed))]
said = [0] * 2205 + tone + [0] * 22050
with wave.open(sys.argv[sys.argv.index("-w") + 1], "wb") as file:
    file.setnchannels(1)
    file.setsampwidth(2)
    file.setframerate(22050)
    file.writeframes(b"".join(one.to_bytes(2, "little", signed=True) for one in said))
"""


@pytest.fixture
def engine(tmp_path, monkeypatch):
    def install(more=""):
        folder = tmp_path / "bin"
        folder.mkdir()
        program = folder / "espeak-ng"
        program.write_text(ENGINE.format(python=sys.executable, more=more))
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv("PATH", str(folder))

    return install


class TestSpeech:
    def test_the_word_without_its_silence_at_the_rate_wanted(self, engine):
        engine()
        sound = speech.synthesize_speech("Shield up", 48_000, None)
        assert len(sound) == pytest.approx(0.3 * 48_000, abs=48)
        peak_hz = np.argmax(np.abs(np.fft.rfft(sound))) * 48_000 / len(sound)
        assert peak_hz == pytest.approx(500, abs=4)
        assert np.abs(sound).max() == pytest.approx(1.0, abs=0.05)

    def test_faster_where_it_must_be_short_and_not_at_all_where_it_cannot(self, engine):
        engine()
        assert len(speech.synthesize_speech("Shield up", 48_000, 10_000)) == pytest.approx(0.17 * 48_000, abs=48)
        assert speech.synthesize_speech("Shield up", 48_000, 4_000) is None

    @pytest.mark.parametrize(
        "more", ["sys.exit(1)", "open(sys.argv[4], 'w').write('no sound'); sys.exit()", "sys.exit()"]
    )
    def test_an_engine_that_fails_is_as_good_as_none(self, engine, more):
        engine(more)
        assert speech.synthesize_speech("Shield up", 48_000, None) is None

    def test_an_engine_that_hangs_is_ended(self, engine, monkeypatch):
        engine("import time; time.sleep(30)")
        monkeypatch.setattr(speech, "TIMEOUT_S", 0.5)
        assert speech.synthesize_speech("Shield up", 48_000, None) is None

    def test_none_installed(self, tmp_path, monkeypatch):
        monkeypatch.setenv("PATH", str(tmp_path))
        assert speech.synthesize_speech("Shield up", 48_000, None) is None

    @pytest.mark.slow
    def test_spoken_placeholders_conform_too(self, tmp_path, engine):
        engine()
        cues = read_sound_list(LIST)
        found = list(make_placeholders(cues, SPEC, tmp_path / "out", target="game"))
        assert [one.is_spoken for one in found] == [True, True, True, True, True, True]
        for one in found:
            entry = check_file(one.path, SPEC, target="game", cue=cues.slot_of_file(one.path.name)[0])
            errors = [finding.code for finding in entry.findings if finding.severity == "error"]
            assert errors == ["placeholder:marked"]

    @pytest.mark.skipif(speech.engine() is None, reason="no espeak-ng is installed")
    def test_the_real_engine(self):
        sound = speech.synthesize_speech("Shield up", 44_100, None)
        assert 0.2 < len(sound) / 44_100 < 3.0


class TestCommand:
    @pytest.fixture(autouse=True)
    def folder(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        (tmp_path / "sounds.csv").write_text(LIST)
        (tmp_path / "spec.toml").write_text(new_spec("44k1"))
        return tmp_path

    ASKED = ("placeholders", "--list", "sounds.csv", "--spec", "spec.toml", "--no-voice", "--out", "out")

    @pytest.mark.slow
    def test_all_then_what_is_missing(self, folder, capsys):
        (folder / "takes").mkdir()
        write_wav(folder / "takes" / "shield_up__alt2.wav", noise())
        assert main([*self.ASKED, "--target", "game", "--target", "handheld", "takes"]) == 0
        out = capsys.readouterr().out
        assert sorted(path.parent.name for path in (folder / "out").rglob("*.wav")) == ["game"] * 5 + ["handheld"] * 5
        assert "SW-004 -> out/handheld/vo_welcome.wav: a pattern, 1.000 s" in out
        assert out.splitlines()[-1] == "10 placeholders; 1 take needs none"
        assert is_placeholder(folder / "out" / "game" / "vo_welcome.wav")

    @pytest.mark.slow
    def test_a_placeholder_is_not_a_take(self, capsys):
        assert main([*self.ASKED]) == 0
        assert main([*self.ASKED, "out"]) == 0
        assert capsys.readouterr().out.splitlines()[-1] == "6 placeholders; 0 takes need none"

    def test_what_is_refused_and_a_wrong_target(self, folder, capsys):
        (folder / "out").mkdir()
        write_wav(folder / "out" / "shield_up.wav", noise())
        assert main([*self.ASKED]) == 1
        assert "refused: out/shield_up.wav is not a placeholder" in capsys.readouterr().out
        assert main([*self.ASKED, "--target", "trailer"]) == 2
        assert "targets of the spec: game, handheld" in capsys.readouterr().err
