"""Secrets of a server, planted where a server has them: no child that reads strangers' bytes reaches one."""

import os
import secrets
import socket
import sqlite3
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app import registry
from app.conformance import checking
from app.core import typesetting
from app.core.parsing import Parsers
from app.renders import children
from app.settings import Settings
from audio_checks import Sandbox, confinement_gaps

pytestmark = pytest.mark.skipif(bool(confinement_gaps()), reason="; ".join(confinement_gaps()))
VARIABLES = (
    "SOUNDLIST_SECRET_KEY", "SOUNDLIST_DATABASE_URL", "SOUNDLIST_METRICS_TOKEN",
    "AWS_SECRET_ACCESS_KEY", "AWS_SESSION_TOKEN", "PGPASSWORD", "PYTHONPATH",
)  # fmt: skip
CHUNK = 1 << 20


def parsers() -> Sandbox:
    """Return what parses sheets, specs and templates, with the modules that a web process has it load."""
    made = Parsers()
    made.connect(registry.PARSERS)
    return made._sandbox


KINDS: dict[str, Callable[[], Sandbox]] = {
    "what parses sheets, specs and templates": parsers,
    "what makes PDFs": typesetting._sandbox.__wrapped__,
    "what reads masters": checking.sandbox.__wrapped__,
    "what draws and renders": children.sandbox.__wrapped__,
}


@pytest.fixture
def planted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[bytes, Path]]:
    """Return a secret that is in this process's environment and memory and in every file of a data folder."""
    secret = secrets.token_hex(20)
    for name in VARIABLES:
        monkeypatch.setenv(name, f"postgresql://soundlist:{secret}@127.0.0.1/soundlist")
    data = tmp_path / "data"
    for name in ("blobs/studio/other-master", "uploads/half", "secret_key", "backup/manifest.json"):
        (data / name).parent.mkdir(parents=True, exist_ok=True)
        (data / name).write_text(secret)
    with sqlite3.connect(data / "soundlist.sqlite") as database:
        database.execute("CREATE TABLE accounts_sign_ins (secret)")
        database.execute("INSERT INTO accounts_sign_ins VALUES (?)", (secret,))
    for path in (tmp_path, data, *data.rglob("*")):
        path.chmod(0o777)  # so that no user of the system is what stops a child
    with open(data / "secret_key", "rb", buffering=0) as held:
        os.set_inheritable(held.fileno(), True)
        settings = Settings(data_dir=data, secret_key=secret)
        yield secret.encode(), data
        assert settings.secret_key.get_secret_value().encode() == secret.encode()  # it was there all the while


def read_everywhere(files: list[str], folders: list[str], caller: int, port: int, line: str) -> list[bytes]:
    """Run in a child: return all that can be read of what is named, of other processes and of what is held open."""
    parent = os.getppid()
    found = [name.encode() + b"=" + value.encode() for name, value in os.environ.items()]
    for process in (caller, parent, 1):
        files = [*files, *(f"/proc/{process}/{name}" for name in ("environ", "mem", "cmdline", "maps"))]
        folders = [*folders, f"/proc/{process}/fd", f"/proc/{process}/cwd", f"/proc/{process}/root"]
    for path in [*files, "/proc/self/environ", "/proc/self/mem", "/etc/passwd"]:
        try:
            with open(path, "rb") as file:
                found.append(path.encode() + b": " + file.read(CHUNK))
        except OSError:
            continue
    for folder in [*folders, "/"]:
        try:
            found += [f"{folder}: {name}".encode() for name in os.listdir(folder)]
        except OSError:
            continue
    for descriptor in range(4, 1_024):
        try:
            os.lseek(descriptor, 0, os.SEEK_SET)
            found.append(os.read(descriptor, CHUNK))
        except OSError:
            continue
    for family, address in ((socket.AF_INET, ("127.0.0.1", port)), (socket.AF_UNIX, line)):
        try:
            with socket.socket(family) as connection:
                connection.connect(address)
                found.append(b"connected to " + repr(address).encode())
        except OSError:
            continue
    return found


def memory_of(pid: int) -> Iterator[bytes]:
    """Yield what a process can write to, so all that it did not read from its programs' files, piece by piece."""
    with open(f"/proc/{pid}/maps") as maps, open(f"/proc/{pid}/mem", "rb", buffering=0) as memory:
        for row in maps:
            span, modes, *_ = row.split()
            begin, end = (int(number, 16) for number in span.split("-"))
            if not modes.startswith("rw"):
                continue
            kept = b""
            for place in range(begin, end, CHUNK):
                try:
                    memory.seek(place)
                    piece = memory.read(min(CHUNK, end - place))
                except (OSError, ValueError, OverflowError):
                    break
                yield kept + piece
                kept = piece[-64:]


def holds(pid: int, secret: bytes) -> bool:
    return any(secret in piece for piece in memory_of(pid))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_no_planted_secret_is_reached(kind: str, planted: tuple[bytes, Path], tmp_path: Path) -> None:
    secret, data = planted
    mine = tmp_path / "mine.wav"
    mine.write_bytes(b"mine")
    with socket.create_server(("127.0.0.1", 0)) as web, socket.socket(socket.AF_UNIX) as database:
        database.bind(line := str(tmp_path / "line"))
        database.listen()
        files, folders = (
            [str(path) for path in data.rglob("*") if path.is_file()],
            [str(data), str(data / "blobs"), tempfile.gettempdir()],
        )
        box = KINDS[kind]()
        try:
            with box.child(timeout_s=60.0, reads=[mine]) as child:
                asked = ([*files, str(mine)], folders, os.getpid(), web.getsockname()[1], line)
                found = child.call(read_everywhere, *asked)
                pid, server = child.call(os.getpid), child.call(os.getppid)
                in_memory = [holds(one, secret) for one in (pid, server)]
        finally:
            box.close()
    assert holds(os.getpid(), secret)  # looking for it finds it where it is
    assert in_memory == [False, False]
    assert [piece for piece in found if secret in piece] == []
    names = {piece.partition(b"=")[0].decode() for piece in found if b"=" in piece.split(b": ")[0]}
    assert names & {*VARIABLES} == set()
    others = [piece for piece in found if b": " in piece or piece.startswith(b"connected")]
    assert others == [str(mine).encode() + b": mine"]
