"""Real server processes over one data folder, to be killed and started again."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
from fastapi.testclient import TestClient

from app.kit import kill
from app.kit.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
SECRET_KEY = "only for tests, nowhere else"
PATIENCE_S = 60.0


class ProcessServer:
    """One data folder; its processes are `python -m app serve` and `python -m app worker`."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.runtime = Runtime.of(Settings(data_dir=folder / "data", secret_key=SECRET_KEY))
        migrate(self.runtime.database)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port: int = free.getsockname()[1]
        self._running: list[subprocess.Popen[bytes]] = []
        self._serves = False

    def browser(self) -> Any:
        """Return a client of the web process; of the application in this process where none was started."""
        if self._serves:
            return self._client()
        return TestClient(create_app(self.runtime), base_url="http://127.0.0.1:8000")

    def _client(self) -> httpx.Client:
        return httpx.Client(base_url=f"http://127.0.0.1:{self.port}", timeout=PATIENCE_S)

    def serve(self, kill_at: str = "") -> subprocess.Popen[bytes]:
        """Start the web process, and return once it answers."""
        process = self._start(["serve", "--port", str(self.port)], kill_at)
        self._serves = True
        with self._client() as client:
            wait_until(lambda: process.poll() is not None or _answers(client))
        assert process.poll() is None, self.log()
        return process

    def work(self, kill_at: str = "") -> subprocess.Popen[bytes]:
        """Start the worker."""
        return self._start(["worker"], kill_at)

    def wait_for_death(self, process: subprocess.Popen[bytes], kill_at: str) -> None:
        """Return once a process has died by its own hand at the point."""
        assert process.wait(PATIENCE_S) == -signal.SIGKILL, self.log()
        assert self._marker(kill_at).read_text() == kill_at

    def stop(self) -> None:
        """End what still runs."""
        for process in self._running:
            if process.poll() is None:
                process.terminate()
        for process in self._running:
            process.wait(PATIENCE_S)
        self._running.clear()

    def close(self) -> None:
        """End everything."""
        self.stop()
        self.runtime.close()

    def log(self) -> str:
        """Return what the processes said."""
        return (self.folder / "log").read_text()

    def _marker(self, kill_at: str) -> Path:
        return self.folder / f"killed-at-{kill_at}"

    def _start(self, command: list[str], kill_at: str) -> subprocess.Popen[bytes]:
        environment = {
            **os.environ,
            "SOUNDLIST_DATA_DIR": str(self.folder / "data"),
            "SOUNDLIST_SECRET_KEY": SECRET_KEY,
        }
        if kill_at:
            environment |= {kill.POINT: kill_at, kill.MARKER: str(self._marker(kill_at))}
        with (self.folder / "log").open("ab") as log:
            process = subprocess.Popen(
                [sys.executable, "-m", "app", *command], cwd=ROOT, env=environment, stdout=log, stderr=log
            )
        self._running.append(process)
        return process


def wait_until(done: Callable[[], Any]) -> Any:
    """Return what `done` returns, once it is true."""
    deadline = time.monotonic() + PATIENCE_S
    while not (answer := done()):
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.05)
    return answer


def _answers(client: httpx.Client) -> bool:
    try:
        return client.get("/healthz").status_code == 200
    except httpx.TransportError:
        return False
