"""The runner: which checks are called, what their findings weigh, and whose fault a crash is."""

import io
import os
import signal
import struct
import subprocess
import sys
from types import ModuleType

import pytest

import audio_checks
from audio_checks import check_file, check_files, measure_file, wav
from audio_checks.checks import Check
from audio_checks.errors import SpecError, Unreadable
from audio_checks.report.findings import Finding
from audio_checks.run import runner
from audio_checks.spec.delivery_spec import CueFacts, new_spec, parse_spec
from audio_checks.spec.sound_list import read_sound_list
from tests.support.chunks import bext, info
from tests.support.waves import chunk as wav_chunk
from tests.support.waves import float_bytes, fmt, join, noise, placeholder_mark, riff, silence, sine, smpl, write_wav

SPEC = parse_spec(new_spec())


def codes_of(entry):
    return [(finding.code, finding.severity) for finding in entry.findings]


@pytest.fixture
def laser(tmp_path):
    return write_wav(tmp_path / "laser_fire.wav", sine(hz=997, dbfs=-6))


@pytest.fixture
def hot(tmp_path):
    """A sound whose true peak is too high, with 20 ms of silence before it."""
    return write_wav(tmp_path / "hot.wav", join(silence(seconds=0.02), sine(hz=1_000, dbfs=-0.5)))


class TestVerdict:
    def test_a_right_file_conforms(self, laser):
        entry = check_file(laser, SPEC)
        assert (entry.verdict, entry.findings) == ("conforming", ())
        assert entry.path == str(laser)
        assert entry.facts["sample_rate_hz"] == 48_000
        assert entry.measurements["sample_peak_dbfs"] == pytest.approx(-6.0, abs=0.01)
        assert len(entry.sha256) == len(entry.pcm_sha256) == 64

    def test_warnings_never_change_it(self, hot):
        entry = check_file(hot, SPEC)
        assert entry.verdict == "conforming"
        assert codes_of(entry) == [("true-peak:over", "warning"), ("head-silence:over", "warning")]

    def test_the_category_raises_a_check(self, hot):
        entry = check_file(hot, SPEC, category="vo")
        assert entry.verdict == "rejected"
        assert codes_of(entry) == [("true-peak:over", "error")]  # and a voice may start 50 ms late
        assert entry.category == "vo"

    def test_errors_come_first(self, tmp_path):
        path = write_wav(tmp_path / "Hot one.wav", join(silence(seconds=0.02), sine(hz=1_000, dbfs=-0.5)))
        severities = [finding.severity for finding in check_file(path, SPEC).findings]
        assert severities == ["error", "warning", "warning"]

    def test_a_check_that_is_off_is_not_called(self, hot):
        spec = parse_spec(new_spec().replace('true-peak = "warning"', 'true-peak = "off"', 1))
        assert codes_of(check_file(hot, spec)) == [("head-silence:over", "warning")]

    def test_the_name_as_delivered_counts(self, laser):
        entry = check_file(laser, SPEC, name="Laser Fire.wav")
        assert entry.path == "Laser Fire.wav"
        assert codes_of(entry) == [("naming:pattern", "error")]

    def test_without_a_spec_only_the_structure_is_judged(self, tmp_path):
        path = write_wav(tmp_path / "Bad Name.WAV", noise(dbfs=0.0))
        assert check_file(path).verdict == "conforming"

    def test_a_cue_names_the_category_and_the_loop(self, hot):
        cue = CueFacts("SW-1", category="music", loop=True)
        entry = check_file(hot, SPEC, cue=cue)
        assert entry.category == "music"
        # A loop may start late, but its end goes straight into that silence.
        assert codes_of(entry) == [("true-peak:over", "error"), ("loop-points:bend", "warning")]

    def test_only_some_checks(self, hot):
        assert codes_of(check_file(hot, SPEC, checks=["head-silence"])) == [("head-silence:over", "warning")]
        with pytest.raises(ValueError, match="hiccup"):
            check_file(hot, SPEC, checks=["hiccup"])

    def test_all_figures_or_those_that_are_asked_for(self, laser):
        asked = check_file(laser, parse_spec("format = 1\nlimits.sample_peak_dbfs = -1")).measurements
        assert "sample_peak_dbfs" in asked
        assert "integrated_lufs" not in asked
        assert check_file(laser, all_figures=True).measurements.keys() == measure_file(laser).measurements.keys()


class TestTargets:
    def test_a_master_is_no_render(self, laser):
        entry = check_file(laser, SPEC, target="game")
        assert codes_of(entry) == [("sample-rate:not-accepted", "error"), ("bit-depth:not-accepted", "error")]

    def test_a_render_is(self, tmp_path):
        path = write_wav(tmp_path / "laser.wav", sine(hz=997, rate=22_050), rate=22_050, bits=16)
        assert check_file(path, SPEC, target="handheld").verdict == "conforming"
        assert check_file(path, SPEC).verdict == "rejected"

    def test_a_placeholder_warns_as_a_delivery_and_fails_as_a_render(self, tmp_path):
        tone = sine(hz=997, rate=44_100)
        path = write_wav(tmp_path / "laser.wav", tone, rate=44_100, bits=16, after=[placeholder_mark("SW-1")])
        assert codes_of(check_file(path, SPEC)) == [("placeholder:marked", "warning")]
        assert codes_of(check_file(path, SPEC, target="game")) == [("placeholder:marked", "error")]

    def test_an_unknown_target(self, laser):
        with pytest.raises(SpecError):
            check_file(laser, SPEC, target="pc")


class TestUnreadable:
    def test_garbage(self, tmp_path):
        (tmp_path / "laser.wav").write_bytes(b"ID3\x04\x00" + bytes(1000))
        entry = check_file(tmp_path / "laser.wav", SPEC)
        assert entry.verdict == "unreadable"
        assert [finding.severity for finding in entry.findings] == ["error"]
        assert entry.facts is None
        assert entry.sha256 is None

    def test_samples_that_are_no_numbers(self, tmp_path):
        samples = sine(hz=440)
        samples[-1] = float("nan")
        data = wav_chunk(b"data", float_bytes(samples))
        (tmp_path / "laser.wav").write_bytes(riff(wav_chunk(b"fmt ", fmt(tag=3, bits=32)), data))
        for spec in (None, SPEC):
            entry = check_file(tmp_path / "laser.wav", spec)
            assert entry.verdict == "unreadable"
            assert "not numbers" in entry.findings[0].message

    def test_flac_by_its_own_name_is_only_not_accepted(self, tmp_path):
        for name, verdict in (("laser.flac", "rejected"), ("laser.wav", "unreadable")):
            (tmp_path / name).write_bytes(b"fLaC" + struct.pack(">I", 34) + bytes(34))
            entry = check_file(tmp_path / name, SPEC)
            assert (entry.verdict, entry.findings[0].check) == (verdict, "container")

    def test_what_is_no_file(self, tmp_path):
        os.mkfifo(tmp_path / "pipe.wav")
        (tmp_path / "dangling.wav").symlink_to(tmp_path / "nowhere.wav")
        (tmp_path / "folder.wav").mkdir()
        for name in ("pipe.wav", "dangling.wav", "folder.wav", "missing.wav"):
            assert check_file(tmp_path / name, SPEC).verdict == "unreadable"
        assert check_file("/dev/zero", SPEC).verdict == "unreadable"
        assert check_file("a\0b.wav", SPEC).verdict == "unreadable"

    def test_measuring_says_so_by_its_error(self, tmp_path):
        (tmp_path / "laser.wav").write_bytes(b"")
        with pytest.raises(Unreadable):
            measure_file(tmp_path / "laser.wav")


def broken(error):
    """Return a check that breaks."""
    module = ModuleType("broken")
    module.FIGURES = ()

    def check(file, spec):
        yield Finding("true-peak:over", "found before it broke", "none")
        raise error

    module.check = check
    return Check("true-peak", module)


class TestCrashes:
    @pytest.mark.parametrize("error", [ZeroDivisionError("by zero"), RecursionError(), MemoryError(), OSError("disk")])
    def test_a_check_that_breaks_leaves_the_file_unjudged(self, monkeypatch, laser, error):
        known = dict(runner.all_checks())
        monkeypatch.setattr(runner, "all_checks", lambda: known | {"true-peak": broken(error)})
        entry = check_file(laser, SPEC, name="Bad name.wav")
        assert entry.verdict == "unjudged"
        assert [finding.code for finding in entry.findings] == ["true-peak:crashed", "naming:pattern"]
        assert type(error).__name__ in entry.findings[0].message
        assert "nothing is known to be wrong with the file" in entry.findings[0].message

    def test_so_does_a_figure_that_breaks(self, monkeypatch, laser):
        def crash(self):
            raise FloatingPointError("over")

        monkeypatch.setattr(runner.AudioFile, "_hashed", crash)
        entry = check_file(laser, SPEC)
        assert (entry.verdict, entry.findings[0].code) == ("unjudged", "audio-checks:crashed")

    @pytest.mark.slow
    def test_a_process_that_dies_takes_one_file_with_it(self, monkeypatch, tmp_path):
        paths = [write_wav(tmp_path / f"laser_{number}.wav", sine(hz=997, seconds=0.1)) for number in range(5)]
        monkeypatch.setattr(runner, "_judge_all", judge_all_or_die)
        report = check_files(paths, None, jobs=2)
        assert [entry.verdict for entry in report.files] == ["conforming"] * 3 + ["unjudged"] + ["conforming"]
        assert f"its process ended with code {-signal.SIGKILL}" in report.files[3].findings[0].message


def judge_all_or_die(tasks):
    if any(task.path.endswith("laser_3.wav") for task in tasks):
        os.kill(os.getpid(), signal.SIGKILL)
    return [runner._judge(task) for task in tasks]


class TestManyFiles:
    @pytest.mark.slow
    def test_processes_say_the_same_as_one(self, tmp_path, hot, laser):
        (tmp_path / "broken.wav").write_bytes(b"RIFF")
        paths = [hot, laser, tmp_path / "broken.wav", hot]
        alone = check_files(paths, SPEC)
        assert check_files(paths, SPEC, jobs=2) == alone
        assert [entry.path for entry in alone.files] == [str(path) for path in paths]
        assert alone.summary["unreadable"] == 1
        assert alone.tool_version == audio_checks.TOOL_VERSION
        assert alone.specs[0].sha256 == SPEC.sha256

    def test_the_list_gives_category_and_request_by_name(self, tmp_path):
        sounds = read_sound_list("number,file_name,category,duration_s,variations\n1,laser,vo,3,2\n")
        names = ("laser_02__alt2.wav", "other.wav")
        paths = [write_wav(tmp_path / name, sine(hz=hz, dbfs=-6)) for name, hz in zip(names, (997, 440), strict=True)]
        first, other = check_files(paths, SPEC, sound_list=sounds).files
        assert (first.category, codes_of(first)) == ("vo", [("duration:cue", "warning")])
        assert (other.category, codes_of(other)) == (None, [("naming:unlisted", "warning")])

    def test_category_by_word_then_list_then_glob(self, tmp_path):
        spec = parse_spec(new_spec() + '\n[files]\n"*.wav" = "ambience"\n')
        path = write_wav(tmp_path / "laser.wav", sine(hz=997))
        sounds = read_sound_list("number,file_name,category\n1,laser,music\n")
        assert check_files([path], spec).files[0].category == "ambience"
        assert check_files([path], spec, sound_list=sounds).files[0].category == "music"
        assert check_files([path], spec, sound_list=sounds, category="vo").files[0].category == "vo"

    @pytest.mark.usefixtures("without_lossy")
    def test_missing_checks_are_reported(self, laser):
        spec = parse_spec("format = 1\nchecks.hum = 'warning'\n[categories.vo]\nchecks.lossy = 'warning'")
        assert check_files([laser], spec).not_run == ()
        assert check_files([laser], spec, category="vo").not_run == ("lossy",)


def test_each_byte_is_read_once(monkeypatch, laser):
    read = []
    real = os.open

    def counted(path, *args, **options):
        descriptor = real(path, *args, **options)
        if os.fspath(path) == str(laser):
            read.append(descriptor)
        return descriptor

    monkeypatch.setattr(os, "open", counted)
    check_file(laser, SPEC, all_figures=True)
    assert len(read) == 1


def test_every_byte_of_sound_is_read_once_with_all_checks_on(monkeypatch, tmp_path):
    around = {"before": [bext(originator="Mara Lind")], "after": [info(ICMT="wind"), smpl([(0, 99)])]}
    path = write_wav(tmp_path / "wind_01.wav", noise(seconds=2, channels=2), **around)
    asked = '[metadata]\nrequired = ["bext.Originator", "INFO.ICMT"]\n'
    spec = parse_spec(new_spec().replace("# loudness_lufs", "loudness_lufs") + asked)
    size, reads = path.stat().st_size, []
    real = wav.open_regular

    class Counted(io.FileIO):
        def read(self, count=-1):
            place = self.tell()
            content = super().read(count)
            reads.append((place, len(content)))
            return content

        def readinto(self, room):
            place = self.tell()
            count = super().readinto(room)
            reads.append((place, count))
            return count

    monkeypatch.setattr(wav, "open_regular", lambda opened: real(opened).close() or Counted(opened, "rb"))
    entry = check_file(path, spec, cue=CueFacts("SW-1", variations=2, duration_s=2.0), all_figures=True)
    assert entry.facts["metadata"]["fields"]["INFO.ICMT"] == "wind"
    assert size <= sum(count for _, count in reads) < size + 600  # only headers are seen twice


@pytest.mark.slow
def test_the_base_install_is_enough_and_loads_little():
    # What an import pulls in is seen only by a fresh interpreter.
    script = """
import sys
loaded = len(sys.modules)
from audio_checks import check_file, load_spec, read_sound_list
import audio_checks.cli
print(len(sys.modules) - loaded)
heavy = {"scipy", "librosa", "app", "pydub", "soundfile", "pydantic", "typer", "rich"} & set(sys.modules)
sys.exit(f"imported: {heavy}" if heavy else 0)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) < 350  # 274, of them 86 of numpy; scipy.signal alone would load 833


def test_the_front_door_opens_on_every_name():
    for name in audio_checks.__all__:
        assert getattr(audio_checks, name) is not None
    with pytest.raises(AttributeError):
        audio_checks.hiccup  # noqa: B018
