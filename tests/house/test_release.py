"""A release is built and installed as its workflow and its users do it; that a forge starts the workflow is not tested.

Everything is built from a copy of the checkout with a tag of its own, and installed from a folder into an empty
environment, where neither a compiler nor Node can be found.
"""

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tarfile
import time
import tomllib
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import yaml

from audio_checks.spec.delivery_spec import new_spec
from tests.support.s3 import free_port
from tests.support.waves import sine, write_wav

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
UV = str(Path(sys.executable).with_name("uv"))
WORKFLOW = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text())
WHEELS = WORKFLOW["jobs"]["wheels"]
SETTINGS = next(step["env"] for step in WHEELS["steps"] if "cibuildwheel" in step.get("uses", ""))
VERSION = "7.8.9"
PARTS = (
    *("pyproject.toml", "uv.lock", "setup.py", "MANIFEST.in", "LICENSE", ".gitignore", ".gitattributes"),
    *(".git_archival.txt", "packages", "audio_checks", "app", "migrations", "frontend/dist"),
)
STARTS_WITHIN_S = 300.0  # ends what hangs, however busy the machine is


def run(*command: object, cwd: Path, **environment: str) -> str:
    """Run a command that has to succeed, and return its output."""
    done = subprocess.run(
        [str(word) for word in command], cwd=cwd, env=os.environ | environment, capture_output=True, text=True
    )
    assert done.returncode == 0, f"{shlex.join(str(word) for word in command)}\n{done.stdout}{done.stderr}"
    return done.stdout


def test_every_system_has_its_wheels():
    systems = WHEELS["strategy"]["matrix"]["system"]
    for prefix in ("ubuntu", "macos", "windows"):
        assert sum(system.startswith(prefix) for system in systems) == 2, "an Intel and an ARM processor each"


def test_one_wheel_serves_every_python_from_the_oldest_on():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    oldest = project["requires-python"].removeprefix(">=")
    assert SETTINGS["CIBW_BUILD"] == f"cp{oldest.replace('.', '')}-*"
    major, minor = (int(part) for part in oldest.split("."))
    assert f"Py_LIMITED_API 0x{major:02x}{minor:02x}0000" in (ROOT / "audio_checks/kernel/kernel.h").read_text()
    assert f'"py_limited_api": "cp{major}{minor}"' in (ROOT / "setup.py").read_text()


def test_what_is_tested_is_there_and_needs_nothing_else(tmp_path: Path):
    for source in SETTINGS["CIBW_TEST_SOURCES"].split():
        assert (ROOT / source).exists(), source
        link = tmp_path / source
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(ROOT / source)
    program, *arguments = shlex.split(SETTINGS["CIBW_TEST_COMMAND"])
    assert program == "python"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [sys.executable, *arguments, "--collect-only", "-p", "no:cacheprovider"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-2000:]


def test_every_job_that_reads_the_version_has_the_tags():
    for name, job in WORKFLOW["jobs"].items():
        for step in job["steps"]:
            if step.get("uses", "").startswith("actions/checkout@"):
                assert step["with"]["fetch-depth"] == 0, name


def test_the_bills_of_materials_name_what_is_locked(tmp_path: Path):
    run("make", "sbom", f"OUT={tmp_path}", cwd=ROOT)
    locked = {
        package["name"]: package.get("version") for package in tomllib.loads((ROOT / "uv.lock").read_text())["package"]
    }
    bills = {path.name: json.loads(path.read_text()) for path in tmp_path.iterdir()}
    assert set(bills) == {"audio-checks.cdx.json", "soundlist.cdx.json", "page.cdx.json"}
    for bill in bills.values():
        assert bill["bomFormat"] == "CycloneDX"
    library, server = (
        {component["name"]: component.get("version") for component in bills[name]["components"]}
        for name in ("audio-checks.cdx.json", "soundlist.cdx.json")
    )
    assert {"numpy", "soundfile"} <= set(library)
    assert "fastapi" not in library
    assert server["fastapi"] == locked["fastapi"]
    assert "pytest" not in server
    assert "react" in {component["name"] for component in bills["page.cdx.json"]["components"]}


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A clone of this project at a tag, with its page built."""
    assert (ROOT / "frontend/dist/help/index.html").exists(), "run: make setup"
    folder = tmp_path_factory.mktemp("source")
    ignored = shutil.ignore_patterns("__pycache__", "*.so", "_version.py")
    for part in PARTS:
        target = folder / part
        target.parent.mkdir(exist_ok=True)
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, target, ignore=ignored)
        else:
            shutil.copy(ROOT / part, target)
    git = ("git", "-c", "user.name=x", "-c", "user.email=x@example.com")
    for command in (("init", "-q"), ("add", "."), ("commit", "-qm", "x"), ("tag", f"v{VERSION}")):
        run(*git, *command, cwd=folder)
    return folder


@pytest.fixture(scope="module")
def release(source: Path) -> Path:
    """The folder of what is published: the library as source and wheel, and the server."""
    folder = source.parent / "dist"
    for package, kind in (("audio-checks", "--sdist"), ("audio-checks", "--wheel"), ("soundlist", "--wheel")):
        build = (UV, "build", "--quiet", "--no-build-isolation", "--python", sys.executable, kind)
        run(*build, "--package", package, "--out-dir", folder, cwd=source)
    return folder


def test_the_tag_is_the_version_of_every_file(source: Path, release: Path):
    names = {path.name.split("-cp311")[0] for path in release.iterdir() if path.suffix in (".whl", ".gz")}
    assert names == {
        f"audio_checks-{VERSION}",
        f"audio_checks-{VERSION}.tar.gz",
        f"soundlist-{VERSION}-py3-none-any.whl",
    }
    (step,) = [step for step in WORKFLOW["jobs"]["attest"]["steps"] if "GITHUB_REF_NAME" in step.get("run", "")]
    (release / ".gitignore").unlink(missing_ok=True)  # of uv
    for tag, code in ((f"v{VERSION}", 0), ("v7.8.8", 1)):
        command = ["bash", "-e", "-c", step["run"]]
        assert subprocess.run(command, cwd=release.parent, env=os.environ | {"GITHUB_REF_NAME": tag}).returncode == code


def test_the_library_is_alone_in_its_files(release: Path):
    (wheel,), (archive,) = release.glob("audio_checks-*.whl"), release.glob("*.tar.gz")
    assert "-cp311-abi3-" in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[0] for name in names if ".dist-info" not in name} == {"audio_checks"}
    assert sum(name.startswith("audio_checks/kernel/_kernel.") for name in names) == 2, "the kernel and its types"
    assert not [name for name in names if name.endswith((".c", ".h"))]
    with tarfile.open(archive) as opened:
        inside = [name.partition("/")[2] for name in opened.getnames()]
    kernel = {path.name for path in (ROOT / "audio_checks/kernel").iterdir() if path.suffix in (".c", ".h")}
    assert kernel <= {Path(name).name for name in inside}
    assert not [name for name in inside if name.startswith(("app", "frontend", "migrations", "tests", "uv.lock"))]


def test_the_server_holds_code_migrations_and_page_in_one_package(release: Path):
    (wheel,) = release.glob("soundlist-*.whl")
    with zipfile.ZipFile(wheel) as opened:
        names = opened.namelist()
        metadata = opened.read(f"soundlist-{VERSION}.dist-info/METADATA").decode()
    assert {name.split("/")[0] for name in names if ".dist-info" not in name} == {"soundlist"}
    for path in (
        "app/main.py",
        "migrations/versions/0001_initial.py",
        "frontend/dist/index.html",
        "frontend/dist/help/index.html",
    ):
        assert f"soundlist/{path}" in names
    assert not [name for name in names if "__pycache__" in name]
    assert f"Requires-Dist: audio-checks=={VERSION}\n" in metadata
    assert (ROOT / "packages/soundlist/LICENSE").read_text() == (ROOT / "LICENSE").read_text()


@pytest.mark.parametrize("version", ["1.2.3", "1.2.4.dev5+gabcdef012"])
def test_an_archive_without_git_knows_its_version(tmp_path: Path, version: str):
    described = {"1.2.3": "v1.2.3", "1.2.4.dev5+gabcdef012": "v1.2.3-5-gabcdef012"}[version]
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    (tmp_path / "audio_checks").mkdir()
    archived = (ROOT / ".git_archival.txt").read_text()
    assert "export-subst" in (ROOT / ".gitattributes").read_text()
    (tmp_path / ".git_archival.txt").write_text(
        archived.replace("$Format:%(describe:tags=true,match=v[0-9]*)$", described).replace("$Format:%H$", "a" * 40)
    )
    assert run(sys.executable, "-m", "setuptools_scm", cwd=tmp_path).strip() == version


def test_without_its_guides_the_server_is_not_built(source: Path, tmp_path: Path):
    guides = source / "frontend/dist/help"
    guides.rename(tmp_path / "help")
    try:
        command = [UV, "build", "--no-build-isolation", "--python", sys.executable, "--wheel"]
        command += ["--package", "soundlist", "--out-dir", str(tmp_path)]
        done = subprocess.run(command, cwd=source, capture_output=True, text=True)
    finally:
        (tmp_path / "help").rename(guides)
    assert done.returncode != 0
    assert "the page is not built" in done.stdout + done.stderr


def test_without_a_compiler_one_sentence_says_so(source: Path, tmp_path: Path):
    command = [
        sys.executable,
        "setup.py",
        "build_ext",
        "--build-lib",
        str(tmp_path / "lib"),
        "--build-temp",
        str(tmp_path),
    ]
    done = subprocess.run(
        command, cwd=source, env=os.environ | {"CC": "/there/is/none"}, capture_output=True, text=True
    )
    assert done.returncode == 1
    assert "the C compiler is missing or failed" in done.stderr
    assert "install" in done.stderr.splitlines()[-1]
    assert "Traceback" not in done.stderr


@pytest.fixture(scope="module")
def environment(source: Path, release: Path) -> dict[str, str]:
    """What a user's shell has: the commands of an environment that only the release was installed into."""
    folder = source.parent / "environment"
    run(sys.executable, "-m", "venv", "--without-pip", folder, cwd=source)
    python = folder / "bin/python"
    locked = source.parent / "locked.txt"
    export = (UV, "export", "--quiet", "--frozen", "--no-dev", "--no-emit-workspace", "--package", "soundlist")
    run(*export, "--output-file", locked, cwd=source)
    install = (UV, "pip", "install", "--quiet", "--python", python)
    run(*install, "--require-hashes", "--no-build", "-r", locked, cwd=source)
    run(*install, "--no-index", "--find-links", release, "soundlist", cwd=source)
    return {"PATH": str(folder / "bin"), "HOME": str(source.parent)}


@pytest.fixture
def empty(tmp_path: Path, environment: dict[str, str]) -> Path:
    """An empty folder, from which neither compiler nor Node is on the PATH."""
    for program in ("cc", "gcc", "clang", "node", "npm", "make"):
        assert shutil.which(program, path=environment["PATH"]) is None
    return tmp_path


def installed(*command: str, cwd: Path, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """Run an installed command."""
    program = Path(environment["PATH"], command[0])
    return subprocess.run([program, *command[1:]], cwd=cwd, env=environment, capture_output=True, text=True)


@pytest.mark.parametrize("program", ["audio-checks", "soundlist"])
def test_both_commands_say_the_version_of_the_tag(empty: Path, environment: dict[str, str], program: str):
    assert installed(program, "--version", cwd=empty, environment=environment).stdout == f"{program} {VERSION}\n"


def test_the_installed_library_judges_a_file(empty: Path, environment: dict[str, str]):
    (empty / "audio-checks.toml").write_text(new_spec())
    write_wav(empty / "loud.wav", sine(hz=997, dbfs=0.0, seconds=0.2))
    done = installed("audio-checks", "check", "--format", "json", "loud.wav", cwd=empty, environment=environment)
    assert done.returncode == 1, done.stderr
    report: dict[str, Any] = json.loads(done.stdout)
    assert report["tool"] == {"name": "audio-checks", "version": VERSION}
    assert report["files"][0]["verdict"] == "rejected"


def test_no_other_project_is_given_a_package_called_app(environment: dict[str, str]):
    names = ("app", "migrations", "soundlist")
    script = f"import importlib.util as u; print([u.find_spec(name) is not None for name in {names}])"
    assert installed("python", "-c", script, cwd=Path("/"), environment=environment).stdout == "[False, False, True]\n"


@pytest.fixture
def demo(empty: Path, environment: dict[str, str]) -> Iterator[httpx.Client]:
    """The installed demo, started where another program's package `app` lies."""
    (empty / "app").mkdir()
    (empty / "app/__init__.py").write_text("raise ImportError('another app')\n")
    port = free_port()
    with (empty / "log").open("w") as log:
        command = [str(Path(environment["PATH"], "soundlist")), "demo", "--port", str(port)]
        process = subprocess.Popen(command, cwd=empty, env=environment, stdout=log, stderr=log)
        try:
            with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=STARTS_WITHIN_S) as client:
                ends_at = time.monotonic() + STARTS_WITHIN_S
                while not _answers(client):
                    assert process.poll() is None, (empty / "log").read_text()
                    assert time.monotonic() < ends_at, (empty / "log").read_text()
                    time.sleep(0.5)
                yield client
        finally:
            process.send_signal(signal.SIGTERM)
            process.wait(60)


def _answers(client: httpx.Client) -> bool:
    try:
        return client.get("/healthz").status_code == 200
    except httpx.TransportError:
        return False


def test_the_installed_demo_serves_health_page_and_interface(demo: httpx.Client):
    page = demo.get("/")
    assert "<title>Soundlist</title>" in page.text
    script = page.text.partition('src="/assets/')[2].partition('"')[0]
    assert demo.get(f"/assets/{script}").headers["content-type"].startswith("text/javascript")
    assert "<title>" in demo.get("/help/").text
    assert demo.get("/v1/openapi.json").json()["info"]["title"] == "Soundlist"
