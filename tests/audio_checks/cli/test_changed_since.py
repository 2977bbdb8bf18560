"""`--changed-since`: only what a change touches, asked of a real repository."""

import json
import os
import shutil
import subprocess

import pytest

from audio_checks.spec.delivery_spec import new_spec
from tests.support.waves import sine, write_wav

GOOD = sine(hz=997, dbfs=-6, seconds=0.1)
OTHER = sine(hz=440, dbfs=-6, seconds=0.1)


def git(*arguments):
    who = ["-c", "user.name=x", "-c", "user.email=x@example.com", "-c", "init.defaultBranch=main"]
    return subprocess.run([shutil.which("git"), *who, *arguments], check=True, capture_output=True, text=True).stdout


@pytest.fixture
def repository(folder):
    (folder / "audio-checks.toml").write_text(new_spec())
    (folder / "sub dir").mkdir()
    for name in ("a.wav", "b.wav", "gone.wav", "sub dir/é.wav"):
        write_wav(folder / name, GOOD)
    git("init", "-q")
    git("add", ".")
    git("commit", "-qm", "before")
    return folder


@pytest.fixture
def judged(run):
    def judged(*arguments):
        code, out, err = run("check", "--format", "json", "--changed-since", *arguments)
        assert code != 2, err
        return [entry["path"] for entry in json.loads(out)["files"]], err

    return judged


def test_changed_and_new_files_are_judged(repository, judged):
    write_wav(repository / "a.wav", OTHER)
    write_wav(repository / "sub dir" / "é.wav", OTHER)
    write_wav(repository / "new.wav", OTHER)
    (repository / "gone.wav").unlink()
    (repository / ".gitignore").write_text("ignored.wav\n")
    write_wav(repository / "ignored.wav", OTHER)
    assert judged("HEAD", ".")[0] == ["./a.wav", "./new.wav", "./sub dir/é.wav"]
    git("add", "a.wav")
    assert judged("HEAD", "a.wav", "b.wav")[0] == ["a.wav"]
    assert judged("HEAD", "sub dir")[0] == ["sub dir/é.wav"]


def test_a_branch_answers_for_itself_only(repository, judged):
    git("switch", "-qc", "mine")
    write_wav(repository / "a.wav", OTHER)
    git("commit", "-qam", "mine")
    git("switch", "-q", "main")
    write_wav(repository / "b.wav", OTHER)
    git("commit", "-qam", "theirs")
    git("switch", "-q", "mine")
    assert judged("main", ".")[0] == ["./a.wav"]


def test_nothing_changed(repository, run):
    code, out, err = run("check", "--changed-since", "HEAD", ".")
    assert (code, "no audio differs from HEAD" in err) == (0, True)
    assert "0 files" in out


@pytest.mark.parametrize("rule", ["audio-checks.toml", "base.toml", "sounds.csv", "baseline.json"])
def test_a_changed_rule_touches_everything_it_is_about(repository, judged, rule):
    (repository / "audio-checks.toml").write_text('format = 1\nextend = "base.toml"\n')
    (repository / "base.toml").write_text(new_spec())
    (repository / "sounds.csv").write_text("number,file_name\n1,a\n")
    (repository / "baseline.json").write_text('{"format": 1, "waived": []}')
    git("add", ".")
    git("commit", "-qm", "rules")
    asked = ("HEAD", "--list", "sounds.csv", "--baseline", "baseline.json", ".")
    assert judged(*asked)[0] == []
    (repository / rule).write_text((repository / rule).read_text() + "\n")
    paths, err = judged(*asked)
    assert len(paths) == 4
    assert f"{rule} differs from HEAD, so every file that it is about is judged" in err


def test_only_the_folder_of_a_changed_spec(repository, judged):
    (repository / "sub dir" / "audio-checks.toml").write_text("format = 1\n")
    assert judged("HEAD", ".")[0] == ["./sub dir/é.wav"]


@pytest.mark.parametrize(
    ("ref", "said"),
    [("nowhere", 'no commit "nowhere"'), ("--output=x", "expected one argument"), ("HEAD:a.wav", "no commit")],
)
def test_a_commit_that_nobody_knows(repository, run, ref, said):
    code, _, err = run("check", "--changed-since", ref, ".")
    assert (code, said in err) == (2, True)
    assert not (repository / "x").exists()


def test_files_outside_of_any_repository(folder, run):
    write_wav(folder / "a.wav", GOOD)
    code, _, err = run("check", "--changed-since", "HEAD", ".")
    assert (code, "in no Git repository" in err) == (2, True)


def test_no_git_at_all(repository, run, monkeypatch):
    monkeypatch.setenv("PATH", str(repository))
    code, _, err = run("check", "--changed-since", "HEAD", ".")
    assert (code, "git is not installed" in err) == (2, True)


def test_the_repository_is_only_read(repository, judged):
    os.utime(repository / "a.wav")  # Git would like to refresh its index now
    before = (repository / ".git" / "index").read_bytes()
    assert judged("HEAD", ".")[0] == []
    assert (repository / ".git" / "index").read_bytes() == before
