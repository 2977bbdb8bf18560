"""The demo as one process tree: web application and worker on the embedded database, stopped together."""

import fcntl
import os
import secrets
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import IO

import httpx
import typer

from app.demo.project import make_demo_project
from app.kit.permissions import tighten
from app.kit.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings

ALIVE_WITHIN_S = 180.0  # seconds on a free machine, a minute on one where much else runs
STOP_WITHIN_S = 20.0
WATCH_EVERY_S = 0.2


class AlreadyRunning(Exception):
    """Another process uses this data folder."""


def run_demo(port: int) -> int:
    """Serve the demo until stopped; return the exit code."""
    settings = Settings()
    settings.data_dir.mkdir(parents=True, exist_ok=True)
    for line in tighten(settings.private_paths):
        typer.echo(line, err=True)
    try:
        lock = _lock(settings.data_dir)
    except AlreadyRunning as error:
        typer.echo(str(error), err=True)
        return 2
    with lock:
        environment = os.environ | {
            "SOUNDLIST_DATA_DIR": str(settings.data_dir.resolve()),
            "SOUNDLIST_SECRET_KEY": _secret_key(settings.data_dir),
            "SOUNDLIST_BASE_URL": f"http://127.0.0.1:{port}",
            "SOUNDLIST_DEMO": "1",
            "SOUNDLIST_LOG_LEVEL": os.environ.get("SOUNDLIST_LOG_LEVEL", "WARNING"),
        }
        os.environ.update(environment)
        runtime = Runtime.of(Settings())
        migrate(runtime.database)
        tree = ProcessTree(
            [
                [sys.executable, "-m", "app", "worker"],
                [sys.executable, "-m", "app", "serve", "--host", "127.0.0.1", "--port", str(port)],
            ],
            environment,
        )
        signal.signal(signal.SIGTERM, tree.stop_on_signal)
        signal.signal(signal.SIGINT, tree.stop_on_signal)
        try:
            tree.start()
            address = f"http://127.0.0.1:{port}"
            if not tree.wait_until(lambda: _answers(address)):
                if tree.is_stopping():
                    return 0
                typer.echo(f"the server did not start; is port {port} taken? Try: make run PORT=8001", err=True)
                return 1
            project, token = make_demo_project(runtime, report=typer.echo, keep_going=tree.is_whole)
            if tree.is_whole():
                _welcome(address, project, token)
            return tree.watch()
        finally:
            tree.stop()
            runtime.close()


def _lock(data_dir: Path) -> IO[str]:
    lock = (data_dir / "soundlist.lock").open("a")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        lock.close()
        raise AlreadyRunning(f"Soundlist runs on {data_dir} already; stop it, or give DATA=another-folder") from None
    return lock


def _secret_key(data_dir: Path) -> str:
    path = data_dir / "secret_key"
    if not path.exists():
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(descriptor, "w") as file:
            file.write(secrets.token_hex(32))
    return path.read_text()


def _answers(address: str) -> bool:
    try:
        return httpx.get(f"{address}/healthz", timeout=2).status_code == httpx.codes.OK
    except httpx.TransportError:
        return False


def _welcome(address: str, project: str, token: str) -> None:
    typer.echo(
        f"\n  Soundlist is at {address}\n"
        "  It needs no sign-in: the menu at the top right switches between producer, approver and designer.\n\n"
        "  The game's CI would say:\n"
        f"    curl -fsS -H 'Authorization: Bearer {token}' {address}/v1/projects/{project}/spec.toml -o spec.toml"
        " && .venv/bin/audio-checks check --spec spec.toml --target game assets/\n\n"
        "  Ctrl C stops it; what you did is kept.\n"
    )


class ProcessTree:
    """A few processes that live and stop together."""

    def __init__(self, commands: list[list[str]], environment: dict[str, str]) -> None:
        self._commands = commands
        self._environment = environment
        self._processes: list[subprocess.Popen[bytes]] = []
        self._stopping = False

    def start(self) -> None:
        """Start every command, each in a new session so that Ctrl-C is handled once, here."""
        for command in self._commands:
            self._processes.append(subprocess.Popen(command, env=self._environment, start_new_session=True))

    def is_stopping(self) -> bool:
        """Whether a stop was requested."""
        return self._stopping

    def is_whole(self) -> bool:
        """Whether every process is running and no stop was requested."""
        return not self._stopping and all(process.poll() is None for process in self._processes)

    def wait_until(self, condition: Callable[[], bool]) -> bool:
        """Return True once the condition holds, False when a process died or time ran out."""
        deadline = time.monotonic() + ALIVE_WITHIN_S
        while time.monotonic() < deadline and self.is_whole():
            if condition():
                return True
            time.sleep(WATCH_EVERY_S)
        return False

    def watch(self) -> int:
        """Return 0 once stopped by a signal, or the exit code of the process that died."""
        while self.is_whole():
            time.sleep(WATCH_EVERY_S)
        died = [process.returncode for process in self._processes if process.returncode]
        return 0 if self._stopping or not died else died[0]

    def stop_on_signal(self, _signal: int, _frame: FrameType | None) -> None:
        """Begin to stop; the watching loop does the rest."""
        self._stopping = True

    def stop(self) -> None:
        """Stop every process, the last started first; kill what does not stop in time."""
        for process in reversed(self._processes):
            if process.poll() is None:
                process.terminate()
        deadline = time.monotonic() + STOP_WITHIN_S
        for process in reversed(self._processes):
            try:
                process.wait(max(0.1, deadline - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
