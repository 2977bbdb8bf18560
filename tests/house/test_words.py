"""Tables and the API's tags are nouns that docs/domain.md defines."""

import json
import re
from pathlib import Path

from app.kit.db import Base
from app.tables import is_ours
from tests.house.test_migrations import ROOMS

ROOT = Path(__file__).resolve().parents[2]
IRREGULAR = {
    "pass": "pass",
    "people": "person",
    "memberships": "membership",
    "feedback": "feedback",
    "deliveries": "delivery",
}


def defined() -> set[str]:
    """Return the words in the first column of the page."""
    rows = re.findall(r"(?m)^\| ([^|]+) \|", (ROOT / "docs" / "domain.md").read_text())
    return {word.strip().lower() for row in rows for word in re.sub(r"\[.*?\]", "", row).replace("-", " ").split(",")}


def singular(noun: str) -> str:
    """Return a noun of several words, its last one in the singular."""
    *first, last = noun.split(" ")
    if last.endswith("ies"):
        last = f"{last[:-3]}y"
    elif last.endswith(("ches", "sses", "xes")):
        last = last[:-2]
    last = IRREGULAR.get(last, last.removesuffix("s"))
    return " ".join([*first, last])


def noun_of(table: str) -> str:
    """Return what a row of a table is: its name without its room, which names rows that other rooms have too."""
    room = next(room for room in ROOMS if table.startswith(f"{room}_"))
    noun = singular(table.removeprefix(f"{room}_").replace("_", " "))
    own = singular(room.replace("_", " "))
    return next((said for said in (f"{own} {noun}", noun) if said in defined()), noun)


def test_a_row_of_every_table_is_a_word_of_the_domain() -> None:
    assert all(is_ours(table) for table in Base.metadata.tables)
    unknown = {table: noun_of(table) for table in Base.metadata.tables if noun_of(table) not in defined()}
    assert unknown == {}


def test_every_tag_of_the_api_is_a_word_of_the_domain() -> None:
    document = json.loads((ROOT / "frontend" / "openapi.json").read_text())
    tags = {tag for path in document["paths"].values() for one in path.values() for tag in one.get("tags", [])}
    assert {tag for tag in tags if singular(tag.replace("-", " ")) not in defined()} == set()


def test_a_word_that_nobody_defined_is_found() -> None:
    assert singular("reverb tail boxes") == "reverb tail box"
    assert singular("reverb tail boxes") not in defined()
