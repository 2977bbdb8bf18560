"""The guides: every path to one leads somewhere."""

import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
PATH_TO_A_GUIDE = re.compile(r"(?<![\w/.:-])(?:\.\./)*(docs/[\w./-]+\.(?:md|png|svg))(?![\w-])")
MADE = {".git", ".make", ".venv", ".hypothesis", "build", "data", "dist", "node_modules", "__pycache__"}
KINDS = {"", ".c", ".css", ".md", ".mjs", ".py", ".service", ".sh", ".toml", ".ts", ".tsx", ".yaml", ".yml"}


def texts() -> Iterator[tuple[Path, str]]:
    """Yield every source and document with its text; the changelog tells of earlier times."""
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in MADE and not name.endswith("_cache")]
        for path in (Path(folder, name) for name in names if name not in ("CHANGELOG.md", "uv.lock")):
            if path.suffix in KINDS and path.is_file():
                content = path.read_bytes()
                if b"docs/" in content:
                    yield path, content.decode("utf-8", "replace")


def test_every_path_to_a_guide_exists():
    dead = [
        f"{path.relative_to(ROOT)}: {guide}"
        for path, text in texts()
        for guide in PATH_TO_A_GUIDE.findall(text)
        if not (ROOT / guide).exists()
    ]
    assert dead == []
