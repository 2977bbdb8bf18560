"""The formats that machines read: what their readers demand, and hostile names."""

import gzip
import json
import os
import re
import string
from pathlib import Path
from xml.etree import ElementTree as ET

import jsonschema
import pytest

from audio_checks.checks import all_checks
from audio_checks.cli import reporters
from audio_checks.cli.reporters import Style, judged_as
from audio_checks.report.findings import FileReport, Finding, Report, SpecRef
from audio_checks.version import TOOL_VERSION
from tests.support.rooms import hits, in_a_room
from tests.support.waves import silence, sine, write_wav

SCHEMA = Path(__file__).resolve().parents[3] / "frontend/node_modules/@microsoft/jest-sarif/lib/schemas"
GOOD = sine(hz=997, dbfs=-6, seconds=0.2)
LOUD = sine(hz=997, dbfs=0.0, seconds=0.2)
SPEC = ("--spec", "../spec.toml")

OVER = Finding(
    "true-peak:over", "true peak 0.20 dBTP, limit -1.0 dBTP", "lower it", "error", 0.2, -1.0, "dBTP", 1.2, 1.3
)
LATE = Finding("head-silence:over", "9 ms of silence", "trim it", "warning", 9.0, 5.0, "ms", 0.0, 0.009)
BROKEN = Finding("clipping:crashed", "the check itself broke", "report it", "error")
HOSTILE = "a\nb\x1b[31m\x00\u202e<&>\"']]>%25,:|`*_\udcff.wav"


def entry(path="laser.wav", *findings, verdict="rejected", pcm="b" * 64):
    return FileReport(path, verdict, sha256="a" * 64, pcm_sha256=pcm, category="weapon", findings=findings)


def report(*files):
    return Report(files=files, specs=(SpecRef("Shield Wing", "c" * 64),), tool_version="1.2.3")


def sarif(*files):
    document = json.loads(judged_as("sarif", report(*files), Style()))
    (run,) = document["runs"]
    return document, run


def parsed(text):
    return ET.fromstring(text)  # noqa: S314 - it is our own


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for variable in ("GITHUB_WORKSPACE", "GITHUB_STEP_SUMMARY"):
        monkeypatch.delenv(variable, raising=False)


@pytest.fixture(scope="module")
def official():
    """The schema of the standard, as its makers' package for tests brings it."""
    (path,) = SCHEMA.glob("sarif-2.1.0*.json")
    return jsonschema.Draft4Validator(json.loads(path.read_text()))


class TestSarif:
    def test_the_schema_is_the_real_one(self, official):
        assert not official.is_valid({"version": "2.1.0"})
        assert not official.is_valid({"version": "2.1.0", "runs": [{"tool": {"driver": {"name": "x"}}, "extra": 1}]})

    @pytest.mark.parametrize(
        "files",
        [
            (),
            (entry(),),
            (entry("a.wav", OVER, LATE), entry(HOSTILE, OVER)),
            (entry("a.wav", BROKEN, OVER, verdict="unjudged"),),
            (FileReport("broken.wav", "unreadable", findings=(Finding("structure:truncated", "m", "f", "error"),)),),
        ],
    )
    def test_it_is_valid(self, official, files):
        official.validate(sarif(*files)[0])

    def test_so_is_that_of_a_real_run(self, official, folder, run):
        write_wav(folder / "Bad Näme.wav", LOUD)
        (folder / "cut.wav").write_bytes(b"RIFF")
        code, out, _ = run("check", *SPEC, "--format", "sarif", ".")
        document = json.loads(out)
        official.validate(document)
        results = document["runs"][0]["results"]
        assert document["runs"][0]["tool"]["driver"]["version"] == TOOL_VERSION
        assert code == 1
        assert {one["ruleId"] for one in results} >= {"naming:pattern", "sample-peak:over", "structure:truncated"}
        uris = {one["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] for one in results}
        assert uris == {"Bad%20N%C3%A4me.wav", "cut.wav"}

    def test_every_check_can_be_a_rule(self, official):
        findings = [Finding(f"{name}:over", "m", "f", "warning") for name in all_checks()]
        document, run = sarif(entry("a.wav", *findings))
        official.validate(document)
        rules = run["tool"]["driver"]["rules"]
        assert [rule["id"] for rule in rules] == [finding.code for finding in findings]
        assert all(one["ruleIndex"] == place for place, one in enumerate(run["results"]))
        assert all(rule["help"]["markdown"] and rule["fullDescription"]["text"] for rule in rules)
        assert all(len(rule["properties"]["tags"]) <= 20 and len(rule["id"]) <= 255 for rule in rules)

    def test_a_result_is_known_again_by_its_sound(self):
        def marks(*files):
            return [one["partialFingerprints"]["primaryLocationLineHash"] for one in sarif(*files)[1]["results"]]

        (before,) = marks(entry("laser.wav", OVER))
        assert re.fullmatch(r"[0-9a-f]{16}:1", before)
        assert marks(entry("moved/laser_2.wav", OVER)) == [before]
        assert marks(entry("laser.wav", OVER, pcm="d" * 64)) != [before]
        assert marks(entry("laser.wav", LATE)) != [before]
        twice = marks(entry("a.wav", OVER), entry("b.wav", OVER))
        assert twice == [before, before.replace(":1", ":2")]  # unique within a run, as code scanning wants

    def test_what_does_not_change_gives_the_same_bytes(self):
        files = (entry("a.wav", OVER, LATE), entry("b.wav", LATE))
        assert judged_as("sarif", report(*files), Style()) == judged_as("sarif", report(*files), Style())

    @pytest.mark.slow
    def test_the_limits_of_github(self):
        many = [entry(f"a/{n}.wav", LATE, OVER, pcm=f"{n:064x}") for n in range(12_600)]
        text = judged_as("sarif", report(*many), Style())
        run = json.loads(text)["runs"][0]
        levels = [one["level"] for one in run["results"]]
        assert len(levels) == 25_000
        assert levels[:12_600] == ["error"] * 12_600  # GitHub shows the first 5,000
        assert len(gzip.compress(text.encode())) < 10 << 20
        (note,) = run["invocations"][0]["toolExecutionNotifications"]
        assert "200 milder findings" in note["message"]["text"]

    def test_waived_and_broken(self):
        waived = Finding("true-peak:over", "m", "f", "error", waived=True)
        _, run = sarif(entry("a.wav", waived), entry("b.wav", BROKEN, verdict="unjudged"))
        (result,) = run["results"]
        assert result["suppressions"][0]["kind"] == "external"
        (invocation,) = run["invocations"]
        assert not invocation["executionSuccessful"]
        assert "b.wav" in invocation["toolExecutionNotifications"][0]["message"]["text"]


class TestJunit:
    def test_cases(self):
        text = judged_as(
            "junit",
            report(
                entry("good.wav", verdict="conforming"),
                entry("late.wav", LATE, verdict="conforming"),
                entry("loud.wav", OVER, LATE),
                entry("crash.wav", BROKEN, verdict="unjudged"),
            ),
            Style(),
        )
        root = parsed(text)
        assert {key: root.get(key) for key in ("tests", "failures", "errors")} == {
            "tests": "4",
            "failures": "1",
            "errors": "1",
        }
        cases = {case.get("name"): case for case in root.iter("testcase")}
        assert [child.tag for child in cases["good.wav"]] == []
        assert [child.tag for child in cases["late.wav"]] == ["system-out"]
        assert [child.tag for child in cases["loud.wav"]] == ["failure", "system-out"]
        assert [child.tag for child in cases["crash.wav"]] == ["error"]
        failure = cases["loud.wav"].find("failure")
        assert failure.get("type") == "true-peak:over"
        assert "limit -1.0 dBTP, at 1.200 to 1.300 s; fix: lower it" in failure.text

    def test_warnings_fail_where_they_are_asked_to(self):
        text = judged_as("junit", report(entry("late.wav", LATE, verdict="conforming")), Style(fail_level="warning"))
        assert parsed(text).get("failures") == "1"

    def test_what_is_waived_fails_nothing(self):
        waived = Finding("true-peak:over", "m", "f", "error", waived=True)
        root = parsed(judged_as("junit", report(entry("a.wav", waived)), Style()))
        assert root.get("failures") == "0"
        assert "waived" in root.find(".//system-out").text

    def test_names_from_strangers_are_well_formed(self):
        root = parsed(judged_as("junit", report(entry(HOSTILE, OVER)), Style()).encode("utf-8"))
        assert root.find(".//testcase").get("name").startswith("a\\nb\\x1b[31m\\x00\\u202e<&>")


class TestGithub:
    def commands(self, *files):
        return judged_as("github", report(*files), Style()).splitlines()

    def test_one_annotation_a_file_its_worst_first(self):
        both = entry("assets/a, b.wav", LATE, OVER)
        (line,) = self.commands(both, entry("good.wav", verdict="conforming"))
        assert line == (
            "::error file=assets/a%2C b.wav,title=true-peak%3Aover in a%2C b.wav::"
            "true peak 0.20 dBTP, limit -1.0 dBTP, at 1.200 to 1.300 s; fix: lower it (1 more in the summary)"
        )

    def test_no_more_than_github_shows(self):
        loud = [entry(f"loud_{n}.wav", OVER) for n in range(13)]
        late = [entry(f"late_{n}.wav", LATE) for n in range(12)]
        lines = self.commands(*loud, *late)
        assert [line.split(" ")[0] for line in lines] == ["::error"] * 10 + ["::warning"] * 10 + ["::notice"]
        assert "5 more files in the summary" in lines[-1]

    def test_paths_are_those_of_the_workspace(self, tmp_path, monkeypatch):
        (tmp_path / "game").mkdir()
        monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path))
        monkeypatch.chdir(tmp_path / "game")
        assert "file=game/a.wav," in self.commands(entry("./a.wav", OVER))[0]
        assert "file=b.wav," in self.commands(entry("../b.wav", OVER))[0]

    def test_nothing_can_break_out_of_its_line(self):
        lines = self.commands(entry(HOSTILE, Finding("naming:pattern", HOSTILE, HOSTILE, "error")))
        assert len(lines) == 1
        assert set(lines[0]) <= set(string.printable) - set("\r\n\x0b\x0c\x00")

    def test_the_summary_of_the_job(self, tmp_path, monkeypatch):
        monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(tmp_path / "summary.md"))
        (tmp_path / "summary.md").write_text("before\n")
        waived = Finding("dc-offset:over", "m", "f", "error", waived=True)
        self.commands(entry("a_b|c.wav", LATE, OVER), entry("old.wav", waived), entry("good.wav", verdict="conforming"))
        text = (tmp_path / "summary.md").read_text()
        assert text.startswith("before\n## audio-checks\n")
        rows = [line for line in text.splitlines() if line.startswith("|")]
        assert len(rows) == 3
        assert rows[2].startswith("| a\\_b&#124;c.wav | rejected | error: true peak")
        assert "old.wav" not in text

    @pytest.mark.slow
    def test_a_large_summary_keeps_within_what_a_step_may_write(self, tmp_path, monkeypatch):
        monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(tmp_path / "summary.md"))
        self.commands(*(entry(f"sounds/{n:05}.wav", OVER, LATE) for n in range(8_000)))
        text = (tmp_path / "summary.md").read_text()
        assert 800_000 < len(text.encode()) < 1 << 20
        assert "more files are left out here" in text


class TestText:
    def test_much_is_summed_up(self):
        files = [entry(f"{n}.wav", OVER, LATE) for n in range(6)]
        out = judged_as("text", report(*files), Style())
        assert "  error    6 files  true-peak:over\n  warning  6 files  head-silence:over" in out

    @pytest.mark.parametrize("columns", [40, 60, 100])
    def test_lines_break_where_a_terminal_ends_and_only_there(self, columns):
        waived = Finding("true-peak:over", "m " * 40, "f", "error", waived=True)
        many = entry("a.wav", OVER, Finding("naming:pattern", "word " * 60, "do it " * 50, "error"), waived)
        shown, whole = (
            judged_as("text", report(many), style).split("\n\n")[0] for style in (Style(columns=columns), Style())
        )
        assert max(len(line) for line in shown.splitlines()[1:]) <= columns
        assert shown.split() == whole.split()
        assert len(whole.splitlines()) == 6

    def test_what_is_waived_is_counted_apart(self):
        waived = Finding("true-peak:over", "m", "f", "error", waived=True)
        out = judged_as("text", report(entry("a.wav", waived), entry("b.wav", LATE)), Style())
        assert "a.wav" not in out
        assert "0 errors, 1 warning, 1 waived" in out

    def test_what_git_lfs_has_not_fetched(self, folder, run):
        pointer = f"version https://git-lfs.github.com/spec/v1\noid sha256:{'a' * 64}\nsize 12345\n"
        (folder / "laser.wav").write_text(pointer)
        code, out, _ = run("check", *SPEC, ".")
        assert code == 1
        assert "container:git-lfs-pointer" in out
        assert "1 file of Git LFS not fetched: git lfs pull" in out

    def test_figures_have_words_and_units(self, folder, run):
        write_wav(folder / "laser.wav", silence(seconds=0.1))
        write_wav(folder / "tone.wav", GOOD)
        out = run("measure", ".")[1]
        assert re.search(r"^  sample peak +-$", out, re.MULTILINE)
        assert re.search(r"^  sample peak +-6\.00 dBFS$", out, re.MULTILINE)
        assert re.search(r"^  is silence +yes$", out, re.MULTILINE)

    @pytest.mark.slow
    def test_reverb_is_drawn_octave_by_octave(self, folder, run):
        dry = hits(channels=2)
        write_wav(folder / "dry.wav", dry)
        write_wav(folder / "wet.wav", in_a_room(dry, rt60_s=1.5))
        out = run("measure", ".")[1]
        dry_lines, wet_lines = (out[out.index(name) :].split("\n\n")[0] for name in ("dry.wav", "wet.wav"))
        octave = re.compile(
            r"^ +1 kHz  (█[▁▂▃▄▅▆▇█]+) +-\d+\.\d dB/s, 60 dB in +(\d\.\d\d) s  [01]\.\d\d, [01]\.\d\d$", re.M
        )
        curve, rt60_s = octave.search(wet_lines).groups()
        assert 1.2 < float(rt60_s) < 1.8
        assert sorted(curve, reverse=True) == list(curve)
        assert len(curve) > 4
        assert float(octave.search(dry_lines)[2]) < 0.3
        assert "decay from" in wet_lines

    def test_where_nothing_dies_away_nothing_is_drawn(self, folder, run):
        write_wav(folder / "silence.wav", silence(seconds=0.1))
        out = run("measure", ".")[1]
        assert "reverb?" in out
        assert "decay from" not in out


@pytest.mark.parametrize("name", reporters.formats())
def test_no_format_prints_a_control_character(name):
    hostile = entry(HOSTILE, Finding("naming:pattern", HOSTILE, HOSTILE, "error", start_s=0.1))
    for style in (Style(), Style(fail_level="warning")):
        out = judged_as(name, report(hostile), style)
        assert all(one.isprintable() or one == "\n" for one in out)
        out.encode("utf-8")


def test_github_goes_beside_text_and_others_do_not(folder, run):
    write_wav(folder / "laser.wav", LOUD)
    code, out, _ = run("check", *SPEC, "--format", "text", "--format", "github", ".")
    assert code == 1
    assert "rejected" in out
    assert "\n::error file=laser.wav," in out
    assert run("check", *SPEC, "--format", "text", "--format", "sarif", ".")[0] == 2


def test_a_file_that_cannot_be_written_is_reported(folder, run):
    write_wav(folder / "laser.wav", GOOD)
    os.mkdir(folder / "out")
    code, _, err = run("check", *SPEC, "--format", "sarif:out", ".")
    assert (code, "out: cannot be written" in err) == (2, True)
