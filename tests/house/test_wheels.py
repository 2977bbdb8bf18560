"""The release workflow builds what pyproject.toml and setup.py promise; its commands and files are there."""

import os
import shlex
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest
import yaml

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
WORKFLOW = yaml.safe_load((ROOT / ".github/workflows/wheels.yml").read_text())
WHEELS = WORKFLOW["jobs"]["wheels"]
SETTINGS = next(step["env"] for step in WHEELS["steps"] if "cibuildwheel" in step.get("uses", ""))


def test_every_system_has_its_wheels():
    systems = WHEELS["strategy"]["matrix"]["system"]
    for system in ("ubuntu", "macos", "windows"):
        assert sum(one.startswith(system) for one in systems) == 2, "an Intel and an ARM processor each"


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
        place = tmp_path / source
        place.parent.mkdir(parents=True, exist_ok=True)
        place.symlink_to(ROOT / source)
    program, *arguments = shlex.split(SETTINGS["CIBW_TEST_COMMAND"])
    assert program == "python"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [sys.executable, *arguments, "--collect-only", "-p", "no:cacheprovider"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-2000:]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The source distribution, and the wheel that is built of it."""
    folder = tmp_path_factory.mktemp("dist")
    uv = Path(sys.executable).with_name("uv")
    subprocess.run([str(uv), "build", "--quiet", "-o", str(folder), str(ROOT)], check=True)
    (source,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    return source, wheel


def test_the_wheel_holds_the_library_alone(built: tuple[Path, Path]):
    source, wheel = built
    assert "-cp311-abi3-" in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[0] for name in names if ".dist-info" not in name} == {"audio_checks"}
    assert sum(name.startswith("audio_checks/kernel/_kernel.") for name in names) == 2, "the kernel and its types"
    assert not [name for name in names if name.endswith((".c", ".h"))]
    with tarfile.open(source) as archive:
        held = {Path(name).name for name in archive.getnames() if "/kernel/" in name}
    assert {path.name for path in (ROOT / "audio_checks/kernel").iterdir() if path.suffix in (".c", ".h")} <= held


def test_without_a_compiler_one_sentence_says_so(tmp_path: Path):
    environment = os.environ | {"CC": "/there/is/none"}
    script = "import setuptools.command.build_ext, runpy; runpy.run_path('setup.py', run_name='__main__')"
    build = ["build_ext", "--build-lib", str(tmp_path / "lib"), "--build-temp", str(tmp_path / "temp")]
    python = Path(sys.executable).with_name("uv")
    command = [
        str(python),
        "run",
        "--quiet",
        "--no-project",
        "--with",
        "setuptools>=77",
        "python",
        "-c",
        script,
        *build,
    ]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 1
    assert "the C compiler is missing or failed" in done.stderr
    assert "install" in done.stderr.splitlines()[-1]
    assert "Traceback" not in done.stderr
