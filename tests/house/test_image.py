"""The image, made without containers: what the Dockerfile copies and runs gives a file system that starts and serves.

The commands of its stages are read from the Dockerfile and run in a folder that stands for `/`. What apt-get and npm do
is left out: the machine of the tests has it already.
"""

import contextlib
import functools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.s3 import free_port

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
VERSION = "v7.8.9-5-gabcdef012"
ROOT_FOLDERS = re.compile(r"(?<![\w./])/(?=(?:opt|src|srv|wheels|data|backups)\b)")
OF_THE_MACHINE = re.compile(r"apt-get|npm|useradd")
STARTS_WITHIN_S = 300.0  # ends what hangs, however busy the machine is


def stages() -> dict[str, list[tuple[str, str]]]:
    """Return the instructions of each stage; the last has no name."""
    text = re.sub(r"^#.*\n", "", (ROOT / "Dockerfile").read_text(), flags=re.MULTILINE).replace("\\\n", " ")
    named: dict[str, list[tuple[str, str]]] = {}
    for line in filter(None, text.splitlines()):
        instruction, _, rest = line.strip().partition(" ")
        if instruction == "FROM":
            stage = named.setdefault(rest.partition(" AS ")[2], [])
        else:
            stage.append((instruction, rest.strip()))
    return named


class Machine:
    """A folder that stands for the root of a container, and the variables of its processes."""

    def __init__(self, root: Path, programs: Path) -> None:
        self.root = root
        self.folder = root
        python = os.path.realpath(programs / "python")  # the one of the image, for what uv makes
        self.variables = os.environ | {"PATH": f"{programs}:{os.environ['PATH']}", "UV_PYTHON": python}

    def placed(self, text: str) -> str:
        """Return a command or a path with the folders of the container in place of those of the machine."""
        return ROOT_FOLDERS.sub(f"{self.root}/", text)

    def obey(self, instruction: str, rest: str, page: Path) -> None:
        """Do what an instruction of a Dockerfile says."""
        if instruction == "WORKDIR":
            self.folder = Path(self.placed(rest))
            self.folder.mkdir(parents=True, exist_ok=True)
        elif instruction == "ENV":
            for assignment in shlex.split(rest):
                name, _, value = assignment.partition("=")
                if name not in ("UV_NO_CACHE", "UV_COMPILE_BYTECODE"):  # which take minutes, and change nothing
                    self.variables[name] = self.placed(value.replace("$PATH", self.variables["PATH"]))
        elif instruction == "ARG":
            self.variables[rest] = VERSION
        elif instruction == "COPY":
            self._copy(rest.split(), page)
        elif instruction == "RUN" and not OF_THE_MACHINE.search(rest):
            command = self.placed(rest)
            done = subprocess.run(
                ["/bin/sh", "-c", command], cwd=self.folder, env=self.variables, capture_output=True, text=True
            )
            assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"

    def _copy(self, words: list[str], page: Path) -> None:
        if words[0] == "--from=packages":
            assert words[1] == words[2]  # made there already
            return
        if words[0] == "--from=page":
            words = [str(page), words[2]]
        *sources, target = words
        folder = self.folder / target
        for source in sources:
            path = ROOT / source
            if path.is_dir():
                ignored = shutil.ignore_patterns("__pycache__", "*.so", "_version.py", "help")  # as .dockerignore does
                shutil.copytree(path, folder, ignore=ignored, dirs_exist_ok=True)
            else:
                folder.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, folder)


@pytest.fixture(scope="module")
def machine() -> Iterator[Machine]:
    """The file system of the image, which another user can read."""
    assert (ROOT / "frontend/dist/index.html").exists(), "run: make setup"
    root = Path(tempfile.mkdtemp(prefix="soundlist-image-"))
    root.chmod(0o755)
    programs = root / "python"
    python, user = interpreter()
    subprocess.run([python, "-m", "venv", programs], check=True)
    machine = Machine(root, programs / "bin")
    try:
        for instruction, rest in stages()["packages"]:
            machine.obey(instruction, rest, ROOT / "frontend/dist")
        machine.variables = {"PATH": os.defpath, "HOME": "/nonexistent"}  # nothing of the stage that builds
        for instruction, rest in stages()[""]:
            machine.obey(instruction, rest, ROOT / "frontend/dist")
        for folder in ("data", "backups"):
            Path(root, folder).mkdir(exist_ok=True)
            if user is not None:
                os.chown(root / folder, user, -1)
        yield machine
    finally:
        shutil.rmtree(root)


def user_id() -> int:
    """Return the user that the image runs as."""
    [user] = [rest for instruction, rest in stages()[""] if instruction == "USER"]
    return int(user)


@functools.cache
def interpreter() -> tuple[str, int | None]:
    """Return a Python, and the user to run it as: that of the image, where this process may become it."""
    own = os.path.realpath(sys.executable)
    has_headers = "os.path.exists(os.path.join(sysconfig.get_path('include'), 'Python.h'))"
    test = f"import ensurepip, os, sys, sysconfig; sys.exit(sys.version_info < (3, 11) or not {has_headers})"
    for python in (own, "/usr/bin/python3") if os.geteuid() == 0 else ():
        with contextlib.suppress(OSError):  # in a folder of root's own
            if subprocess.run([python, "-c", test], user=user_id()).returncode == 0:
                return python, user_id()
    return own, None


def instruction_of_last(name: str) -> list[str]:
    """Return the command of an instruction of the last stage."""
    [rest] = [rest for instruction, rest in stages()[""] if instruction == name]
    command: list[str] = json.loads(rest[rest.index("[") :])
    return command


def test_a_build_without_a_version_is_refused(tmp_path: Path):
    """Else two versions of the image would say that they are the same, and keep each other's verdicts."""
    [command] = [rest for instruction, rest in stages()["packages"] if instruction == "RUN" and "VERSION" in rest]
    for version in ("", "latest", "1.0.0"):
        variables = os.environ | {"VERSION": version}
        done = subprocess.run(["/bin/sh", "-c", command], cwd=tmp_path, env=variables, capture_output=True, text=True)
        assert done.returncode == 1
        assert "name the tag that is checked out: --build-arg VERSION=$(git describe --tags)" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_what_runs_is_the_wheels_and_what_the_lock_names(machine: Machine):
    python = machine.root / "opt/soundlist/bin/python"
    script = "import importlib.metadata as m, json; print(json.dumps({d.name: d.version for d in m.distributions()}))"
    listed = subprocess.run([python, "-I", "-c", script], capture_output=True, text=True, check=True).stdout
    versions: dict[str, str] = json.loads(listed)
    assert versions["soundlist"] == versions["audio-checks"] == "7.8.10.dev5+gabcdef012"
    assert "fastapi" in versions
    assert not {"pytest", "mypy", "hatchling", "setuptools-scm"} & set(versions)
    packages = next(machine.root.glob("opt/soundlist/lib/python*/site-packages"))
    for page in ("index.html", "help/how-to/review.html"):
        assert (packages / "soundlist/frontend/dist" / page).exists()
    assert not list(packages.glob("audio_checks/**/*.c"))


def test_it_serves_as_its_own_user_and_its_health_check_says_so(machine: Machine):
    port = str(free_port())
    environment = machine.variables | {"SOUNDLIST_SECRET_KEY": "0" * 64}
    _, user = interpreter()
    assert instruction_of_last("CMD")[0] == "soundlist"

    def run_as_user(command: list[str]) -> subprocess.CompletedProcess[bytes]:
        return subprocess.run(command, cwd=machine.folder, env=environment, user=user, capture_output=True)

    program = str(machine.root / "opt/soundlist/bin/soundlist")
    migrated = run_as_user([program, "migrate"])
    assert migrated.returncode == 0, migrated.stderr
    serve = [
        program,
        *(word.replace("8000", port) for word in instruction_of_last("CMD")[1:]),
    ]
    health = [word.replace("8000", port) for word in instruction_of_last("HEALTHCHECK")]
    health[0] = str(machine.root / "opt/soundlist/bin" / health[0])
    log = machine.root / "log"
    with log.open("w") as output:
        server = subprocess.Popen(serve, cwd=machine.folder, env=environment, user=user, stdout=output, stderr=output)
        try:
            assert run_as_user(health).returncode != 0, "nothing answers yet"
            ends_at = time.monotonic() + STARTS_WITHIN_S
            while run_as_user(health).returncode:
                assert server.poll() is None, log.read_text()
                assert time.monotonic() < ends_at, log.read_text()
                time.sleep(0.5)
            read = f"import urllib.request as r; print(r.urlopen('http://127.0.0.1:{port}/').read().decode())"
            assert b"<title>Soundlist</title>" in run_as_user([health[0], "-c", read]).stdout
        finally:
            server.terminate()
            server.wait(60)
    if user is not None:
        assert {path.stat().st_uid for path in (machine.root / "data").rglob("*")} == {user}
