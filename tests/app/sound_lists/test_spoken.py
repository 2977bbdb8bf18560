"""Placeholders that a person says: recorded for a cue, heard, in the placeholder files of every target, removed."""

import base64
import io
import zipfile

import numpy as np
import pytest
from httpx import Response
from httpx2 import Client

from app.builds.packs.placeholders import Slot, keep, open_slots
from app.builds.packs.service import pack_of
from app.core.web import response_headers
from app.projects.models import Project
from audio_checks.placeholders.recorded import read_recording
from tests.support.deliver import add_cues
from tests.support.server import World
from tests.support.waves import silence, sine, wav_bytes

WORD = wav_bytes(np.concatenate([silence(seconds=0.5), sine(hz=500, dbfs=-20, seconds=0.4)]), rate=48_000, bits=16)


def say(world: World, cue_id: str, content: bytes = WORD, by: Client | None = None) -> Response:
    body = {"content_base64": base64.b64encode(content).decode()}
    return (by or world.producer).put(f"/v1/cues/{cue_id}/spoken-placeholder", json=body)


@pytest.fixture
def cue_id(world: World) -> str:
    return str(add_cues(world, {"name": "Bonk"})[0]["id"])


def placeholders(world: World) -> list[dict[str, object]]:
    world.server.wait_for_jobs()
    answer = world.producer.get(f"/v1/projects/{world.project_id}/placeholders", params={"target": "game"})
    assert answer.status_code == 200, answer.text
    return list(answer.json()["items"])


@pytest.mark.slow
def test_a_word_is_trimmed_kept_and_heard_by_all_of_the_project(world: World, cue_id: str) -> None:
    assert world.producer.get(f"/v1/cues/{cue_id}/spoken-placeholder").json() is None
    made = say(world, cue_id)
    assert made.status_code == 200, made.text
    said = made.json()
    assert said["recorded_by"]["name"] == "Producer"
    assert said["duration_s"] == pytest.approx(0.42, abs=0.01)
    for client in (world.designer, world.reviewer):
        assert client.get(f"/v1/cues/{cue_id}/spoken-placeholder").json() == said
        heard = client.get(f"/v1/cues/{cue_id}/spoken-placeholder/file")
        assert (heard.status_code, heard.headers["content-type"]) == (200, "audio/wav")
        assert len(read_recording(heard.content, 48_000)) == round(said["duration_s"] * 48_000)


@pytest.mark.slow
def test_the_placeholder_files_say_it_and_are_packed(world: World, cue_id: str) -> None:
    [before] = placeholders(world)
    assert before["state"] == "missing"
    say(world, cue_id)
    [made] = placeholders(world)
    assert (made["state"], made["spoken"]) == ("made", True)
    asked = {"target": "game", "placeholders": True}
    packed = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params=asked)
    assert packed.status_code == 200, packed.text
    with zipfile.ZipFile(io.BytesIO(packed.content)) as archive:
        names = [name for name in archive.namelist() if name.endswith("bonk.wav")]
        sound = read_recording(archive.read(names[0]), 48_000)
    assert np.argmax(np.abs(np.fft.rfft(sound[:19_200]))) / 0.4 == pytest.approx(500, abs=3)


@pytest.mark.slow
def test_it_is_replaced_and_removed_and_the_files_follow(world: World, cue_id: str) -> None:
    first = say(world, cue_id).json()
    second = say(world, cue_id, wav_bytes(sine(hz=900, seconds=0.3), rate=44_100, bits=24), world.approver).json()
    assert second["sha256"] != first["sha256"]
    assert second["recorded_by"]["name"] == "Audio director"
    assert [placeholder["state"] for placeholder in placeholders(world)] == ["made"]
    assert world.producer.delete(f"/v1/cues/{cue_id}/spoken-placeholder").status_code == 204
    assert world.producer.get(f"/v1/cues/{cue_id}/spoken-placeholder").json() is None
    assert world.producer.delete(f"/v1/cues/{cue_id}/spoken-placeholder").json()["code"] == "spoken-placeholder-missing"
    [remade] = placeholders(world)
    assert remade["state"] == "made"


@pytest.mark.slow
def test_a_file_of_what_was_said_before_does_not_replace_that_of_what_is_said_now(world: World, cue_id: str) -> None:
    def slot_now() -> tuple[Project, Slot]:
        with world.server.runtime.database.reading() as session:
            project = session.get_one(Project, world.project_id)
            (slot,) = (
                one for one in open_slots(session, pack_of(session, project, "game")) if str(one.cue.id) == cue_id
            )
            return project, slot

    say(world, cue_id)
    project, before = slot_now()
    say(world, cue_id, wav_bytes(sine(hz=900, seconds=0.3), rate=44_100, bits=24))
    assert [placeholder["state"] for placeholder in placeholders(world)] == ["made"]
    with world.server.runtime.database.writing() as session:
        keep(session, project, "game", before, None, is_spoken=True, refusal="too late")
    assert [placeholder["state"] for placeholder in placeholders(world)] == ["made"]


@pytest.mark.parametrize(
    "content", [b"", b"RIFF\x04\0\0\0WAVE", bytes(5_000), wav_bytes(silence(seconds=1), rate=48_000, bits=16)]
)
def test_what_is_no_word_is_refused_with_how_to_fix_it(world: World, cue_id: str, content: bytes) -> None:
    refused = say(world, cue_id, content)
    assert (refused.status_code, refused.json()["code"]) == (422, "recording-invalid")
    assert refused.json()["fix"]
    assert world.producer.get(f"/v1/cues/{cue_id}/spoken-placeholder").json() is None


def test_the_team_speaks_and_a_cut_cue_needs_no_placeholder(world: World, cue_id: str) -> None:
    for client in (world.reviewer, world.designer):
        assert say(world, cue_id, by=client).status_code == 403
    assert say(world, cue_id, by=world.stranger).status_code == 404
    assert world.stranger.get(f"/v1/cues/{cue_id}/spoken-placeholder/file").status_code == 404
    world.approver.post(f"/v1/cues/{cue_id}/cut", json={"reason": "the scene is gone"})
    assert say(world, cue_id).json()["code"] == "cue-is-cut"


def test_a_page_may_use_the_microphone_and_no_other_site_may() -> None:
    headers = response_headers.security_headers(None, is_https=False)
    assert "microphone=(self)" in headers["Permissions-Policy"].split(", ")
    assert "camera=()" in headers["Permissions-Policy"].split(", ")
