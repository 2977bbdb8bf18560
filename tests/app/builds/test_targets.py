"""Targets and what they take in memory: the accepted sounds as they are, the rest as the list asks for them."""

from typing import Any

import pytest

from tests.app.builds.approved import approve
from tests.support.deliver import add_cues
from tests.support.server import World

SECOND_16_BIT_MONO = 2 * 44_100


def targets(world: World) -> dict[str, dict[str, Any]]:
    answer = world.reviewer.get(f"/v1/projects/{world.project_id}/targets")
    assert answer.status_code == 200, answer.text
    return {one["name"]: one for one in answer.json()["targets"]}


def budget(world: World, lines: str) -> None:
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = spec["toml"] + f"\n[targets.tiny]\nsample_rate_hz = 44100\nbit_depth = 16\n{lines}\n"
    body = {"toml": toml, "based_on_version": spec["version"]}
    saved = world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body)
    assert saved.status_code == 200, saved.text


@pytest.mark.slow
def test_what_is_there_is_counted_and_the_rest_forecast(world: World) -> None:
    (laser, *_) = add_cues(
        world,
        {"name": "Laser fire", "variations": 2, "category": "weapon", "duration_s": 0.25},
        {"name": "Hum", "category": "ambience", "duration_s": 10.0},
        {"name": "Nobody knows", "category": "ambience"},
    )
    approve(world, [laser])
    budget(world, "budget_bytes = 1000000\ncodec_ratio = 4\nchannels = 1")
    world.server.wait_for_jobs()
    game = targets(world)["tiny"]
    laser_bytes = 2 * -(-2 * 11_025 // 4)
    assert (
        game["used"]["total"]["memory_bytes"] == laser_bytes
    )  # two files of a quarter of a second, four times smaller
    assert game["used"]["total"]["over_bytes"] == laser_bytes - 1_000_000
    forecast = {one["category"]: one for one in game["forecast"]["categories"]}
    assert forecast["weapon"]["memory_bytes"] == laser_bytes
    assert forecast["ambience"]["memory_bytes"] == 10 * SECOND_16_BIT_MONO // 4
    assert (forecast["ambience"]["files"], forecast["ambience"]["unknown_files"]) == (1, 1)
    assert game["forecast"]["total"]["pcm_bytes"] == 2 * 2 * 11_025 + 10 * SECOND_16_BIT_MONO


@pytest.mark.slow
def test_what_is_streamed_takes_its_buffer_alone(world: World) -> None:
    add_cues(world, {"name": "Hum", "duration_s": 10.0})
    budget(world, "streamed = true\nstream_buffer_bytes = 4096\nbudget_bytes = 4000")
    total = targets(world)["tiny"]["forecast"]["total"]
    assert (total["memory_bytes"], total["over_bytes"]) == (4096, 96)


def test_presets_say_what_each_engine_takes(world: World) -> None:
    presets = world.reviewer.get(f"/v1/projects/{world.project_id}/targets").json()["presets"]
    assert {preset["engine"] for preset in presets} >= {"Wwise", "FMOD Studio", "Unreal Engine", "Unity"}
    assert all(preset["toml"].startswith(f"[targets.{preset['name']}]") and preset["accepts"] for preset in presets)
