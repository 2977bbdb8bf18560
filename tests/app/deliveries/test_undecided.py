"""Several files of one delivery for one sound: nobody is asked later, so they are asked at the drop."""

from typing import Any
from uuid import UUID

import pytest

from app.deliveries.rules import OpenTake, undecided_groups
from tests.app.deliveries.test_tray import tray_action, undo
from tests.app.reviews.test_adoption_with_project import sound
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

DELIVERY, CUE = UUID(int=100), UUID(int=200)


def take(number: int, file_name: str, **more: Any) -> OpenTake:
    facts: dict[str, Any] = {"delivery_id": DELIVERY, "cue_id": CUE, "variation": 1, "alternate": None}
    return OpenTake(
        **facts | {"id": UUID(int=number), "number": number, "file_name": file_name, "fix_of_id": None} | more
    )


@pytest.mark.parametrize(
    ("takes", "numbers"),
    [
        ([take(1, "step_03.wav"), take(2, "Step 03 FINAL (2).wav")], [[1, 2]]),
        ([take(1, "a/laser.wav"), take(2, "b/laser.wav")], [[1, 2]]),
        ([take(1, "laser_v2.wav"), take(2, "laser_v1.wav")], [[1, 2]]),
        ([take(1, "laser.wav"), take(2, "Laser.wav"), take(3, "LASER.wav")], [[1, 2, 3]]),
        ([take(1, "laser.wav"), take(2, "Laser.wav"), take(3, "laser.wav")], [[2, 3]]),
        ([take(1, "laser.wav")], []),
        ([take(1, "laser.wav"), take(2, "laser.wav")], []),  # sent again
        ([take(1, "laser.wav"), take(2, "laser_v2.wav"), take(3, "laser_v3.wav")], []),
        ([take(1, "laser.wav"), take(2, "laser_altB.wav", alternate=2)], []),
        ([take(1, "laser.wav"), take(2, "Laser.wav", variation=2)], []),
        ([take(1, "laser.wav"), take(2, "Laser.wav", cue_id=UUID(int=201))], []),
        ([take(1, "laser.wav"), take(2, "Laser.wav", delivery_id=UUID(int=101))], []),
        ([take(1, "Laser.wav"), take(2, "laser.wav", fix_of_id=UUID(int=1))], []),
    ],
)
def test_when_nobody_chose(takes: list[OpenTake], numbers: list[list[int]]) -> None:
    assert [[one.number for one in group] for group in undecided_groups(takes)] == numbers


def undecided(world: World, by: Any = None) -> list[dict[str, Any]]:
    answer = (by or world.designer).get(f"/v1/projects/{world.project_id}/takes/undecided")
    assert answer.status_code == 200, answer.text
    return list(answer.json())


def test_two_files_for_one_sound_are_named_until_somebody_decides(world: World) -> None:
    [steps, laser] = add_cues(world, {"name": "Steps", "variations": 2}, {"name": "Laser"})
    delivery_id = open_delivery(world)
    first, second, _ = (
        deliver(world, name, sound(place), delivery_id=delivery_id)
        for place, name in enumerate(["steps_02.wav", "Steps 02 FINAL (2).wav", "steps_01.wav"])
    )
    world.server.wait_for_jobs()
    [place] = undecided(world)
    assert (place["cue"]["id"], place["variation"], place["delivery_id"]) == (steps["id"], 2, delivery_id)
    assert [one["file_name"] for one in place["takes"]] == ["steps_02.wav", "Steps 02 FINAL (2).wav"]
    assert undecided(world, world.producer) == [place]
    assert world.stranger.get(f"/v1/projects/{world.project_id}/takes/undecided").status_code == 404

    done = tray_action(world, "discard", {"take_ids": [first["id"]]})
    assert undecided(world) == []
    undo(world, done)
    assert len(undecided(world)) == 1

    as_alternate = {"take_id": second["id"], "cue_id": steps["id"], "variation": 2, "as_alternate": True}
    done = tray_action(world, "move", {"moves": [as_alternate]})
    assert undecided(world) == []
    moved = world.designer.get(f"/v1/takes/{second['id']}").json()
    assert (moved["alternate"], moved["variation"], moved["number"]) == (2, 2, second["number"])
    undo(world, done)
    assert len(undecided(world)) == 1

    tray_action(world, "move", {"moves": [{"take_id": second["id"], "cue_id": laser["id"]}]})
    assert undecided(world) == []


def test_a_set_with_files_nobody_chose_between_is_not_approved_in_silence(world: World) -> None:
    [steps] = add_cues(world, {"name": "Steps", "variations": 2})
    delivery_id = open_delivery(world)
    made = [
        deliver(world, name, sound(place), delivery_id=delivery_id)
        for place, name in enumerate(["steps_01.wav", "steps_02.wav", "Steps 02 FINAL (2).wav"])
    ]
    world.server.wait_for_jobs()
    takes = world.approver.get(f"/v1/cues/{steps['id']}/review").json()["takes"]
    rivals = {one["id"]: one["undecided_with"] for one in takes}
    assert rivals == {made[0]["id"]: [], made[1]["id"]: [made[2]["id"]], made[2]["id"]: [made[1]["id"]]}
    path = f"/v1/cues/{steps['id']}/accept-set"
    refused = world.approver.post(path, json={})
    assert (refused.status_code, refused.json()["code"]) == (409, "versions-undecided")
    assert "steps_02.wav" in refused.json()["detail"]
    assert "Steps 02 FINAL (2).wav" in refused.json()["detail"]
    accepted = world.approver.post(path, json={"take_ids": [made[1]["id"]]})
    assert accepted.status_code == 200, accepted.text
    assert accepted.json()["cue_accepted"]
