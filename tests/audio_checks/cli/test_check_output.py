"""What `audio-checks check` prints: formats, colour, progress, and findings that a baseline waives."""

import io
import json

import jsonschema_rs
import numpy as np
import pytest

from audio_checks import TOOL_VERSION, check_file
from audio_checks.cli import main
from audio_checks.report.findings import schema as report_schema
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from tests.audio_checks.cli.test_cli import GOOD, LATE, LOUD
from tests.support.waves import noise, write_wav

SPEC = ("--spec", "../spec.toml")


class TestReports:
    def test_several_formats_at_once(self, folder, run):
        write_wav(folder / "laser.wav", LOUD)
        code, out, _ = run(
            "check", *SPEC, "--format", "text", "--format", "json:report.json", "--format", "jsonl:l.jsonl", "."
        )
        report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        assert code == 1
        assert "rejected" in out
        assert report["spec"]["name"] == "Shield Wing"
        assert report["tool"] == {"name": "audio-checks", "version": TOOL_VERSION}
        assert [json.loads((folder / "l.jsonl").read_text(encoding="utf-8"))] == report["files"]
        jsonschema_rs.validator_for(report_schema()).validate(report)

    def test_text_is_grouped_with_the_worst_first(self, folder, run):
        write_wav(folder / "a_late.wav", LATE)
        write_wav(folder / "b_loud.wav", LOUD)
        (folder / "c_broken.wav").write_bytes(b"RIFF")
        write_wav(folder / "d_good.wav", GOOD)
        out = run("check", *SPEC, ".")[1]
        assert [line.split()[0] for line in out.splitlines() if line.startswith("./")] == [
            "./c_broken.wav",
            "./b_loud.wav",
            "./a_late.wav",
        ]
        assert "4 files: 2 conforming, 1 rejected, 1 unreadable; 2 errors, 2 warnings" in out
        figure, fix = out[out.index("sample peak") :].splitlines()[:2]
        assert figure.endswith("sample-peak:over")
        assert fix.strip() == "fix: lower the level by 0.10 dB or more"

    def test_colour_only_where_it_is_wanted(self, folder, monkeypatch):
        class Terminal(io.StringIO):
            def isatty(self):
                return True

        write_wav(folder / "laser.wav", LOUD)
        for variable, coloured in (("", True), ("1", False)):
            terminal = Terminal()
            monkeypatch.setattr("sys.stdout", terminal)
            monkeypatch.setenv("TERM", "xterm")
            monkeypatch.setenv("NO_COLOR", variable)
            main(["check", *SPEC, "."])
            assert ("\x1b[" in terminal.getvalue()) is coloured

    def test_the_progress_line_can_be_left_out(self, folder, monkeypatch):
        class Terminal(io.StringIO):
            def isatty(self):
                return True

        for name in ("a.wav", "b.wav"):
            write_wav(folder / name, GOOD)
        for extra, shown in (([], True), (["--no-progress"], False)):
            terminal = Terminal()
            monkeypatch.setattr("sys.stderr", terminal)
            main(["check", *SPEC, *extra, "."])
            assert ("1/2" in terminal.getvalue()) is shown

    @pytest.mark.slow
    def test_processes_change_nothing(self, folder, run):
        for number in range(4):
            write_wav(folder / f"laser_{number}.wav", LOUD if number % 2 else GOOD)
        assert run("check", *SPEC, "--format", "json", "-j", "2", ".") == run("check", *SPEC, "--format", "json", ".")


class TestBaseline:
    def test_waived_findings_stay_but_do_not_fail(self, folder, run):
        path = write_wav(folder / "laser.wav", LOUD)
        spec = parse_spec(new_spec())
        waived = {"pcm_sha256": check_file(path, spec).pcm_sha256, "codes": ["sample-peak:over"], "reason": "style"}
        (folder / "baseline.json").write_text(json.dumps({"format": 1, "waived": [waived]}), encoding="utf-8")
        code, out, _ = run("check", *SPEC, "--baseline", "baseline.json", "--format", "json", ".")
        (entry,) = json.loads(out)["files"]
        assert code == 0
        assert entry["verdict"] == "rejected"
        assert [one.get("waived", False) for one in entry["findings"]] == [True, False]
        code, out, _ = run("check", *SPEC, "--baseline", "baseline.json", "--fail-level", "warning", ".")
        assert (code, "1 waived" in out) == (1, True)

    @pytest.mark.parametrize(
        "content",
        ["", "[]", '{"format": 2, "waived": []}', '{"format": 1, "waived": [{"pcm_sha256": "x", "codes": []}]}'],
    )
    def test_what_is_no_baseline(self, folder, run, content):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "baseline.json").write_text(content, encoding="utf-8")
        assert run("check", *SPEC, "--baseline", "baseline.json", ".")[0] == 2


def test_the_summary_says_where_reverb_could_not_be_judged(folder, run):
    burst = noise(seconds=1.5, dbfs=-12) * 10 ** (-3 * np.arange(72_000) / 48_000 / 1.2)[:, np.newaxis]
    write_wav(folder / "burst.wav", burst)
    asked = '[engine]\nadds = ["reverb"]\n'
    (folder / "asked.toml").write_text(f"format = 1\n{asked}")
    (folder / "plain.toml").write_text("format = 1\n")
    assert "reverb: cannot tell in 1 of 1\n" in run("check", "--spec", "asked.toml", "burst.wav")[1]
    assert "reverb" not in run("check", "--spec", "plain.toml", "burst.wav")[1]
