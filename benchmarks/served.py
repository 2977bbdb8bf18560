"""The server as an operator runs it, for benchmarks: processes of their own on a database that is there."""

import os
import secrets
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

import httpx

from app.accounts.authentication import CSRF_HEADER, SESSION_COOKIE, csrf_token
from app.core.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings

ALIVE_WITHIN_S = 180.0
TICKS_A_SECOND = os.sysconf("SC_CLK_TCK")
SECRET_KEY = secrets.token_hex(16)


@dataclass
class Place:
    """Where a benchmark's server keeps its data, and on which database."""

    folder: Path
    database_url: str = ""
    environment: dict[str, str] = field(default_factory=dict)

    @property
    def settings(self) -> Settings:
        """The settings that the processes read from their environment."""
        return Settings(data_dir=self.folder, database_url=self.database_url, secret_key=SECRET_KEY)

    def runtime(self) -> Runtime:
        """Open what the processes use, with the tables of this version."""
        runtime = Runtime.of(self.settings)
        migrate(runtime.database)
        return runtime

    @contextmanager
    def running(self, *command: str, name: str, **environment: str) -> Iterator[subprocess.Popen[bytes]]:
        """Run a command of the server for the length of a block; its log is kept in the folder."""
        with self.running_python("-m", "app", *command, name=name, **environment) as process:
            yield process

    @contextmanager
    def running_python(self, *command: str, name: str, **environment: str) -> Iterator[subprocess.Popen[bytes]]:
        """Run Python in the server's environment for the length of a block; its log is kept in the folder."""
        variables = {
            "SOUNDLIST_DATA_DIR": str(self.folder),
            "SOUNDLIST_DATABASE_URL": self.database_url,
            "SOUNDLIST_SECRET_KEY": SECRET_KEY,
            "SOUNDLIST_LOG_LEVEL": "WARNING",
        }
        with (self.folder / f"{name}.log").open("ab") as log:
            process = subprocess.Popen(
                [sys.executable, *command],
                env=os.environ | variables | self.environment | environment,
                stdout=log,
                stderr=log,
            )
        try:
            yield process
        finally:
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    @contextmanager
    def serving(self, *, processes: int = 1) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
        """Give the address of a web application that answers, by one process or several of the one given."""
        port = free_port()
        with self.running("serve", "--port", str(port), name="web", SOUNDLIST_WEB_PROCESSES=str(processes)) as process:
            address = f"http://127.0.0.1:{port}"
            wait_until_alive(address, process, self.folder / "web.log")
            yield address, process


def free_port() -> int:
    """Return a free port."""
    with socket.socket() as asked:
        asked.bind(("127.0.0.1", 0))
        return int(asked.getsockname()[1])


def wait_until_alive(address: str, process: subprocess.Popen[bytes], log: Path) -> None:
    """Return once the server answers; fail when it ends or takes too long."""
    deadline = time.monotonic() + ALIVE_WITHIN_S
    while time.monotonic() < deadline:
        if process.poll() is not None:
            raise SystemExit(f"the server ended with {process.returncode}:\n{log.read_text()[-2000:]}")
        try:
            if httpx.get(f"{address}/healthz", timeout=2).status_code == httpx.codes.OK:
                return
        except httpx.TransportError:
            time.sleep(0.1)
    raise SystemExit("the server did not answer in time")


def own_cpu_seconds(pid: int) -> float:
    """Return what a process has used by itself."""
    return sum(map(int, _stat(pid)[11:13])) / TICKS_A_SECOND


def cpu_now_s(web_pid: int, database_pid: int | None) -> dict[int, float]:
    """Return the CPU time, to the microsecond, of each web process and of each process of their database."""
    pids = [web_pid, *_children(web_pid), *(_children(database_pid) if database_pid is not None else ())]
    spent = {}
    for pid in pids:
        with suppress(OSError):  # one that just ended
            spent[pid] = time.clock_gettime(~pid << 3 | 2)  # clock_getcpuclockid(3)
    return spent


def cpu_since_s(before: dict[int, float], web_pid: int, database_pid: int | None) -> float:
    """Return what they have used since."""
    now = cpu_now_s(web_pid, database_pid)
    return sum(now[pid] - spent for pid, spent in before.items() if pid in now)


def cpu_seconds(pid: int) -> float:
    """Return what a process and all below it have used, those that ended included."""
    return sum(map(int, _stat(pid)[11:15])) / TICKS_A_SECOND + sum(map(_cpu_seconds_if_there, _children(pid)))


def memory_bytes(pid: int) -> int:
    """Return what a process and those directly below it hold in memory; pages that they share count in each."""
    return sum(_resident_bytes(one) for one in (pid, *_children(pid)))


def _children(pid: int) -> list[int]:
    """Return the processes that any thread of a process started and that are still there."""
    children: list[int] = []
    for task in Path(f"/proc/{pid}/task").iterdir():
        with suppress(FileNotFoundError, ProcessLookupError):  # a thread that has just ended
            children += map(int, (task / "children").read_text().split())
    return children


def _resident_bytes(pid: int) -> int:
    try:
        return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (FileNotFoundError, ProcessLookupError):
        return 0


def _cpu_seconds_if_there(pid: int) -> float:
    try:
        return cpu_seconds(pid)
    except (FileNotFoundError, ProcessLookupError):
        return 0.0  # it ended meanwhile, and is its parent's from now on


def _stat(pid: int) -> list[str]:
    return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()


def headers_for(secret: str) -> dict[str, str]:
    """Return the headers that a browser with this sign-in sends."""
    settings = Settings(secret_key=SECRET_KEY)
    return {"Cookie": f"{SESSION_COOKIE}={secret}", CSRF_HEADER: csrf_token(settings, secret)}
