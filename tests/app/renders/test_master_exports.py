"""A master that is handed out says where it comes from; the master itself stays as it was delivered."""

import csv
import io
from typing import Any
from uuid import UUID

import pytest
import soundfile
from httpx2 import Client

from app.core.db import new_id
from app.renders.master_exports import jobs as export_jobs
from audio_checks import AudioFile, SandboxFailed
from tests.app.money.agreed import Agreed, milestone
from tests.app.renders.making import add_cue, deliver, deliver_sound
from tests.support.server import World
from tests.support.waves import chunk, sine, wav_bytes

TONE = sine(hz=400, dbfs=-12, rate=48_000, seconds=0.1)


def made(world: World, client: Client, take_id: str) -> dict[str, Any]:
    """Ask for a take's master with its provenance, wait for it, and return it."""
    asked = client.post(f"/v1/takes/{take_id}/master-exports")
    assert asked.status_code == 201, asked.text
    world.server.wait_for_jobs()
    export: dict[str, Any] = client.get(f"/v1/master-exports/{asked.json()['id']}").json()
    return export


@pytest.mark.slow
def test_a_master_is_handed_out_with_what_is_on_record(world: World, tmp_path: Any) -> None:
    add_cue(world, "laser", description="fires once", loop=True)
    content = wav_bytes(TONE, rate=48_000, bits=24, after=[chunk(b"xYz1", b"kept")])
    (take,) = deliver(world, ("laser.wav", content))
    world.server.wait_for_jobs()
    export = made(world, world.reviewer, take["id"])
    assert (export["state"], export["file_name"], export["left"]) == ("made", "laser.wav", [])
    project = world.producer.get(f"/v1/projects/{world.project_id}").json()
    number = f"{project['cue_prefix']}-001"
    assert export["fields"] == {
        "project": project["name"],
        "originator": take["designer"]["name"],
        "originatorStudio": project["studio"]["name"],
        "fxName": "laser",
        "orderRef": number,
        "notes": "fires once",
        "state": "in review",
        "isLoop": "true",
    }
    file = world.reviewer.get(export["file_url"])
    assert 'filename="laser.wav"' in file.headers["content-disposition"]
    copy = tmp_path / "copy.wav"
    copy.write_bytes(file.content)
    with AudioFile(copy) as sound:
        reported = sound.metadata.fields
        ours = file.content[sound.layout.data_offset :][: sound.layout.data_size]
        assert [one.id for one in sound.layout.chunks] == ["fmt ", "bext", "iXML", "data", "xYz1"]
    assert {name: reported[f"iXML.ASWG.{name}"] for name in export["fields"]} == export["fields"]
    assert (reported["bext.OriginatorReference"], reported["bext.Originator"]) == (number, take["designer"]["name"])
    assert ours in content
    assert world.reviewer.get(f"/v1/takes/{take['id']}/master").content == content


@pytest.mark.slow
def test_contract_and_state_stand_in_the_copy_and_in_the_documentation_key(world: World, tmp_path: Any) -> None:
    cue = add_cue(world, "laser")
    agreed = Agreed(world)
    agreed.agree(milestone("Alpha", UUID(cue["id"]), amount_minor=20_000))
    take_id = deliver_sound(world, "laser.wav", TONE, rate=48_000)
    world.server.wait_for_jobs()
    agreed.approve(UUID(take_id))
    contract = f"{world.producer.get(f'/v1/projects/{world.project_id}').json()['cue_prefix']} contract 1"
    export = made(world, world.reviewer, take_id)
    copy = tmp_path / "copy.wav"
    copy.write_bytes(world.producer.get(export["file_url"]).content)
    with AudioFile(copy) as sound:
        reported = sound.metadata.fields
    assert (reported["iXML.ASWG.billingCode"], reported["iXML.ASWG.state"]) == (contract, "approved")
    assert reported["bext.Description"].endswith(f"; {contract}; approved")
    key = world.producer.get(f"/v1/projects/{world.project_id}/documentation-key.csv").content.decode("utf-8-sig")
    (row,) = csv.DictReader(io.StringIO(key))
    assert (row["originator"], row["contract"], row["state"]) == (export["fields"]["originator"], contract, "approved")


@pytest.mark.slow
def test_the_same_knowledge_gives_the_same_copy_and_other_knowledge_another(world: World) -> None:
    cue = add_cue(world, "laser")
    take_id = deliver_sound(world, "laser.wav", TONE, rate=48_000)
    first = made(world, world.reviewer, take_id)
    assert made(world, world.designer, take_id) == first
    change = {"edition": cue["edition"], "description": "now with a tail"}
    revised = world.producer.patch(f"/v1/cues/{cue['id']}", json=change)
    assert revised.status_code == 200, revised.text
    second = made(world, world.reviewer, take_id)
    assert (second["id"] != first["id"], second["fields"]["notes"]) == (True, "now with a tail")
    assert world.reviewer.get(first["file_url"]).status_code == 200  # nothing is replaced


@pytest.mark.slow
def test_an_unmatched_take_says_whose_it_is(world: World) -> None:
    export = made(world, world.reviewer, deliver_sound(world, "unasked.wav", TONE, rate=48_000))
    assert set(export["fields"]) == {"project", "originator", "originatorStudio", "state"}


@pytest.mark.slow
def test_only_who_sees_the_take_gets_it(world: World) -> None:
    add_cue(world, "laser")
    export = made(world, world.designer, deliver_sound(world, "laser.wav", TONE, rate=48_000))
    for address in (f"/v1/master-exports/{export['id']}", export["file_url"]):
        assert world.designer.get(address).status_code == 200
        assert world.nobody.get(address).status_code == 401
        for client in (world.stranger, world.other_designer):
            answer = client.get(address)
            assert (answer.status_code, answer.json()["code"]) == (404, "master-export-not-found")
    assert world.stranger.post(f"/v1/takes/{export['take_id']}/master-exports").status_code == 404
    assert world.reviewer.get(f"/v1/master-exports/{new_id()}").json()["code"] == "master-export-not-found"


def test_an_unreadable_file_is_refused_with_a_reason(world: World) -> None:
    (take,) = deliver(world, ("laser.wav", b"RIFF and nothing more"))
    world.server.wait_for_jobs()
    export = made(world, world.reviewer, take["id"])
    assert (export["state"], export["file_url"]) == ("refused", None)
    assert ";" in export["refusal"]  # what was found; how to fix it
    answer = world.reviewer.get(f"/v1/master-exports/{export['id']}/file")
    assert (answer.status_code, answer.json()["code"]) == (409, "master-export-not-made")
    assert answer.json()["fix"] == "take the master as it was delivered"


@pytest.mark.slow
def test_a_copy_that_failed_is_made_when_it_is_asked_for_again(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    take_id = deliver_sound(world, "laser.wav", TONE, rate=48_000)

    def broken(*_: Any) -> Any:
        raise SandboxFailed("the child was killed")

    with monkeypatch.context() as patch:
        patch.setattr(export_jobs, "retried", broken)
        failed = made(world, world.reviewer, take_id)
    assert (failed["state"], failed["refusal"]) == ("refused", export_jobs.NO_EXPORT)
    again = made(world, world.reviewer, take_id)
    assert (again["id"], again["state"], again["refusal"]) == (failed["id"], "made", None)


@pytest.mark.slow
def test_a_flac_master_comes_as_wav(world: World) -> None:
    packed = io.BytesIO()
    soundfile.write(packed, TONE, 48_000, format="FLAC", subtype="PCM_24")
    (take,) = deliver(world, ("laser.flac", packed.getvalue()))
    world.server.wait_for_jobs()
    export = made(world, world.reviewer, take["id"])
    assert (export["state"], export["file_name"]) == ("made", "laser.wav")
    assert world.reviewer.get(export["file_url"]).content[:4] == b"RIFF"
    assert world.reviewer.get(f"/v1/takes/{take['id']}/master").content == packed.getvalue()
