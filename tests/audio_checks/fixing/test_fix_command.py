"""`audio-checks fix`: copies below a folder, what was done and what is left, and the exit code."""

import io
import json
import os

import numpy as np
import pytest

from audio_checks.cli import main
from audio_checks.spec.delivery_spec import new_spec
from tests.support.waves import join, silence, sine, swelling, write_wav

FINE = swelling(sine(hz=443.7, seconds=0.1))  # a period that no buffer repeats
LOUD = swelling(sine(hz=443.7, dbfs=0.0, seconds=0.1, phase=1.0))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    work = tmp_path / "work"
    (work / "in" / "doors").mkdir(parents=True)
    monkeypatch.chdir(work)
    (work / "spec.toml").write_text(new_spec(), encoding="utf-8")
    return work


@pytest.fixture
def fix(capsys):
    """Run the command; return its exit code and what it printed."""

    def run(*arguments):
        code = main(["fix", "--spec", "spec.toml", "--out", "out", *map(str, arguments)])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return run


def made(folder):
    return sorted(str(path.relative_to(folder / "out")) for path in (folder / "out").rglob("*") if path.is_file())


@pytest.mark.parametrize("command", ["fix", "render"])
def test_the_nearest_spec_is_used_where_none_is_named(folder, command):
    write_wav(folder / "in" / "a.wav", join(silence(seconds=0.2), FINE))
    (folder / "in" / "audio-checks.toml").write_text((folder / "spec.toml").read_text(), encoding="utf-8")
    (folder / "spec.toml").unlink()
    assert main([command, "--out", "out", "in"]) == 0
    assert made(folder)


@pytest.mark.parametrize(("extra", "shown"), [([], True), (["--no-progress"], False)])
def test_the_progress_line_can_be_left_out(folder, fix, monkeypatch, extra, shown):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    for name in ("a.wav", "b.wav"):
        write_wav(folder / "in" / name, FINE)
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    assert fix(*extra, "in")[0] == 0
    assert ("1/2" in terminal.getvalue()) is shown


def test_copies_go_to_the_same_places_and_masters_stay(folder, fix):
    late = join(silence(seconds=0.4), LOUD)
    master = write_wav(folder / "in" / "doors" / "Airlock Cycle.WAV", late)
    write_wav(folder / "in" / "fine.wav", FINE)
    content, touched = master.read_bytes(), os.stat(master).st_mtime_ns
    code, out, err = fix("in")
    assert (code, err) == (0, "")
    assert out == (
        "in/doors/Airlock Cycle.WAV\n"
        "  fixed    395.0 ms trimmed from the start\n"
        "  fixed    level lowered by 1.00 dB (sample peak 0.00 to -1.00 dBFS, true peak 0.00 to -1.00 dBTP)\n"
        "  fixed    renamed to airlock_cycle.wav\n"
        "  copy     out/doors/airlock_cycle.wav\n"
        "\n"
        "2 files: 1 fixed, 0 in part, 0 not, 1 had nothing to fix\n"
    )
    assert made(folder) == ["doors/airlock_cycle.wav"]
    assert (master.read_bytes(), os.stat(master).st_mtime_ns) == (content, touched)


def test_what_no_fix_answers_is_reported_and_fails(folder, fix):
    write_wav(folder / "in" / "low.wav", sine(hz=440, rate=32_000), rate=32_000)
    code, out, _ = fix("in")
    assert code == 1
    assert "sample-rate:not-accepted" in out
    assert "A fix never changes the sample rate" in out
    assert not (folder / "out").exists()


def test_a_warning_that_is_left_fails_only_when_asked(folder, fix):
    write_wav(folder / "in" / "gun.wav", np.hstack([FINE, silence(seconds=0.1)]))
    assert fix("in")[0] == 0
    code, out, _ = fix("--fail-level", "warning", "in")
    assert code == 1
    assert "silence:channel" in out


def test_a_broken_file_is_a_finding(folder, fix):
    (folder / "in" / "bad.wav").write_bytes(b"RIFF1234")
    assert fix("in")[0] == 1


def test_two_masters_never_make_one_copy(folder, fix):
    write_wav(folder / "in" / "Laser.wav", LOUD)
    write_wav(folder / "in" / "laser.wav", LOUD)
    code, out, _ = fix("in")
    assert code == 1
    assert "another file has the name laser.wav too" in out
    assert made(folder) == ["laser.wav"]


def test_a_master_is_never_replaced(folder, capsys):
    master = write_wav(folder / "in" / "laser.wav", LOUD)
    content = master.read_bytes()
    assert main(["fix", "--spec", "spec.toml", "--out", "in", "in"]) == 1
    assert "replace its master" in capsys.readouterr().out
    assert master.read_bytes() == content


def test_json(folder, fix):
    write_wav(folder / "in" / "Laser.wav", LOUD)
    code, out, _ = fix("--format", "json", "in")
    reported = json.loads(out)
    assert code == 0
    assert reported["summary"] == {"files": 1, "fixed": 1, "partly": 0, "left": 0, "fine": 0}
    [one] = reported["files"]
    assert (one["path"], one["out"], one["state"]) == ("in/Laser.wav", "out/laser.wav", "fixed")
    assert [repair["kind"] for repair in one["repairs"]] == ["gain", "name"]
    assert (one["before"]["verdict"], one["after"]["verdict"]) == ("rejected", "conforming")


def test_the_list_says_what_loops(folder, fix):
    (folder / "sounds.csv").write_text("number,name,loop\n1,hum,yes\n2,hit,no\n", encoding="utf-8")
    for name in ("hum", "hit"):
        write_wav(folder / "in" / f"{name}.wav", join(silence(seconds=0.2), FINE))
    assert fix("--list", "sounds.csv", "in")[0] == 0
    assert made(folder) == ["hit.wav"]


@pytest.mark.parametrize(
    ("arguments", "reported"),
    [
        (["--spec", "spec.toml", "--out", "out", "nowhere"], "no such file"),
        (["--out", "out", "in"], "name one with --spec, or put an audio-checks.toml above it"),
        (["--spec", "spec.toml", "in"], "--out"),
        (["--spec", "spec.toml", "--out", "out", "--target", "moon", "in/a.wav"], 'no target "moon"'),
        (["--spec", "spec.toml", "--out", "out", "--format", "xml", "in/a.wav"], 'no format "xml"'),
    ],
)
def test_usage_errors(folder, capsys, arguments, reported):
    write_wav(folder / "in" / "a.wav", FINE)
    assert main(["fix", *arguments]) == 2
    assert reported in capsys.readouterr().err


def test_names_from_strangers_print_no_control_characters(folder, fix):
    write_wav(folder / "in" / "la\x1b[31mser\u202e.wav", LOUD)
    _, out, _ = fix("in")
    assert "\x1b" not in out
    assert "\u202e" not in out
