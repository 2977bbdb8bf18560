"""The list as a workbook: all of it leaves, comes back without a difference, and runs as no formula."""

import io
import itertools
import zipfile
from datetime import date
from typing import Any, get_args

import pytest
import python_calamine
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.sound_lists.schemas import ImportField
from audio_checks import HEADS
from tests.app.sound_lists.lists import add, columns_of, cut, set_columns, the_list
from tests.app.sound_lists.test_imports import send
from tests.support.server import World

COLUMNS: list[dict[str, Any]] = [
    {"name": "Mood", "kind": "choice", "choices": ["calm", "Tense", "=grim", "n/a"]},
    {"name": "Priority", "kind": "number"},
    {"name": "Streamed", "kind": "yes_no"},
    {"name": "Reviewed on", "kind": "date"},
    {"name": "-notes, of a kind", "kind": "text"},
]
AWKWARD = st.sampled_from(
    [
        *("=1+1", "+1", "-2", "@x", "'", "''=", "'=1", "\t", "\r", "\n", '"', ",", ";", "|", " ", "#N/A", "TRUE"),
        *("_x0041_", "_x000D_", "\x0b", "\u200b", "\ufeff", "\ufffe", "\uffff", "ß", "世", "👍", "e\u0301"),
        *("1e5", "0012", "12:30"),
    ]
)
ANY = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\x00"), max_size=8)
TEXT = st.lists(AWKWARD | ANY, max_size=3).map("".join)
numbers = itertools.count(1)


@st.composite
def rows(draw: st.DrawFn) -> dict[str, Any]:
    figure = st.floats(1e-6, 86_400)
    values = {
        "mood": draw(st.sampled_from(["", "CALM", "tense", "=grim", "n/a"])),
        "Priority": draw(st.just("") | st.floats(allow_nan=False, allow_infinity=False).map(repr)),
        "Streamed": draw(st.sampled_from(["", "yes", "no", "ja"])),
        "Reviewed on": draw(st.just("") | st.dates(date(1, 1, 1)).map(str)),
        "-notes, of a kind": draw(TEXT),
        draw(st.sampled_from(["Kept", "kept", "fps old", "Length", "=kept", "number", "#"])): draw(TEXT),
    }
    return {
        "name": draw(TEXT),
        "category": draw(st.sampled_from(["", "ui", "Weapon", "a-b_c"])),
        "description": draw(TEXT),
        "use": draw(TEXT),
        "trigger": draw(TEXT),
        "duration_s": draw(st.none() | figure),
        "length_locked": draw(st.booleans()),
        "frame_rate_fps": draw(st.none() | st.floats(1e-3, 1000)),
        "loop": draw(st.booleans()),
        "reverb": draw(st.sampled_from([None, "dry", "designed-tail", "separate-tail"])),
        "channels": draw(st.sampled_from([None, "mono", "stereo"])),
        "variations": draw(st.integers(1, 99)),
        "state": draw(st.sampled_from(["concept", "prototype", "locked"])),
        "need": draw(st.sampled_from(["must", "should", "wish"])),
        "playback_priority": draw(st.none() | st.integers(0, 1000)),
        "due_on": draw(st.none() | st.dates(date(1, 1, 1)).map(str)),
        "placeholder": draw(st.booleans()),
        "palette": draw(st.booleans()),
        "extra": values,
    }


def exported(world: World) -> bytes:
    answer = world.designer.get(f"/v1/projects/{world.project_id}/sound-list.xlsx")
    assert answer.status_code == 200, answer.text
    return answer.content


def sheet_of(content: bytes) -> list[list[Any]]:
    return python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(content)).get_sheet_by_index(0).to_python()


@pytest.mark.slow
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(rows(), min_size=1, max_size=12))
def test_a_list_comes_back_without_a_difference(world: World, typed: list[dict[str, Any]]) -> None:
    if not columns_of(world)["columns"]:
        set_columns(world, COLUMNS)
    added = add(world, *({**cue, "name": f"{cue['name']} q{next(numbers)}"} for cue in typed))
    cut(world, added[0]["id"], "the level is gone")
    for content in (exported(world), world.producer.get(f"/v1/projects/{world.project_id}/sound-list.csv").content):
        read = send(world, content, dry_run=True)
        assert [row["changes"] for row in read["rows"] if row["action"] != "same"] == []
        assert read["errors"] == []
        assert read["same"] == len(the_list(world)["cues"])


@pytest.mark.slow
def test_text_like_a_broken_formula_comes_back(world: World) -> None:
    set_columns(world, [{"name": "Mood"}])
    add(world, {"name": "Door", "description": "#N/A", "extra": {"Mood": "#REF!", "Kept": "#NAME?"}})
    for content in (exported(world), world.producer.get(f"/v1/projects/{world.project_id}/sound-list.csv").content):
        read = send(world, content, dry_run=True)
        assert (read["errors"], read["same"]) == ([], 1)
    assert send(world, "number,description\nSW-001,#N/A\n", dry_run=True)["errors"][0]["column"] == "description"


def test_it_has_a_column_for_every_field_of_an_import(world: World) -> None:
    assert {*HEADS} == {*get_args(ImportField)} - {"extra", "ignore"}
    set_columns(world, [{"name": "Mood"}])
    add(world, {"name": "Door", "need": "wish", "due_on": "2026-12-04", "duration_s": 1.5, "extra": {"Kept": "x"}})
    head, row = sheet_of(exported(world))
    assert head == [*HEADS, "Mood", "Kept"]
    said = dict(zip(head, row, strict=True))
    assert (said["number"], said["name"], said["need"], said["duration_s"]) == ("SW-001", "Door", "wish", 1.5)
    assert (said["due_on"], said["Mood"], said["Kept"]) == (date(2026, 12, 4), "", "x")


def test_what_looks_like_a_formula_is_text(world: World) -> None:
    typed = ["=HYPERLINK(1)", "+1", "-1", "@SUM(1)"]
    add(
        world,
        *[{"name": f"{text} {place}", "description": text, "extra": {text: text}} for place, text in enumerate(typed)],
    )
    content = exported(world)
    with zipfile.ZipFile(io.BytesIO(content)) as book:
        assert b"<f>" not in book.read("xl/worksheets/sheet1.xml")
    head, *lines = sheet_of(content)
    assert [line[head.index("description")] for line in lines] == typed
    assert head[-4:] == typed
