"""`soundlist demo` starts again however it ended, or reports in a line what keeps it and how to go on."""

import fcntl
import os
import signal
import socket
import sqlite3
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.accounts.models import Studio
from app.cli import cli
from app.core.runtime import Runtime
from app.demo import project, run
from app.demo.data_lock import DataLock, InUse
from app.demo.progress import Progress
from app.migrate import migrate
from app.settings import Settings

pytestmark = pytest.mark.slow

WITHIN_S = 240.0
STOPS_WITH_INPUT = """
import signal, sys, threading
from app.cli import running

running.KILL_AFTER_S = 0.0
if "deaf" in sys.argv:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
running.stop_when_input_ends()
print("ready", flush=True)
threading.Event().wait()
"""


@pytest.fixture
def demo(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[int], tuple[int, str]]:
    """Run the command in this process on a folder of the test; give its exit code and what it printed."""
    for name in ("BASE_URL", "DEMO", "SECRET_KEY", "LOG_LEVEL"):
        monkeypatch.setenv(f"SOUNDLIST_{name}", "")  # the command sets them for this whole process
        monkeypatch.delenv(f"SOUNDLIST_{name}")
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path))
    monkeypatch.setattr("app.logs.configure", lambda _: None)

    def start(port: int) -> tuple[int, str]:
        result = CliRunner().invoke(cli, ["demo", "--port", str(port)])
        return result.exit_code, result.output

    return start


@pytest.fixture
def taken_port() -> Iterator[int]:
    with socket.create_server(("127.0.0.1", 0)) as other:
        yield int(other.getsockname()[1])


def test_another_demo_in_the_folder_is_named(tmp_path: Path, demo: Callable[[int], tuple[int, str]]):
    with DataLock(tmp_path, pytest.fail):
        code, output = demo(1)
    assert code == 2
    assert f"{tmp_path} is in use by another soundlist demo, process {os.getpid()}; stop it, or" in output
    assert "make run DATA=another-folder" in output


def test_a_taken_port_is_reported_before_anything_is_made(
    tmp_path: Path, demo: Callable[[int], tuple[int, str]], taken_port: int
):
    code, output = demo(taken_port)
    assert code == 2
    assert f"nothing can listen on 127.0.0.1:{taken_port}" in output
    assert f"make run PORT={taken_port + 1}" in output
    assert {path.name for path in tmp_path.iterdir()} == {"soundlist.lock", "processes.lock"}


def test_a_folder_that_cannot_be_used_is_named(
    tmp_path: Path, demo: Callable[[int], tuple[int, str]], monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "data").write_text("a file")
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "data"))
    code, output = demo(1)
    assert code == 2
    assert f"{tmp_path / 'data'} cannot be used" in output
    assert "make run DATA=another-folder" in output


def test_a_database_of_a_newer_version_is_reported(tmp_path: Path, demo: Callable[[int], tuple[int, str]]):
    runtime = Runtime.of(Settings(data_dir=tmp_path))
    migrate(runtime.database)
    with runtime.database.engine.begin() as connection:
        connection.exec_driver_sql("UPDATE alembic_version SET version_num = 'of tomorrow'")
    runtime.close()
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    code, output = demo(port)
    assert code == 2
    assert "at revision of tomorrow" in output
    assert "a newer version made it; update Soundlist" in output
    assert "make run DATA=another-folder" in output


def test_what_a_version_before_the_release_made_is_moved_aside(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    data = tmp_path / "data"
    settings = Settings(data_dir=data)
    data.mkdir()
    with closing(sqlite3.connect(data / "soundlist.sqlite")) as database:
        database.executescript(
            "create table alembic_version (version_num); insert into alembic_version values ('0042')"
        )
    (data / "blobs").mkdir()
    (data / "blobs" / "master").write_bytes(b"a sound")
    run._move_old_data_aside(settings)
    (aside,) = (path for path in tmp_path.iterdir() if path != data)
    assert (aside / "blobs" / "master").read_bytes() == b"a sound"
    assert (aside / "soundlist.sqlite").exists()
    assert list(data.iterdir()) == []
    said = capsys.readouterr().out
    assert "at revision 0042" in said
    assert f"Everything in {data} was moved to {aside}, and a new demo begins in {data}" in said


def test_the_data_of_this_version_stays(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    runtime = Runtime.of(Settings(data_dir=tmp_path / "data"))
    migrate(runtime.database)
    runtime.close()
    before = sorted(path.name for path in (tmp_path / "data").iterdir())
    run._move_old_data_aside(runtime.settings)
    assert [path.name for path in tmp_path.iterdir()] == ["data"]
    assert sorted(path.name for path in (tmp_path / "data").iterdir()) == before
    assert capsys.readouterr().out == ""


def left_behind(data: Path) -> subprocess.Popen[str]:
    """Start a process that keeps the folder in use until its input ends, as a server does whose demo was killed."""
    with DataLock(data, pytest.fail) as lock:
        child = subprocess.Popen(
            [sys.executable, "-c", "input()"], stdin=subprocess.PIPE, pass_fds=[lock.inherited], text=True
        )
        lock.record_processes([child.pid])
    return child


def test_what_a_killed_demo_left_is_waited_for(tmp_path: Path):
    child = left_behind(tmp_path)
    begun: list[str] = []
    waits, has_it = threading.Event(), threading.Event()

    def begin(step: str) -> None:
        begun.append(step)
        waits.set()

    def take() -> None:
        with DataLock(tmp_path, begin):
            has_it.set()

    thread = threading.Thread(target=take)
    thread.start()
    assert waits.wait(WITHIN_S)
    assert not has_it.is_set()
    child.communicate("end\n", timeout=WITHIN_S)
    assert has_it.wait(WITHIN_S)
    thread.join()
    assert begun == ["Waiting for the server and the worker of a demo that was killed"]


def test_what_does_not_end_is_named(tmp_path: Path):
    child = left_behind(tmp_path)
    with pytest.raises(InUse, match=rf"what a killed demo left, process {child.pid}; end it by"):
        DataLock(tmp_path, lambda _: None, patience_s=0).__enter__()
    child.communicate("end\n", timeout=WITHIN_S)
    with (tmp_path / "soundlist.lock").open() as lock:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # the one that was refused keeps nothing


@pytest.mark.parametrize(("arguments", "ends"), [([], -signal.SIGTERM), (["deaf"], -signal.SIGKILL)])
def test_a_process_stops_once_its_parent_is_gone(arguments: list[str], ends: int):
    child = subprocess.Popen(
        [sys.executable, "-c", STOPS_WITH_INPUT, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    assert child.stdin is not None
    assert child.stdout.readline() == "ready\n"
    child.stdin.close()  # as the kernel does for a parent that is killed
    assert child.wait(WITHIN_S) == ends
    child.stdout.close()


def test_a_long_step_is_reported_again_until_the_next():
    lines: list[str] = []
    is_long = threading.Event()

    def report(line: str) -> None:
        lines.append(line)
        if "so far" in line:
            is_long.set()

    with Progress(report, quiet_s=0.01) as progress:
        progress.begin("Preparing the database")
        assert is_long.wait(WITHIN_S)
    assert lines[:2] == ["  Preparing the database …", "  Preparing the database … 0 s so far"]
    after = len(lines)
    progress.begin("Stopping")
    assert lines[after:] == ["  Stopping …"]


def test_a_key_whose_writing_was_cut_off_is_made_again(tmp_path: Path):
    (tmp_path / "secret_key").touch()
    key = run._secret_key(tmp_path)
    assert len(key) == 64
    assert run._secret_key(tmp_path) == key
    assert (tmp_path / "secret_key").stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("is_whole", [True, False])
def test_a_step_that_fails_leaves_the_demo_running(tmp_path: Path, is_whole: bool):
    with socket.create_server(("127.0.0.1", 0)) as probe:  # nothing listens there once it is closed
        address = f"http://127.0.0.1:{probe.getsockname()[1]}"
    settings = Settings(data_dir=tmp_path, base_url=address, secret_key="x" * 32, demo=True)
    runtime = Runtime.of(settings)
    migrate(runtime.database)
    steps: list[str] = []

    def make() -> tuple[str, str] | None:
        with Progress(steps.append) as progress:
            return project.make_demo_project(runtime, progress=progress, keep_going=lambda: is_whole)

    if is_whole:
        with pytest.raises(project.DemoIncomplete, match="Connection refused"):
            make()
    else:  # the server that it asked was stopped
        assert make() is None
    with runtime.database.reading() as session:
        assert session.query(Studio).count() == 1
    assert not (tmp_path / "demo.json").exists()
    runtime.close()
