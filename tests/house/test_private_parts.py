"""Nothing here uses a private part of the engine of jobs, so that any of its minor versions will do."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint
ROOT = Path(__file__).parents[2]
PRIVATE = re.compile(r"dbos\.(?=_)|\bDBOS\._(?!_)|_sys_db\b")


@pytest.mark.parametrize("folder", ["app", "benchmarks", "tests"])
def test_no_private_part_of_dbos_is_used(folder: str):
    using = [
        f"{path.relative_to(ROOT)}: {match.group()}"
        for path in (ROOT / folder).rglob("*.py")
        if path != Path(__file__)
        for match in PRIVATE.finditer(path.read_text(encoding="utf-8"))
    ]
    assert using == []
