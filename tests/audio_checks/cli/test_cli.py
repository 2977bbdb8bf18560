"""The command line: what it prints, where, and with which exit code."""

import io
import json
import os
import subprocess
import sys
import tomllib

import jsonschema_rs
import pytest

from audio_checks.checks import all_checks
from audio_checks.cli import main, reporters
from audio_checks.run import runner
from audio_checks.spec.delivery_spec import new_spec
from audio_checks.system.plural import counted
from tests.support.waves import join, silence, sine, write_wav

GOOD = sine(hz=1_000, dbfs=-6, seconds=0.2)
LATE = join(silence(seconds=0.02), GOOD)
LOUD = sine(hz=1_000, dbfs=0.0, seconds=0.2)
SPEC = ("--spec", "../spec.toml")


class TestExitCodes:
    def test_conforming(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        code, out, err = run("check", *SPEC, "laser.wav")
        assert (code, len(err.splitlines())) == (0, 1)  # what is judged less well, once
        assert "no sound list (--list): lengths, loops and variations of cues are not compared" in err
        assert "no category for 1 of 1 file" in err
        assert out == "1 file: 1 conforming; 0 errors, 0 warnings\n"
        (folder / "sounds.csv").write_text("number,file_name,category\n1,laser,vo\n")
        assert run("check", *SPEC, "--list", "sounds.csv", "laser.wav")[2] == ""

    def test_an_error(self, folder, run):
        write_wav(folder / "laser.wav", LOUD)
        code, out, _ = run("check", *SPEC, ".")
        assert code == 1
        assert "sample peak 0.00 dBFS, limit -0.1 dBFS" in out

    def test_a_warning_counts_at_its_own_level(self, folder, run):
        write_wav(folder / "laser.wav", LATE)
        assert run("check", *SPEC, ".")[0] == 0
        assert run("check", *SPEC, "--fail-level", "warning", ".")[0] == 1

    def test_a_broken_file_is_a_finding(self, folder, run):
        (folder / "laser.wav").write_bytes(b"not audio")
        code, out, _ = run("check", *SPEC, ".")
        assert code == 1
        assert "unreadable" in out

    def test_a_tool_fault_outranks_a_finding(self, folder, run, monkeypatch):
        def crash(check, *_):
            raise ZeroDivisionError

        write_wav(folder / "Bad Name.wav", LOUD)
        monkeypatch.setattr(all_checks()["clipping"].module, "check", crash)
        code, out, _ = run("check", *SPEC, ".")
        assert code == 2
        assert "the check itself broke" in out

    def test_so_does_a_tool_that_breaks_altogether(self, folder, run, monkeypatch):
        def crash(*_, **__):
            raise ZeroDivisionError("a\x1bb")

        write_wav(folder / "laser.wav", GOOD)
        monkeypatch.setattr(runner, "judge", crash)
        code, _, err = run("check", *SPEC, ".")
        assert code == 2
        assert "a fault of the tool" in err
        assert "a\\x1bb" in err

    def test_a_disk_that_refuses(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "out").write_text("in the way", encoding="utf-8")
        code, _, err = run("render", *SPEC, "--out", "out", "laser.wav")
        assert code == 2
        assert "out" in err
        assert "fault of the tool" not in err

    def test_no_path_is_this_folder(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        for command in ("check", "measure"):
            _, out, _ = run(command, "--format", "jsonl")
            assert [json.loads(line)["path"] for line in out.splitlines()] == ["./laser.wav"]

    def test_damaged_utf16_is_named(self, folder, run):
        (folder / "list.txt").write_bytes(b"\xff\xfea\0\n")
        code, _, err = run("check", "--files-from", "list.txt")
        assert (code, "list.txt: is UTF-16 text that is damaged at byte 4" in err) == (2, True)

    def test_nothing_judged_because_of_what_is_not_there_fails(self, folder, run):
        (folder / "shared").symlink_to("../gone")
        code, _, err = run("check", *SPEC, "--allow-empty", ".")
        assert (code, "./shared: a link that leads nowhere" in err, "no audio found" in err) == (2, True, True)

    def test_no_audio(self, folder, run):
        (folder / "readme.txt").write_text("hello", encoding="utf-8")
        code, _, err = run("check", *SPEC, ".")
        assert (code, "--allow-empty" in err) == (2, True)
        assert run("check", *SPEC, "--allow-empty", ".")[0] == 0

    @pytest.mark.parametrize(
        ("arguments", "said"),
        [
            ([], "COMMAND"),
            (["chekc"], 'no command "chekc"; the nearest is check;'),
            (["fix", *SPEC, "--out", "out"], "no path given"),
            (["check", "nowhere.wav"], "nowhere.wav: no such file or folder"),
            (["check", "--frmat", "json", "."], "--frmat; the nearest is --format;"),
            (["check", "--sepc=spec.toml", "."], "--sepc; the nearest is --spec;"),
            (["check", "--format", "yaml", "."], "formats: github, json, jsonl, junit, sarif, text"),
            (["check", "--format", "json", "--format", "text", "."], "same place"),
            (["check", "--format", "json:no/such/folder.json", "laser.wav"], "cannot be written"),
            (["check", "--spec", "none.toml", "."], "none.toml"),
            (["check", *SPEC, "--target", "pc", "laser.wav"], "targets of this spec: game, handheld"),
            (["check", *SPEC, "--category", "wepon", "laser.wav"], 'no category "wepon"'),
            (["check", "--category", "vo", "laser.wav"], 'no category "vo"'),
            (["check", "--target", "game", "laser.wav"], "--target needs a spec"),
            (["check", *SPEC, "--list", "none.csv", "laser.wav"], "none.csv"),
            (["check", *SPEC, "--baseline", "none.json", "laser.wav"], "none.json"),
            (["check", "-j", "-1", "laser.wav"], "-j"),
            (["check", "-j", "many", "laser.wav"], "argument -j/--jobs: wanted a whole number"),
            (["measure", "nowhere.wav"], "no such file"),
            (["render", "--out", "out", "laser.wav"], "--spec"),
            (["explain", "true-peek"], '"true-peak"'),
            (["explain", "silenc"], 'are "silence" and "head-silence" and "tail-silence"'),
            (["schema", "sounds"], "sounds"),
            (["new-spec", "--preset", "96k"], "96k"),
        ],
    )
    def test_usage_errors(self, folder, run, arguments, said):
        write_wav(folder / "laser.wav", GOOD)
        code, _, err = run(*arguments)
        assert code == 2
        assert said in err

    def test_a_judgement_is_explained_by_its_check(self, run):
        assert run("explain", "reverb")[1].startswith("baked-reverb")

    def test_no_number_of_a_rule_is_shown(self, folder, run):
        (folder / "broken.wav").write_bytes(write_wav(folder / "good.wav", GOOD).read_bytes()[:-40])
        _, out, _ = run("check", *SPEC, "broken.wav")
        assert "are missing" in out
        assert "(R1)" not in out

    @pytest.mark.parametrize(
        ("count", "words"), [(0, "0 files"), (1, "1 file"), (2, "2 files"), (1_200, "1,200 files")]
    )
    def test_a_number_and_its_noun(self, count, words):
        assert counted(count, "file") == words

    def test_an_unknown_key_of_the_spec(self, folder, run):
        (folder / "mine.toml").write_text("format = 1\n[limits]\ntrue_peak = -1\n", encoding="utf-8")
        code, _, err = run("check", "--spec", "mine.toml", ".")
        assert code == 2
        assert 'mine.toml: limits.true_peak: no such key; the nearest known is "true_peak_dbtp"' in err


class TestSpecs:
    def test_no_spec_judges_the_structure_and_says_so(self, folder, run):
        write_wav(folder / "Bad Name.WAV", LOUD)
        code, _, err = run("check", ".")
        assert code == 0
        assert "only their structure is judged" in err

    def test_the_nearest_spec_is_taken_whole(self, folder, run):
        (folder / "audio-checks.toml").write_text("format = 1\nlimits.sample_peak_dbfs = -1\n", encoding="utf-8")
        (folder / "sub").mkdir()
        (folder / "sub" / "pyproject.toml").write_text("[tool.audio-checks]\nformat = 1\n", encoding="utf-8")
        (folder / "sub" / "deep").mkdir()
        (folder / "sub" / "deep" / "pyproject.toml").write_text("[tool.other]\n", encoding="utf-8")
        quiet, loud = sine(hz=997, dbfs=-0.5), folder / "loud.wav"
        write_wav(loud, quiet)
        write_wav(folder / "sub" / "deep" / "same.wav", quiet)
        code, out, _ = run("check", "--format", "json", ".")
        report = json.loads(out)
        assert code == 1
        assert {entry["path"]: entry["verdict"] for entry in report["files"]} == {
            "./loud.wav": "rejected",
            "./sub/deep/same.wav": "conforming",
        }
        assert report["spec"] is None
        assert len(report["specs"]) == 2

    def test_globs_give_categories(self, folder, run):
        text = new_spec() + '\n[files]\n"vo/**" = "vo"\n'
        (folder / "audio-checks.toml").write_text(text, encoding="utf-8")
        (folder / "vo").mkdir()
        write_wav(folder / "vo" / "line.wav", LATE)
        code, out, _ = run("check", "--fail-level", "warning", "--format", "jsonl", ".")
        assert (code, json.loads(out)["category"]) == (0, "vo")

    @pytest.mark.usefixtures("without_lossy")
    def test_a_missing_check_is_reported(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "mine.toml").write_text("format = 1\nchecks.lossy = 'warning'\n", encoding="utf-8")
        code, out, err = run("check", "--spec", "mine.toml", "--format", "json", ".")
        assert (code, json.loads(out)["not_run"]) == (0, ["lossy"])
        assert "lossy" in err
        code, _, err = run("explain", "lossy")
        assert (code, "this version lacks" in err) == (2, True)

    def test_a_doubtful_spec_is_reported(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "mine.toml").write_text(new_spec().replace("[44100, ", "[22050, 44100, "), encoding="utf-8")
        assert "22050 Hz" in run("check", "--spec", "mine.toml", ".")[2]

    def test_target_and_list(self, folder, run):
        write_wav(folder / "laser_01.wav", sine(hz=997, rate=44_100, seconds=0.5), rate=44_100, bits=16)
        write_wav(folder / "extra.wav", sine(hz=440, rate=44_100, seconds=0.5), rate=44_100, bits=16)
        (folder / "sounds.csv").write_text("number,file_name,duration_s,variations\n1,laser,2,2\n", encoding="utf-8")
        code, out, _ = run("check", *SPEC, "--list", "sounds.csv", "--target", "game", "--format", "json", ".")
        codes = {entry["path"]: [one["code"] for one in entry["findings"]] for entry in json.loads(out)["files"]}
        assert code == 0
        assert codes == {"./laser_01.wav": ["duration:cue"], "./extra.wav": ["naming:unlisted"]}


class TestFiles:
    def test_folders_are_walked_for_audio_of_any_kind(self, folder, run):
        (folder / ".git").mkdir()
        (folder / "a").mkdir()
        for name in ("a/laser.wav", ".hidden.wav", ".git/laser.wav", "b.WAV"):
            write_wav(folder / name, GOOD)
        (folder / "song.mp3").write_bytes(b"ID3" + bytes(100))
        (folder / "notes.txt").write_text("hello", encoding="utf-8")
        code, out, _ = run("check", "--format", "jsonl", ".")
        entries = {entry["path"]: entry["verdict"] for entry in map(json.loads, out.splitlines())}
        assert code == 1
        assert entries == {"./b.WAV": "conforming", "./song.mp3": "unreadable", "./a/laser.wav": "conforming"}

    def test_links_pipes_and_folders_are_findings_and_nothing_hangs(self, folder, run):
        os.mkfifo(folder / "pipe.wav")
        (folder / "dangling.wav").symlink_to("nowhere.wav")
        (folder / "loop.wav").symlink_to("loop.wav")
        (folder / "self").symlink_to(".")
        code, out, _ = run("check", "--format", "jsonl", ".", "dangling.wav", "pipe.wav")
        entries = [json.loads(line) for line in out.splitlines()]
        assert code == 1
        assert {entry["verdict"] for entry in entries} == {"unreadable"}
        assert {entry["path"] for entry in entries} >= {"./pipe.wav", "./dangling.wav", "./loop.wav"}

    def test_a_file_is_judged_once(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        assert len(run("check", "--format", "jsonl", ".", "laser.wav", "./laser.wav")[1].splitlines()) == 1

    def test_paths_from_stdin(self, folder, run, monkeypatch):
        for name in ("a.wav", "b c.wav", "d\ne.wav"):
            write_wav(folder / name, GOOD)
        lines = "a.wav\r\nb c.wav\n"
        for raw, count in (
            (lines.encode(), 2),
            (b"a.wav\0d\ne.wav\0", 2),
            (lines.encode("utf-8-sig"), 2),
            (lines.encode("utf-16"), 2),  # with a byte order mark, as Windows PowerShell writes for >
            ("\ufeff".encode("utf-16-be") + lines.encode("utf-16-be"), 2),
            (lines.encode("utf-16-le"), 2),
            (lines.encode("utf-16-be"), 2),
            ("\ufeffa.wav\0d\ne.wav\0".encode("utf-16-le"), 2),
        ):
            monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(raw)))
            code, out, _ = run("check", "--files-from", "-", "--format", "jsonl")
            assert (code, len(out.splitlines())) == (0, count)

    @pytest.mark.parametrize(
        "name", ["a\nb.wav", "\x1b[31mred.wav", "\u202evaw.exe.wav", "\x7f\x9b.wav", b"\xff\xfe.wav"]
    )
    def test_names_are_never_printed_raw(self, folder, run, name):
        path = os.fsdecode(name)
        write_wav(folder / path, LOUD)
        for form in ("text", "json", "jsonl"):
            code, out, err = run("check", *SPEC, "--format", form, path)
            assert code == 1
            assert all(one.isprintable() or one == "\n" for one in out + err)
            out.encode("utf-8")
        code, out, err = run("check", f"{path}.gone")
        assert code == 2
        assert all(one.isprintable() or one == "\n" for one in out + err)

    def test_inputs_are_left_alone(self, folder, run):
        path = write_wav(folder / "laser.wav", LOUD)
        path.chmod(0o444)
        before = path.read_bytes(), path.stat().st_mtime_ns
        run("check", *SPEC, ".")
        run("measure", ".")
        assert (path.read_bytes(), path.stat().st_mtime_ns) == before


class TestPlain:
    def test_explain_by_name_and_by_code(self, run):
        code, out, _ = run("explain", "true-peak")
        assert code == 0
        assert "ITU-R BS.1770" in out
        assert run("explain", "true-peak:over")[1] == out

    def test_list(self, run):
        code, out, _ = run("list")
        assert code == 0
        assert all(f"\n{name} " in f"\n{out}" for name in all_checks())

    @pytest.mark.parametrize("preset", ["44k1", "48k"])
    def test_new_spec(self, run, preset):
        code, out, _ = run("new-spec", "--preset", preset)
        assert (code, tomllib.loads(out)["format"]) == (0, 1)

    @pytest.mark.parametrize("document", ["spec", "report"])
    def test_schema(self, run, document):
        code, out, _ = run("schema", document)
        assert code == 0
        jsonschema_rs.meta.validate(json.loads(out))

    def test_every_format_can_be_distinguished(self):
        assert set(reporters.measured_formats()) <= set(reporters.formats())
        assert {"text", "json", "jsonl"} <= set(reporters.formats())


@pytest.mark.slow
def test_a_cold_start_costs_a_few_imports_of_numpy(folder):
    """Half a second of a processor is the promise, as benchmarks measure; here against the same machine."""
    write_wav(folder / "laser.wav", LOUD)

    def spent_s(arguments, code):
        before = os.times()
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False)
        after = os.times()
        assert done.returncode == code
        assert code == 0 or "sample-peak:over" in done.stdout
        return after.children_user + after.children_system - before.children_user - before.children_system

    ours_s = min(spent_s(["-m", "audio_checks.cli", "check", *SPEC, "laser.wav"], 1) for _ in range(3))
    numpy_s = min(spent_s(["-c", "import numpy"], 0) for _ in range(3))
    assert ours_s < 5 * numpy_s


@pytest.mark.slow
def test_a_closed_pipe_is_no_traceback():
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([sys.executable, "-m", "audio_checks.cli", "list"], stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert b"Traceback" not in done.stderr
    assert b"Exception ignored" not in done.stderr


def test_the_version(capsys):
    with pytest.raises(SystemExit) as left:
        main(["--version"])
    assert left.value.code == 0
    assert capsys.readouterr().out == f"audio-checks {runner.TOOL_VERSION}\n"
