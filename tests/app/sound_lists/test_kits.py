"""Starter kits: cues that a designer could make, under names that the project's spec asks for."""

import csv
from dataclasses import dataclass
from typing import Any

import pytest
from httpx import Response
from typer.testing import CliRunner

import audio_checks
from app.cli import cli
from app.sound_lists.kits.rules import Kit, KitCue, all_kits, file_name_of
from app.sound_lists.rules import NEW_CUE, validation_errors
from tests.support.server import World

KITS = pytest.mark.parametrize("kit", all_kits(), ids=lambda kit: kit.key)
CATEGORIES = {"ambience", "foley", "ui", "weapon", "impact", "creature", "vehicle", "music", "vo"}


def test_there_are_twelve_kinds_of_game() -> None:
    assert len({kit.key for kit in all_kits()}) == 12
    assert len({kit.name for kit in all_kits()}) == 12


@KITS
def test_a_kit_is_a_list_that_can_be_saved(kit: Kit) -> None:
    assert 25 <= len(kit.cues) <= 60
    stems = [stem for cue in kit.cues for stem in audio_checks.stems_of("", "_".join(cue.parts), cue.variations)]
    assert len(set(stems)) == len(stems)
    assert {cue.category for cue in kit.cues} <= CATEGORIES
    for cue in kit.cues:
        facts = {"name": cue.name, "category": cue.category, "description": cue.description, "use": cue.use}
        facts |= {"duration_s": cue.duration_s, "variations": cue.variations, "file_name": "_".join(cue.parts)}
        assert list(validation_errors(NEW_CUE | facts)) == []
    for low, high in (kit.usual_cues, kit.usual_hours, kit.usual_memory_mb):
        assert 0 < low < high
    assert kit.usual_cues[1] >= len(kit.cues)


@KITS
def test_each_cue_says_what_is_heard(kit: Kit) -> None:
    """A description has a source and how near and loud it is; what loops says that it is seamless."""
    for cue in kit.cues:
        assert len(cue.description.split()) >= 7, cue.name
        assert "," in cue.description, cue.name  # several facts
        assert cue.use, cue.name
        assert cue.description.endswith("."), cue.name
        assert cue.loop == ("seamless" in cue.description), cue.name


@dataclass(frozen=True)
class Token:
    name: str
    one_of: tuple[str, ...] = ()
    digits: int | None = None
    case: str = "lower"
    optional: bool = False
    repeats: bool = False


STEP = KitCue("Step", ("foot", "grass", "wet"), "foley", 0.3, False, 6, "Each step", "A step.")


@pytest.mark.parametrize(
    ("tokens", "separator", "name"),
    [
        ((), "_", "foot_grass_wet"),
        (
            (Token("what"), Token("detail", repeats=True), Token("variation", digits=2, optional=True)),
            "_",
            "foot_grass_wet",
        ),
        ((Token("what", repeats=True, case="capital"),), "-", "Foot-Grass-Wet"),
        ((Token("category", case="upper"), Token("what", case="upper")), "_", "FOLEY_FOOTGRASSWET"),
        ((Token("kind", one_of=("amb", "fol", "sfx")), Token("what", repeats=True)), ".", "fol.foot.grass.wet"),
        ((Token("kind", one_of=("amb", "sfx")), Token("what")), "_", "amb_footgrasswet"),
        ((Token("kind", one_of=("amb", "sfx"), optional=True), Token("what")), "_", "footgrasswet"),
    ],
)
def test_names_are_built_from_the_parts_of_the_spec(tokens: tuple[Token, ...], separator: str, name: str) -> None:
    assert file_name_of(STEP, tokens, separator) == name


def path(world: World, rest: str) -> str:
    return f"/v1/projects/{world.project_id}{rest}"


def rows(world: World, kit: str = "platformer") -> list[dict[str, Any]]:
    answer = world.producer.get(path(world, f"/kits/{kit}"))
    assert answer.status_code == 200, answer.text
    return list(answer.json()["rows"])


def add(world: World, chosen: list[dict[str, Any]]) -> Response:
    cues = [{key: value for key, value in row.items() if key != "is_listed"} for row in chosen]
    return world.producer.post(path(world, "/cues"), json={"cues": cues})


def undo(world: World, cues: list[dict[str, Any]], by: str = "producer") -> Response:
    return getattr(world, by).post(path(world, "/cues/undo-addition"), json={"cue_ids": [cue["id"] for cue in cues]})


def test_kits_are_shown_with_what_is_usual(world: World) -> None:
    shown = world.designer.get("/v1/kits").json()
    assert [kit["key"] for kit in shown] == [kit.key for kit in all_kits()]
    first = shown[0]
    assert sum(first["categories"].values()) == first["cues"] < first["files"]
    assert first["usual_hours"]["low"] < first["usual_hours"]["high"]
    assert world.producer.get(path(world, "/kits/chess")).json()["code"] == "kit-not-found"


@pytest.mark.parametrize("kit", [kit.key for kit in all_kits()])
def test_every_kit_is_added_whole(world: World, kit: str) -> None:
    shown = rows(world, kit)
    assert not any(row["is_listed"] for row in shown)
    added = add(world, shown)
    assert added.status_code == 201, added.text
    assert all(row["is_listed"] for row in rows(world, kit))


def test_names_follow_the_spec_of_the_project(world: World) -> None:
    spec = world.producer.get(path(world, "/spec")).json()
    tokens = [
        {"name": "category", "case": "capital"},
        {"name": "what", "case": "capital", "repeats": True},
        {"name": "variation", "digits": 2, "optional": True},
    ]
    tables = spec["tables"] | {"naming": {"tokens": tokens, "separator": "-", "extension": ".wav"}}
    saved = world.producer.post(path(world, "/spec/form"), json={"tables": tables, "based_on_version": 1})
    assert saved.status_code == 200, saved.text
    names = {row["name"]: row["file_name"] for row in rows(world)}
    assert names["Footstep, grass"] == "Foley-Foot-Grass"
    assert names["Coin"] == "Ui-Coin-Pickup"


@pytest.mark.slow
def test_an_addition_is_undone_in_one_act(world: World) -> None:
    add(world, [{"name": "Airlock"}])
    added = add(world, rows(world)).json()
    assert undo(world, added, "designer").status_code == 403
    assert undo(world, added[1:]).json()["code"] == "addition-in-use"  # not all that was added
    assert undo(world, added).status_code == 204
    listed = world.producer.get(path(world, "/sound-list")).json()
    assert ([cue["name"] for cue in listed["cues"]], listed["revision"]) == (["Airlock"], 1)
    assert not any(row["is_listed"] for row in rows(world))
    assert undo(world, added).status_code == 409
    assert add(world, rows(world)).status_code == 201


@pytest.mark.slow
def test_what_has_gone_on_is_not_undone(world: World) -> None:
    first, second = add(world, rows(world)[:2]).json()
    asked = world.designer.post(f"/v1/cues/{first['id']}/questions", json={"text": "Which grass?"})
    assert asked.status_code == 201
    assert undo(world, [first, second]).json()["code"] == "addition-in-use"
    listed = world.producer.get(path(world, "/sound-list")).json()["cues"]
    assert [cue["stems"][0] for cue in listed] == ["foot_grass_01", "foot_stone_01"]
    world.producer.patch(f"/v1/cues/{second['id']}", json={"edition": 1, "use": "Often"})
    assert undo(world, [first, second]).json()["code"] == "addition-in-use"


def test_the_command_lists_kits_and_prints_one_that_an_import_reads(world: World) -> None:
    assert "platformer" in CliRunner().invoke(cli, ["kits"]).output
    printed = CliRunner().invoke(cli, ["kits", "puzzle"])
    assert len(list(csv.DictReader(printed.output.splitlines()))) == 29
    body = {"format": "csv", "text": printed.output, "dry_run": False}
    imported = world.producer.post(path(world, "/sound-list/import"), json=body).json()
    assert (imported["imported"], imported["added"], imported["errors"]) == (True, 29, [])
    refused = CliRunner().invoke(cli, ["kits", "chess"])
    assert refused.exit_code == 2
    assert "there are: card-game" in refused.output
