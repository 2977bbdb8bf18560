"""The guides: every path to one leads somewhere, and every reader finds the way."""

import json
import os
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support import architecture, keys

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
PATH_TO_A_GUIDE = re.compile(r"(?<![\w/.:-])(?:\.\./)*(docs/[\w./-]+\.(?:md|png|svg))(?![\w-])")
MADE = {".git", ".make", ".venv", ".hypothesis", "build", "data", "dist", "node_modules", "__pycache__"}
KINDS = {"", ".c", ".css", ".md", ".mjs", ".py", ".service", ".sh", ".toml", ".ts", ".tsx", ".yaml", ".yml"}


def texts() -> Iterator[tuple[Path, str]]:
    """Yield every source and document with its text; the changelog tells of earlier times."""
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in MADE and not name.endswith(("_cache", ".cache"))]
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
    assert "<picture>" in text


USER_PAGES = [*(ROOT / "docs" / "how-to").glob("*.md"), *(ROOT / "docs" / "tutorials").glob("*.md")]
FOR_OPERATORS = {"operate.md"}  # what a proxy passes on
# What the product says with a name, a figure or a word of a sheet in it, or what another program shows.
COMPOSED = {
    "Accept 3 sure matches",
    "All 4 are Shield hit",
    "Bedarf",
    "Effects, second part",
    "Download game",
    "Former user",
    "Import 3 cues",
    "Import 4 cues",
    "Interface",
    "Length (as written)",
    "Length (frames)",
    "Level lowered by 1.00 dB.",
    "Map to",
    "MoSCoW",
    "Only a wish for Shield hit",
    "Prefer A",
    "Priority",
    "Sample peak 0.00 dBFS. Limit −0.1 dBFS.",
    "Squashed peaks",
    "Third chord higher",
    "This is an MP3 named .wav.",
    "This link does not open anything any more.",
    "Unclear: Of what? How heavy? Into what?",
    "Upload renamed files",
}


def without_folded(page: Path) -> str:
    """Return a page without its code and its folded blocks."""
    return re.sub(r"```.*?```|<details.*?</details>", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)


@pytest.mark.parametrize("page", USER_PAGES, ids=lambda page: page.name)
def test_user_pages_fold_what_is_for_programs(page: Path):
    text = without_folded(page)
    assert page.name in FOR_OPERATORS or "/v1/" not in text
    assert not re.search(r"\bp95\b|\d ms at the median|on two busy cores", text), "figures of speed are benchmarks"


def test_every_label_that_user_pages_name_is_on_a_screen():
    sources = [*(ROOT / "frontend/src").rglob("*.ts*"), *(ROOT / "app/agreements/clauses/library").glob("*.md")]
    screens = " ".join(path.read_text(encoding="utf-8") for path in sources if ".test." not in path.name)
    screens = re.sub(r"\s+", " ", screens)
    unknown = {
        f"{page.name}: {label}"
        for page in [*USER_PAGES, *(ROOT / "docs" / "explanation").glob("*.md")]
        for label in re.findall(r"(?<![*\w])\*([A-Z][^*\n]{1,60})\*(?![*\w])", without_folded(page))
        if label not in COMPOSED and label.replace("'", "’") not in screens and label.rstrip(".:,") not in screens
    }
    assert unknown == set()


def test_every_request_that_user_pages_name_is_one():
    document = json.loads((ROOT / "frontend/openapi.json").read_text(encoding="utf-8"))
    requests = {
        f"{method.upper()} {re.sub(r'{[^}]*}', '{}', path)}"
        for path, methods in document["paths"].items()
        for method in methods
    }
    named = {
        f"{method} {re.sub(r'{[^}]*}', '{}', path)}"
        for page in USER_PAGES
        for method, path in re.findall(r"`(GET|PUT|POST|PATCH|DELETE) (/v1/[^`?\s]*)", page.read_text(encoding="utf-8"))
    }
    assert len(named) > 100
    assert named - requests == set()


def test_the_picture_of_the_architecture_is_that_of_the_imports():
    shown = (ROOT / "docs/pictures/architecture.svg").read_text(encoding="utf-8")
    assert shown == architecture.svg(), "run: make docs"


def test_an_import_that_follows_from_others_is_not_drawn():
    imports = {"shares": {"reviews", "core"}, "reviews": {"core"}, "core": set()}
    assert architecture.reduced(imports) == {"shares": {"reviews"}, "reviews": {"core"}, "core": set()}
    assert architecture.heights(imports) == {"core": 0, "reviews": 1, "shares": 2}


def test_the_page_of_keys_is_that_of_the_sources():
    shown = (ROOT / "docs/reference/keys.md").read_text(encoding="utf-8")
    assert shown == keys.page(), "run: make docs"
    assert shown.count("\n- `") > 150
    assert keys.written("mod+shift+Enter") == "Ctrl Shift Enter"


def test_every_picture_of_a_page_exists_in_light_and_dark():
    for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
        for source in re.findall(r'(?:src|srcset)="([^"]+)"', page.read_text(encoding="utf-8")):
            picture = page.parent / source
            assert picture.is_file(), f"{page.relative_to(ROOT)}: {source}"
            assert picture.with_name(re.sub("light|dark", "light", picture.name)).is_file()
            assert picture.with_name(re.sub("light|dark", "dark", picture.name)).is_file()
