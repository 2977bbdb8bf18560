"""Several cues in one line: parts combined each with each, under the names that the spec asks for."""

from typing import Any

import pytest
from httpx import Response

from app.sound_lists.matrix.rules import matrix_cues, read_matrix
from tests.app.sound_lists.lists import add, the_list
from tests.app.sound_lists.test_kits import Token
from tests.support.server import World

LINE = "deck, sand, water × walk, run, land × 6"


def names(line: str) -> list[str]:
    return [cue.name for cue in matrix_cues(read_matrix(line), "", (), "_")]


@pytest.mark.parametrize(
    ("line", "made", "variations"),
    [
        (LINE, ["deck_walk", "deck_run", "deck_land", "sand_walk", "sand_run", "sand_land"], 6),
        ("foot × deck,sand * walk", ["foot_deck_walk", "foot_sand_walk"], 1),
        ("deck, sand x walk X 2", ["deck_walk", "sand_walk"], 2),
        ("deck\nsand\n × walk", ["deck_walk", "sand_walk"], 1),
        ("Big metal; Wood × hit", ["big_metal_hit", "wood_hit"], 1),
        ("box, axe × open", ["box_open", "axe_open"], 1),  # an x within a word parts nothing
        ("Tür × auf", ["tur_auf"], 1),
        ("gun × 3", ["gun"], 3),
        ("level × 1, 2", ["level_1", "level_2"], 1),  # a list of numbers is not a number of variations
    ],
)
def test_a_line_makes_each_with_each(line: str, made: list[str], variations: int) -> None:
    matrix = read_matrix(line)
    assert names(line)[: len(made)] == made
    assert matrix.variations == variations


def test_the_first_part_changes_slowest_and_every_pair_is_made_once() -> None:
    assert len(names(LINE)) == len(set(names(LINE))) == 9


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("deck × × 6", "a part is missing before or after ×"),
        ("× 6", "a part is missing"),
        ("deck, sand × walk × 100", "100 variations; a cue may have 1 to 99"),
        ("deck × walk × 0", "0 variations"),
        ("deck, Deck × walk", '"deck" is there twice'),
        ("deck, !! × walk", '"!!" has no letter or digit'),
        (
            f"{', '.join(f'a{n}' for n in range(30))} × {', '.join(f'b{n}' for n in range(30))}",
            "30 × 30 makes 900 cues",
        ),
        ("a" * 4001, "4,001 characters"),
        ("a, a b × c, b c", 'would both own the file name "a_b_c"'),
    ],
)
def test_what_makes_no_cues_says_why(line: str, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        names(line)


def test_five_hundred_cues_are_made_and_one_more_is_not() -> None:
    fifty, ten = ", ".join(f"a{n}" for n in range(50)), ", ".join(f"b{n}" for n in range(10))
    assert len(names(f"{fifty} × {ten}")) == 500
    with pytest.raises(ValueError, match="501 × 1 makes 501 cues"):
        names(f"{', '.join(f'a{n}' for n in range(501))} × b")


def test_names_are_those_that_the_spec_asks_for() -> None:
    tokens = (
        Token("prefix", one_of=("SFX",), case="upper"),
        Token("what", case="capital"),
        Token("detail", case="capital", repeats=True),
        Token("variation", digits=2, optional=True),
    )
    (cue, _) = matrix_cues(read_matrix("deck, sand × walk × 2"), "foley", tokens, "_")
    assert (cue.name, cue.file_name) == ("deck_walk", "SFX_Deck_Walk")
    assert cue.stems == ["SFX_Deck_Walk_01", "SFX_Deck_Walk_02"]


def ask(world: World, line: str, by: str = "producer", **more: Any) -> Response:
    response: Response = getattr(world, by).get(
        f"/v1/projects/{world.project_id}/cue-matrix", params={"line": line, **more}
    )
    return response


def test_a_line_is_shown_before_it_is_added_and_one_undo_takes_it_back(world: World) -> None:
    rows = ask(world, LINE).json()["rows"]
    assert the_list(world) == {"revision": 0, "cues": []}
    assert (len(rows), rows[0]["name"], rows[0]["stems"][-1]) == (9, "deck_walk", "deck_walk_06")
    fields = ("name", "file_name", "variations")
    added = add(world, *({field: row[field] for field in fields} for row in rows))
    assert [cue["stems"] for cue in added] == [row["stems"] for row in rows]
    undo = world.producer.post(
        f"/v1/projects/{world.project_id}/cues/undo-addition", json={"cue_ids": [cue["id"] for cue in added]}
    )
    assert undo.status_code == 204
    assert the_list(world)["cues"] == []


def test_a_name_that_the_list_has_is_said_with_its_owner(world: World) -> None:
    add(world, {"name": "Sand run", "variations": 6})
    rows = ask(world, LINE).json()["rows"]
    assert {row["name"]: row["owner"] for row in rows if row["owner"]} == {"sand_run": "SW-001"}


def test_a_line_that_makes_nothing_is_refused_in_words(world: World) -> None:
    refused = ask(world, "deck × × 6")
    assert (refused.status_code, refused.json()["code"]) == (422, "matrix-invalid")
    assert refused.json()["detail"].startswith("a part is missing")
    assert ask(world, LINE, by="designer").status_code == 200
    assert ask(world, LINE, by="stranger").status_code == 404
