"""`soundlist why`: what the lock file knows, what the server adds, and what is said to be known online only."""

import json
from pathlib import Path

import pytest

from tests.app.builds.approved import accepted_list, sound
from tests.app.client.served import PATHS, Client, client_of
from tests.support.deliver import deliver
from tests.support.server import World

NOWHERE = "http://127.0.0.1:9"  # the discard port, where nothing listens


def rows(text: str) -> dict[str, str]:
    return {line[2:26].strip(): line[26:] for line in text.splitlines() if line.startswith("  ")}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ui_confirm", "ui_confirm.wav", "SW-002"])
def test_a_name_leads_to_cue_approver_contract_and_spec(client: Client, game: Path, name: str) -> None:
    client.pull(game)
    assert client.why(name, "--folder", str(game)) == 0, client.err
    assert client.out.splitlines()[0] == "ui_confirm.wav"
    said = rows(client.out)
    assert (said["cue"], said["target"], said["approved by"]) == ("SW-002 UI confirm", "game", "Audio director")
    assert said["contract"] == "no contract in Soundlist"
    assert (said["delivery spec"], said["accepted now"], said["in this folder"]) == ("1", "yes", "as it was pulled")
    assert "sources" in said["open points"] or said["open points"]
    assert "known online only" not in said


@pytest.mark.slow
def test_a_path_below_the_lock_file_is_enough(client: Client, game: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    client.line.change_listing = lambda said: said["files"][0].update(path="Audio/weapon/laser.wav")
    client.pull(game)
    monkeypatch.chdir(game / "Audio")
    assert client.why("weapon/laser.wav") == 0, client.err
    assert client.out.splitlines()[0] == "Audio/weapon/laser.wav"
    (game / "Audio/weapon/laser.wav").write_bytes(b"louder")
    client.why("weapon/laser.wav", "--offline")
    assert rows(client.out)["in this folder"] == "changed since it was pulled"


@pytest.mark.slow
def test_offline_the_lock_file_is_asked_alone(client: Client, game: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    client.pull(game)
    asked = len(client.line.asked)
    assert client.why("ui_confirm", "--folder", str(game), "--offline") == 0
    said = rows(client.out)
    assert (said["cue"], said["target"]) == ("SW-002", "game")
    assert said["known online only"].startswith("cue, approved by, approved on, contract, designer, libraries")
    assert len(client.line.asked) == asked
    client.source[1] = NOWHERE
    assert client.why("ui_confirm", "--folder", str(game)) == 3
    assert rows(client.out) == said
    assert "the server cannot be reached" in client.err
    assert client.why("laser_fire_03", "--folder", str(game)) == 3
    monkeypatch.delenv("SOUNDLIST_TOKEN")
    assert client.why("ui_confirm", "--folder", str(game)) == 3
    assert "SOUNDLIST_TOKEN is not set" in client.err


@pytest.mark.slow
def test_programs_read_it_as_json(client: Client, game: Path) -> None:
    client.pull(game)
    assert client.why("SW-001", "--folder", str(game), "--format", "json") == 0
    said = json.loads(client.out)
    assert (said["format_version"], said["problem"]) == (1, None)
    assert [one["path"] for one in said["files"]] == PATHS[:2]
    assert {one["approved_by"] for one in said["files"]} == {"Audio director"}
    assert [one["only_online"] for one in said["files"]] == [[], []]
    client.why("SW-001", "--folder", str(game), "--format", "json", "--offline")
    said = json.loads(client.out)
    assert "contract" in said["files"][0]["only_online"]
    assert said["files"][0]["in_folder"] is True


@pytest.mark.slow
def test_without_a_lock_file_the_server_is_asked_by_name(client: Client, game: Path) -> None:
    assert client.why("laser_fire_02", "--folder", str(game)) == 0
    assert rows(client.out)["cue"] == "SW-001 Laser fire"
    assert client.why("nothing_like_it", "--folder", str(game)) == 2
    assert 'no approved file is called "nothing_like_it"' in client.err


@pytest.mark.slow
def test_a_version_that_was_replaced_is_said_to_be(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path
) -> None:
    accepted_list(world)
    with client_of(world, monkeypatch, capsys) as client:
        client.pull(game)
        take = deliver(world, "ui_confirm.wav", sound(77))
        world.server.wait_for_jobs()
        assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
        assert client.why("ui_confirm", "--folder", str(game)) == 0
        assert rows(client.out)["accepted now"] == "no"


def test_a_token_for_ci_does_not_read_contracts(
    client: Client, game: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with client_of(client.world, monkeypatch, capsys, "manifest:read") as other:
        assert other.pull(game) == 0
        assert other.why("ui_confirm", "--folder", str(game)) == 3
        assert rows(other.out)["cue"] == "SW-002"
        assert "this token lacks the scope rights:read" in other.err
