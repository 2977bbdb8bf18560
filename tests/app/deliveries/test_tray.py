"""Messy names find their cue where they are sure; many files are matched, moved and discarded at once, and back."""

from typing import Any
from uuid import UUID

import pytest

from app.core.db import new_id
from app.deliveries.rules import TakeState
from tests.app.deliveries.test_takes import another, become, engage, slot
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

LIST = (
    {"name": "Perc bell", "file_name": "perc_bell"},
    {"name": "Perc bell 2", "file_name": "perc_bell2"},
    {"name": "Step grass", "file_name": "step_grass", "variations": 4},
    {"name": "UI click", "file_name": "ui_click"},
    {"name": "Glitch", "file_name": "glitch_perc1"},
)


def tray_action(world: World, what: str, body: dict[str, Any], by: Any = None) -> dict[str, Any]:
    done = (by or world.designer).post(f"/v1/projects/{world.project_id}/takes/{what}", json=body)
    assert done.status_code == 200, done.text
    return dict(done.json())


def undo(world: World, done: dict[str, Any], by: Any = None) -> dict[str, Any]:
    undone = (by or world.designer).post(f"/v1/tray-actions/{done['id']}/undo")
    assert undone.status_code == 200, undone.text
    return dict(undone.json())


def takes(world: World, **query: Any) -> list[dict[str, Any]]:
    shown = world.designer.get(f"/v1/projects/{world.project_id}/takes", params={"limit": 200} | query)
    return list(shown.json()["items"])


def desk_unmatched(world: World) -> int:
    return int(world.designer.get(f"/v1/projects/{world.project_id}/desk").json()["unmatched"])


def see(world: World, take_id: str) -> dict[str, Any]:
    return dict(world.designer.get(f"/v1/takes/{take_id}").json())


@pytest.mark.parametrize(
    ("name", "cue", "variation"),
    [
        ("perc-bell2.wav", "Perc bell 2", 1),
        ("PERC_BELL.wav", "Perc bell", 1),
        ("PercBell2 FINAL (1).wav", "Perc bell 2", 1),
        ("perc_bell_FINAL2.wav", "Perc bell", 1),
        ("glitch_perc1_final_FINAL2.wav", "Glitch", 1),
        ("Step Grass 3 v02.wav", "Step grass", 3),
        ("UI/click.wav", "UI click", 1),
        ("perc bell 2.wav", None, 1),
        ("step_grass_v2.wav", None, 1),
        ("glitch_perc2.wav", None, 1),
    ],
)
def test_a_messy_name_finds_its_cue_where_it_is_sure(world: World, name: str, cue: str | None, variation: int) -> None:
    add_cues(world, *LIST)
    assert slot(deliver(world, name, another(1)))[:2] == (cue, variation)


@pytest.mark.slow
def test_a_file_in_doubt_waits_with_guesses(world: World) -> None:
    add_cues(world, *LIST)
    take = see(world, deliver(world, "perc bell 2.wav", another(1))["id"])
    assert take["sure"] is None
    assert [guess["name"] for guess in take["guesses"][:2]] == ["Perc bell 2", "Perc bell"]
    assert take["guesses"][0]["becomes"] == "perc_bell2.wav"
    assert "Perc bell" in take["guesses"][0]["reason"]
    steps = see(world, deliver(world, "step_grass_v2.wav", another(2))["id"])["guesses"][0]
    assert (steps["name"], steps["variation"], steps["variations"], steps["becomes"]) == ("Step grass", None, 4, None)


@pytest.mark.slow
def test_sure_matches_are_accepted_in_one_act_and_undone(world: World) -> None:
    delivery_id = open_delivery(world)
    names = ["PercBell2_FINAL.wav", "UI/click.wav", "step grass 04.wav", "nothing like it.wav"]
    waiting = [deliver(world, name, another(seed), delivery_id=delivery_id)["id"] for seed, name in enumerate(names)]
    assert desk_unmatched(world) == 4
    add_cues(world, *LIST)
    assert [take["sure"] and take["sure"]["becomes"] for take in reversed(takes(world, unmatched=True))] == [
        "perc_bell2.wav",
        "ui_click.wav",
        "step_grass_04.wav",
        None,
    ]
    done = tray_action(world, "accept-sure", {})
    assert done["take_ids"] == waiting[:3]
    assert [slot(see(world, take_id))[:2] for take_id in waiting] == [
        ("Perc bell 2", 1),
        ("UI click", 1),
        ("Step grass", 4),
        (None, 1),
    ]
    assert desk_unmatched(world) == 1
    undone = undo(world, done)
    assert (undone["moved_back"], undone["left"]) == (3, 0)
    assert desk_unmatched(world) == 4
    again = world.designer.post(f"/v1/tray-actions/{done['id']}/undo")
    assert (again.status_code, again.json()["code"]) == (409, "already-undone")


@pytest.mark.slow
def test_a_prefix_that_a_delivery_shares_is_read(world: World) -> None:
    cues = ["laser_fire", "shield_hit", "door_open", "rain_loop", "engine_start"]
    delivery_id = open_delivery(world)
    for seed, name in enumerate([*cues, "other_thing"]):
        deliver(world, f"Nordlicht_{name}.wav", another(seed), delivery_id=delivery_id)
    add_cues(world, *({"name": name} for name in cues))
    assert len(tray_action(world, "accept-sure", {})["take_ids"]) == 5


@pytest.mark.slow
def test_only_the_named_are_accepted(world: World) -> None:
    first, second = (
        deliver(world, name, another(seed))["id"] for seed, name in enumerate(["PERC BELL.wav", "UI click.wav"])
    )
    add_cues(world, *LIST)
    assert tray_action(world, "accept-sure", {"take_ids": [second]})["take_ids"] == [second]
    assert see(world, first)["cue"] is None


@pytest.mark.slow
def test_a_folder_of_300_goes_away_in_one_act_and_comes_back(world: World) -> None:
    add_cues(world, *LIST)
    delivery_id = open_delivery(world)
    matched = deliver(world, "ui_click.wav", another(0), delivery_id=delivery_id)["id"]
    ids = [deliver(world, f"wrong/{seed}.wav", another(seed), delivery_id=delivery_id)["id"] for seed in range(1, 12)]
    done = tray_action(world, "discard", {"take_ids": [*ids, matched]})
    assert (desk_unmatched(world), takes(world)) == (0, [])
    gone = takes(world, discarded=True)
    assert {take["id"] for take in gone} == {*ids, matched}
    assert all(take["discarded_at"] for take in gone)
    assert world.designer.get(f"/v1/deliveries/{delivery_id}").json()["takes"] == []
    assert undo(world, done)["moved_back"] == 12
    assert (slot(see(world, matched))[:3], desk_unmatched(world)) == (("UI click", 1, 1), 11)


@pytest.mark.slow
def test_discarded_files_can_be_restored_and_sent_again(world: World) -> None:
    take = deliver(world, "stray.wav", another(1))
    tray_action(world, "discard", {"take_ids": [take["id"]]})
    matched = world.designer.put(f"/v1/takes/{take['id']}/match", json={"cue_id": add_cues(world, *LIST)[0]["id"]})
    assert (matched.status_code, matched.json()["code"]) == (409, "wrong-state")
    again = deliver(world, "stray.wav", another(1))
    assert (again["already_here"], again["id"] == take["id"]) == (False, False)
    tray_action(world, "restore", {"take_ids": [take["id"]]})
    assert desk_unmatched(world) == 2


@pytest.mark.slow
def test_many_are_moved_at_once_and_undone(world: World) -> None:
    bell, _, steps, click, _ = add_cues(world, *LIST)
    first, second = deliver(world, "perc_bell.wav", another(1)), deliver(world, "stray.wav", another(2))
    moves = [
        {"take_id": first["id"], "cue_id": steps["id"], "variation": 2},
        {"take_id": second["id"], "cue_id": click["id"]},
    ]
    preview = world.designer.post(f"/v1/projects/{world.project_id}/takes/rename-preview", json={"moves": moves})
    assert [one["becomes"] for one in preview.json()] == ["step_grass_02.wav", "ui_click.wav"]
    assert see(world, first["id"])["cue"]["id"] == bell["id"]  # a preview changes nothing
    done = tray_action(world, "move", {"moves": moves}, by=world.producer)
    assert [slot(see(world, take["id"]))[:2] for take in (first, second)] == [("Step grass", 2), ("UI click", 1)]
    assert undo(world, done, by=world.producer)["moved_back"] == 2
    assert see(world, first["id"])["cue"]["id"] == bell["id"]
    assert see(world, second["id"])["cue"] is None


@pytest.mark.slow
def test_for_a_cut_cue_a_file_keeps_its_name(world: World) -> None:
    bell = add_cues(world, *LIST)[0]
    take = deliver(world, "stray.wav", another(1))
    assert (
        world.producer.post(f"/v1/cues/{bell['id']}/cut", json={"reason": "the level was dropped"}).status_code == 200
    )
    moves = [{"take_id": take["id"], "cue_id": bell["id"]}]
    preview = world.designer.post(f"/v1/projects/{world.project_id}/takes/rename-preview", json={"moves": moves})
    assert [one["becomes"] for one in preview.json()] == ["stray.wav"]


@pytest.mark.slow
def test_nothing_is_moved_or_discarded_once_a_verdict_stands(world: World) -> None:
    bell, _, _, click, _ = add_cues(world, *LIST)
    decided, free = deliver(world, "perc_bell.wav", another(1)), deliver(world, "ui_click.wav", another(2))
    world.server.wait_for_jobs()
    become(world, decided["id"], TakeState.RECEIVED, TakeState.CONFORMING, TakeState.APPROVED)
    ids = [free["id"], decided["id"]]
    for what, body in (
        ("discard", {"take_ids": ids}),
        ("move", {"moves": [{"take_id": take_id, "cue_id": bell["id"]} for take_id in [free["id"]]]
                  + [{"take_id": decided["id"], "cue_id": click["id"]}]}),
    ):  # fmt: skip
        refused = world.designer.post(f"/v1/projects/{world.project_id}/takes/{what}", json=body)
        assert (refused.status_code, refused.json()["code"]) == (409, "wrong-state")
    assert slot(see(world, free["id"]))[0] == "UI click"


@pytest.mark.slow
def test_what_was_touched_since_stays_when_an_act_is_undone(world: World) -> None:
    take = deliver(world, "PERC BELL.wav", another(1))["id"]
    click = add_cues(world, *LIST)[3]
    done = tray_action(world, "accept-sure", {})
    world.designer.put(f"/v1/takes/{take}/match", json={"cue_id": click["id"]})
    undone = undo(world, done)
    assert (undone["moved_back"], undone["left"]) == (0, 1)
    assert see(world, take)["cue"]["id"] == click["id"]


@pytest.mark.slow
def test_the_same_bytes_are_already_here_under_any_name(world: World) -> None:
    add_cues(world, *LIST)
    first = deliver(world, "stray.wav", another(1))
    again = deliver(world, "wrong/other name.wav", another(1))
    assert (again["already_here"], again["id"], again["file_name"]) == (True, first["id"], "stray.wav")
    matched = deliver(world, "Perc-Bell.wav", another(1))  # its bytes under a name that is sure
    assert (matched["already_here"], matched["id"], matched["cue"]["name"]) == (True, first["id"], "Perc bell")
    assert deliver(world, "ui_click.wav", another(1))["id"] == first["id"]
    assert len(takes(world)) == 1


@pytest.mark.slow
def test_another_designer_can_touch_nothing_of_it(world: World) -> None:
    engage(world)
    bell = add_cues(world, *LIST)[0]
    take = deliver(world, "stray.wav", another(1))["id"]
    for what, body in (
        ("discard", {"take_ids": [take]}),
        ("restore", {"take_ids": [take]}),
        ("move", {"moves": [{"take_id": take, "cue_id": bell["id"]}]}),
        ("rename-preview", {"moves": [{"take_id": take, "cue_id": bell["id"]}]}),
    ):
        refused = world.other_designer.post(f"/v1/projects/{world.project_id}/takes/{what}", json=body)
        assert (refused.status_code, refused.json()["code"]) == (404, "take-not-found"), what
    assert tray_action(world, "accept-sure", {"take_ids": [take]}, by=world.other_designer)["take_ids"] == []
    done = tray_action(world, "discard", {"take_ids": [take]})
    for action_id in (done["id"], new_id()):
        assert world.other_designer.post(f"/v1/tray-actions/{action_id}/undo").status_code == 404
    assert UUID(done["id"])
