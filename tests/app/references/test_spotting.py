"""Spotting a clip: its marks become cues with their part of the clip, in one act that can be undone."""

from typing import Any

import pytest
from httpx import Response
from httpx2 import Client

from tests.support.deliver import add_cues
from tests.support.references import add, added, board, opened, uploaded
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

CLIP = b"\0\0\0\x18ftypisom\0\0\2\0isomiso2" + bytes(64)
DOOR = {"name": "Door slam", "category": "door", "start_s": 1.234, "duration_s": 0.5}
SHOT = {"name": "Shot", "start_s": 4.0}


def make(world: World, clip: dict[str, Any], *marks: dict[str, Any], by: Client | None = None) -> Response:
    return (by or world.producer).post(f"/v1/references/{clip['id']}/cues", json={"marks": list(marks)})


def undo(world: World, clip: dict[str, Any], cues: list[dict[str, Any]]) -> Response:
    url = f"/v1/references/{clip['id']}/cues/undo"
    return world.producer.post(url, json={"cue_ids": [cue["id"] for cue in cues]})


def names_of_list(world: World) -> list[str]:
    return [cue["name"] for cue in world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]]


@pytest.fixture
def clip(world: World) -> dict[str, Any]:
    return added(world, "walkway.mp4", CLIP, caption="The walkway", terms="Not to be shipped")


@pytest.mark.slow
def test_each_mark_becomes_a_cue_with_its_part_of_the_clip(world: World, clip: dict[str, Any]) -> None:
    made = make(world, clip, DOOR, SHOT)
    assert made.status_code == 201, made.text
    door, shot = made.json()
    assert (door["name"], door["category"], door["duration_s"]) == ("Door slam", "door", 0.5)
    assert (shot["name"], shot["category"], shot["duration_s"]) == ("Shot", "", None)
    assert names_of_list(world) == ["Door slam", "Shot"]
    [part] = [one for one in board(world, world.designer, cue_id=door["id"]) if one["cue"]]
    assert (part["start_s"], part["end_s"]) == (1.234, 1.734)
    assert (part["caption"], part["terms"]) == ("The walkway", "Not to be shipped")
    assert (part["version"]["kind"], part["version"]["file_name"]) == ("video", "walkway.mp4")
    assert opened(world, part, by=world.designer).content == CLIP
    [whole] = board(world, cue_id=shot["id"])
    assert (whole["start_s"], whole["end_s"]) == (4.0, None)
    assert len(board(world)) == 3


def test_the_cues_are_one_revision(world: World, clip: dict[str, Any]) -> None:
    make(world, clip, DOOR, SHOT)
    revisions = world.producer.get(f"/v1/projects/{world.project_id}/sound-list/revisions").json()["items"]
    assert [revision["summary"] for revision in revisions] == ["2 cues added"]


@pytest.mark.slow
def test_undo_takes_cues_and_parts_away_together(world: World, clip: dict[str, Any]) -> None:
    cues = make(world, clip, DOOR, SHOT).json()
    assert undo(world, clip, cues).status_code == 204
    assert names_of_list(world) == []
    assert [one["id"] for one in board(world)] == [clip["id"]]
    assert make(world, clip, DOOR, SHOT).status_code == 201


def test_undo_is_refused_once_a_part_was_opened(world: World, clip: dict[str, Any]) -> None:
    cues = make(world, clip, DOOR).json()
    [part] = [one for one in board(world) if one["cue"]]
    opened(world, part, by=world.designer)
    refused = undo(world, clip, cues)
    assert (refused.status_code, refused.json()["code"]) == (409, "addition-in-use")
    assert names_of_list(world) == ["Door slam"]
    assert len(board(world)) == 2


@pytest.mark.slow
def test_undo_is_refused_once_the_list_has_gone_on(world: World, clip: dict[str, Any]) -> None:
    cues = make(world, clip, DOOR).json()
    add_cues(world, {"name": "Later"})
    assert undo(world, clip, cues).status_code == 409
    assert len(board(world)) == 2


@pytest.mark.slow
def test_a_name_that_is_taken_refuses_all_and_names_its_row(world: World, clip: dict[str, Any]) -> None:
    add_cues(world, {"name": "Shot"})
    refused = make(world, clip, DOOR, SHOT)
    assert (refused.status_code, refused.json()["code"]) == (422, "rows-invalid")
    assert [error["where"] for error in refused.json()["errors"]] == ["row 2: name"]
    assert names_of_list(world) == ["Shot"]
    assert len(board(world)) == 1


@pytest.mark.parametrize(
    "wrong", [{"start_s": -1}, {"duration_s": 0}, {"name": ""}, {"start_s": 86_400, "duration_s": 1}]
)
def test_what_cannot_be_is_refused(world: World, clip: dict[str, Any], wrong: dict[str, Any]) -> None:
    assert make(world, clip, DOOR | wrong).status_code == 422
    assert names_of_list(world) == []


def test_only_a_clip_is_spotted(world: World) -> None:
    sound = added(world, "splash.wav", wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=16))
    link = add(world, url="https://example.test/clip").json()
    for reference in (sound, link):
        refused = make(world, reference, DOOR)
        assert (refused.status_code, refused.json()["code"]) == (422, "reference-invalid")


def test_the_team_spots_and_no_one_else(world: World, clip: dict[str, Any]) -> None:
    assert make(world, clip, DOOR, by=world.approver).status_code == 201
    for client in (world.reviewer, world.designer):
        assert make(world, clip, SHOT, by=client).status_code == 403
    assert make(world, clip, SHOT, by=world.stranger).status_code == 404


def test_a_category_is_guessed_from_the_list_then_from_the_words(world: World) -> None:
    def guess(name: str, by: Client | None = None) -> str:
        found = (by or world.producer).get(f"/v1/projects/{world.project_id}/category-guess", params={"name": name})
        assert found.status_code == 200, found.text
        return str(found.json()["category"])

    assert guess("door slam") == "door"
    assert guess("rifle shot") == "weapon"
    assert guess("blorp") == ""
    add_cues(world, {"name": "Hull door open", "category": "ship"}, {"name": "Rifle", "category": "guns"})
    assert guess("hull door close") == "ship"
    assert guess("pistol shot", world.designer) == "guns"
    url = f"/v1/projects/{world.project_id}/category-guess"
    assert world.stranger.get(url, params={"name": "door"}).status_code == 404


def renewed(world: World, clip: dict[str, Any], content: bytes = CLIP + b"second cut") -> dict[str, Any]:
    body = {"upload_id": uploaded(world, "walkway_2.mp4", content)}
    answer = world.producer.post(f"/v1/references/{clip['id']}/versions", json=body)
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def part_of(world: World, cue: dict[str, Any]) -> dict[str, Any]:
    [part] = [one for one in board(world, cue_id=cue["id"]) if one["cue"]]
    return part


@pytest.mark.slow
def test_parts_follow_to_a_new_version_of_the_clip_at_their_times(world: World, clip: dict[str, Any]) -> None:
    door, shot = make(world, clip, DOOR, SHOT).json()
    opened(world, part_of(world, door), by=world.designer)
    assert renewed(world, clip)["parts"] == 2
    part = part_of(world, door)
    assert (part["start_s"], part["end_s"], part["parts"]) == (1.234, 1.734, 0)
    assert (part["version"]["number"], part["version"]["file_name"]) == (2, "walkway_2.mp4")
    assert opened(world, part, by=world.designer).content == CLIP + b"second cut"
    assert part_of(world, shot)["version"]["number"] == 2
    log = world.producer.get(f"/v1/projects/{world.project_id}/reference-openings").json()["items"]
    assert [(one["version"], one["file_name"]) for one in log] == [(2, "walkway_2.mp4"), (1, "walkway.mp4")]


@pytest.mark.slow
def test_a_part_with_a_file_of_its_own_keeps_it(world: World, clip: dict[str, Any]) -> None:
    door, shot = make(world, clip, DOOR, SHOT).json()
    renewed(world, part_of(world, door), CLIP + b"a close-up")
    renewed(world, clip)
    assert part_of(world, door)["version"]["number"] == 2
    assert opened(world, part_of(world, door)).content == CLIP + b"a close-up"
    assert opened(world, part_of(world, shot)).content == CLIP + b"second cut"


def test_parts_stay_where_the_new_version_is_no_clip(world: World, clip: dict[str, Any]) -> None:
    [door] = make(world, clip, DOOR).json()
    renewed(world, clip, wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=16))
    assert part_of(world, door)["version"]["number"] == 1


@pytest.mark.slow
def test_the_range_of_a_part_is_changed_afterwards(world: World, clip: dict[str, Any]) -> None:
    [door] = make(world, clip, DOOR).json()
    url = f"/v1/references/{part_of(world, door)['id']}"
    assert world.producer.patch(url, json={"start_s": 2.5, "end_s": 3.25}).status_code == 200
    renewed(world, clip)
    part = part_of(world, door)
    assert (part["start_s"], part["end_s"], part["version"]["number"]) == (2.5, 3.25, 2)
    assert world.producer.patch(url, json={"end_s": 2.0}).json()["detail"] == "the part ends before it begins"
    assert world.designer.patch(url, json={"start_s": 0}).status_code == 403


@pytest.mark.slow
def test_undo_still_takes_the_cues_away_after_a_new_version(world: World, clip: dict[str, Any]) -> None:
    cues = make(world, clip, DOOR, SHOT).json()
    renewed(world, clip)
    assert undo(world, clip, cues).status_code == 204
    assert [one["id"] for one in board(world)] == [clip["id"]]
