"""Need: each cue is a must, a should or a wish."""

import pytest

from app.dashboards.progress.queries import NeedGroup
from app.dashboards.progress.service import completion
from app.deliveries.cue_counts.rules import VariationFact
from app.deliveries.rules import TakeState
from app.sound_lists.rules import CueState, Need
from tests.app.sound_lists.lists import add, cut, the_list
from tests.app.sound_lists.test_imports import send
from tests.support.server import World


def test_a_cue_is_a_must_until_it_is_said_otherwise(world: World) -> None:
    must, wish = add(world, {"name": "Door"}, {"name": "Whale", "need": "wish"})
    assert (must["need"], wish["need"]) == ("must", "wish")
    changed = world.approver.patch(f"/v1/cues/{must['id']}", json={"edition": 1, "need": "should"})
    assert changed.json()["need"] == "should"
    unknown = world.producer.patch(f"/v1/cues/{must['id']}", json={"edition": 2, "need": "perhaps"})
    assert unknown.status_code == 422


@pytest.mark.parametrize(
    ("typed", "need"),
    [
        ("Must", "must"),
        ("must-have", "must"),
        ("S", "should"),
        ("could", "wish"),
        ("nice to have", "wish"),
        ("", "must"),
    ],
)
def test_a_sheet_says_it_in_the_words_of_the_trade(world: World, typed: str, need: str) -> None:
    assert send(world, f"name,need\nDoor,{typed}\n")["imported"] is True
    assert [cue["need"] for cue in the_list(world)["cues"]] == [need]


def test_an_empty_cell_leaves_it_as_it_is_and_a_wrong_one_is_named(world: World) -> None:
    add(world, {"name": "Door", "need": "wish"})
    assert send(world, "number,need\n1,\n")["same"] == 1
    (fault,) = send(world, "number,need\n1,perhaps\n")["errors"]
    assert fault["message"] == 'wanted must, should, wish, found "perhaps"'
    assert [cue["need"] for cue in the_list(world)["cues"]] == ["wish"]


def test_completion_counts_accepted_cues_of_each_need() -> None:
    accepted = str(VariationFact(has_approved=True, has_waiting=False, newest=TakeState.APPROVED).packed)

    def group(need: Need, variations: int, facts: str | None, cues: int) -> NeedGroup:
        return NeedGroup(need, CueState.LOCKED, variations, placeholder=False, facts=facts, cues=cues)

    groups = [group(Need.WISH, 1, None, 2), group(Need.MUST, 1, accepted, 3), group(Need.MUST, 2, accepted, 4)]
    counted = [(each.need, each.accepted, each.cues) for each in completion(groups)]
    assert counted == [("must", 3, 7), ("wish", 0, 2)]  # one of two variations is not yet the cue


def test_a_project_says_how_far_each_need_is_and_leaves_cut_cues_out(world: World) -> None:
    cues = add(world, {"name": "Door"}, {"name": "Gate"}, {"name": "Whale", "need": "wish"})
    cut(world, cues[1]["id"], "no gate any more")
    for by in (world.producer, world.designer):
        overview = by.get(f"/v1/projects/{world.project_id}/overview").json()
        assert overview["needs"] == [
            {"need": "must", "accepted": 0, "cues": 1},
            {"need": "wish", "accepted": 0, "cues": 1},
        ]
