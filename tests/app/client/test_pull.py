"""`soundlist pull` against a real server over a socket."""

import io
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from app.client.lock import read_lock
from app.client.source_control import program
from tests.app.builds.approved import accepted_list, approve, sound
from tests.app.client.served import PATHS, Client, client_of, files_in, states_of
from tests.support.deliver import add_cues, deliver
from tests.support.server import World


def packed(world: World) -> dict[str, bytes]:
    """The game files of the pack, which a pull makes a folder equal to."""
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        return {name: archive.read(name) for name in archive.namelist() if name.endswith(".wav")}


@pytest.mark.slow
def test_an_empty_folder_gets_the_files_of_the_pack(client: Client, game: Path) -> None:
    assert client.pull(game) == 0, client.out + client.err
    assert files_in(game) == packed(client.world)
    lock = read_lock(game)
    assert lock is not None
    assert (lock.project, lock.target) == (str(client.world.project_id), "game")
    assert [(entry.path, entry.cue) for entry in lock.entries.values()] == list(
        zip(PATHS, ["SW-001", "SW-001", "SW-002"], strict=True)
    )
    assert "added  ui_confirm.wav  SW-002 UI confirm" in client.out
    assert client.out.splitlines()[-1] == "Shield Wing, game: 3 approved files, 3 added, 0 unchanged"


def test_a_second_pull_touches_nothing(client: Client, game: Path) -> None:
    client.pull(game)
    before = states_of(game)
    assert client.pull(game, "--prune", "--force") == 0
    assert states_of(game) == before
    assert len(client.line.downloads) == 3
    assert client.out.splitlines() == ["Shield Wing, game: 3 approved files, 3 unchanged"]


def test_without_a_lock_file_what_is_as_approved_is_not_written_again(client: Client, game: Path) -> None:
    client.pull(game)
    text = (game / "soundlist.lock").read_bytes()
    (game / "soundlist.lock").unlink()
    before = states_of(game)
    assert client.pull(game) == 0
    assert (game / "soundlist.lock").read_bytes() == text
    assert before.items() <= states_of(game).items()
    assert len(client.line.downloads) == 3


@pytest.mark.slow
def test_only_a_changed_sound_is_written_and_a_cut_cue_is_reported_then_pruned(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path
) -> None:
    accepted_list(world)
    with client_of(world, monkeypatch, capsys) as client:
        client.pull(game)
        before = states_of(game)
        take = deliver(world, "ui_confirm.wav", sound(77))
        world.server.wait_for_jobs()
        assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
        world.server.wait_for_jobs()
        assert client.pull(game, "--dry-run") == 1
        assert "would change  ui_confirm.wav" in client.out
        assert states_of(game) == before
        assert client.pull(game) == 0
        changed = {Path(path).name for path, state in states_of(game).items() if before.get(path) != state}
        assert changed == {"ui_confirm.wav", "soundlist.lock"}
        assert files_in(game) == packed(world)

        cue = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"][0]
        assert world.producer.post(f"/v1/cues/{cue['id']}/cut", json={"reason": "no lasers"}).status_code == 200
        (game / "laser_fire_02.wav").write_bytes(b"mine")
        assert client.pull(game) == 0
        assert "left  laser_fire_01.wav  SW-001: no longer approved; --prune removes it" in client.out
        assert client.pull(game, "--prune") == 0
        assert set(files_in(game)) == {"laser_fire_02.wav", "ui_confirm.wav"}
        assert "laser_fire_02.wav  SW-001: no longer approved; it was changed here" in client.out
        assert client.pull(game, "--prune", "--force") == 0
        assert set(files_in(game)) == {"ui_confirm.wav"}
        lock = read_lock(game)
        assert lock is not None
        assert set(lock.entries) == {"ui_confirm.wav"}


@pytest.mark.slow
def test_what_was_changed_here_is_named_and_kept_unless_forced(client: Client, game: Path) -> None:
    client.pull(game)
    (game / PATHS[0]).write_bytes(b"louder")
    (game / PATHS[1]).unlink()
    assert client.pull(game) == 1
    assert f"kept  {PATHS[0]}: it was changed here since it was pulled; --force overwrites it" in client.out
    assert (game / PATHS[0]).read_bytes() == b"louder"
    assert client.pull(game, "--force") == 0
    assert files_in(game) == packed(client.world)


@pytest.mark.slow
def test_a_file_that_was_there_before_is_kept_unless_forced(client: Client, game: Path) -> None:
    (game / PATHS[2]).write_bytes(b"from the prototype")
    assert client.pull(game) == 1
    assert f"kept  {PATHS[2]}: it was here before and is not from Soundlist" in client.out
    lock = read_lock(game)
    assert lock is not None
    assert PATHS[2] not in lock.entries
    assert client.pull(game, "--force") == 0
    assert files_in(game) == packed(client.world)


def test_a_read_only_file_waits_for_its_source_control(client: Client, game: Path) -> None:
    client.pull(game)
    client.line.change_listing = lambda said: said["files"][0].update(sound="0" * 16, sha256="0" * 64)
    (game / PATHS[0]).chmod(0o444)
    assert client.pull(game) == 1
    assert f"kept  {PATHS[0]}: it is read-only" in client.out


@pytest.mark.slow
def test_other_bytes_around_the_same_sound_are_not_written(client: Client, game: Path) -> None:
    client.pull(game)
    before = states_of(game)
    client.line.change_listing = lambda said: said["files"][0].update(sha256="0" * 64)
    assert client.pull(game) == 0
    assert states_of(game) == before


@pytest.mark.slow
def test_a_file_whose_bytes_are_here_under_another_name_is_copied(client: Client, game: Path) -> None:
    client.pull(game)

    def rename(said: dict) -> None:
        said["files"][0]["path"] = "weapon/laser.wav"

    client.line.change_listing = rename
    assert client.pull(game, "--prune") == 0
    assert len(client.line.downloads) == 3
    assert files_in(game) == {("weapon/laser.wav" if n == PATHS[0] else n): b for n, b in packed(client.world).items()}


@pytest.mark.slow
def test_a_name_of_which_only_the_case_changed_is_not_removed(client: Client, game: Path) -> None:
    client.pull(game)
    renamed = PATHS[0].capitalize()
    (game / renamed).hardlink_to(game / PATHS[0])  # one file under both names, as where case does not count
    client.line.change_listing = lambda said: said["files"][0].update(path=renamed)
    assert client.pull(game, "--prune") == 0
    assert (game / renamed).exists()
    lock = read_lock(game)
    assert lock is not None
    assert set(lock.entries) == {renamed, *PATHS[1:]}


def test_a_pointer_of_git_lfs_counts_as_the_file_it_points_to(client: Client, game: Path) -> None:
    client.pull(game)
    lock = read_lock(game)
    assert lock is not None
    pointer = f"version https://git-lfs.github.com/spec/v1\noid sha256:{lock.entries[PATHS[0]].sha256}\nsize 22094\n"
    (game / PATHS[0]).write_text(pointer)
    assert client.pull(game) == 0
    assert (game / PATHS[0]).read_text() == pointer


@pytest.mark.slow
def test_the_release_gate_names_what_is_not_final(client: Client, game: Path) -> None:
    assert client.pull(game, "--no-placeholders") == 1
    assert "not final  warp_in.wav  SW-003: no sound is accepted for it yet" in client.out
    assert files_in(game) == {}
    client.line.change_listing = lambda said: said["placeholders"].clear()
    assert client.pull(game, "--no-placeholders") == 0
    client.line.change_listing = lambda said: (said["placeholders"].clear(), said["files"].pop())
    assert client.pull(game, "--no-placeholders") == 1
    assert "not final  ui_confirm.wav  SW-002: no longer approved" in client.out
    assert client.pull(game, "--no-placeholders", "--prune") == 0


def test_another_target_is_another_folder(client: Client, game: Path, tmp_path: Path) -> None:
    assert client.pull(game, "--target", "handheld") == 0
    lock = read_lock(game)
    assert lock is not None
    assert lock.target == "handheld"
    assert client.pull(game) == 0, "the lock file names the target"
    assert client.pull(game, "--target", "game") == 2
    assert 'this folder holds the sounds for "handheld"' in client.err
    other = tmp_path / "other"
    other.mkdir()
    assert client.pull(other, "--target", "toaster") == 2
    assert 'the spec has no target "toaster"' in client.err


def test_a_settings_file_above_the_folder_names_server_and_project(
    client: Client, game: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    client.source = []
    assert client.pull(game) == 2
    assert "which server and project?" in client.err
    settings = game.parent / "soundlist.toml"
    settings.write_text(f'server = "http://127.0.0.1:{client.port}"\nproject = "{client.world.project_id}"\n')
    assert client.pull(game) == 0, client.out + client.err
    settings.write_text('servant = "x"\n')
    assert client.pull(game) == 2
    assert '"servant" is none of the settings server, project, target' in client.err
    client.source = ["--server", "http://sounds.example", "--project", str(client.world.project_id)]
    settings.unlink()
    assert client.pull(game) == 2
    assert "unencrypted" in client.err
    monkeypatch.delenv("SOUNDLIST_TOKEN")
    client.source = ["--server", "https://sounds.example"]
    assert client.pull(game) == 2
    assert "SOUNDLIST_TOKEN is not set" in client.err


def test_a_token_that_is_revoked_or_lacks_its_scope_is_refused(
    client: Client, game: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SOUNDLIST_TOKEN", "slt_unknown")
    assert client.pull(game) == 2
    assert "does not know this token" in client.err
    with client_of(client.world, monkeypatch, capsys, "list:read") as other:
        assert other.pull(game) == 2
        assert "this token lacks the scope manifest:read" in other.err
    assert files_in(game) == {}


@pytest.mark.slow
def test_two_pulls_of_different_branches_merge_in_git(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path
) -> None:
    cues = add_cues(world, *({"name": f"Step {number}", "file_name": f"step_{number}"} for number in range(3)))
    approve(world, cues[1:2])
    with client_of(world, monkeypatch, capsys) as client:

        def git(*arguments: str) -> str:
            identity = ["-c", "user.name=test", "-c", "user.email=test@example.test", "-c", "init.defaultBranch=main"]
            done = subprocess.run([program("git"), *identity, *arguments], cwd=game, capture_output=True, text=True)
            assert done.returncode == 0, done.stdout + done.stderr
            return done.stdout

        git("init", "-q")
        client.pull(game)
        git("add", ".")
        git("commit", "-qm", "one step")
        git("checkout", "-qb", "first")
        approve(world, cues[:1])
        client.pull(game)
        git("add", ".")
        git("commit", "-qm", "the first step")
        git("checkout", "-q", "main")
        approve(world, cues[2:])
        client.line.change_listing = lambda said: said["files"].pop(0)
        client.pull(game)
        client.line.change_listing = None
        git("add", ".")
        git("commit", "-qm", "the last step")
        git("merge", "-q", "-m", "both", "first")
        before = states_of(game)
        assert client.pull(game) == 0
        assert client.out.splitlines() == ["Shield Wing, game: 3 approved files, 3 unchanged"]
        assert {path: state for path, state in states_of(game).items() if ".git/" not in path} == {
            path: state for path, state in before.items() if ".git/" not in path
        }


@pytest.mark.slow
def test_it_starts_without_what_a_server_needs() -> None:
    code = "import sys, app.client.commands; print(*sorted(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stdout.split()} - sys.stdlib_module_names
    assert {name for name in loaded if not name.startswith("_")} == {"app"}


@pytest.mark.slow
@pytest.mark.parametrize("command", ["pull", "why"])
def test_the_program_takes_the_options_of_the_client(command: str, game: Path) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "SOUNDLIST_TOKEN"}
    done = subprocess.run(
        [sys.executable, "-m", "app", command, *(["x"] if command == "why" else []), "--server", "https://sounds.example"],
        env=environment, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 2
    assert f"soundlist {command}: which project?" in done.stderr
