"""What is installed is what was looked at: hashes of packages, digests of images and actions."""

import json
import re
import runpy
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
LOCKS = ("constraints.txt", "constraints-server.txt", "constraints-uv.txt")
PIN = runpy.run_path(str(ROOT / "deploy/pin_digests.py"))
# Named by tag only: `make pins` pins them where images and GitHub can be reached. What is pinned leaves this list.
NOT_PINNED = {
    "actions/cache@v4",
    "actions/checkout@v5",
    "actions/download-artifact@v6",
    "actions/setup-node@v5",
    "actions/setup-python@v5",
    "actions/setup-python@v6",
    "actions/upload-artifact@v5",
    "axllent/mailpit",
    "caddy:2.11.9",
    "node:22-trixie-slim",
    "postgres:17",
    "pypa/cibuildwheel@v3.2",
    "pypa/gh-action-pypi-publish@v1.13.0",
    "python:3.13-slim-trixie",
    "versity/versitygw:v1.8.0",
}


def locked(name: str) -> dict[str, list[str]]:
    """Return the pinned packages of a lock file, `name==version; marker`, each with its hashes."""
    text = (ROOT / name).read_text().replace("\\\n", " ")
    lines = [line for line in text.splitlines() if line and not line.lstrip().startswith("#")]
    return {line.partition(" --hash")[0].strip(): re.findall(r"--hash=sha256:([0-9a-f]{64})", line) for line in lines}


def names(packages: dict[str, list[str]]) -> set[str]:
    return {package.partition("==")[0] for package in packages}


@pytest.mark.parametrize("name", LOCKS)
def test_every_package_has_its_version_and_hashes(name: str):
    packages = locked(name)
    assert packages
    assert [package for package, hashes in packages.items() if "==" not in package or not hashes] == []


def test_every_dependency_is_locked():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]

    def wanted(*lists: list[str]) -> set[str]:
        return {re.split(r"[^A-Za-z0-9_.-]", each)[0].lower() for some in lists for each in some}

    assert wanted(project["dependencies"], extras["server"], extras["dev"]) <= names(locked("constraints.txt"))
    assert wanted(project["dependencies"], extras["server"]) <= names(locked("constraints-server.txt"))
    assert locked("constraints-server.txt").items() <= locked("constraints.txt").items(), "run: make constraints"
    assert "pytest" not in names(locked("constraints-server.txt"))


def test_setup_and_image_install_nothing_without_a_hash():
    """Each installs from a lock file, from wheels that one named, or our own package without its dependencies."""
    setup = (ROOT / "Makefile").read_text().partition("\n.make/python:")[2].partition("\n.make/librosa:")[0]
    image = (ROOT / "Dockerfile").read_text().replace("\\\n", " ")
    installs = [line for line in (setup + image).splitlines() if re.search(r"pip\S* (install|wheel) ", line)]
    assert len(installs) == 6
    for line in installs:
        for command in re.findall(r"pip (?:install|wheel) [^&]+", line):
            is_safe = "--require-hashes" in command or "--no-index" in command
            assert is_safe or ("--no-deps" in command and "--no-build-isolation" in command), command


def test_every_package_of_the_frontend_has_its_hash():
    lock = json.loads((ROOT / "frontend/package-lock.json").read_text())
    packages = {path: package for path, package in lock["packages"].items() if path and not package.get("link")}
    assert len(packages) > 100
    assert [path for path, package in packages.items() if not package.get("integrity", "").startswith("sha512-")] == []
    assert "npm ci" in (ROOT / "Makefile").read_text()
    assert "npm ci" in (ROOT / "Dockerfile").read_text()


def test_what_is_named_by_tag_only_is_listed():
    found = [reference for path in PIN["files"]() for reference in PIN["references"](path)]
    assert {reference.name for reference in found if not reference.is_pinned} == NOT_PINNED


def test_pinning_writes_digests_and_keeps_what_is_ours():
    digest, commit = "sha256:" + "a" * 64, "b" * 40

    def pinned(text: str) -> str:
        return str(PIN["pinned"](text, lambda _image: digest, lambda _action, _tag: commit))

    changed = []
    for path in PIN["files"]():
        before = path.read_text()
        after = pinned(before)
        assert pinned(after) == after
        assert after.replace(f"@{digest}", "").replace(f"{commit} # ", "") == before
        changed += [path.name] if after != before else []
        assert path.suffix != ".yml" or yaml.safe_load(after)
    assert changed == [path.name for path in PIN["files"]()]
    services: dict[str, Any] = yaml.safe_load(pinned((ROOT / "docker-compose.yml").read_text()))["services"]
    assert {service["image"] for service in services.values() if "@" not in service["image"]} == {"soundlist"}


def test_workflows_have_no_right_that_they_do_not_need():
    for path in sorted((ROOT / ".github/workflows").iterdir()):
        workflow = yaml.safe_load(path.read_text())
        assert workflow["permissions"] == {"contents": "read"}, path.name
        for name, job in workflow["jobs"].items():
            needed = {"id-token": "write"} if name == "publish" else None  # trusted publishing, in place of a token
            assert job.get("permissions") == needed, f"{path.name}: {name}"
            checkouts = [step for step in job["steps"] if step.get("uses", "").startswith("actions/checkout@")]
            assert all(step.get("with", {}).get("persist-credentials") is False for step in checkouts), path.name
