"""Words of tables, of the API and of every other name: docs/domain.md defines them, or they are everyday English."""

import json
import re
from collections.abc import Iterable
from pathlib import Path

import pytest

from app.kit.db import Base
from app.tables import is_ours
from tests.house import words_in_use
from tests.house.test_migrations import ROOMS
from tests.house.words_in_use import ROOT, bases_of, is_among, words_of, words_with_places

EVERYDAY = Path(__file__).with_name("everyday_words.txt")
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


def everyday() -> list[str]:
    """Return the words that need no definition."""
    return EVERYDAY.read_text(encoding="utf-8").splitlines()


def of_the_domain() -> set[str]:
    """Return the words of all terms, a term written as one word too (`handoff`), in every inflection."""
    words = {word for term in defined() for word in [*re.findall("[a-z]+", term), term.replace(" ", "")]}
    return inflected(words)


def inflected(words: Iterable[str]) -> set[str]:
    """Return words with what each may be an inflection of."""
    return {base for word in words for base in bases_of(word)}


def faults(places: dict[str, str], known: set[str]) -> list[str]:
    """Return a message for each word that is neither defined nor everyday."""
    what_to_do = f"define it in docs/domain.md, or add it to tests/house/{EVERYDAY.name} if it is everyday English"
    return [f"{word}, in {place}: {what_to_do}" for word, place in sorted(places.items()) if not is_among(word, known)]


def test_every_word_of_a_name_is_defined_or_everyday() -> None:
    assert faults(words_in_use.words_in_use(), of_the_domain() | inflected(everyday())) == []


def test_everyday_words_are_sorted_and_each_is_needed() -> None:
    words = everyday()
    assert words == sorted(set(words))
    left = [word for word in words_in_use.words_in_use() if not is_among(word, of_the_domain())]
    assert [word for word in words if not any(is_among(used, bases_of(word)) for used in left)] == []


def test_names_of_every_kind_are_read() -> None:
    kinds = {place.split(" ")[0] for _, place in words_in_use.names_of_api()}
    assert {"path", "parameter", "schema", "property", "value"} <= kinds
    commands = {place for _, place in words_in_use.names_of_commands()}
    assert {"audio-checks check --fail-level", "soundlist operators add", "soundlist backup --keep"} <= commands
    assert "ConcurrencyLimiter" in {name for name, _ in words_in_use.names_of_classes()}
    assert "deliveries_takes.cue_id" in {name for name, _ in words_in_use.names_of_columns()}
    assert [name for name, _ in words_in_use.names_of_metrics() if name == "soundlist_requests_in_flight"]
    assert [name for name, _ in words_in_use.names_of_settings() if name == "digest_delay_s"]
    assert {"sound-list", "/projects/$projectId/sound-list"} <= {name for name, _ in words_in_use.names_of_frontend()}


@pytest.mark.parametrize(
    ("schemas", "word"),
    [
        ({"FrobnicRead": {}}, "frobnic"),
        ({"CueRead": {"properties": {"frobnic_at": {}}}}, "frobnic"),
        ({"CueRead": {"properties": {"state": {"anyOf": [{"enum": ["frobnics"]}, {"type": "null"}]}}}}, "frobnics"),
        ({"CueRead": {"properties": {"kind": {"const": "add-frobnic"}}}}, "frobnic"),
    ],
)
def test_an_undefined_word_is_named_with_its_place(schemas: dict[str, object], word: str) -> None:
    places = words_with_places(words_in_use.names_of_api({"paths": {}, "components": {"schemas": schemas}}))
    [fault] = faults(places, of_the_domain() | inflected(everyday()))
    assert fault.startswith(f"{word}, in ")
    assert "Read: define it in docs/domain.md" in fault


def test_names_are_split_and_inflections_found() -> None:
    assert words_of("/v1/takes/{take_id}/HTTPErrorRead-2x") == ["takes", "take", "id", "http", "error", "read"]
    known = inflected(["plan", "cue", "ready", "accept", "stem", "person"])
    assert all(is_among(word, known) for word in ("planned", "cues", "unready", "accepting", "stems", "people"))
    assert not any(is_among(word, known) for word in ("plane", "system", "restem", "unison"))
