"""Columns of the project's own: typed, kept with the cues, and never lost with what was typed into them."""

from typing import Any

import pytest
from httpx import Response

from app.sound_lists.own_columns.rules import Column, ColumnKind, column_faults, read_value
from tests.app.sound_lists.lists import add, columns_of, cut, set_columns, the_list
from tests.app.sound_lists.test_imports import send
from tests.support.server import World

MOOD: dict[str, Any] = {"name": "Mood", "kind": "choice", "choices": ["calm", "tense"]}


def put(world: World, columns: list[dict[str, Any]], by: str = "producer", edition: str | None = None) -> Response:
    body = {"columns": columns, "edition": edition or columns_of(world)["edition"]}
    response: Response = getattr(world, by).put(f"/v1/projects/{world.project_id}/sound-list/columns", json=body)
    return response


def change(world: World, cue: dict[str, Any], **extra: str) -> Response:
    body = {"edition": cue["edition"], "extra": extra}
    response: Response = world.producer.patch(f"/v1/cues/{cue['id']}", json=body)
    return response


def values(world: World) -> list[dict[str, str]]:
    return [cue["extra"] for cue in the_list(world)["cues"]]


@pytest.mark.parametrize(
    ("kind", "typed", "kept"),
    [
        ("text", " two  words ", "two  words"),
        ("number", "1,50", "1.5"),
        ("number", "12.0", "12"),
        ("number", "?", ""),
        ("yes_no", "Ja", "yes"),
        ("yes_no", "0", "no"),
        ("yes_no", "n/a", ""),
        ("date", "4 December 2026", "2026-12-04"),
        ("choice", "CALM", "calm"),
        ("choice", "tbd", ""),
    ],
)
def test_a_value_is_kept_as_its_type_writes_it(kind: str, typed: str, kept: str) -> None:
    assert read_value(Column(None, "c", ColumnKind(kind), ["calm", "tense"]), typed) == kept


@pytest.mark.parametrize(
    ("kind", "typed", "wanted"),
    [
        ("number", "loud", 'wanted a number such as 1.5, found "loud"'),
        ("number", "1" * 200, "wanted a number"),
        ("yes_no", "perhaps", 'wanted yes or no, found "perhaps"'),
        ("date", "soon", 'wanted a day such as 2026-12-04, found "soon"'),
        ("choice", "angry", 'wanted calm, tense; found "angry"'),
    ],
)
def test_a_value_that_does_not_fit_says_what_was_wanted(kind: str, typed: str, wanted: str) -> None:
    with pytest.raises(ValueError, match=wanted):
        read_value(Column(None, "c", ColumnKind(kind), ["calm", "tense"]), typed)


def test_the_limits_of_columns() -> None:
    def faults(*columns: Column) -> list[tuple[int, str]]:
        return [(place, field) for place, field, _ in column_faults(columns)]

    def text(name: str) -> Column:
        return Column(None, name, ColumnKind.TEXT)

    def choice(*choices: str) -> Column:
        return Column(None, "c", ColumnKind.CHOICE, choices)

    assert faults(*(text(f"c{number}") for number in range(20))) == []
    assert faults(*(text(f"c{number}") for number in range(21))) == [(21, "name")]
    assert faults(text("a" * 60), text("a" * 61), text("")) == [(2, "name"), (3, "name")]
    assert faults(text("Mood"), text("mood"), text("Loop"), text("number")) == [(2, "name"), (3, "name"), (4, "name")]
    assert faults(choice()) == faults(choice("a", "A")) == faults(choice("a" * 61)) == [(1, "choices")]
    assert faults(choice(*map(str, range(51)))) == [(1, "choices")]


@pytest.mark.slow
def test_columns_have_an_order_and_cues_have_values(world: World) -> None:
    set_columns(world, [MOOD, {"name": "Bank"}])
    (cue,) = add(world, {"name": "Door", "extra": {"mood": "TENSE", "Bank": " sfx "}})
    assert cue["extra"] == {"Mood": "tense", "Bank": "sfx"}
    refused = change(world, cue, Mood="angry")
    assert refused.status_code == 422
    assert refused.json()["errors"][0] == {"where": "Mood", "message": 'wanted calm, tense; found "angry"'}
    assert change(world, cue, Mood="calm").json()["extra"] == {"Mood": "calm"}
    read = columns_of(world)["columns"]
    set_columns(world, read[::-1])
    assert [column["name"] for column in columns_of(world)["columns"]] == ["Bank", "Mood"]
    assert {column["id"] for column in columns_of(world)["columns"]} == {column["id"] for column in read}


def test_a_removed_column_leaves_its_values_and_finds_them_again(world: World) -> None:
    set_columns(world, [MOOD])
    add(world, {"name": "Door", "extra": {"Mood": "calm"}})
    set_columns(world, [])
    assert values(world) == [{"Mood": "calm"}]
    set_columns(world, [{**MOOD, "name": "MOOD"}])
    assert values(world) == [{"MOOD": "calm"}]


@pytest.mark.slow
def test_a_renamed_column_takes_its_values_along_cut_cues_too(world: World) -> None:
    set_columns(world, [MOOD, {"name": "Bank"}])
    cues = add(
        world, {"name": "Door", "extra": {"Mood": "calm", "Bank": "a"}}, {"name": "Gate", "extra": {"Mood": "tense"}}
    )
    cut(world, cues[1]["id"], "no gate any more")
    mood, bank = columns_of(world)["columns"]
    set_columns(world, [{**mood, "name": "Bank"}, {**bank, "name": "Mood"}])  # the two swap names
    assert values(world) == [{"Bank": "calm", "Mood": "a"}, {"Bank": "tense"}]
    assert the_list(world)["cues"][1]["state"] == "cut"
    revision = the_list(world)["revision"]
    compared = world.designer.get(
        f"/v1/projects/{world.project_id}/sound-list/revisions/compare", params={"from": revision - 1, "to": revision}
    ).json()
    assert len(compared["changed"]) + len(compared["cut"]) == 2


def test_a_rename_that_would_hide_a_value_is_refused(world: World) -> None:
    add(world, {"name": "Door", "extra": {"Tone": "dark"}})
    set_columns(world, [MOOD])
    (cue,) = the_list(world)["cues"]
    assert change(world, cue, Mood="calm", Tone="dark").status_code == 200
    (mood,) = columns_of(world)["columns"]
    refused = put(world, [{**mood, "name": "Tone", "kind": "text"}])
    assert refused.status_code == 422
    assert "SW-001" in refused.json()["detail"]
    assert values(world) == [{"Mood": "calm", "Tone": "dark"}]


@pytest.mark.slow
def test_a_type_that_values_do_not_fit_is_refused_and_says_where(world: World) -> None:
    add(world, {"name": "One", "extra": {"Weight": "1,5"}}, {"name": "Two", "extra": {"Weight": "heavy"}})
    refused = put(world, [{"name": "Weight", "kind": "number"}])
    assert refused.status_code == 422
    (error,) = refused.json()["errors"]
    assert error == {
        "where": "column 1: kind",
        "message": 'SW-002 does not fit: wanted a number such as 1.5, found "heavy"',
    }
    assert columns_of(world)["columns"] == []
    set_columns(world, [{"name": "Weight"}])
    two = the_list(world)["cues"][1]
    assert change(world, two, Weight="400").status_code == 200
    set_columns(world, [{**columns_of(world)["columns"][0], "kind": "number"}])
    assert values(world) == [{"Weight": "1.5"}, {"Weight": "400"}]


def test_two_editors_of_columns_notice_each_other(world: World) -> None:
    edition = columns_of(world)["edition"]
    set_columns(world, [MOOD])
    late = put(world, [{"name": "Bank"}], edition=edition)
    assert (late.status_code, late.json()["code"]) == (409, "columns-changed")
    assert [column["name"] for column in columns_of(world)["columns"]] == ["Mood"]


@pytest.mark.parametrize(("by", "status"), [("approver", 200), ("reviewer", 403), ("designer", 403), ("stranger", 404)])
def test_who_may_set_columns(world: World, by: str, status: int) -> None:
    assert put(world, [MOOD], by=by).status_code == status


@pytest.mark.slow
def test_an_import_reads_a_column_by_its_name_or_as_mapped(world: World) -> None:
    set_columns(world, [MOOD, {"name": "Priority", "kind": "date"}])
    guessed = send(world, "name,MOOD,Priority,Stimmung\nDoor,Calm,31/5/2026,\nGate,angry,4/6/2026,\n", dry_run=True)
    assert [column["field"] for column in guessed["columns"]] == ["name", "own:Mood", "own:Priority", "extra"]
    (fault,) = guessed["errors"]
    assert (fault["row"], fault["column"]) == (3, "MOOD")
    assert send(world, "name,Stimmung\nDoor,calm\n", mapping={"Stimmung": "own:mood"})["imported"] is True
    assert send(world, "name,Priority,x\nGate,31/5/2026,\nHatch,4/6/2026,\n")["imported"] is True
    assert values(world) == [{"Mood": "calm"}, {"Priority": "2026-05-31"}, {"Priority": "2026-06-04"}]
    body = {"format": "csv", "dry_run": True, "text": "name,a\nx,y\n", "mapping": {"a": "own:Bank"}}
    unknown = world.producer.post(f"/v1/projects/{world.project_id}/sound-list/import", json=body)
    assert (unknown.status_code, unknown.json()["code"]) == (422, "column-unknown")
