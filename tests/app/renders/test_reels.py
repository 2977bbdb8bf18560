"""All takes of a cue in a row, made by the real worker, for people who see all of them."""

import hashlib
import io
import wave
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from httpx2 import Client

from app.core.db import new_id
from app.deliveries.models import Take
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from app.renders.models import Picture
from app.renders.reels import jobs as reel_jobs
from app.renders.reels import service as reels
from audio_checks import SandboxFailed
from tests.app.renders.making import add_cue, deliver, deliver_sound
from tests.support.server import World
from tests.support.waves import sine, wav_bytes


@pytest.fixture(autouse=True)
def _without_speech(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reel_jobs, "synthesize_speech", lambda *_: None)


def tone(hz: int, seconds: float = 0.2) -> Any:
    return sine(hz=hz, dbfs=-12, rate=48_000, seconds=seconds)


def two_takes(world: World) -> tuple[str, list[str]]:
    """Put a cue with two takes on record; return both."""
    cue = add_cue(world, "laser")
    takes = [deliver_sound(world, "laser.wav", tone(hz), rate=48_000, bits=16) for hz in (400, 500)]
    return cue["id"], takes


def ask(client: Client, cue_id: str, **how: Any) -> dict[str, Any]:
    answer = client.post(f"/v1/cues/{cue_id}/reels", json=how)
    assert answer.status_code == 201, answer.text
    found: dict[str, Any] = answer.json()
    return found


def made(world: World, client: Client, cue_id: str, **how: Any) -> dict[str, Any]:
    asked = ask(client, cue_id, **how)
    world.server.wait_for_jobs()
    reel: dict[str, Any] = client.get(f"/v1/reels/{asked['id']}").json()
    assert reel["state"] == "made", reel
    return reel


@pytest.mark.slow
def test_takes_follow_one_another_in_a_file_that_says_what_it_is(world: World) -> None:
    cue_id, takes = two_takes(world)
    reel = made(world, world.reviewer, cue_id, gap_ms=250)
    assert [one["take_id"] for one in reel["takes"]] == takes
    # One beep and two, 120 ms each and as much between, 300 ms before each take, 250 ms between takes.
    assert [one["start_s"] for one in reel["takes"]] == [0.42, 0.42 + 0.2 + 0.25 + 0.66]
    assert (reel["duration_s"], reel["slates"], reel["file_name"]) == (1.73, "beeped", "laser_reel.wav")
    file = world.reviewer.get(reel["file_url"])
    assert 'filename="laser_reel.wav"' in file.headers["content-disposition"]
    assert len(file.content) == reel["file_bytes"]
    with wave.open(io.BytesIO(file.content)) as sound:
        assert (sound.getframerate(), sound.getnframes()) == (48_000, round(1.73 * 48_000))


@pytest.mark.slow
def test_the_same_takes_give_the_same_reel_and_another_take_another(world: World) -> None:
    cue_id, _ = two_takes(world)
    first = made(world, world.reviewer, cue_id)
    assert ask(world.designer, cue_id) == first  # all takes are this designer's
    other = made(world, world.reviewer, cue_id, slates="none", crossfade_ms=50)
    assert (other["id"] != first["id"], other["slates"], other["duration_s"]) == (True, "none", 0.35)
    deliver_sound(world, "laser.wav", tone(600), rate=48_000, bits=16)
    longer = made(world, world.reviewer, cue_id)
    assert (longer["id"] != first["id"], len(longer["takes"])) == (True, 3)
    assert world.reviewer.get(first["file_url"]).status_code == 200  # nothing is replaced


@pytest.mark.slow
def test_a_designer_hears_their_own_takes_only(world: World) -> None:
    cue_id, takes = two_takes(world)

    def give_away(session: Any) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        session.add(Engagement(**of, designer_id=world.other_designer_id, kind=EngagementKind.CONTRACT))
        session.execute(sa.update(Take).where(Take.id == UUID(takes[1])).values(designer_id=world.other_designer_id))

    world.server.in_database(give_away)
    everything = made(world, world.reviewer, cue_id)
    mine, theirs = made(world, world.designer, cue_id), made(world, world.other_designer, cue_id)
    assert [one["take_id"] for one in everything["takes"]] == takes
    assert ([one["take_id"] for one in mine["takes"]], [their["take_id"] for their in theirs["takes"]]) == (
        takes[:1],
        takes[1:],
    )
    for client, reel in (
        (world.designer, everything),
        (world.designer, theirs),
        (world.other_designer, everything),
        (world.other_designer, mine),
        (world.stranger, mine),
    ):
        for address in (f"/v1/reels/{reel['id']}", reel["file_url"]):
            answer = client.get(address)
            assert (answer.status_code, answer.json()["code"]) == (404, "reel-not-found")
    for reel in (mine, theirs):
        assert world.reviewer.get(reel["file_url"]).status_code == 200
    assert world.stranger.post(f"/v1/cues/{cue_id}/reels", json={}).status_code == 404
    assert world.nobody.get(everything["file_url"]).status_code == 401


@pytest.mark.slow
def test_a_set_is_heard_variation_by_variation(world: World) -> None:
    cue = add_cue(world, "hum", variations=2)
    files = [("hum_02.wav", 500), ("hum_01.wav", 400)]
    deliver(world, *[(name, wav_bytes(tone(hz), rate=48_000, bits=16)) for name, hz in files])
    world.server.wait_for_jobs()
    reel = made(world, world.reviewer, cue["id"], gap_ms=0)
    assert [(one["variation"], one["number"]) for one in reel["takes"]] == [(1, 1), (2, 1)]
    # One low beep and two, and a high one for version 1, each with its pause.
    assert [one["start_s"] for one in reel["takes"]] == pytest.approx([0.84, 0.84 + 0.2 + 1.08])


@pytest.mark.slow
def test_the_newest_take_may_come_first(world: World) -> None:
    cue_id, takes = two_takes(world)
    reel = made(world, world.reviewer, cue_id, order="newest", slates="none")
    assert [one["take_id"] for one in reel["takes"]] == takes[::-1]
    assert made(world, world.reviewer, cue_id, order="oldest", slates="none")["id"] != reel["id"]


def test_a_cue_without_playable_takes_is_refused_with_a_reason(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    cue_id = add_cue(world, "siren")["id"]

    def refusal() -> tuple[int, str]:
        answer = world.reviewer.post(f"/v1/cues/{cue_id}/reels", json={})
        return answer.status_code, answer.json()["code"]

    assert refusal() == (409, "nothing-to-play")
    deliver_sound(world, "siren.wav", tone(400), rate=48_000, bits=16)
    monkeypatch.setattr(reels, "MAX_DURATION_S", 0.1)
    assert refusal() == (409, "reel-too-long")
    world.server.in_database(lambda session: session.execute(sa.delete(Picture)))
    assert refusal() == (409, "takes-being-drawn")
    assert world.reviewer.get(f"/v1/reels/{new_id()}").json()["code"] == "reel-not-found"


@pytest.mark.slow
def test_a_reel_that_failed_is_made_when_it_is_asked_for_again(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    cue_id, _ = two_takes(world)

    def broken(*_: Any) -> Any:
        raise SandboxFailed("the child was killed")

    with monkeypatch.context() as patch:
        patch.setattr(reel_jobs, "retried", broken)
        asked = ask(world.reviewer, cue_id)
        world.server.wait_for_jobs()
    failed = world.reviewer.get(f"/v1/reels/{asked['id']}").json()
    assert (failed["state"], failed["refusal"], failed["file_url"]) == ("refused", reel_jobs.NO_REEL, None)
    assert world.reviewer.get(f"/v1/reels/{asked['id']}/file").json()["code"] == "reel-not-made"
    assert made(world, world.reviewer, cue_id)["id"] == asked["id"]


@pytest.mark.slow
def test_speech_makes_the_slates_where_it_is_installed(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []

    def speak(words: str, rate_hz: int, most_frames: int | None) -> Any:
        said.append(words)
        return sine(hz=200, dbfs=0, rate=rate_hz, seconds=0.5)[:, 0]

    monkeypatch.setattr(reel_jobs, "synthesize_speech", speak)
    cue_id, _ = two_takes(world)
    reel = made(world, world.reviewer, cue_id)
    assert (reel["slates"], said) == ("spoken", ["version 1", "version 2"])
    assert reel["takes"][0]["start_s"] == pytest.approx(0.8, abs=0.001)
    beeped = made(world, world.reviewer, cue_id, slates="beeped")
    assert (beeped["slates"], len(said)) == ("beeped", 2)  # nothing more was said
    assert beeped["takes"][0]["start_s"] == 0.42


@pytest.mark.slow
def test_a_reel_never_ships(world: World) -> None:
    cue_id, takes = two_takes(world)
    assert world.approver.post(f"/v1/takes/{takes[1]}/verdict", json={"kind": "approve"}).status_code == 200
    reel = made(world, world.reviewer, cue_id)
    sha256 = hashlib.sha256(world.reviewer.get(reel["file_url"]).content).hexdigest()
    pack = world.reviewer.get(f"/v1/projects/{world.project_id}/pack", params={"target": "game"})
    assert pack.status_code == 200, pack.text
    assert "laser.wav" in pack.text
    assert "_reel" not in pack.text
    assert sha256 not in pack.text
