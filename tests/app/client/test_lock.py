"""soundlist.lock: what it says, how it merges, and what is said of a damaged one."""

import subprocess
from pathlib import Path

import pytest

from app.client.errors import Refusal
from app.client.lock import Entry, Lock, matching, parse, read_lock, write_lock
from app.client.source_control import program

PROJECT = "0198c0de-0000-7000-8000-000000000000"


def entry(path: str, sha256: str = "a" * 64, cue: str = "SW-001") -> Entry:
    return Entry(path, sha256, cue, "0198c0de-1111-7000-8000-000000000000", "b" * 16)


def lock(*entries: Entry) -> Lock:
    return Lock(PROJECT, "game", {one.path: one for one in entries})


MANY = [entry(f"foley/step_{number:02}.wav", cue=f"SW-{number:03}") for number in range(1, 10)]


def test_it_is_sorted_text_and_reads_back() -> None:
    written = lock(entry("ui/ok.wav"), entry("Ambience/wind, cold #2.wav", cue="ÄÖ 7"))
    assert [line.partition("\t")[0] for line in written.text.splitlines()[4:]] == [
        "Ambience/wind, cold #2.wav",
        "ui/ok.wav",
    ]
    assert parse(written.text, Path("soundlist.lock")) == written
    assert parse(written.text.replace("\n", "\r\n"), Path("soundlist.lock")) == written


def test_one_that_is_the_same_is_not_written(tmp_path: Path) -> None:
    assert read_lock(tmp_path) is None
    assert write_lock(tmp_path, lock(*MANY))
    before = (tmp_path / "soundlist.lock").stat()
    assert not write_lock(tmp_path, lock(*reversed(MANY)))
    after = (tmp_path / "soundlist.lock").stat()
    assert (before.st_ino, before.st_mtime_ns) == (after.st_ino, after.st_mtime_ns)
    assert [path.name for path in tmp_path.iterdir()] == ["soundlist.lock"]


def merged(tmp_path: Path, base: Lock, ours: Lock, theirs: Lock) -> tuple[int, str]:
    """What `git merge-file` makes of two changed lock files, as `git merge` does."""
    for name, one in (("ours", ours), ("base", base), ("theirs", theirs)):
        (tmp_path / name).write_text(one.text)
    done = subprocess.run(
        [program("git"), "merge-file", "-p", "ours", "base", "theirs"], cwd=tmp_path, capture_output=True, text=True
    )
    return done.returncode, done.stdout


def test_changes_of_different_lines_merge(tmp_path: Path) -> None:
    ours = lock(entry("ambience/wind.wav"), *MANY[:6], entry(MANY[6].path, "c" * 64), *MANY[7:])
    theirs = lock(MANY[0], *MANY[2:4], entry(MANY[4].path, "d" * 64), *MANY[5:], entry("ui/ok.wav"))
    conflicts, text = merged(tmp_path, lock(*MANY), ours, theirs)
    assert conflicts == 0
    both = {**{one.path: one for one in (*theirs.entries.values(), entry("ambience/wind.wav"))}}
    both[MANY[6].path] = entry(MANY[6].path, "c" * 64)
    assert parse(text, Path("soundlist.lock")) == Lock(PROJECT, "game", both)


def test_a_conflict_is_named_by_its_line_with_the_way_out(tmp_path: Path) -> None:
    changed = [lock(entry(MANY[0].path, sha256 * 64), *MANY[1:]) for sha256 in "cd"]
    conflicts, text = merged(tmp_path, lock(*MANY), *changed)
    assert conflicts == 1
    (tmp_path / "soundlist.lock").write_text(text)
    with pytest.raises(Refusal, match=r"line 5 is a marker of a merge conflict.*checkout --ours.*pull"):
        read_lock(tmp_path)


HEAD = lock().text
LINE = MANY[0].line


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "line 1 is not"),
        ("not ours\n", "line 1 is not"),
        ("soundlist.lock\t2\n", "line 1: its format is newer"),
        ("soundlist.lock\t1\ntarget\tgame\n", "do not name project and target"),
        (HEAD + LINE.replace("\t", " ") + "\n", "line 5 is not a path"),
        (HEAD + LINE[:-1] + "\n", "line 5 is not a path"),
        (HEAD + LINE + "\n" + LINE + "\n", "line 6 names foley/step_01.wav a second time"),
        (HEAD + LINE + "\n\n", "line 6 is not a path"),
        (HEAD + LINE.replace("foley/", "../") + "\n", "line 5 is refused"),
        (HEAD + LINE.replace("foley/", "/") + "\n", "line 5 is refused"),
        (HEAD + "======= \n", "line 5 is a marker"),
        (HEAD + LINE + "\n" + LINE.replace("foley", "FOLEY") + "\n", "one file on some systems"),
    ],
)
def test_a_damaged_one_is_refused_by_its_line(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "soundlist.lock").write_text(text)
    with pytest.raises(Refusal) as refusal:
        read_lock(tmp_path)
    assert said in str(refusal.value)


def test_bytes_that_are_no_text_are_refused_by_their_line(tmp_path: Path) -> None:
    (tmp_path / "soundlist.lock").write_bytes(HEAD.encode() + b"\xff\n")
    with pytest.raises(Refusal, match="line 5 is not UTF-8"):
        read_lock(tmp_path)


@pytest.mark.parametrize(
    ("name", "count"), [("foley/step_01.wav", 1), ("step_01.wav", 1), ("step_01", 1), ("SW-001", 1), ("step", 0)]
)
def test_files_are_found_by_every_name(name: str, count: int) -> None:
    assert len(matching(MANY, name)) == count
