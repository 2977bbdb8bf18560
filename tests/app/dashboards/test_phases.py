"""Phases of a production: a gate says what is missing and who must act, and the palette opens the next as a set."""

from typing import Any

import pytest

from app.dashboards.phases.rules import PhaseAct, PhaseCount, act_for, open_phases
from app.dashboards.rules import CueStatus
from app.sound_lists.rules import Phase
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import sine, wav_bytes


def tone(hz: float) -> bytes:
    return wav_bytes(sine(hz=hz, dbfs=-6.0, seconds=0.1))


def phases(world: World) -> dict[str, Any]:
    answer = world.approver.get(f"/v1/projects/{world.project_id}/phases")
    assert answer.status_code == 200, answer.text
    read: dict[str, Any] = answer.json()
    return read


def approve(world: World, take: dict[str, Any]) -> None:
    world.server.wait_for_jobs()
    answer = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"})
    assert answer.status_code in (200, 201), answer.text


def approve_palette(world: World) -> Any:
    return world.approver.post(f"/v1/projects/{world.project_id}/palette-approval")


@pytest.mark.slow
def test_the_palette_is_approved_as_a_set_and_opens_the_next_phase(world: World) -> None:
    add_cues(
        world,
        {"name": "Laser fire", "palette": True},
        {"name": "Shield hit", "phase": "palette"},
        {"name": "Door", "phase": "beta"},
    )
    take = deliver(world, "laser_fire.wav", tone(440))
    other = deliver(world, "shield_hit.wav", tone(550))
    world.server.wait_for_jobs()
    read = phases(world)
    palette, beta = read["phases"]
    assert (palette["phase"], palette["cues"], palette["accepted"], palette["is_open"]) == ("palette", 2, 0, True)
    assert palette["awaited"] == [{"who": "Audio director", "act": "review", "count": 2}]
    assert (beta["is_open"], len(read["closed_cue_ids"])) == (False, 1)
    refused = approve_palette(world)
    assert (refused.status_code, refused.json()["code"]) == (409, "palette-incomplete")
    assert "SW-001" in refused.json()["detail"]
    approve(world, take)
    approve(world, other)
    read = phases(world)
    assert read["phases"][0]["awaited"] == [{"who": "Audio director", "act": "approve_palette", "count": 1}]
    assert (read["may_approve_palette"], read["phases"][1]["is_open"]) == (True, False)
    assert world.designer.post(f"/v1/projects/{world.project_id}/palette-approval").status_code == 403
    assert approve_palette(world).status_code == 201
    read = phases(world)
    assert read["palette_approval"]["approver"]["name"] == "Audio director"
    assert (read["phases"][0]["is_done"], read["phases"][1]["is_open"], read["closed_cue_ids"]) == (True, True, [])
    add_cues(world, {"name": "Warp", "palette": True})
    assert phases(world)["palette_approval"] is None, "another set than the one that was approved"


def test_a_list_without_phases_has_none(world: World) -> None:
    add_cues(world, {"name": "Laser fire", "palette": True})
    assert phases(world)["phases"] == []


def test_a_gate_opens_once_all_before_it_is_done() -> None:
    alpha, beta, gold = PhaseCount(Phase.ALPHA, 2, 2), PhaseCount(Phase.BETA, 2, 1), PhaseCount(Phase.GOLD, 2, 0)
    assert open_phases([alpha, beta, gold]) == {Phase.ALPHA, Phase.BETA}
    assert open_phases([PhaseCount(Phase.PALETTE, 2, 2, waits_for_approval=True), alpha]) == {Phase.PALETTE}


def test_who_must_act_follows_from_the_state() -> None:
    assert act_for(CueStatus.TO_REVIEW) is PhaseAct.REVIEW
    assert act_for(CueStatus.RETURNED) is act_for(CueStatus.TO_MAKE) is PhaseAct.DELIVER
    assert act_for(CueStatus.ACCEPTED) is None
