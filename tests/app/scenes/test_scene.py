"""The scene of a version: who is in it, when and how loud, and which bands are heard."""

import numpy as np
import pytest

from app.core import clock
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.rules import DesignersHear
from tests.app.reviews.making import Stage
from tests.app.scenes.making import add_audit, approved, drawn_take, masking, opened_scene
from tests.support.references import added
from tests.support.server import World
from tests.support.waves import noise, silence, sine

WEBM = b"\x1a\x45\xdf\xa3" + b"\x00" * 20 + b"webm" + b"\x00" * 60


def waiting(stage: Stage, samples: np.ndarray | None = None, **facts: object):
    cue_id = stage.cue("suit_hit", **facts)
    return drawn_take(stage, cue_id, noise(dbfs=-20.0, seconds=0.5) if samples is None else samples)


def lanes_of(scene: dict) -> dict[str, dict]:
    return {lane["name"]: lane for lane in scene["lanes"]}


@pytest.mark.slow
def test_a_version_plays_among_the_approved_sounds_of_its_scene(world: World, stage: Stage):
    take_id = waiting(stage, category="impacts", extra={"Scene": "Boarding"})
    approved(stage, "laser_fire", category="weapons", extra={"Scene": "Boarding"}, variations=3)
    approved(stage, "engine_idle_loop", category="ships", extra={"Scene": "Boarding"}, loop=True)
    approved(stage, "hull_impact", category="impacts")
    waiting_beside = stage.cue("not_approved", category="impacts")
    drawn_take(stage, waiting_beside, noise(seconds=0.1))
    approved(stage, "cut_sound", category="impacts", state="cut", cut_at=clock.now())
    scene = opened_scene(world, take_id, settled=False)
    assert [lane["name"] for lane in scene["lanes"]] == ["suit_hit", "engine_idle_loop", "laser_fire", "hull_impact"]
    assert scene["lanes"][0]["id"] == "sound"
    assert [lane["loops"] for lane in scene["lanes"]] == [False, True, False, False]
    assert (scene["length_s"], scene["has_spots"], scene["audit_label"]) == (8.0, False, None)
    assert {lane["level_from"] for lane in scene["lanes"]} == {"approved"}
    assert scene["is_ready"] is False
    assert opened_scene(world, take_id)["is_ready"] is True


def test_the_list_says_when_a_sound_plays(world: World, stage: Stage):
    take_id = waiting(stage, extra={"Spots": "1.5, 3.05, 9.5"})
    approved(stage, "laser_fire", extra={"spots": "0.8 3"})
    approved(stage, "hull_impact")
    lanes = lanes_of(scene := opened_scene(world, take_id, settled=False))
    assert scene["has_spots"] is True
    assert scene["length_s"] == 11.0
    assert lanes["suit_hit"]["starts_s"] == [1.5, 3.05, 9.5]
    assert lanes["laser_fire"]["starts_s"] == [0.8, 3.0]
    assert lanes["hull_impact"]["starts_s"] == [1.5]  # without times it plays with the version


def test_levels_are_those_of_the_newest_audit(world: World, stage: Stage):
    take_id = waiting(stage)
    laser, _ = approved(stage, "laser_fire")
    approved(stage, "hull_impact")
    add_audit(world, {laser: 3.0}, label="Build 480")
    add_audit(world, {laser: -6.04})
    lanes = lanes_of(scene := opened_scene(world, take_id, settled=False))
    assert scene["audit_label"] == "Build 481"
    assert (lanes["laser_fire"]["level_db"], lanes["laser_fire"]["level_from"]) == (-6.0, "audit")
    assert (lanes["hull_impact"]["level_db"], lanes["hull_impact"]["level_from"]) == (0.0, "approved")


@pytest.mark.slow
def test_a_louder_level_in_the_game_covers_more(world: World, stage: Stage):
    take_id = waiting(stage)
    engine, _ = approved(stage, "engine", noise(dbfs=-20.0, seconds=1.0, seed=5), loop=True)
    opened_scene(world, take_id)
    equal = masking(world, take_id)
    assert (equal["part_bands"], equal["heard_bands"]) == (37, 37)  # equal sounds stand 3 dB over the threshold
    add_audit(world, {engine: 12.0})
    covered = masking(world, take_id)
    assert covered["heard_bands"] == 0
    assert covered["in_words"].startswith("Covered in all bands. Covered by engine: 50 Hz–13.4 kHz.")
    assert {band["covered_by"] for band in covered["bands"]} == {str(engine)}
    margins = [
        one["margin_db"] - other["margin_db"] for one, other in zip(equal["bands"], covered["bands"], strict=True)
    ]
    assert margins == pytest.approx([12.0] * 37, abs=0.3)


@pytest.mark.slow
def test_lanes_can_be_left_out_and_be_heard_at_another_level(world: World, stage: Stage):
    take_id = waiting(stage, sine(hz=1_000, dbfs=-30.0, seconds=0.5))
    engine, _ = approved(stage, "engine", noise(dbfs=-20.0, seconds=1.0), loop=True)
    opened_scene(world, take_id)
    alone = masking(world, take_id, sound=0)
    assert (alone["is_compared"], alone["bands"], alone["heard_bands"]) == (False, [], 0)
    assert alone["in_words"] == "Not known: the other sounds of the scene are off. Switch one on."
    shares = [masking(world, take_id, **{str(engine): level})["energy_share"] for level in (-40.0, 12.0)]
    assert shares == [1.0, 0.0]
    assert masking(world, take_id, **{str(engine): 12.0, "sound": 12.0})["energy_share"] > 0.9


@pytest.mark.parametrize("lane", ["music:-12", "nobody:0", "sound:99", "sound:1e9", "sound", "sound:", ":3"])
def test_lanes_that_are_not_there_are_refused(world: World, stage: Stage, lane: str):
    take_id = waiting(stage)
    answer = world.reviewer.get(f"/v1/takes/{take_id}/masking", params={"lane": lane})
    assert answer.status_code == 422, answer.text


def test_before_all_is_measured_no_figure_is_given(world: World, stage: Stage):
    take_id = waiting(stage)
    approved(stage, "engine")
    assert masking(world, take_id) == {
        "is_measured": False, "is_compared": True,
        "missing": "The scene has no bed: music and ambience are not counted.",
        "bands": [], "part_bands": 0, "heard_bands": 0, "energy_share": 0.0, "time_share": 0.0,
        "in_words": "",
    }  # fmt: skip


def test_a_sound_alone_is_not_said_to_be_heard(world: World, stage: Stage):
    take_id = waiting(stage)
    opened_scene(world, take_id)
    alone = masking(world, take_id)
    assert (alone["is_compared"], alone["part_bands"], alone["heard_bands"]) == (False, 0, 0)
    assert alone["in_words"].startswith("Not known yet: the scene has no bed and no neighbours.")


@pytest.mark.slow
def test_silence_among_others_has_no_bands(world: World, stage: Stage):
    take_id = waiting(stage, silence(seconds=0.5))
    approved(stage, "engine")
    opened_scene(world, take_id)
    found = masking(world, take_id)
    assert (found["part_bands"], found["energy_share"]) == (0, 0.0)
    assert found["in_words"] == "The sound is silent. The scene has no bed: music and ambience are not counted."


@pytest.mark.slow
def test_a_clip_gives_the_scene_its_length_and_the_nearest_pin_comes_first(world: World, stage: Stage):
    take_id = waiting(stage, category="impacts")
    scene = opened_scene(world, take_id, settled=False)
    added(world, "game.webm", WEBM, caption="The whole game", start_s=10, end_s=20)
    added(world, "boarding.webm", WEBM, caption="Boarding", cue_id=scene["cue_id"], start_s=2.0, end_s=7.5)
    added(world, "impacts.webm", WEBM, caption="Impacts", category="impacts")
    scene = opened_scene(world, take_id, settled=False)
    assert [clip["caption"] for clip in scene["clips"]] == ["Boarding", "Impacts", "The whole game"]
    assert scene["length_s"] == 5.5
    assert (scene["clips"][0]["start_s"], scene["clips"][0]["end_s"]) == (2.0, 7.5)
    assert scene["clips"][0]["media_type"] == "video/webm"


@pytest.mark.slow
def test_the_team_and_its_designer_open_a_scene(world: World, stage: Stage):
    take_id = waiting(stage)
    for path, method in ((f"/v1/takes/{take_id}/scene", "POST"), (f"/v1/takes/{take_id}/masking", "GET")):
        assert world.designer.request(method, path).status_code == 200
        assert world.stranger.request(method, path).status_code == 404
        assert world.other_designer.request(method, path).status_code == 404
        assert world.nobody.request(method, path).status_code == 401


@pytest.mark.slow
@pytest.mark.parametrize(("choice", "names"), [
    (DesignersHear.OWN, ["suit_hit", "own_hit"]), (DesignersHear.APPROVED, ["suit_hit", "own_hit", "rivals_hit"]),
])  # fmt: skip
def test_a_designer_hears_others_in_the_scene_as_the_project_allows(
    world: World, stage: Stage, choice: DesignersHear, names: list[str]
):
    take_id = waiting(stage)
    approved(stage, "own_hit")
    _, rivals = approved(stage, "rivals_hit")
    bed = {"role": "music", "category": "", "take_id": str(rivals), "level_db": -6.0}
    assert world.approver.put(f"/v1/projects/{world.project_id}/beds", json=bed).status_code == 200

    def given_to_another(session) -> None:
        session.get_one(Take, rivals).designer_id = world.other_designer_id
        session.get_one(Project, world.project_id).designers_hear = choice

    world.server.in_database(given_to_another)
    scene = world.designer.post(f"/v1/takes/{take_id}/scene").json()
    assert [lane["name"] for lane in scene["lanes"] if lane["bed"] is None] == names
    assert [lane["name"] for lane in scene["lanes"] if lane["bed"]] == names[2:]
    assert scene["may_change"] is False
    everything = world.reviewer.post(f"/v1/takes/{take_id}/scene").json()
    assert len(everything["lanes"]) == 4


def test_a_version_for_no_cue_has_no_scene(world: World, stage: Stage):
    take_id = drawn_take(stage, None, noise(seconds=0.1), state=TakeState.RECEIVED)
    assert world.reviewer.post(f"/v1/takes/{take_id}/scene").status_code == 404


@pytest.mark.slow
def test_each_sound_is_measured_once(world: World, stage: Stage):
    take_id = waiting(stage)
    for _ in range(3):
        opened_scene(world, take_id, settled=False)
    assert opened_scene(world, take_id)["is_ready"] is True
    with world.server.counted_selects() as selects:
        opened_scene(world, take_id, settled=False)
    assert len(selects) < 30
