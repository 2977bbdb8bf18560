"""Beds: set for a project and for a category, changed, taken away, played."""

from typing import Any

import pytest
from httpx2 import Client

from tests.app.reviews.making import Stage
from tests.app.scenes.making import approved, drawn_take, masking, opened_scene
from tests.support.references import added
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

NOBODY_ID = "0197f8f0-0000-7000-8000-000000000000"


def put(world: World, by: Client | None = None, **body: Any) -> Any:
    return (by or world.approver).put(f"/v1/projects/{world.project_id}/beds", json=body)


def set_bed(world: World, **body: Any) -> dict[str, Any]:
    answer = put(world, **body)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def beds_in(scene: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {lane["id"]: lane for lane in scene["lanes"] if lane["bed"]}


@pytest.fixture
def take_id(stage: Stage):
    return drawn_take(stage, stage.cue("suit_hit", category="impacts"), noise(dbfs=-20.0, seconds=0.5))


@pytest.mark.slow
def test_a_bed_of_the_project_plays_under_every_sound_and_a_category_has_its_own(
    world: World, stage: Stage, take_id: str
):
    _, engine = approved(stage, "engine_loop", loop=True, category="ships")
    _, wind = approved(stage, "wind_loop", loop=True, category="ambiences")
    _, line = approved(stage, "vo_oath", category="voice")
    set_bed(world, role="ambience", take_id=str(engine), level_db=-14)
    set_bed(world, role="voice", take_id=str(line))
    scene = opened_scene(world, take_id, settled=False)
    beds = beds_in(scene)
    assert list(beds) == ["ambience", "voice"]
    assert (beds["ambience"]["name"], beds["ambience"]["level_db"]) == ("engine_loop", -14.0)
    assert (beds["ambience"]["level_from"], beds["ambience"]["loops"]) == ("bed", True)
    assert (beds["voice"]["loops"], beds["voice"]["level_db"]) == (False, -12.0)
    own = set_bed(world, role="ambience", category="impacts", take_id=str(wind), level_db=-20)
    assert beds_in(opened_scene(world, take_id, settled=False))["ambience"]["name"] == "wind_loop"
    assert world.approver.delete(f"/v1/beds/{own['id']}").status_code == 204
    assert beds_in(opened_scene(world, take_id, settled=False))["ambience"]["name"] == "engine_loop"


def test_a_second_bed_in_a_role_takes_the_place_of_the_first(world: World, stage: Stage):
    _, first = approved(stage, "first")
    _, second = approved(stage, "second")
    one = set_bed(world, role="music", take_id=str(first))
    other = set_bed(world, role="music", take_id=str(second), level_db=-3, is_on=False)
    assert one["id"] == other["id"]
    assert (other["take_id"], other["level_db"], other["is_on"]) == (str(second), -3.0, False)


@pytest.mark.slow
def test_a_part_of_a_reference_is_a_bed_once_it_was_opened(world: World, take_id: str):
    music = wav_bytes(sine(hz=440, dbfs=-12.0, seconds=4.0, rate=96_000), rate=96_000)
    reference = added(world, "battle_2.wav", music, caption="Battle 2", start_s=1, end_s=3)
    set_bed(world, role="music", reference_id=reference["id"], level_db=-18)
    scene = opened_scene(world, take_id, settled=False)
    assert beds_in(scene)["music"]["preview_url"] is None
    scene = opened_scene(world, take_id)
    lane = beds_in(scene)["music"]
    assert (lane["name"], lane["duration_s"], lane["loops"]) == ("Battle 2", 2.0, True)
    assert lane["thumb"]["points"] > 0
    refused = world.reviewer.get(lane["preview_url"])
    assert (refused.status_code, refused.json()["code"]) == (409, "reference-unopened")
    opening = f"/v1/reference-versions/{lane['reference_version_id']}/openings"
    assert world.reviewer.post(opening).status_code == 204
    played = world.reviewer.get(lane["preview_url"])
    assert played.status_code == 200
    assert played.headers["content-type"] == "audio/wav"
    assert len(played.content) == 44 + 2 * 48_000 * 2
    assert world.stranger.get(lane["preview_url"]).status_code == 404
    assert masking(world, take_id)["is_measured"] is True


@pytest.mark.slow
def test_a_reference_that_cannot_be_decoded_says_so_and_holds_nothing_up(world: World, take_id: str):
    reference = added(world, "broken.flac", b"fLaC" + bytes(400))
    set_bed(world, role="music", reference_id=reference["id"])
    scene = opened_scene(world, take_id)
    lane = beds_in(scene)["music"]
    assert scene["is_ready"] is True
    assert "cannot be decoded" in lane["problem"]
    assert lane["preview_url"] is None
    assert masking(world, take_id)["is_measured"] is True


@pytest.mark.slow
def test_what_is_no_longer_approved_or_on_the_board_is_no_lane(world: World, stage: Stage, take_id: str):
    _, engine = approved(stage, "engine_loop", loop=True)
    reference = added(world, "a.wav", wav_bytes(sine(hz=440, seconds=0.5)))
    set_bed(world, role="ambience", take_id=str(engine))
    set_bed(world, role="music", reference_id=reference["id"])
    assert world.producer.delete(f"/v1/references/{reference['id']}").status_code == 204
    assert list(beds_in(opened_scene(world, take_id, settled=False))) == ["ambience"]


@pytest.mark.slow
def test_a_bed_that_is_off_covers_nothing(world: World, stage: Stage, take_id: str):
    _, engine = approved(stage, "engine_loop", noise(dbfs=-6.0, seconds=1.0), loop=True)
    bed = set_bed(world, role="ambience", take_id=str(engine), level_db=0)
    opened_scene(world, take_id)
    heard_with = masking(world, take_id, ambience=0.0)["energy_share"]
    changed = world.approver.patch(f"/v1/beds/{bed['id']}", json={"is_on": False})
    assert (changed.status_code, changed.json()["level_db"], changed.json()["is_on"]) == (200, 0.0, False)
    assert beds_in(opened_scene(world, take_id, settled=False))["ambience"]["is_on"] is False
    assert heard_with < 1.0
    assert masking(world, take_id, sound=0.0)["is_compared"] is False


@pytest.mark.parametrize(
    "body",
    [
        {},
        {"role": "music"},
        {"role": "choir", "take_id": NOBODY_ID},
        {"role": "music", "take_id": NOBODY_ID},
        {"role": "music", "reference_id": NOBODY_ID},
        {"role": "music", "take_id": NOBODY_ID, "reference_id": NOBODY_ID},
        {"role": "music", "take_id": NOBODY_ID, "level_db": 13},
        {"role": "music", "take_id": NOBODY_ID, "level_db": -61},
        {"role": "music", "take_id": NOBODY_ID, "category": "\0"},
    ],
)
def test_beds_that_cannot_be(world: World, body: dict[str, Any]):
    assert put(world, **body).status_code == 422


def test_a_version_that_is_not_approved_or_of_another_project_is_no_bed(world: World, stage: Stage, take_id: str):
    assert put(world, role="music", take_id=str(take_id)).status_code == 422
    elsewhere = Stage(World(world.server))
    _, other = approved(elsewhere, "engine_loop")
    assert put(world, role="music", take_id=str(other)).status_code == 422


@pytest.mark.slow
def test_those_who_act_for_the_team_set_beds(world: World, stage: Stage):
    _, engine = approved(stage, "engine_loop")
    body = {"role": "music", "take_id": str(engine)}
    assert [put(world, by, **body).status_code for by in (world.reviewer, world.designer, world.stranger)] == [
        403, 403, 404,
    ]  # fmt: skip
    bed = set_bed(world, **body)
    for by, status in ((world.reviewer, 403), (world.designer, 403), (world.stranger, 404)):
        assert by.patch(f"/v1/beds/{bed['id']}", json={"level_db": -3}).status_code == status
        assert by.delete(f"/v1/beds/{bed['id']}").status_code == status
    assert world.approver.patch(f"/v1/beds/{NOBODY_ID}", json={}).status_code == 404


@pytest.mark.slow
def test_sources_are_approved_sounds_with_loops_first_then_references(world: World, stage: Stage, take_id: str):
    approved(stage, "hull_impact")
    approved(stage, "engine_loop", loop=True)
    added(world, "battle_2.wav", wav_bytes(sine(hz=440, seconds=0.5)))
    answer = world.reviewer.get(f"/v1/projects/{world.project_id}/bed-sources")
    assert [(one["name"], one["loops"]) for one in answer.json()] == [
        ("engine_loop", True), ("hull_impact", False), ("battle_2.wav", False),
    ]  # fmt: skip
    assert world.designer.get(f"/v1/projects/{world.project_id}/bed-sources").status_code == 403
