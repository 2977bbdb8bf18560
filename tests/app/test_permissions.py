"""Nobody but the server's own user reads what it keeps: the modes of files that its real processes write."""

import os
import stat
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from app.core.db import new_id
from app.core.permissions import OTHERS, tighten
from app.core.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def generous_umask() -> Iterator[None]:
    """Start commands as a login shell does, where new files are readable by everyone."""
    before = os.umask(0o022)
    yield
    os.umask(before)


def soundlist(data_dir: Path, *arguments: str, **more: str) -> "subprocess.CompletedProcess[str]":
    environment = os.environ | {"SOUNDLIST_DATA_DIR": str(data_dir), "SOUNDLIST_SECRET_KEY": "k" * 32} | more
    return subprocess.run(
        [sys.executable, "-m", "app", *arguments], cwd=ROOT, env=environment, capture_output=True, text=True
    )


def readable_by_others(*roots: Path) -> list[str]:
    every = [path for root in roots for path in (root, *root.rglob("*"))]
    assert len(every) > len(roots)
    return [f"{path} {mode(path):04o}" for path in every if mode(path) & OTHERS]


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@pytest.mark.slow
def test_what_was_open_is_tightened_and_what_is_written_is_the_servers_alone(tmp_path: Path):
    data, backups = tmp_path / "data", tmp_path / "backups"
    runtime = Runtime.of(Settings(data_dir=data))
    migrate(runtime.database)
    runtime.store.put(new_id(), [b"a sound"])
    (data / "secret_key").write_text("k" * 32)
    backups.mkdir()
    (backups / "database-1.sqlite").write_bytes(b"an older copy")
    old = [data, backups, *data.iterdir(), *backups.iterdir()]
    assert {path.name for path in old} >= {"soundlist.sqlite", "soundlist.sqlite-wal", "secret_key", "blobs"}
    for path in old:
        path.chmod(0o755 if path.is_dir() else 0o644)

    done = soundlist(data, "backup", str(backups))
    assert (done.returncode, done.stderr) == (0, "")
    assert [f"{path} {mode(path):04o}" for path in old if path.exists() and mode(path) & OTHERS] == []
    assert readable_by_others(backups) == []
    runtime.close()

    assert soundlist(tmp_path / "new", "restore", str(backups)).returncode == 0
    assert len(list((tmp_path / "new" / "blobs").rglob("*"))) == 3
    assert readable_by_others(tmp_path / "new") == []


def test_what_cannot_be_tightened_is_named():
    shared = Path(tempfile.mkdtemp())
    try:
        shared.chmod(0o1777)
        assert tighten([shared, shared / "not there"]) == [
            f"{shared} is a folder that all users share (mode 1777); name a folder of Soundlist's own"
        ]
        assert mode(shared) == 0o1777
        shared.chmod(0o755)
        with another_user() as owned_by_another:
            path = owned_by_another or shared
            [line] = tighten([path])
        assert line == (
            f"{path} can be read by other users (mode 0755), and this user does not own it; "
            f"as its owner run: chmod go= {path}"
        )
    finally:
        shared.rmdir()


@contextmanager
def another_user() -> Iterator[Path | None]:
    """Be another user for a block where this user may; give a folder that another user owns where not."""
    if os.geteuid():
        yield Path("/usr")
        return
    os.seteuid(65_534)
    try:
        yield None
    finally:
        os.seteuid(0)
