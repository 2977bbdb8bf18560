"""Placeholder files for what is not accepted: to spec, by name, marked, counted down, and never in a pack unasked."""

import io
import zipfile
from pathlib import Path
from typing import Any

import pytest

import audio_checks
from tests.app.builds.approved import accepted_list, approve, sound
from tests.app.builds.test_builds import token
from tests.app.builds.test_sealed_packs import fetch, seal
from tests.support.deliver import add_cues, deliver
from tests.support.server import World

GAME = {"target": "game"}


def register(world: World) -> dict[str, Any]:
    answer = world.reviewer.get(f"/v1/projects/{world.project_id}/placeholders", params=GAME)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def make(world: World) -> None:
    asked = world.reviewer.post(f"/v1/projects/{world.project_id}/placeholders", json=GAME)
    assert asked.status_code == 202, asked.text
    world.server.wait_for_jobs()


def pack(world: World, **params: Any) -> Any:
    return world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params=GAME | params)


def named(whole: bytes) -> list[str]:
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        return [name for name in archive.namelist() if name.endswith(".wav")]


@pytest.mark.slow
def test_the_register_counts_down_as_sounds_are_accepted(world: World) -> None:
    (laser, _) = add_cues(world, {"name": "Laser fire", "variations": 2}, {"name": "Siren", "duration_s": 0.4})
    before = register(world)
    assert [(one["path"], one["state"]) for one in before["items"]] == [
        ("laser_fire_01.wav", "missing"),
        ("laser_fire_02.wav", "missing"),
        ("siren.wav", "missing"),
    ]
    make(world)
    assert [one["state"] for one in register(world)["items"]] == ["made"] * 3
    approve(world, [laser])
    after = register(world)
    assert (after["files"], after["replaced"], after["left"], after["made"]) == (3, 2, 1, 1)
    changed = world.producer.patch(f"/v1/cues/{after['items'][0]['cue_id']}", json={"duration_s": 0.7, "edition": 1})
    assert changed.status_code == 200, changed.text
    assert register(world)["items"][0]["state"] == "outdated"


def countdown(world: World) -> dict[str, Any]:
    answer = world.reviewer.get(f"/v1/projects/{world.project_id}/placeholders/countdown", params=GAME)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


@pytest.mark.slow
def test_the_countdown_says_how_much_is_left_and_what_comes_next(world: World) -> None:
    assert countdown(world) == {
        "target": "game",
        **dict.fromkeys(("cues", "cues_left", "files", "left"), 0),
        "categories": [],
        "next": None,
    }
    (_, laser, _, door) = add_cues(
        world,
        {"name": "Hum", "category": "ambience", "state": "concept"},
        {"name": "Laser fire", "category": "weapon", "variations": 2, "state": "locked"},
        {"name": "Siren", "category": "weapon", "state": "locked"},
        {"name": "Door", "category": "foley", "state": "locked"},
    )
    assert world.producer.post(f"/v1/cues/{door['id']}/cut", json={"reason": "no doors any more"}).is_success
    first = countdown(world)
    assert [first[name] for name in ("cues", "cues_left", "files", "left")] == [3, 3, 4, 4]
    assert first["next"]["path"] == "laser_fire_01.wav"  # the hum stands before it, and is a concept
    deliver(world, "laser_fire_01.wav", sound(1))
    world.server.wait_for_jobs()
    assert countdown(world)["next"]["path"] == "laser_fire_02.wav"  # one waits for its verdict
    approve(world, [laser])
    after = countdown(world)
    assert [after[name] for name in ("cues_left", "files", "left")] == [2, 4, 2]
    assert {"category": "weapon", "files": 3, "left": 1} in after["categories"]
    assert after["next"]["path"] == "siren.wav"


@pytest.mark.slow
def test_placeholders_are_packed_only_on_request_and_marked(world: World, tmp_path: Path) -> None:
    accepted_list(world)  # two cues accepted, "Warp in" is not
    make(world)
    assert named(pack(world).content) == ["laser_fire_01.wav", "laser_fire_02.wav", "ui_confirm.wav"]
    whole = pack(world, placeholders=True)
    assert named(whole.content)[-1] == "warp_in.wav"
    with zipfile.ZipFile(io.BytesIO(whole.content)) as archive:
        archive.extractall(tmp_path)
        assert "PLACEHOLDER" in archive.read("documentation-key.csv").decode("utf-8-sig")
    assert audio_checks.is_placeholder(tmp_path / "warp_in.wav")
    # The game's CI judges it by the target: to spec in everything, and refused all the same, in words.
    spec = audio_checks.parse_spec(world.producer.get(f"/v1/projects/{world.project_id}/spec.toml").text)
    (entry,) = audio_checks.check_files([tmp_path / "warp_in.wav"], spec, target="game").files
    errors = [finding for finding in entry.findings if finding.severity == "error"]
    assert [finding.code for finding in errors] == ["placeholder:marked"]
    assert "SW-003" in errors[0].message
    sealed = seal(world, placeholders=True)
    with fetch(world, sealed) as archive:
        assert "warp_in.wav" in archive.namelist()
    assert (sealed["files"], sealed["placeholder_files"], sealed["placeholders"]) == (3, 1, True)


@pytest.mark.slow
def test_an_accepted_placeholder_does_not_ship_unnoticed(world: World) -> None:
    add_cues(world, {"name": "Siren"})
    make(world)
    # A placeholder file of ours, taken for the sound: delivered, let be, approved.
    placeholder_file = zipfile.ZipFile(io.BytesIO(pack(world, placeholders=True).content)).read("siren.wav")
    take = deliver(world, "siren.wav", placeholder_file)
    world.server.wait_for_jobs()
    assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
    world.server.wait_for_jobs()
    refused = pack(world)
    assert (refused.status_code, refused.json()["code"]) == (409, "placeholder-accepted")
    assert "siren.wav" in refused.json()["detail"]
    assert pack(world, placeholders=True).status_code == 200
    sealed = world.reviewer.post(f"/v1/projects/{world.project_id}/packs", json=GAME)
    assert (sealed.status_code, sealed.json()["code"]) == (409, "placeholder-accepted")


@pytest.mark.slow
def test_nothing_is_left_of_a_cut_cue(world: World) -> None:
    (siren,) = add_cues(world, {"name": "Siren"})
    cut = world.approver.post(f"/v1/cues/{siren['id']}/cut", json={"reason": "no longer needed"})
    assert cut.status_code in (200, 204), cut.text
    assert register(world)["left"] == 0


@pytest.mark.parametrize(("who", "status"), [("designer", 403), ("stranger", 404), ("nobody", 401)])
def test_who_may_not(world: World, who: str, status: int) -> None:
    client = getattr(world, who)
    for path in ("placeholders", "targets"):
        assert client.get(f"/v1/projects/{world.project_id}/{path}").status_code == status
    assert client.post(f"/v1/projects/{world.project_id}/placeholders", json=GAME).status_code == status


def test_a_build_reads_the_register_by_its_token(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/placeholders"
    assert token(world, "manifest:read").get(url, params=GAME).status_code == 200
    assert token(world, "list:read").get(url, params=GAME).status_code == 403
