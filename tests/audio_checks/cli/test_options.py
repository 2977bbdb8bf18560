"""Options that several commands take mean the same in each; a spec is found; - and names that begin with it."""

import argparse
import json

import pytest

from audio_checks.cli import COMMANDS, parser_of
from audio_checks.spec.delivery_spec import new_spec
from tests.support.waves import noise, sine, swelling, write_wav

GOOD = swelling(sine(hz=997, dbfs=-6, seconds=0.2))
LOUD = sine(hz=997, dbfs=0.0, seconds=0.2)
SPEC = ("--spec", "../spec.toml")
OF_SOUNDS = {"check", "measure", "render", "fix", "export-master", "placeholders", "manifest", "audit"}


def flags_of(command):
    (group,) = [action for action in parser_of()._actions if isinstance(action, argparse._SubParsersAction)]
    return {flag for action in group.choices[command]._actions for flag in action.option_strings}


@pytest.fixture
def sounds(folder):
    for number in range(3):
        (folder / f"in{number}").mkdir()
        write_wav(folder / f"in{number}" / "laser.wav", noise(seconds=0.2, dbfs=-20, seed=number))
        write_wav(folder / f"in{number}" / "loud.wav", LOUD)
    return ["in0", "in1", "in2"]


class TestOptions:
    @pytest.mark.parametrize(
        ("flag", "commands"),
        [
            ("--no-progress", OF_SOUNDS | {"new-spec"}),
            ("--quiet", OF_SOUNDS | {"memory", "new-spec"}),
            ("--format", OF_SOUNDS - {"manifest"} | {"memory"}),
            ("--jobs", OF_SOUNDS - {"export-master", "placeholders"} | {"new-spec"}),
            ("--fail-level", {"check", "render", "fix"}),
        ],
    )
    def test_every_command_that_they_concern_knows_them(self, flag, commands):
        assert {command for command in COMMANDS if flag in flags_of(command)} == commands

    @pytest.mark.slow
    def test_measure_in_several_processes(self, sounds, run):
        alone = run("measure", "--format", "json", "-j", "1", *sounds)
        assert alone[0] == 0
        assert run("measure", "--format", "json", "-j", "2", *sounds) == alone

    @pytest.mark.slow
    def test_measure_says_what_cannot_be_read_in_order(self, sounds, folder, run):
        for name in ("in0/laser.wav", "in2/laser.wav"):
            (folder / name).write_bytes(b"RIFF")
        alone = run("measure", "-j", "1", *sounds)
        assert alone[0] == 1
        assert alone[2].index("in0/laser.wav") < alone[2].index("in2/laser.wav")
        assert run("measure", "-j", "2", *sounds) == alone

    @pytest.mark.slow
    def test_render_in_several_processes(self, sounds, folder, run):
        code, alone, _ = run("render", *SPEC, "--out", "one", "--format", "json", "-j", "1", *sounds)
        assert code == 1  # three folders with one name
        made = {path.relative_to(folder / "one"): path.read_bytes() for path in (folder / "one").rglob("*.wav")}
        assert len(made) == 4
        code, out, _ = run("render", *SPEC, "--out", "two", "--format", "json", "-j", "2", *sounds)
        assert code == 1
        assert out == alone.replace("one/", "two/").replace('"one', '"two')
        assert {path.relative_to(folder / "two"): path.read_bytes() for path in (folder / "two").rglob("*.wav")} == made

    @pytest.mark.slow
    def test_fix_in_several_processes(self, sounds, folder, run):
        (folder / "all").mkdir()
        for name in sounds:
            (folder / name).rename(folder / "all" / name)
        code, alone, _ = run("fix", *SPEC, "--out", "one", "--format", "json", "-j", "1", "all")
        made = {path.relative_to(folder / "one"): path.read_bytes() for path in (folder / "one").rglob("*.wav")}
        assert (code, len(made)) == (0, 3)
        again, out, _ = run("fix", *SPEC, "--out", "two", "--format", "json", "-j", "2", "all")
        assert (again, out) == (code, alone.replace('"one/', '"two/'))
        assert {path.relative_to(folder / "two"): path.read_bytes() for path in (folder / "two").rglob("*.wav")} == made

    def test_render_fails_by_its_warnings_where_that_is_asked(self, folder, run):
        tone = sine(hz=997, dbfs=-6, seconds=0.2, channels=2)
        tone[:, 1] *= -0.9
        write_wav(folder / "wide.wav", tone)
        arguments = ("render", *SPEC, "--target", "handheld", "--out", "out", "wide.wav")
        assert run(*arguments)[0] == 0
        code, out, _ = run(*arguments, "--fail-level", "warning")
        assert (code, "warning: " in out) == (1, True)

    def test_quiet_runs_say_only_what_was_found(self, folder, run):
        write_wav(folder / "good.wav", GOOD)
        assert run("check", *SPEC, "-q", "good.wav") == (0, "", "")
        assert run("check", "-q", "good.wav") == (0, "", "")  # without a spec, too
        assert run("render", *SPEC, "--out", "out", "--quiet", "good.wav") == (0, "", "")
        assert run("fix", *SPEC, "--out", "out", "-q", "good.wav") == (0, "", "")
        assert run("manifest", "--out", "approved.json", "-q", "good.wav") == (0, "", "")
        assert run("export-master", "--out", "copies", "-q", "good.wav") == (0, "", "")
        write_wav(folder / "loud.wav", LOUD)
        code, out, err = run("check", *SPEC, "-q", ".")
        assert (code, err) == (1, "")
        assert "sample peak 0.00 dBFS" in out
        assert "5 files" not in out
        assert run("check", *SPEC, ".")[1].count("5 files") == 1  # quiet ends with its run

    def test_a_render_that_is_refused_is_no_quiet_matter(self, folder, run):
        write_wav(folder / "low.wav", noise(seconds=0.1, rate=16_000), rate=16_000)
        code, out, _ = run("render", *SPEC, "--out", "out", "-q", "low.wav")
        assert code == 1
        assert "low.wav -> game: refused: " in out

    def test_reports_of_commands_that_had_only_text(self, folder, run):
        write_wav(folder / "good.wav", GOOD)
        code, out, _ = run("export-master", "--out", "copies", "--format", "json", "good.wav")
        assert (code, json.loads(out)["masters"][0]["path"]) == (0, "copies/good.wav")
        (folder / "sounds.csv").write_text("number,name,file_name,duration_s\n1,hit,hit,0.5\n", encoding="utf-8")
        arguments = ("--list", "sounds.csv", *SPEC, "--out", "made", "--no-voice", "--no-progress")
        code, out, _ = run("placeholders", *arguments, "--format", "json:made.json", "--format", "text")
        assert (code, "1 placeholder" in out) == (0, True)
        (made,) = json.loads((folder / "made.json").read_text(encoding="utf-8"))["placeholders"]
        assert made["number"] == "1"
        assert run("placeholders", *arguments, "-q")[:2] == (0, "")
        code, out, _ = run("memory", *SPEC, "--list", "sounds.csv", "--format", "json")
        assert (code, {load["target"] for load in json.loads(out)["targets"]}) == (0, {"game", "handheld"})
        assert run("memory", *SPEC, "--list", "sounds.csv", "--quiet")[:2] == (0, "")

    def test_the_former_name_of_fix(self, folder, run):
        write_wav(folder / "loud.wav", LOUD)
        code, out, _ = run("mend", *SPEC, "--out", "one", "loud.wav")
        assert (code, out) == (0, run("fix", *SPEC, "--out", "two", "loud.wav")[1].replace("two/", "one/"))
        assert "mend" not in COMMANDS


@pytest.mark.usefixtures("folder")
class TestStandardStreams:
    @pytest.mark.parametrize("command", [("check",), ("measure",), ("render", *SPEC, "--out", "out")])
    def test_a_sound_from_standard_input_is_refused_with_a_reason(self, run, command):
        code, _, err = run(*command, "-")
        assert code == 2
        assert "- is standard input" in err
        assert "--files-from -" in err

    def test_a_file_of_that_name(self, folder, run):
        write_wav(folder / "-", GOOD)
        assert run("measure", "./-")[0] == 0

    @pytest.mark.parametrize("command", ["render", "fix", "export-master"])
    def test_sounds_do_not_go_to_standard_output(self, folder, run, command):
        write_wav(folder / "good.wav", GOOD)
        spec = () if command == "export-master" else SPEC
        code, _, err = run(command, *spec, "--out", "-", "good.wav")
        assert (code, "--out wants a folder" in err) == (2, True)
        assert not (folder / "-").exists()

    def test_reports_and_manifests_do(self, folder, run):
        write_wav(folder / "good.wav", GOOD)
        assert json.loads(run("check", *SPEC, "--format", "json:-", "good.wav")[1])["summary"]["files"] == 1
        code, out, _ = run("manifest", "--out", "-", "good.wav")
        assert (code, json.loads(out)["files"][0]["path"]) == (0, "good.wav")

    @pytest.mark.parametrize("command", ["check", "measure", "manifest"])
    def test_names_that_begin_with_a_hyphen(self, folder, run, command):
        write_wav(folder / "-hit.wav", GOOD)
        more = ("--out", "-") if command == "manifest" else ("--format", "json")
        code, out, _ = run(command, *more, "--", "-hit.wav")
        assert (code, json.loads(out)["files"][0]["path"]) == (0, "-hit.wav")

    @pytest.mark.parametrize("name", ["-hit.wav", "-big.wav"])
    def test_without_the_two_hyphens_it_is_said_how(self, folder, run, name):
        write_wav(folder / name, GOOD)
        code, _, err = run("check", name)
        assert (code, "a name that begins with - comes after --" in err) == (2, True)


@pytest.mark.usefixtures("folder")
class TestSpec:
    @pytest.fixture
    def outside(self, tmp_path):
        """A folder above which there is no spec."""
        (tmp_path / "elsewhere").mkdir()
        write_wav(tmp_path / "elsewhere" / "loud.wav", LOUD)
        return tmp_path / "elsewhere" / "loud.wav"

    def test_files_elsewhere_are_judged_by_the_one_where_one_stands(self, folder, run, outside):
        (folder / "audio-checks.toml").write_text(new_spec(), encoding="utf-8")
        code, out, err = run("check", outside)
        assert (code, "sample-peak:over" in out, "no delivery spec" in err) == (1, True, False)

    def test_above_the_folder_one_stands_in_will_do(self, folder, run, outside, monkeypatch):
        (folder / "audio-checks.toml").write_text(new_spec(), encoding="utf-8")
        (folder / "deep").mkdir()
        monkeypatch.chdir(folder / "deep")
        assert run("check", outside)[0] == 1

    def test_their_own_comes_first(self, folder, run, outside):
        (folder / "audio-checks.toml").write_text(new_spec(), encoding="utf-8")
        (outside.parent / "audio-checks.toml").write_text("format = 1\nname = 'anything goes'\n", encoding="utf-8")
        assert run("check", outside)[0] == 0

    def test_none_at_all_is_an_error_where_one_is_required(self, run, outside):
        code, _, err = run("check", outside)
        assert (code, "no delivery spec for 1 of 1 file: only their structure" in err) == (0, True)
        code, out, err = run("check", "--require-spec", outside)
        assert (code, out) == (2, "")
        assert "no delivery spec for 1 of 1 file" in err
        assert "name one with --spec" in err

    def test_one_that_is_found_is_enough(self, folder, run, outside):
        (folder / "audio-checks.toml").write_text(new_spec(), encoding="utf-8")
        assert run("check", "--require-spec", outside)[0] == 1
        assert run("check", "--require-spec", *SPEC, outside)[0] == 1
