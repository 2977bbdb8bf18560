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


@pytest.mark.slow
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


LOW_RATE = sine(hz=440, dbfs=-6, seconds=0.1)  # written at 22,050 Hz, which the spec does not accept


def bad(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    return write_wav(path, LOW_RATE, rate=22_050)


def commit(root, what):
    git("-C", root, "add", "-A")
    git("-C", root, "commit", "-qm", what)


def submodule_of(root, source, place):
    git("-C", root, "-c", "protocol.file.allow=always", "submodule", "add", "-q", f"file://{source}", place)
    commit(root, f"add {place}")


@pytest.fixture
def with_submodule(tmp_path, monkeypatch):
    """A game whose sounds are a submodule, and whose branch moves it to a commit with a sound of a wrong rate."""
    library, game = tmp_path / "library", tmp_path / "game"
    for root in (library, game):
        root.mkdir()
        git("-C", root, "init", "-q")
        (root / "audio-checks.toml").write_text(new_spec())
    write_wav(library / "good.wav", GOOD)
    commit(library, "first")
    commit(game, "first")
    submodule_of(game, library, "assets/lib")
    git("-C", game, "switch", "-qc", "feature")
    bad(game / "assets" / "lib" / "bad.wav")
    commit(game / "assets" / "lib", "bad")
    git("-C", game / "assets" / "lib", "push", "-q", "origin", "HEAD:moved")
    commit(game, "move")
    monkeypatch.chdir(game)
    return game


def cloned(source, target, *options):
    """Clone as CI services do: the newest commit of the branch, detached."""
    git("clone", "-q", "-c", "protocol.file.allow=always", f"file://{source}", target, "-b", "feature", *options)
    git("-C", target, "checkout", "-q", "--detach")
    return target


def update_submodules(root, *options):
    git("-C", root, "-c", "protocol.file.allow=always", "submodule", "-q", "update", "--init", "--recursive", *options)


@pytest.mark.slow
@pytest.mark.parametrize("paths", [["."], ["assets"], ["assets/lib"], ["assets/lib/bad.wav", "assets/lib/good.wav"]])
def test_a_moved_submodule_is_judged_from_the_commit_that_was_recorded(with_submodule, judged, paths):
    found, _ = judged("main", *paths)
    assert [os.path.normpath(path) for path in found] == ["assets/lib/bad.wav"]


@pytest.mark.slow
def test_the_branch_of_a_submodule_is_not_the_branch_of_the_game(with_submodule, judged):
    git("-C", "assets/lib", "branch", "-f", "feature", "HEAD")  # a branch of the same name, where nothing differs
    assert judged("main", ".")[0] == ["./assets/lib/bad.wav"]
    assert judged("feature", ".")[0] == []


@pytest.mark.slow
def test_changes_in_the_working_tree_of_a_submodule(with_submodule, judged):
    write_wav(with_submodule / "assets" / "lib" / "new.wav", OTHER)
    assert judged("HEAD", ".")[0] == ["./assets/lib/new.wav"]


@pytest.mark.slow
def test_a_new_submodule_is_new_throughout(with_submodule, judged, tmp_path):
    submodule_of(with_submodule, tmp_path / "library", "more")
    assert judged("main", ".")[0] == ["./assets/lib/bad.wav", "./more/good.wav"]


@pytest.mark.slow
def test_a_setting_cannot_hide_a_submodule(with_submodule, judged):
    git("config", "-f", ".gitmodules", "submodule.assets/lib.ignore", "all")
    git("config", "diff.ignoreSubmodules", "all")
    assert judged("main", ".")[0] == ["./assets/lib/bad.wav"]


@pytest.mark.slow
def test_a_submodule_of_a_submodule(with_submodule, judged, tmp_path):
    inner = tmp_path / "inner"
    inner.mkdir()
    git("-C", inner, "init", "-q")
    write_wav(inner / "old.wav", GOOD)
    commit(inner, "first")
    library = with_submodule / "assets" / "lib"
    submodule_of(library, inner, "inner")
    commit(with_submodule, "inner")
    git("switch", "-qc", "later")
    bad(library / "inner" / "deep.wav")
    commit(library / "inner", "deep")
    commit(library, "deep")
    commit(with_submodule, "deep")
    assert judged("feature", ".")[0] == ["./assets/lib/inner/deep.wav"]


@pytest.mark.slow
def test_a_clone_without_the_earlier_commit_of_the_submodule(with_submodule, judged, tmp_path, monkeypatch):
    write_wav(tmp_path / "library" / "later.wav", OTHER)
    commit(tmp_path / "library", "later")  # so that the newest commit of its branch is another one
    clone = cloned(with_submodule, tmp_path / "clone")
    update_submodules(clone, "--depth=1")
    monkeypatch.chdir(clone)
    found, err = judged("origin/main", ".")
    assert found == ["./assets/lib/bad.wav", "./assets/lib/good.wav"]
    assert "its earlier commit" in err
    assert "was not fetched, so every file of the submodule is judged" in err


@pytest.mark.slow
def test_a_shallow_clone_with_both_ends(with_submodule, judged, tmp_path, monkeypatch):
    clone = cloned(with_submodule, tmp_path / "clone", "--depth=1")
    git("-C", clone, "fetch", "-q", "--depth=1", "origin", "main")
    update_submodules(clone)
    monkeypatch.chdir(clone)
    assert judged("FETCH_HEAD", ".")[0] == ["./assets/lib/bad.wav"]


@pytest.mark.slow
def test_a_moved_submodule_that_is_not_checked_out_fails(with_submodule, run, tmp_path, monkeypatch):
    clone = cloned(with_submodule, tmp_path / "clone")
    write_wav(clone / "own.wav", GOOD)
    monkeypatch.chdir(clone)
    code, out, err = run("check", "--changed-since", "origin/main", ".")
    assert (code, "1 file" in out) == (2, True)
    assert "assets/lib: the submodule differs from origin/main and is not checked out" in err
    assert "git submodule update --init --recursive" in err
    code, _, err = run("check", "--changed-since", "origin/main", "--allow-empty", "assets")
    assert (code, "not checked out" in err) == (2, True)
    code, _, err = run("check", "--changed-since", "origin/feature", ".")  # it did not move since then
    assert (code, "the submodule differs" in err) == (0, False)


@pytest.mark.slow
def test_a_submodule_by_itself_has_its_own_branches(with_submodule, judged, monkeypatch):
    monkeypatch.chdir(with_submodule / "assets" / "lib")
    assert judged("HEAD~1", ".")[0] == ["./bad.wav"]


@pytest.mark.slow
def test_another_repository_inside_the_tree_is_judged_whole(repository, judged):
    git("init", "-q", "vendor")
    write_wav(repository / "vendor" / "x.wav", GOOD)
    commit(repository / "vendor", "x")
    found, err = judged("HEAD", ".")
    assert found == ["./vendor/x.wav"]
    assert "a repository of its own and no submodule, so every file of it is judged" in err


@pytest.mark.slow
def test_a_hook_of_git_names_its_own_repository_only(with_submodule, judged, monkeypatch):
    monkeypatch.setenv("GIT_DIR", str(with_submodule / ".git"))
    monkeypatch.setenv("GIT_INDEX_FILE", str(with_submodule / ".git" / "index"))
    assert judged("main", ".")[0] == ["./assets/lib/bad.wav"]


@pytest.mark.slow
def test_links_count_by_where_they_lead(repository, judged, tmp_path):
    shared = tmp_path / "shared"
    shared.mkdir()
    write_wav(shared / "outside.wav", GOOD)
    (repository / "beside").mkdir()
    write_wav(repository / "beside" / "c.wav", GOOD)
    (repository / "sfx").mkdir()
    (repository / "sfx" / "c.wav").symlink_to("../beside/c.wav")
    (repository / "sfx" / "folder").symlink_to("../beside")
    commit(repository, "links")
    assert judged("HEAD", "sfx")[0] == []
    write_wav(repository / "beside" / "c.wav", OTHER)
    assert judged("HEAD", "sfx")[0] == ["sfx/c.wav", "sfx/folder/c.wav"]
    git("checkout", "-q", ".")
    (repository / "sfx" / "shared").symlink_to(shared)
    commit(repository, "shared")
    found, err = judged("HEAD", "sfx")
    assert found == ["sfx/shared/outside.wav"]
    assert "leads to files of no Git repository, so they are judged as if they were new" in err


def test_a_folder_link_that_was_changed_brings_other_sounds(repository, judged):
    for name in ("one", "two"):
        (repository / name).mkdir()
        write_wav(repository / name / "x.wav", GOOD)
    (repository / "sfx").mkdir()
    (repository / "sfx" / "now").symlink_to("../one")
    commit(repository, "links")
    (repository / "sfx" / "now").unlink()
    (repository / "sfx" / "now").symlink_to("../two")
    assert judged("HEAD", "sfx")[0] == ["sfx/now/x.wav"]


def test_a_spec_of_no_repository_is_taken_for_unchanged(repository, judged, tmp_path):
    write_wav(repository / "a.wav", OTHER)
    found, err = judged("HEAD", "--spec", str(tmp_path / "spec.toml"), ".")
    assert found == ["./a.wav"]
    assert "is in no Git repository, so it is taken for unchanged" in err
