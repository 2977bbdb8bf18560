"""A machine as docs/how-to/operate.md has it: a folder in place of /, with a checkout, and units without systemd.

Commands run in a shell, units by their `ExecStart` in real processes.
"""

import configparser
import os
import re
import shlex
import shutil
import signal
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx

from app.settings import PREFIX, Settings
from tests.support.s3 import free_port
from tests.support.waiting import until

ROOT = Path(__file__).resolve().parents[2]
IN_CHECKOUT = ("deploy", ".venv", ".git")
UNIX_PATH = re.compile(r"(?<![\w./-])/(?=(?:etc|opt|srv|var)/)")
STOPS_WITHIN_S = 300.0
COMMAND_WITHIN_S = 600.0


@dataclass(frozen=True)
class Ran:
    """The exit code and the output of a command."""

    code: int
    printed: str
    warned: str


class Host:
    """One machine; `settings` is what its operator fills into /etc/soundlist.env."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.port = free_port()
        self.checkout = root / "opt/soundlist"
        for folder in ("etc/sysusers.d", "etc/tmpfiles.d", "etc/systemd/system", "etc/caddy", "srv", "home"):
            (root / folder).mkdir(parents=True)
        for folder in ("var/lib/soundlist", "var/backups/soundlist", "opt/soundlist"):
            (root / folder).mkdir(parents=True, mode=0o700)
        for name in IN_CHECKOUT:
            if (ROOT / name).exists():
                (self.checkout / name).symlink_to(ROOT / name)
        self._running: dict[str, subprocess.Popen[bytes]] = {}

    @property
    def data(self) -> Path:
        """The folder of database and sounds."""
        return self.root / "var/lib/soundlist"

    @property
    def env_file(self) -> Path:
        """The settings of the units."""
        return self.root / "etc/soundlist.env"

    def run(self, command: str, given: Mapping[str, str] | None = None, *, typed: str = "") -> Ran:
        """Run a command with the paths of this machine, after replacing what the page gives as an example."""
        for example, value in (given or {}).items():
            assert example in command, f"{command!r} has no {example!r}: the page has changed"
            command = command.replace(example, value)
        command = self._here(command)
        if command.startswith("systemctl "):
            self._systemctl(shlex.split(command)[1:])
            return Ran(0, "", "")
        ran = subprocess.run(
            ["/bin/bash", "-e", "-o", "pipefail", "-c", command],
            cwd=self.checkout, env=self._environment(), input=typed, capture_output=True, text=True,
            timeout=COMMAND_WITHIN_S,
        )  # fmt: skip
        return Ran(ran.returncode, ran.stdout, ran.stderr)

    def fill_in(self, **settings: str) -> None:
        """Set values in /etc/soundlist.env, as an operator does."""
        text = self.env_file.read_text()
        for name, value in settings.items():
            text, count = re.subn(rf"^#?{name}=.*$", f"{name}={value}", text, count=1, flags=re.MULTILINE)
            assert count == 1, f"deploy/host/soundlist.env does not name {name}"
        self.env_file.write_text(text)

    def settings(self) -> Settings:
        """Return the settings by which the units run."""
        written = {
            name.removeprefix(PREFIX).lower(): value
            for name, value in self._environment().items()
            if name.startswith(PREFIX)
        }
        return Settings(**written)

    def client(self) -> httpx.Client:
        """Return a browser without credentials."""
        return httpx.Client(base_url=f"http://127.0.0.1:{self.port}", timeout=COMMAND_WITHIN_S)

    def stop(self, *units: str) -> None:
        """Stop units, or all; what was begun is finished."""
        names = units or tuple(self._running)
        stopping = [self._running.pop(name) for name in names]
        for process in stopping:
            process.send_signal(signal.SIGTERM)
        for process in stopping:
            process.wait(STOPS_WITHIN_S)

    def log(self) -> str:
        """Return what the units printed."""
        return (self.root / "log").read_text() if (self.root / "log").exists() else ""

    def _systemctl(self, words: list[str]) -> None:
        """Do with the units in /etc/systemd/system what systemd would."""
        action, *units = [word for word in words if not word.startswith("-")]
        if action == "daemon-reload":
            return
        assert action in ("enable", "start", "restart"), words
        for unit in units:
            running = [name for name in self._running if unit.endswith("@*") and name.startswith(unit[:-1])]
            for name in running or [unit]:
                if name in self._running:
                    self.stop(name)
                if not name.endswith(".timer"):
                    self._start(name)

    def _start(self, unit: str) -> None:
        """Run a unit of type oneshot to its end; leave another running, a web process once it answers."""
        template = re.sub(r"@.+$", "@", unit.removesuffix(".service"))
        written = configparser.ConfigParser(strict=False, interpolation=None)
        written.optionxform = str  # type: ignore[assignment,method-assign]
        text = (self.root / f"etc/systemd/system/{template}.service").read_text()
        written.read_string(text)
        for other in written["Unit"].get("Wants", "").split():
            if other.startswith("soundlist"):
                self._start(other)
        command = shlex.split(self._here(written["Service"]["ExecStart"]).replace("8000", str(self.port)))
        environment = self._environment() | dict(
            assignment.split("=", 1)
            for line in re.findall(r"^Environment=(.+)$", self._here(text), re.MULTILINE)
            for assignment in shlex.split(line)
        )
        with (self.root / "log").open("ab") as log:
            started: subprocess.Popen[Any] = subprocess.Popen(
                command, cwd=self.root, env=environment, stdout=log, stderr=log
            )
        if written["Service"]["Type"] == "oneshot":
            assert started.wait(STOPS_WITHIN_S) == 0, self.log()
            return
        self._running[unit] = started
        if "serve" in command:
            until(lambda: started.poll() is not None or self._answers())
        assert started.poll() is None, self.log()

    def _answers(self) -> bool:
        try:
            return httpx.get(f"http://127.0.0.1:{self.port}/healthz", timeout=5).status_code == 200
        except httpx.TransportError:
            return False

    def _here(self, text: str) -> str:
        return UNIX_PATH.sub(f"{self.root}/", text)

    def _environment(self) -> dict[str, str]:
        """Return the environment of an operator's shell, with the settings of the services."""
        inherited = {name: value for name, value in os.environ.items() if not name.startswith(PREFIX)}
        settings = {}
        if self.env_file.exists():
            settings = dict(re.findall(r"^([A-Z_]+)=(.*)$", self.env_file.read_text(), re.MULTILINE))
        venv = self.checkout / ".venv/bin"
        assert shutil.which("soundlist", path=str(venv)), "make setup has not run"
        return inherited | {
            "PATH": f"{venv}{os.pathsep}{inherited['PATH']}",
            "HOME": str(self.root / "home"),
            "SOUNDLIST_DATA_DIR": str(self.data),
            **settings,
        }
