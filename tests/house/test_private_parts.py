"""Nothing here uses a private part of a framework, so that any of its minor versions will do."""

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint
ROOT = Path(__file__).parents[2]
FRAMEWORKS = "alembic|anyio|dbos|fastapi|granian|httpx|pydantic|pydantic_settings|sqlalchemy|starlette|typer|uvicorn"
PRIVATE = re.compile(
    r"dbos\.(?=_)|\bDBOS\._(?!_)|_sys_db\b"
    rf"|\b(?:from|import) (?:{FRAMEWORKS})(?:\.\w+)*\._\w+"  # a private module
    rf"|\bfrom (?:{FRAMEWORKS})[.\w]* import (?:.*, )?\(?_\w+"  # a private name
    r"|\buvicorn\.protocols|\bfastapi\.dependencies\.utils"
    r"|\bfrom starlette\.routing import .*\bMatch\b|\.matches\(scope"
    r"|\bfrom fastapi\.routing import .*\b(?:get_request_handler|request_response|run_endpoint|serialize_response)"
)


@pytest.mark.parametrize("folder", ["app", "audio_checks", "benchmarks", "migrations", "tests"])
def test_no_private_part_of_a_framework_is_used(folder: str):
    using = [
        f"{path.relative_to(ROOT)}: {match.group()}"
        for path in (ROOT / folder).rglob("*.py")
        if path != Path(__file__)
        for match in PRIVATE.finditer(path.read_text(encoding="utf-8"))
    ]
    assert using == []


@pytest.mark.parametrize(
    "line",
    [
        "from dbos._dbos import DBOS",
        "import uvicorn.protocols.http",
        "from starlette.routing import Match, Router",
        "from fastapi.routing import APIRoute, serialize_response",
        "from pydantic._internal import _fields",
        "from sqlalchemy.orm import Session, _loader",
    ],
)
def test_the_test_sees_it(line: str):
    assert PRIVATE.search(line)
