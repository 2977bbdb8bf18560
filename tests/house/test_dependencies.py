"""What is installed is what was looked at: hashes of packages, digests of images and actions."""

import json
import re
import runpy
import subprocess
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
LOCK = tomllib.loads((ROOT / "uv.lock").read_text())["package"]
PIN = runpy.run_path(str(ROOT / "deploy/pin_digests.py"))
# Named by tag only: `make pins` pins them where images and GitHub can be reached. What is pinned leaves this list.
NOT_PINNED = {
    "actions/attest-build-provenance@v3",
    "actions/cache@v4",
    "actions/checkout@v5",
    "actions/download-artifact@v6",
    "actions/setup-node@v5",
    "actions/setup-python@v5",
    "actions/setup-python@v6",
    "actions/upload-artifact@v5",
    "axllent/mailpit:v1.27",
    "prom/prometheus:v3.5.0",
    "caddy:2.11.9",
    "node:22-trixie-slim",
    "postgres:17",
    "pypa/cibuildwheel@v3.2",
    "pypa/gh-action-pypi-publish@v1.13.0",
    "python:3.13-slim-trixie",
    "versity/versitygw:v1.8.0",
}
# Of the jobs of a release: signing and trusted publishing, in place of a token, and the page of the release.
RIGHTS = {
    "attest": {"attestations": "write", "contents": "read", "id-token": "write"},
    "publish": {"id-token": "write"},
    "announce": {"contents": "write"},
}


def test_every_package_has_its_version_and_hashes():
    ours = [package for package in LOCK if "editable" in package["source"]]
    assert [package["name"] for package in ours] == ["audio-checks", "soundlist"]
    for package in (package for package in LOCK if package not in ours):
        assert package["version"], package["name"]
        files = [*package.get("wheels", []), *([package["sdist"]] if "sdist" in package else [])]
        assert files, package["name"]
        assert all(file["hash"].startswith("sha256:") for file in files), package["name"]


def test_the_lock_is_of_the_dependencies_that_the_project_names():
    done = subprocess.run(
        [ROOT / ".venv/bin/uv", "lock", "--check", "--offline"], cwd=ROOT, capture_output=True, text=True
    )
    assert done.returncode == 0, f"run: make lock\n{done.stderr}"


def test_what_is_there_before_uv_is_installs_by_the_hashes_of_the_lock():
    done = subprocess.run([ROOT / ".ci/locked.py", "uv"], capture_output=True, text=True, check=True)
    [line] = [line.split(" --hash=") for line in done.stdout.splitlines()]
    [package] = [package for package in LOCK if package["name"] == "uv"]
    assert line[0] == f"uv=={package['version']}"
    assert set(line[1:]) == {wheel["hash"] for wheel in package["wheels"]}


def test_setup_and_image_install_nothing_without_a_hash():
    """Each installs from the lock, or our own package without its dependencies."""
    setup = (ROOT / "Makefile").read_text().partition("\n.make/python:")[2].partition("\n.make/peers:")[0]
    setup += (ROOT / "Makefile").read_text().partition("\n.make/kernel:")[2].partition("\n.make/node:")[0]
    image = (ROOT / "Dockerfile").read_text().replace("\\\n", " ")
    installs = re.findall(r"(?:pip\S* (?:install|wheel)|sync) [^&\n]+", setup + image)
    assert len(installs) == 7
    for command in installs:
        is_locked = "--require-hashes" in command or ("--frozen" in command and "--no-install-workspace" in command)
        is_ours = "--no-deps" in command and ("--no-build-isolation" in command or "/wheels/*.whl" in command)
        assert is_locked or is_ours, command


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
    assert {service["image"] for service in services.values() if "@" not in service["image"]} == {
        "soundlist:${IMAGE_TAG}"
    }


def test_workflows_have_no_right_that_they_do_not_need():
    for path in sorted((ROOT / ".github/workflows").iterdir()):
        workflow = yaml.safe_load(path.read_text())
        assert workflow["permissions"] == {"contents": "read"}, path.name
        for name, job in workflow["jobs"].items():
            assert job.get("permissions") == RIGHTS.get(name), f"{path.name}: {name}"
            checkouts = [step for step in job["steps"] if step.get("uses", "").startswith("actions/checkout@")]
            assert all(step.get("with", {}).get("persist-credentials") is False for step in checkouts), path.name
