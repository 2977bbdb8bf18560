"""Pin container images and GitHub Actions by digest: `make pins`, where Docker and gh can reach their registries.

A tag can be moved to other bytes; a digest cannot. Writes `image: NAME:TAG@sha256:…`, `FROM NAME:TAG@sha256:… AS …`
and `uses: OWNER/NAME@COMMIT # TAG` into the files themselves. What is pinned already is looked up again.
"""

import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
IMAGE = re.compile(
    r"^(?P<before>\s*(?:image:|FROM)\s+)(?P<name>[\w./-]+(?::[\w.-]+)?)(?P<pin>@sha256:[0-9a-f]{64})?(?=\s|$)", re.M
)
ACTION = re.compile(
    r"^(?P<before>\s*(?:- )?uses:\s+)(?P<name>[\w.-]+/[\w./-]+)@(?P<ref>[\w./-]+)(?: # (?P<tag>[\w./-]+))?$", re.M
)
COMMIT = re.compile(r"[0-9a-f]{40}")
OUR_IMAGES = frozenset({"soundlist"})


class Reference(NamedTuple):
    """An image or an action that a file names."""

    path: Path
    name: str  # with the tag: python:3.13-slim, actions/checkout@v5
    is_pinned: bool


def files(root: Path = ROOT) -> list[Path]:
    """Return the files that name images or actions."""
    named = [root / "Dockerfile", root / "docker-compose.yml", root / "action.yml"]
    return named + sorted((root / ".github/workflows").glob("*.yml"))


def references(path: Path) -> Iterator[Reference]:
    """Yield the images and actions that a file names."""
    text = path.read_text()
    stages = set(re.findall(r"^FROM \S+ AS (\w+)", text, re.MULTILINE))
    for found in IMAGE.finditer(text):
        if found["name"] not in OUR_IMAGES | stages:
            yield Reference(path, found["name"], bool(found["pin"]))
    for found in ACTION.finditer(text):
        tag = found["tag"] or found["ref"]
        yield Reference(path, f"{found['name']}@{tag}", bool(COMMIT.fullmatch(found["ref"])))


def pinned(text: str, image_digest: Callable[[str], str], action_commit: Callable[[str, str], str]) -> str:
    """Return a file's text with the digest of each image and the commit of each action."""
    stages = set(re.findall(r"^FROM \S+ AS (\w+)", text, re.MULTILINE))

    def pin_image(found: re.Match[str]) -> str:
        if found["name"] in OUR_IMAGES | stages:
            return found[0]
        return f"{found['before']}{found['name']}@{image_digest(found['name'])}"

    def pin_action(found: re.Match[str]) -> str:
        tag = found["tag"] or found["ref"]
        return f"{found['before']}{found['name']}@{action_commit(found['name'], tag)} # {tag}"

    return ACTION.sub(pin_action, IMAGE.sub(pin_image, text))


def image_digest(name: str) -> str:
    """Ask the image's registry for the digest of its list of platforms."""
    return _answer("docker", "buildx", "imagetools", "inspect", name, "--format", "{{.Manifest.Digest}}")


def action_commit(name: str, tag: str) -> str:
    """Ask GitHub for the commit that a tag names."""
    repository = "/".join(name.split("/")[:2])
    return _answer("gh", "api", f"repos/{repository}/commits/{tag}", "--jq", ".sha")


def _answer(*command: str) -> str:
    try:
        ran = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        sys.exit(f"{command[0]} is not installed; install it, or pin on a machine that has it")
    if ran.returncode:
        sys.exit(f"{' '.join(command)}: {ran.stderr.strip()}")
    return ran.stdout.strip()


if __name__ == "__main__":
    for path in files():
        path.write_text(pinned(path.read_text(), image_digest, action_commit))
