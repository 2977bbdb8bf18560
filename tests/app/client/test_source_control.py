"""Files are opened in Perforce or locked in Git LFS before they are written.

The programs are substitutes that know what their documents name, refuse all else, and record what they are asked.
"""

import json
import stat
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.app.client.served import PATHS, Client, files_in, states_of

PERFORCE = """
import json, os, pathlib, stat, sys
record, depot = pathlib.Path(os.environ["RECORD"]), pathlib.Path(os.environ["RECORD"] + ".depot")
known = set(json.loads(depot.read_text())) if depot.exists() else set()
given, options = sys.argv[1:], []
lines = sys.stdin.read()
def plain(name):
    for sign, code in (("@", "%40"), ("#", "%23"), ("*", "%2A"), ("%", "%25")):
        name = name.replace(code, sign)
    return pathlib.Path(name)
with record.open("a") as file:
    file.write(json.dumps([given, lines, sorted(str(p.name) for p in pathlib.Path.cwd().glob("*.wav"))]) + "\\n")
if given == ["change", "-i"]:
    print("Change 4711 created.")
    sys.exit()
if given[:2] != ["-x", "-"]:
    sys.exit("Unknown argument: " + repr(given))
verb, rest = given[2], given[3:]
if rest[:1] == ["-c"]:
    if rest[1] != "4711":
        sys.exit("Change unknown.")
    rest = rest[2:]
if (verb, rest) not in (("edit", []), ("add", ["-f"]), ("delete", [])):
    sys.exit("Invalid option: " + repr(given))
for name in lines.splitlines():
    path = pathlib.Path(name) if verb == "add" else plain(name)
    if verb == "edit" and os.environ.get("REFUSES"):
        sys.exit("Perforce password (P4PASSWD) invalid or unset.")
    if verb != "add" and str(path) not in known:
        print(f"{name} - file(s) not on client.", file=sys.stderr)
        continue
    if verb == "edit":
        path.chmod(path.stat().st_mode | stat.S_IWUSR)
        print(f"{path}#1 - opened for edit")
    if verb == "add":
        known.add(str(path))
    if verb == "delete":
        path.unlink()
        known.discard(str(path))
depot.write_text(json.dumps(sorted(known)))
"""
LFS = """
import json, os, pathlib, sys
with open(os.environ["RECORD"], "a") as file:
    file.write(json.dumps(sys.argv[1:]) + "\\n")
if sys.argv[1:4] != ["lfs", "lock", "--"] or len(sys.argv) != 5 or not pathlib.Path(sys.argv[4]).exists():
    sys.exit("Error: unknown command")
if os.environ.get("REFUSES") == sys.argv[4]:
    sys.exit("Locking " + sys.argv[4] + " failed: Lock exists")
"""


@pytest.fixture
def programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder of programs, the only one on PATH."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setenv("RECORD", str(tmp_path / "record"))
    return folder


def install(folder: Path, name: str, source: str) -> None:
    program = folder / name
    program.write_text(f"#!{sys.executable}\n{source}")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)


def recorded(folder: Path) -> list[Any]:
    path = folder.parent / "record"
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def other_sound(said: dict[str, Any]) -> None:
    """The last file is approved with the bytes of the second, at a path that Perforce has to be given in codes."""
    del said["files"][0]
    said["files"][1] |= {key: said["files"][0][key] for key in ("sha256", "bytes", "sound", "url")}


@pytest.mark.slow
def test_new_files_are_added_after_they_are_written_with_a_changelist(
    client: Client, game: Path, programs: Path
) -> None:
    install(programs, "p4", PERFORCE)
    client.line.change_listing = lambda said: said["files"][0].update(path="laser#1@50%.wav")
    assert client.pull(game, "--p4", "--changelist") == 0, client.err
    (change, _), (add, added) = [(given, lines) for given, lines, _ in recorded(programs)]
    assert change == ["change", "-i"]
    assert add == ["-x", "-", "add", "-c", "4711", "-f"]
    assert added.splitlines() == [str(game / name) for name in ("laser#1@50%.wav", *PATHS[1:], "soundlist.lock")]
    form = recorded(programs)[0][1]
    assert form.startswith("Change:\tnew\n\nDescription:\n\tSoundlist: 3 files of Shield Wing for game\n")
    assert "\tSW-001 Laser fire\n\t  add laser#1@50%.wav\n\t  add laser_fire_02.wav\n" in form
    assert "changelist 4711" in client.out


@pytest.mark.slow
def test_changed_files_are_opened_first_and_removed_ones_deleted(client: Client, game: Path, programs: Path) -> None:
    install(programs, "p4", PERFORCE)
    client.pull(game, "--p4")
    for path in game.iterdir():
        path.chmod(0o444)
    (programs.parent / "record").unlink()
    client.line.change_listing = other_sound
    before = states_of(game)
    assert client.pull(game, "--prune") == 1, "without --p4 read-only files stay"
    assert {path: state for path, state in states_of(game).items() if not path.endswith(".lock")} == {
        path: state for path, state in before.items() if not path.endswith(".lock")
    }
    assert client.pull(game, "--p4", "--prune") == 0, client.out + client.err
    (edit, edited, there), (delete, deleted, _) = recorded(programs)
    assert (edit, delete) == (["-x", "-", "edit"], ["-x", "-", "delete"])
    assert edited.splitlines() == [str(game / PATHS[2]), str(game / "soundlist.lock")]
    assert there == PATHS
    assert deleted.splitlines() == [str(game / PATHS[0])]
    assert set(files_in(game)) == set(PATHS[1:])
    assert files_in(game)[PATHS[1]] == files_in(game)[PATHS[2]]


@pytest.mark.slow
def test_a_file_that_perforce_does_not_have_is_added(client: Client, game: Path, programs: Path) -> None:
    install(programs, "p4", PERFORCE)
    (game / PATHS[2]).write_bytes(b"from the prototype")
    assert client.pull(game, "--p4", "--force") == 0, client.err
    (edit, edited, _), (add, added, _) = recorded(programs)
    assert (edit, edited.splitlines()) == (["-x", "-", "edit"], [str(game / PATHS[2])])
    assert sorted(added.splitlines()) == sorted(str(game / name) for name in (*PATHS, "soundlist.lock"))
    assert add == ["-x", "-", "add", "-f"]


@pytest.mark.slow
def test_nothing_is_opened_where_nothing_changes(client: Client, game: Path, programs: Path) -> None:
    install(programs, "p4", PERFORCE)
    client.pull(game, "--p4")
    (programs.parent / "record").unlink()
    assert client.pull(game, "--p4", "--changelist") == 0
    assert client.pull(game, "--p4", "--dry-run") == 0
    assert recorded(programs) == []


@pytest.mark.slow
def test_a_lock_file_that_is_not_checked_out_stops_the_pull(client: Client, game: Path) -> None:
    client.pull(game)
    (game / "soundlist.lock").chmod(0o444)
    assert client.pull(game) == 0, "nothing changes"
    (game / PATHS[0]).unlink()
    before = states_of(game)
    client.line.change_listing = other_sound
    assert client.pull(game) == 2
    assert "soundlist.lock is read-only; --p4 or --lfs-lock opens it" in client.err
    assert states_of(game) == before


@pytest.mark.parametrize("options", [["--p4"], ["--lfs-lock"]])
def test_a_missing_program_stops_the_pull_before_anything_is_written(
    client: Client, game: Path, programs: Path, options: list[str]
) -> None:
    (game / ("p4" if options == ["--p4"] else "git")).write_text("#!/bin/sh\ntouch owned\n")
    (game / ("p4" if options == ["--p4"] else "git")).chmod(0o755)
    before = states_of(game)
    assert client.pull(game, *options) == 2
    assert "is not on PATH; install it, or leave its option out. Nothing was written" in client.err
    assert states_of(game) == before


@pytest.mark.slow
def test_what_perforce_refuses_stops_the_pull_before_anything_is_written(
    client: Client, game: Path, programs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    install(programs, "p4", PERFORCE)
    client.pull(game, "--p4")
    before = states_of(game)
    monkeypatch.setenv("REFUSES", "yes")
    client.line.change_listing = other_sound
    assert client.pull(game, "--p4", "--prune") == 2
    assert "Perforce password (P4PASSWD) invalid or unset." in client.err
    assert states_of(game) == before


@pytest.mark.slow
def test_changed_files_are_locked_in_git_lfs(
    client: Client, game: Path, programs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    install(programs, "git", LFS)
    install(programs, "git-lfs", "")
    assert client.pull(game, "--lfs-lock") == 0, client.err
    assert recorded(programs) == [], "no one else has a new file"
    client.line.change_listing = other_sound
    monkeypatch.setenv("REFUSES", PATHS[2])
    before = states_of(game)
    assert client.pull(game, "--lfs-lock") == 2
    assert f"Locking {PATHS[2]} failed: Lock exists" in client.err
    assert states_of(game) == before
    monkeypatch.delenv("REFUSES")
    assert client.pull(game, "--lfs-lock", "--changelist") == 0
    locked = [given[-1] for given in recorded(programs)]
    assert locked == [PATHS[2], PATHS[2], "soundlist.lock"]
    assert "SW-002 UI confirm\n  change ui_confirm.wav" in client.out
