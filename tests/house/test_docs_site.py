"""The site of the guides: built without a warning, and within the content security policy of the server."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow  # both build in one folder

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site") / "help"
    subprocess.run([sys.executable, ROOT / ".ci/docs_site.py", "--to", folder], check=True)
    return folder


def test_no_page_runs_a_script_of_its_own_or_loads_anything_from_elsewhere(site: Path):
    pages = list(site.rglob("*.html"))
    assert len(pages) > 100
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert not re.findall(r"<script(?![^>]*(?:src=|application/json))[^>]*>", text), page
        assert not re.findall(r"""<(?:script|img|iframe)[^>]*src=["']?(?:https?:)?//""", text), page
        assert not re.findall(r"""<link[^>]*rel=["']?stylesheet[^>]*href=["']?(?:https?:)?//""", text), page
        assert not re.findall(r"<[^>]* on(?:click|load|error)=", text), page


def test_every_link_within_the_site_leads_to_a_file(site: Path):
    for page in site.rglob("*.html"):
        for link in re.findall(r"""(?:href|src)=["']?([^"' >]+)""", page.read_text(encoding="utf-8")):
            target, _, _ = link.partition("#")
            if target and "//" not in target and not target.startswith(("mailto:", "data:", "/")):
                assert (page.parent / target).exists(), f"{page.relative_to(site)}: {link}"
