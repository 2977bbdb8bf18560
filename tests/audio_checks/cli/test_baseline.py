"""Beginning on a tree that has a past."""

import json

import pytest

from audio_checks.cli.commands import check
from audio_checks.report.findings import FileReport, Finding
from audio_checks.run.baseline import add_to_baseline, read_baseline
from tests.support.waves import sine, write_wav

GOOD = sine(hz=1_000, dbfs=-6, seconds=0.1)
LOUD = sine(hz=1_000, dbfs=0.0, seconds=0.1)
SPEC = ("--spec", "../spec.toml")
KEPT = ("--baseline", "audio-checks-baseline.json")


def test_what_is_there_is_let_through_and_what_is_new_fails(folder, run):
    write_wav(folder / "laser.wav", LOUD)
    (folder / "cut.wav").write_bytes(b"RIFF")
    code, out, err = run("check", *SPEC, "--add-baseline", ".")
    assert (code, "3 waived" in out) == (0, True)
    assert "read it with --baseline audio-checks-baseline.json" in err
    assert run("check", *SPEC, ".")[0] == 1
    assert run("check", *SPEC, *KEPT, "--fail-level", "warning", ".")[0] == 0
    write_wav(folder / "new.wav", sine(hz=440, dbfs=0.0, seconds=0.1))
    code, out, _ = run("check", *SPEC, *KEPT, "--format", "json", ".")
    assert code == 1
    counting = {
        entry["path"]: [one["code"] for one in entry["findings"] if not one.get("waived")]
        for entry in json.loads(out)["files"]
    }
    assert counting["./laser.wav"] == counting["./cut.wav"] == []
    assert "sample-peak:over" in counting["./new.wav"]


def test_it_goes_by_the_sound_not_by_the_name(folder, run):
    path = write_wav(folder / "laser.wav", LOUD)
    run("check", *SPEC, "--add-baseline", ".")
    path = path.rename(folder / "phaser.wav")
    assert run("check", *SPEC, *KEPT, ".")[0] == 0
    write_wav(path, sine(hz=1_000, dbfs=0.0, seconds=0.2))
    assert run("check", *SPEC, *KEPT, ".")[0] == 1


def test_it_goes_by_the_rule_too(folder, run):
    path = write_wav(folder / "laser.wav", LOUD)
    run("check", *SPEC, "--add-baseline", ".")
    path.rename(folder / "Laser.wav")
    code, out, _ = run("check", *SPEC, *KEPT, ".")
    assert (code, "naming:pattern" in out) == (1, True)


def test_it_is_added_to_and_keeps_what_it_had(folder, run):
    write_wav(folder / "laser.wav", LOUD)
    server = {"pcm_sha256": "a" * 64, "codes": ["true-peak:over"], "reason": "style", "decider": "someone"}
    (folder / "mine.json").write_text(json.dumps({"format": 1, "waived": [server], "project": "x"}))
    assert run("check", *SPEC, "--baseline", "mine.json", "--add-baseline", ".")[0] == 0
    first = (folder / "mine.json").read_text()
    document = json.loads(first)
    assert document["project"] == "x"
    assert document["waived"][0] == server
    assert len(document["waived"]) == 2
    assert run("check", *SPEC, "--baseline", "mine.json", "--add-baseline", ".")[0] == 0
    assert (folder / "mine.json").read_text() == first


def test_two_files_of_one_sound_share_an_entry(tmp_path):
    sound = {"verdict": "rejected", "pcm_sha256": "b" * 64}
    one = FileReport("a.wav", findings=(Finding("naming:pattern", "m", "f", "error"),), **sound)
    other = FileReport("b.wav", findings=(Finding("true-peak:over", "m", "f", "error"),), **sound)
    assert add_to_baseline(tmp_path / "b.json", [other, one]) == 2
    assert read_baseline(tmp_path / "b.json") == {"b" * 64: {"naming:pattern", "true-peak:over"}}


def test_a_fault_of_the_tool_is_never_let_through(tmp_path):
    broken = Finding("clipping:crashed", "m", "f", "error")
    entry = FileReport("a.wav", "unjudged", pcm_sha256="b" * 64, findings=(broken,))
    assert add_to_baseline(tmp_path / "b.json", [entry]) == 0
    assert read_baseline(tmp_path / "b.json") == {}


def test_what_is_no_baseline_is_not_overwritten(folder, run):
    write_wav(folder / "laser.wav", LOUD)
    (folder / "notes.json").write_text("[]")
    assert run("check", *SPEC, "--baseline", "notes.json", "--add-baseline", ".")[0] == 2
    assert (folder / "notes.json").read_text() == "[]"


@pytest.mark.parametrize(("count", "offered"), [(2, False), (3, True)])
def test_a_first_run_on_a_large_tree_offers_it(folder, run, monkeypatch, count, offered):
    monkeypatch.setattr(check, "MANY_FAILING", 3)
    for number in range(count):
        write_wav(folder / f"Laser {number}.wav", GOOD)
    write_wav(folder / "good.wav", GOOD)
    code, _, err = run("check", *SPEC, ".")
    assert (code, "--add-baseline" in err) == (1, offered)
    run("check", *SPEC, "--add-baseline", ".")
    write_wav(folder / "Another.wav", LOUD)
    assert "--add-baseline" not in run("check", *SPEC, *KEPT, ".")[2]


def test_it_is_written_whole_or_not_at_all(folder, run, monkeypatch):
    write_wav(folder / "laser.wav", LOUD)
    run("check", *SPEC, "--add-baseline", ".")
    before = (folder / "audio-checks-baseline.json").read_text()
    write_wav(folder / "Another.wav", GOOD)
    monkeypatch.setattr("os.fsync", lambda _: (_ for _ in ()).throw(OSError(28, "No space left on device")))
    code, _, err = run("check", *SPEC, "--no-cache", "--add-baseline", ".")
    assert (code, "No space left" in err) == (2, True)
    assert (folder / "audio-checks-baseline.json").read_text() == before
    assert sorted(path.name for path in folder.iterdir()) == ["Another.wav", "audio-checks-baseline.json", "laser.wav"]
