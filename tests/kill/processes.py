"""Real server processes over one data folder and database, to be killed and started again."""

import inspect
import json
import os
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import httpx
from fastapi.testclient import TestClient

from app.core import kill_points
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
SECRET_KEY = "only for tests, nowhere else"
PATIENCE_S = 60.0  # nothing may be stuck for longer
IMPORTED_WITHIN_S = 300.0  # seconds of processor time, once, before anything is promised: minutes where others want it
SomeOf = Callable[[Sequence[str], int], Sequence[str]]


class Process:
    """One process of the server."""

    def __init__(self, zygote: "Zygote", pid: int) -> None:
        self.pid = pid
        self._zygote = zygote
        self._ended: int | None = None

    def poll(self) -> int | None:
        """Return how it ended, None while it lives."""
        if self._ended is None:
            self._ended = self._zygote.ask({"poll": self.pid})
        return self._ended

    def wait(self) -> int:
        """Return how it ended, once it has."""
        wait_until(lambda: self.poll() is not None)
        assert self._ended is not None
        return self._ended

    def send(self, number: int) -> None:
        """Send a signal."""
        os.kill(self.pid, number)


class Zygote:
    """What the processes are forked from."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.kill.zygote"], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            text=True,
        )  # fmt: skip
        assert self._line(IMPORTED_WITHIN_S) == "ready"

    def ask(self, request: dict[str, Any]) -> Any:
        """Send one request, and return its answer."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps(request) + "\n")
        self._process.stdin.flush()
        return json.loads(self._line(PATIENCE_S))

    def start(self, arguments: list[str], environment: dict[str, str], log: Path) -> Process:
        """Start `soundlist` with these arguments."""
        return Process(self, self.ask({"start": arguments, "environment": environment, "log": str(log)}))

    def close(self) -> None:
        """End it; its children are theirs who started them."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait(PATIENCE_S)

    def _line(self, within_s: float) -> str:
        assert self._process.stdout is not None
        ready, _, _ = select.select([self._process.stdout], [], [], within_s)
        assert ready, f"what the processes are forked from said nothing for {within_s:.0f} s"
        return self._process.stdout.readline().strip()


class ProcessServer:
    """One data folder and database; its processes are `soundlist serve` and `soundlist worker`."""

    recorder = None  # what its processes send is not seen here

    def __init__(self, zygote: Zygote, folder: Path, **settings: Any) -> None:
        self.folder = folder
        self._zygote = zygote
        self._settings = {"secret_key": SECRET_KEY, "data_dir": folder / "data", "worker_silent_s": 1.0, **settings}
        self.runtime = Runtime.of(Settings(**self._settings))
        migrate(self.runtime.database)
        self.port = free_port()
        self._running: list[Process] = []
        self._servers: list[Process] = []  # those of them that serve
        self._serves = False

    def browser(self) -> Any:
        """Return a client of the web process; of the application in this process where none was started."""
        if self._serves:
            return self._client()
        return TestClient(create_app(self.runtime), base_url="http://127.0.0.1:8000")

    def _client(self) -> httpx.Client:
        return httpx.Client(base_url=f"http://127.0.0.1:{self.port}", timeout=PATIENCE_S)

    def serve(self, kill_at: str = "", *, victim: int = 0, port: int = 0, **settings: Any) -> Process:
        """Start a web process, and return once it answers."""
        port = port or self.port
        process = self._start(["serve", "--port", str(port)], kill_at, victim, settings)
        self._serves = True
        self._servers.append(process)
        wait_until(lambda: process.poll() is not None or answers(port))
        assert process.poll() is None, self.log()
        return process

    def work(self, kill_at: str = "", *, victim: int = 0) -> Process:
        """Start a worker."""
        return self._start(["worker"], kill_at, victim, {})

    def wait_for_death(self, process: Process, kill_at: str) -> None:
        """Return once a process has died by its own hand at the point; of a web server, its parent dies too."""
        self.wait_for_kill(kill_at)
        if process in self._servers:
            process.send(signal.SIGKILL)  # it would replace what died
            wait_until(lambda: not answers(self.port))
        assert process.wait() == -signal.SIGKILL, self.log()

    def wait_for_kill(self, kill_at: str) -> None:
        """Return once a process has killed its victim at the point."""
        wait_until(lambda: self._marker(kill_at).exists() and self._marker(kill_at).read_text() == kill_at)

    def stop(self) -> None:
        """End what still runs."""
        for process in self._running:
            if process.poll() is None:
                process.send(signal.SIGTERM)
        for process in self._running:
            process.wait()
        self._running.clear()

    def close(self) -> None:
        """End everything, at once: what a process does on SIGTERM has its own test."""
        for process in self._running:
            if process.poll() is None:
                process.send(signal.SIGKILL)
        self.stop()
        self.runtime.close()

    def log(self) -> str:
        """Return what the processes said."""
        return (self.folder / "log").read_text()

    def _marker(self, kill_at: str) -> Path:
        return self.folder / f"killed-at-{kill_at}"

    def _start(self, arguments: list[str], kill_at: str, victim: int, settings: dict[str, Any]) -> Process:
        set_here = self._settings | settings
        environment = {**os.environ} | {f"SOUNDLIST_{name.upper()}": str(value) for name, value in set_here.items()}
        if kill_at:
            environment |= {kill_points.POINT: kill_at, kill_points.MARKER: str(self._marker(kill_at))}
        if victim:
            environment |= {kill_points.VICTIM: str(victim)}
        process = self._zygote.start(arguments, environment, self.folder / "log")
        self._running.append(process)
        return process


def free_port() -> int:
    """Return a port that nobody listens on."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
        return port


def answers(port: int) -> bool:
    """Whether a web process answers at a port."""
    try:
        return httpx.get(f"http://127.0.0.1:{port}/healthz", timeout=5).status_code == 200
    except httpx.TransportError:
        return False


def wait_until(done: Callable[[], Any]) -> Any:
    """Return what `done` returns, once it is true."""
    deadline = time.monotonic() + PATIENCE_S
    while not (answer := done()):
        assert time.monotonic() < deadline, f"waited {PATIENCE_S:.0f} s in vain: {inspect.getsource(done).strip()}"
        time.sleep(0.05)
    return answer
