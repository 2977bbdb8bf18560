"""Notes at moments of a screen recording: sent with their time, kept beside others, and linked from their tasks."""

from pathlib import Path
from typing import Any

import pytest

from app.core.db import new_id
from tests.app.builds.audited import approved_pack, audited, posted
from tests.app.builds.test_listening import cue_named, say, seen, started, tasks
from tests.support.references import added
from tests.support.server import World

pytestmark = pytest.mark.slow

MP4 = b"\0\0\0\x18ftypisom\0\0\2\0isomiso2" + bytes(200)


@pytest.fixture
def listening(world: World, tmp_path: Path) -> dict[str, Any]:
    posted(world, audited(world, tmp_path, approved_pack(world), laser_fire=6.0), "482")
    return started(world)


@pytest.fixture
def recording(world: World) -> str:
    """A recording of the game on the board; the id of its version."""
    return str(added(world, "playthrough.mp4", MP4)["version"]["id"])


def at(recording: str, at_s: float) -> dict[str, Any]:
    return {"recording": {"reference_version_id": recording, "at_s": at_s}}


def test_a_note_at_a_moment_becomes_a_task_that_leads_to_it(
    world: World, listening: dict[str, Any], recording: str
) -> None:
    said = say(world, listening, "Laser fire", "too-loud", amount_db=-6.0, **at(recording, 83.4))
    assert said.status_code == 201, said.text
    moment = {"reference_version_id": recording, "at_s": 83.4}
    assert said.json()["recording"] == moment
    (task,) = tasks(world)
    assert (task["kind"], task["role"], task["gain_db"], task["recording"]) == (
        "too-loud", "implementer", -6.0, moment,
    )  # fmt: skip
    (note,) = seen(world)["notes"]
    assert note["recording"] == moment
    assert say(world, listening, "UI confirm", "too-long").json()["recording"] is None


def test_a_cue_has_a_note_for_each_moment_and_one_beside_them(
    world: World, listening: dict[str, Any], recording: str
) -> None:
    for at_s in (3.0, 9.5):
        assert say(world, listening, "Laser fire", "too-loud", **at(recording, at_s)).status_code == 201
    for said in ("wrong", "too-soft"):
        assert say(world, listening, "Laser fire", said).status_code == 201
    found = [(one["said"], one["recording"] and one["recording"]["at_s"]) for one in seen(world)["notes"]]
    assert sorted(found, key=str) == [("too-loud", 3.0), ("too-loud", 9.5), ("too-soft", None)]
    assert len(tasks(world)) == 3


def test_a_note_that_is_sent_again_counts_once(world: World, listening: dict[str, Any], recording: str) -> None:
    body = {"note_id": str(new_id()), **at(recording, 2.0)}
    first, again = (say(world, listening, "Laser fire", "wrong", **body) for _ in range(2))
    assert first.json() == again.json()
    assert len(tasks(world)) == 1


def test_what_is_no_recording_of_this_project_is_refused(
    world: World, listening: dict[str, Any], recording: str
) -> None:
    text = str(added(world, "read me.txt", b"plain words")["version"]["id"])
    refused = say(world, listening, "Laser fire", "wrong", **at(text, 1.0))
    assert (refused.status_code, refused.json()["code"]) == (422, "listening-note-invalid")
    assert "name a clip or a sound" in refused.json()["detail"]
    assert say(world, listening, "Laser fire", "wrong", **at(str(new_id()), 1.0)).status_code == 404
    assert say(world, listening, "Laser fire", "wrong", **at(recording, -1.0)).status_code == 422
    assert say(world, listening, "Laser fire", "wrong", by=world.stranger, **at(recording, 1.0)).status_code == 404
    assert (seen(world)["notes"], tasks(world)) == ([], [])
    assert cue_named(listening, "Laser fire")


def test_a_designer_notes_a_moment_of_their_own_cue_and_sees_its_task(
    world: World, listening: dict[str, Any], recording: str
) -> None:
    assert say(world, listening, "UI confirm", "too-long", by=world.designer, **at(recording, 4.0)).status_code == 201
    (own,) = tasks(world, world.designer)
    assert own["recording"] == {"reference_version_id": recording, "at_s": 4.0}
