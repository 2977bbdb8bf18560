"""The guides: every path to one leads somewhere, and every reader finds the way."""

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


def pages_by_links(page: Path) -> set[Path]:
    """Return the documents that a document links to."""
    links = re.findall(r"\]\(([^)#\s]+\.md)", page.read_text(encoding="utf-8"))
    return {(page.parent / link).resolve() for link in links if "://" not in link}


@pytest.mark.parametrize(
    "goal",
    [
        "how-to/contracts.md",  # a producer
        "how-to/deliver.md",  # a sound designer
        "how-to/ci.md",  # a CI engineer
        "how-to/operate.md",  # an operator
        "explanation/architecture.md",  # a contributor
    ],
)
def test_each_reader_is_at_the_goal_in_three_links(goal: str):
    reached = {ROOT / "README.md"}
    for _ in range(3):
        reached |= {linked for page in reached for linked in pages_by_links(page) if linked.is_file()}
    assert ROOT / "docs" / goal in reached


def test_every_guide_is_in_the_navigation_of_the_site_and_linked_from_its_first_page():
    navigation = re.findall(r'"((?:[\w-]+/)*[\w-]+\.md)"', (ROOT / "zensical.toml").read_text())
    folders = {"decisions", "checks"}  # their first pages list the others
    guides = {
        str(page.relative_to(ROOT / "docs"))
        for page in (ROOT / "docs").rglob("*.md")
        if page.parent.name not in folders or page.name == "README.md"
    }
    assert set(navigation) == guides
    first = ROOT / "docs" / "README.md"
    assert {first, *pages_by_links(first)} >= {ROOT / "docs" / guide for guide in guides}
    for folder in folders:
        index = ROOT / "docs" / folder / "README.md"
        assert pages_by_links(index) >= {page for page in index.parent.glob("*.md") if page != index}


def test_the_first_page_of_the_repository_is_one_screen():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 60
    assert "![" in text
