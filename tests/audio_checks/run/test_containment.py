"""A figure, a check or a judgement that fails costs its own answer alone, and every report names it."""

import json
from xml.etree import ElementTree as ET

import pytest

from audio_checks import check_file, measure_file
from audio_checks.audio import figures
from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.figures import FIGURES
from audio_checks.checks import all_checks
from audio_checks.cli import main
from audio_checks.measure.faults import DETECTORS
from audio_checks.measure.hum import Hum
from audio_checks.measure.noise_floor import NoiseFloor
from audio_checks.report.findings import FileReport
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from tests.support.waves import join, noise, silence, sine, write_wav

SPEC = parse_spec(new_spec())
LIMITED = parse_spec(new_spec().replace("[naming]", "noise_floor_dbfs = -60.0\n\n[naming]"))
CLASSES = {
    "clicks": "Clicks",
    "dropouts": "Dropouts",
    "repeats": "Repeats",
    "flat_tops": "FlatTops",
    "hum": "Hum",
    "noise_floor": "NoiseFloor",
}
STEPS = [
    (family, step)
    for family in FIGURES
    for step in ("made", "add", "result")
    if not (step == "made" and family in DETECTORS)  # detectors are made together: that has its own test
]
QUIET_START = join(silence(seconds=0.1), sine(hz=997, dbfs=0.0))


@pytest.fixture
def sound(tmp_path):
    return write_wav(tmp_path / "laser.wav", QUIET_START)


def fail(*_, **__):
    raise ValueError("min() arg is an empty sequence")


@pytest.fixture
def without_noise_floor(monkeypatch):
    monkeypatch.setattr(NoiseFloor, "result", fail)


class TestFigures:
    @pytest.mark.parametrize(("family", "step"), STEPS)
    def test_any_family_fails_alone(self, monkeypatch, sound, family, step):
        with AudioFile(sound) as file:
            whole = file.measured()
        if family in DETECTORS:
            monkeypatch.setattr(f"audio_checks.measure.faults.{CLASSES[family]}.{step}", fail)
        elif step == "made":
            monkeypatch.setitem(figures.MAKERS, family, fail)
        else:
            make = figures.MAKERS[family]

            def broken(layout, survey):
                made = make(layout, survey)
                setattr(made, step, fail)
                return made

            monkeypatch.setitem(figures.MAKERS, family, broken)
        with AudioFile(sound) as file:
            measured = file.measured()
            assert file.errors.keys() == set(FIGURES[family])
            with pytest.raises(ValueError, match="empty sequence"):
                file.figure(FIGURES[family][0])
        assert measured.keys() == whole.keys()
        assert all(measured[one] is None for one in FIGURES[family])
        plain = {one: value for one, value in whole.items() if isinstance(value, float | int | str)}
        assert {one: measured[one] for one in plain if one not in FIGURES[family]} == {
            one: value for one, value in plain.items() if one not in FIGURES[family]
        }

    def test_the_rest_is_measured_where_all_detectors_fail(self, monkeypatch, sound):
        monkeypatch.setattr(Hum, "__init__", fail)
        entry = measure_file(sound)
        assert entry.measurements["sample_peak_dbfs"] == pytest.approx(0, abs=0.01)
        assert {one.check for one in entry.unjudged} >= {"click", "dropout", "clipping", "hum", "noise-floor"}
        assert entry.sha256 == check_file(sound).sha256

    def test_every_figure_has_a_check_that_would_be_named(self):
        from audio_checks import judge

        read = {figure for check in all_checks().values() for figure in check.figures}
        read |= {figure for name in judge.names() for figure in judge.figures_of(name)}
        assert all(read & set(figures) for figures in FIGURES.values())

    def test_a_machine_without_memory_is_no_bug_of_a_figure(self, monkeypatch, sound):
        def out_of_memory(*_):
            raise MemoryError

        monkeypatch.setattr(NoiseFloor, "result", out_of_memory)
        with pytest.raises(MemoryError):
            measure_file(sound)


@pytest.mark.usefixtures("without_noise_floor")
class TestReports:
    def test_its_check_is_unjudged_and_the_others_count(self, sound):
        entry = check_file(sound, LIMITED)
        assert entry.verdict == "unjudged"
        codes = [finding.code for finding in entry.findings]
        assert codes[0] == "noise-floor:crashed"
        assert {"sample-peak:over", "head-silence:over"} <= set(codes)
        (unjudged,) = entry.unjudged
        assert (unjudged.check, unjudged.figures) == ("noise-floor", ("noise_floor_dbfs",))
        assert unjudged.message == "ValueError: min() arg is an empty sequence"
        assert FileReport.from_dict(entry.to_dict()).unjudged == entry.unjudged

    def test_a_check_that_nobody_asked_for_leaves_the_verdict(self, sound):
        """The server measures everything, the command line what the checks read: both say the same."""
        mine, everything = check_file(sound, SPEC), check_file(sound, SPEC, all_figures=True)
        assert (mine.verdict, mine.findings) == (everything.verdict, everything.findings)
        assert mine.verdict == "rejected"
        assert [one.check for one in everything.unjudged] == ["noise-floor"]
        assert everything.measurements["noise_floor_dbfs"] is None

    @pytest.fixture
    def written(self, sound, capsys, monkeypatch):
        def written(*arguments):
            monkeypatch.chdir(sound.parent)
            (sound.parent / "spec.toml").write_text(
                new_spec().replace("[naming]", "noise_floor_dbfs = -60.0\n\n[naming]"), encoding="utf-8"
            )
            assert main([*arguments, sound.name]) == 2
            return capsys.readouterr()

        return written

    def test_text(self, written):
        out = written("check", "--spec", "spec.toml").out
        assert "noise-floor:crashed" in out
        assert "sample-peak:over" in out

    def test_json(self, written):
        (entry,) = json.loads(written("check", "--spec", "spec.toml", "--format", "json").out)["files"]
        assert entry["unjudged"] == [
            {
                "check": "noise-floor",
                "figures": ["noise_floor_dbfs"],
                "message": "ValueError: min() arg is an empty sequence",
            }
        ]

    def test_sarif(self, written):
        (run,) = json.loads(written("check", "--spec", "spec.toml", "--format", "sarif").out)["runs"]
        (invocation,) = run["invocations"]
        assert not invocation["executionSuccessful"]
        (note,) = invocation["toolExecutionNotifications"]
        assert "laser.wav: unjudged by noise-floor: " in note["message"]["text"]
        assert "sample-peak:over" in {one["ruleId"] for one in run["results"]}

    def test_junit(self, written):
        document = ET.fromstring(written("check", "--spec", "spec.toml", "--format", "junit").out)  # noqa: S314 - ours
        (error,) = document.iter("error")
        assert error.get("type") == "noise-floor:crashed"

    def test_measure_goes_on_with_the_file_and_with_the_others(self, sound, written):
        write_wav(sound.parent / "second.wav", noise(seconds=0.1))
        said = written("measure", "--format", "json", "second.wav")
        second, first = json.loads(said.out)["files"]
        assert first["measurements"]["noise_floor_dbfs"] is None
        assert first["measurements"]["sample_peak_dbfs"] == pytest.approx(0, abs=0.01)
        assert first["unjudged"][0]["check"] == second["unjudged"][0]["check"] == "noise-floor"
        assert "laser.wav: unjudged by noise-floor: ValueError: min() arg" in said.err

    def test_measure_names_it_in_its_text(self, written):
        out = written("measure").out
        assert "unjudged  noise-floor (noise_floor_dbfs): ValueError: min() arg is an empty sequence" in out


def test_measure_survives_a_file_that_it_fails_on_altogether(tmp_path, monkeypatch, capsys):
    paths = [write_wav(tmp_path / f"laser_{number}.wav", noise(seconds=0.1)) for number in range(3)]
    measured = AudioFile.measured

    def broken(self):
        return fail() if self.name == "laser_1.wav" else measured(self)

    monkeypatch.setattr(AudioFile, "measured", broken)
    assert main(["measure", "--format", "json", *map(str, paths)]) == 2
    entries = json.loads(capsys.readouterr().out)["files"]
    assert ["sample_peak_dbfs" in entry["measurements"] for entry in entries] == [True, False, True]
    assert entries[1]["unjudged"][0]["check"] == "audio-checks"


def test_a_judgement_that_fails_is_named_with_its_check(sound, monkeypatch):
    monkeypatch.setattr("audio_checks.judge.reverb.features_of", lambda _: 1 / 0)
    entry = measure_file(sound)
    assert [one.check for one in entry.unjudged] == ["baked-reverb"]
    assert entry.judgements.keys() == {"lossy", "reversed", "upsampled"}
    server, command_line = check_file(sound, SPEC, all_figures=True), check_file(sound, SPEC)
    assert (server.verdict, server.findings) == (command_line.verdict, command_line.findings)
