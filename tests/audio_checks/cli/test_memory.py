"""`audio-checks memory`: sums by target and category, and an exit code that a build can act on."""

import json

import pytest

from audio_checks.cli import main

LIST = "number,name,category,duration_s\n1,door,foley,2\n2,theme,music,60\n3,idea,foley,\n"
SPEC = "format = 1\n[targets.pc]\nsample_rate_hz = 48000\nbit_depth = 16\nchannels = 1\nbudget_bytes = {}\n"


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)

    def run(budget, *more):
        (tmp_path / "sounds.csv").write_text(LIST)
        (tmp_path / "spec.toml").write_text(SPEC.format(budget) + "[categories.music]\ntargets.pc.streamed = true\n")
        code = main(["memory", "--spec", "spec.toml", "--list", "sounds.csv", *more])
        return code, capsys.readouterr()

    return run


def test_within_the_budget(run):
    code, said = run(512 * 1024)
    assert code == 0
    assert said.out.splitlines() == [
        "pc: 2 files, 252 KiB in memory, 5,812 KiB on disk, 260 KiB under the budget of 512 KiB; "
        "1 more has no duration yet",
        "  foley: 1 file, 188 KiB in memory, 188 KiB on disk; 1 more has no duration yet",
        "  music: 1 file, 64 KiB in memory, 5,625 KiB on disk",
    ]


def test_over_it_as_json(run):
    code, said = run(100_000, "--format", "json")
    (target,) = json.loads(said.out)["targets"]
    assert code == 1
    assert target["total"]["over_bytes"] == 2 * 48_000 * 2 + 65_536 - 100_000


def test_a_target_that_is_not_there(run):
    code, said = run(1, "--target", "trailer")
    assert (code, "targets of this spec: pc" in said.err) == (2, True)
