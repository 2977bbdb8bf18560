"""Answers write the delivery spec: shown as a difference, saved in one act."""

from typing import Any

import pytest

import audio_checks
from app.briefs.spec_proposal import proposal
from tests.app.briefs.test_briefs import path, save
from tests.support.server import World

PRESENT = audio_checks.parse_spec(audio_checks.new_spec("44k1")).tables


def answered(**values: Any) -> dict[str, Any]:
    return {key: {"value": value, "is_unknown": False, "note": ""} for key, value in values.items()}


def changed(**values: Any) -> dict[str, Any]:
    return {change.place: change.after for change in proposal(PRESENT, answered(**values))[1]}


TOKENS = [{"name": "what", "case": "lower", "repeats": True}, {"name": "variation", "digits": 2, "optional": True}]


@pytest.mark.parametrize(
    ("values", "wanted"),
    [
        ({"effects": {"everything": ["reverb", "doppler"]}}, {"engine.adds": ["reverb", "doppler"]}),
        (
            {"effects": {"everything": ["reverb"], "ui": [], "vehicle": ["reverb", "doppler"], "vo": ["reverb"]}},
            {
                "categories.ui.engine.adds": [],
                "categories.vehicle.engine.adds": ["reverb", "doppler"],
            },
        ),
        ({"effects": {"everything": ["reverb"]}}, {}),  # as it is
        ({"effects": {"everything": []}}, {"engine.adds": []}),
        ({"memory": 8}, {"targets.handheld.budget_bytes": 8_000_000}),
        ({"platforms": ["pc"]}, {"targets.handheld": None}),
        ({"platforms": ["pc", "handheld"]}, {}),
        (
            {"platforms": ["pc"], "memory": 64.5},  # no handheld: the first target is the smallest
            {"targets.handheld": None, "targets.game.budget_bytes": 64_500_000},
        ),
        ({"quality": "48k"}, {"accept.sample_rates_hz": [48_000, 96_000], "accept.bit_depths": [24]}),
        ({"surround": ["stereo", "5.1"]}, {"accept.channels": [1, 2, 6]}),
        ({"surround": ["stereo"]}, {}),
        ({"categories": ["ui", "weapon"]}, {}),  # the preset has them
        ({"categories": ["ui", "robot"]}, {"categories.robot": {}}),
        (
            {"naming": {"tokens": TOKENS, "separator": "_", "extension": ".wav"}},
            {"naming.pattern": None, "naming.tokens": TOKENS, "naming.separator": "_"},
        ),
        ({"genre": "A platformer", "loudness": "game"}, {}),
    ],
)
def test_what_an_answer_asks_for(values: dict[str, Any], wanted: dict[str, Any]) -> None:
    assert changed(**values) == wanted


@pytest.mark.parametrize("player", ["wwise", "fmod", "unreal", "unity", "raw"])
def test_an_engine_gets_the_target_that_suits_it(player: str) -> None:
    tables, changes = proposal(PRESENT, answered(player=player))
    assert [change.place for change in changes] == [f"targets.{player}"]
    made = audio_checks.parse_spec(audio_checks.DeliverySpec(tables=tables).to_toml())
    preset = audio_checks.TARGET_PRESETS[player]
    assert made.targets[player].sample_rate_hz == preset.sample_rate_hz
    assert proposal(tables, answered(player=player))[1] == []


def test_what_is_not_known_asks_for_nothing() -> None:
    unknown = {"effects": {"value": None, "is_unknown": True, "note": ""}}
    assert proposal(PRESENT, unknown) == (PRESENT, [])


def test_a_spec_without_targets_is_left_so() -> None:
    assert proposal({"format": 1}, answered(memory=8, platforms=["pc"]))[1] == []


def test_the_proposal_names_its_question_and_is_saved_in_one_act(world: World) -> None:
    naming = {"tokens": TOKENS, "separator": "_", "extension": ".wav"}
    save(world, 0, effects={"everything": ["doppler"]}, memory=8, naming=naming)
    shown = world.designer.get(path(world, "/spec"))
    assert shown.status_code == 200, shown.text
    proposed = shown.json()
    assert (proposed["based_on_version"], proposed["brief_revision"], proposed["errors"]) == (1, 1, [])
    first = next(change for change in proposed["changes"] if change["place"] == "engine.adds")
    assert (first["before"], first["after"], first["number"]) == (["reverb"], ["doppler"], 16)
    assert first["lines"] == ["[engine]", 'adds = ["doppler"]']
    assert audio_checks.parse_spec(proposed["toml"]).engine.adds == ("doppler",)

    made_from = {"based_on_version": 1, "brief_revision": 1}
    assert world.designer.post(path(world, "/spec"), json=made_from).status_code == 403
    assert world.reviewer.post(path(world, "/spec"), json=made_from).status_code == 403
    stale = world.producer.post(path(world, "/spec"), json={**made_from, "brief_revision": 0})
    assert stale.json()["code"] == "answer-changed"
    applied = world.producer.post(path(world, "/spec"), json=made_from)
    assert (applied.status_code, applied.json()) == (200, {"version": 2}), applied.text
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    assert spec["note"] == "From the brief: questions 16, 19, 20"
    assert spec["toml"] == proposed["toml"]
    assert [token["name"] for token in spec["resolved"]["naming"]["tokens"]] == ["what", "variation"]
    assert world.producer.get(path(world, "/spec")).json()["changes"] == []
    again = world.producer.post(path(world, "/spec"), json={**made_from, "based_on_version": 2})
    assert (again.status_code, again.json()["code"]) == (409, "nothing-proposed")


def test_a_spec_that_another_person_saved_is_not_overwritten(world: World) -> None:
    save(world, 0, effects={"everything": []})
    toml = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()["toml"] + "\n# A remark.\n"
    url = f"/v1/projects/{world.project_id}/spec"
    assert world.approver.put(url, json={"toml": toml, "based_on_version": 1}).status_code == 200
    refused = world.producer.post(path(world, "/spec"), json={"based_on_version": 1, "brief_revision": 1})
    assert (refused.status_code, refused.json()["code"]) == (409, "spec-changed")
