"""Everything re-rendered in one action: planned at once, made one by one, ended when asked, both sets kept."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.core.db import new_id
from app.core.jobs import queue
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.renders.batches import jobs as batch_jobs
from app.renders.batches import service as batches
from app.renders.models import BatchItem, Render, RenderSet
from app.renders.rules import BatchState, ItemState
from app.sound_lists.models import Cue, Stem
from tests.app.renders.making import add_cue, deliver_sound
from tests.support.blobs import blob_file
from tests.support.server import World
from tests.support.waves import sine

MONO_16 = 2 * 11_025  # bytes of half a second at 22,050 Hz


def add_target(world: World, name: str, rate_hz: int, bits: int = 16) -> None:
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = spec["toml"] + f"\n[targets.{name}]\nsample_rate_hz = {rate_hz}\nbit_depth = {bits}\n"
    saved = world.producer.put(
        f"/v1/projects/{world.project_id}/spec", json={"toml": toml, "based_on_version": spec["version"]}
    )
    assert saved.status_code == 200, saved.text


def accepted(world: World, *names: str) -> list[str]:
    """Deliver and approve half a second of a tone for each cue; return the takes."""
    takes = []
    for place, name in enumerate(names):
        add_cue(world, name, category="weapon")
        takes.append(deliver_sound(world, f"{name}.wav", sine(hz=500 + place, dbfs=-12, rate=96_000, seconds=0.5)))
    for take in takes:
        assert world.approver.post(f"/v1/takes/{take}/verdict", json={"kind": "approve"}).status_code == 200
    world.server.wait_for_jobs()
    return takes


def listed(world: World) -> list[dict[str, Any]]:
    answer = world.reviewer.get(f"/v1/projects/{world.project_id}/batches")
    assert answer.status_code == 200, answer.text
    found: list[dict[str, Any]] = answer.json()["items"]
    return found


def batch(world: World, batch_id: str) -> dict[str, Any]:
    found: dict[str, Any] = world.reviewer.get(f"/v1/batches/{batch_id}").json()
    return found


def renders(world: World) -> set[tuple[str, str | None]]:
    rows = sa.select(Render.target, Render.sha256).where(Render.project_id == world.project_id)
    return {tuple(row) for row in world.server.in_database(lambda session: session.execute(rows).all())}


def begin(world: World, **body: Any) -> dict[str, Any]:
    begun = world.approver.post(f"/v1/projects/{world.project_id}/batches", json=body)
    assert begun.status_code == 201, begun.text
    answer: dict[str, Any] = begun.json()
    return answer


@contextmanager
def paused(world: World) -> Iterator[None]:
    """Let batches be planned, and nothing of them be made, until the block is over."""
    original = batch_jobs.render_next_of_batch
    queue._handlers[batches.RENDER_NEXT] = lambda *_: None
    try:
        yield
    finally:
        queue._handlers[batches.RENDER_NEXT] = original


@pytest.mark.slow
def test_a_new_target_is_made_of_everything_and_the_sizes_are_compared(world: World) -> None:
    takes = accepted(world, "laser", "siren")
    before = renders(world)
    add_target(world, "trailer", 48_000)
    world.server.wait_for_jobs()
    (reported,) = listed(world)
    assert (reported["state"], reported["by_spec"], reported["files"], reported["waiting"]) == ("done", True, 6, 0)
    assert (reported["made"], reported["kept"], reported["refused"], reported["left"]) == (2, 4, 0, 0)
    assert before < renders(world)  # both sets are kept
    by_target = {row["target"]: row for row in batch(world, reported["id"])["sizes"]}
    assert {row["category"] for row in by_target.values()} == {"weapon"}
    trailer, handheld = by_target["trailer"], by_target["handheld"]
    assert (trailer["files"], trailer["before_bytes"]) == (2, 0)
    assert 2 * 2 * 24_000 <= trailer["after_bytes"] <= 2 * (2 * 24_000 + 200)
    assert handheld["before_bytes"] == handheld["after_bytes"] >= 2 * MONO_16
    for take in takes:
        made = {one["target"]: one["state"] for one in world.approver.get(f"/v1/takes/{take}/sounds").json()["renders"]}
        assert made == {"game": "made", "handheld": "made", "trailer": "made"}


@pytest.mark.slow
def test_a_changed_target_says_what_it_replaces(world: World) -> None:
    accepted(world, "laser")
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    assert spec["toml"].count("sample_rate_hz = 22050") == 1
    toml = spec["toml"].replace("sample_rate_hz = 22050", "sample_rate_hz = 44100")
    body = {"toml": toml, "based_on_version": spec["version"]}
    assert world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body).status_code == 200
    world.server.wait_for_jobs()
    (reported,) = listed(world)
    (handheld,) = (row for row in batch(world, reported["id"])["sizes"] if row["target"] == "handheld")
    # Twice the rate is twice the sound; the header is as long as it was.
    assert handheld["after_bytes"] - handheld["before_bytes"] == MONO_16


@pytest.mark.slow
def test_what_cannot_be_made_is_said_and_nothing_else_waits_for_it(world: World) -> None:
    (lost, _) = accepted(world, "laser", "siren")
    find = sa.select(Take.master_sha256).where(Take.id == UUID(lost))
    sha256 = world.server.in_database(lambda session: session.scalar(find))
    blob_file(world.server.runtime.store, world.studio_id, sha256).unlink()
    add_target(world, "trailer", 48_000)
    add_target(world, "film", 192_000, 24)
    world.server.wait_for_jobs()
    newest = batch(world, listed(world)[0]["id"])
    assert newest["state"] == "done"
    reasons = {(one["name"], one["target"]): one["reason"] for one in newest["trouble"]}
    assert "192000 Hz" in reasons["siren", "film"]
    assert "not in the store" in reasons["laser", "film"]
    assert {one["cue"] for one in newest["trouble"]} == {"SW-001", "SW-002"}


@pytest.mark.slow
def test_a_batch_can_be_cancelled_and_begun_again(world: World) -> None:
    accepted(world, "laser", "siren")
    with paused(world):
        add_target(world, "trailer", 48_000)
        world.server.wait_for_jobs()
        (reported,) = listed(world)
        assert (reported["state"], reported["waiting"]) == ("running", 2)
        ended = world.approver.post(f"/v1/batches/{reported['id']}/cancel")
        assert (ended.status_code, ended.json()["state"], ended.json()["waiting"]) == (200, "cancelled", 2)
        again = world.approver.post(f"/v1/batches/{reported['id']}/cancel")
        assert (again.status_code, again.json()["code"]) == (409, "batch-ended")
    begin(world, targets=["trailer"])
    world.server.wait_for_jobs()
    newest, first = listed(world)
    assert (newest["state"], newest["files"], newest["made"], newest["targets"]) == ("done", 2, 2, ["trailer"])
    assert (first["state"], first["made"]) == ("cancelled", 0)


@pytest.mark.slow
def test_a_newer_batch_takes_the_place_of_one_that_runs(world: World) -> None:
    accepted(world, "laser")
    with paused(world):
        add_target(world, "trailer", 48_000)
        world.server.wait_for_jobs()
    begin(world)
    world.server.wait_for_jobs()
    newest, first = listed(world)
    assert (newest["state"], first["state"], first["note"]) == ("done", "cancelled", "batch 2 took its place")


def test_nothing_to_make_and_no_such_target(world: World) -> None:
    empty = world.approver.post(f"/v1/projects/{world.project_id}/batches", json={})
    assert (empty.status_code, empty.json()["code"]) == (409, "nothing-to-render")
    unknown = world.approver.post(f"/v1/projects/{world.project_id}/batches", json={"targets": ["toaster"]})
    assert (unknown.status_code, unknown.json()["code"]) == (422, "target-unknown")
    add_target(world, "trailer", 48_000)
    world.server.wait_for_jobs()
    assert listed(world) == []  # a spec that changes before anything came opens no batch


@pytest.mark.slow
@pytest.mark.parametrize(("who", "status"), [("reviewer", 403), ("designer", 403), ("stranger", 404), ("nobody", 401)])
def test_who_may_not_begin_or_cancel(world: World, who: str, status: int) -> None:
    accepted(world, "laser")
    reported = begin(world)
    client = getattr(world, who)
    assert client.post(f"/v1/projects/{world.project_id}/batches", json={}).status_code == status
    assert client.post(f"/v1/batches/{reported['id']}/cancel").status_code == status
    if who != "reviewer":
        assert client.get(f"/v1/batches/{reported['id']}").status_code == status
        assert client.get(f"/v1/projects/{world.project_id}/batches").status_code == status


def five_thousand_takes(world: World) -> None:
    """Fill the list of a project with accepted takes, as they stand after years."""
    of = {"studio_id": world.studio_id, "project_id": world.project_id}
    numbers = range(1, 5_001)
    cue_ids = {number: new_id() for number in numbers}

    def fill(session: Any) -> None:
        delivery = Delivery(**of, designer_id=world.designer_id, number=1)
        session.add(delivery)
        session.flush()
        cues = [
            {**of, "id": cue_ids[number], "number": number, "position": number, "name": f"c{number}"}
            for number in numbers
        ]
        session.execute(sa.insert(Cue), cues)
        stems = [
            {**of, "cue_id": cue_ids[number], "variation": 1, "stem": f"c{number}", "folded": f"c{number}"}
            for number in numbers
        ]
        session.execute(sa.insert(Stem), stems)
        takes = [
            {
                **of,
                "delivery_id": delivery.id,
                "designer_id": world.designer_id,
                "cue_id": cue_ids[number],
                "number": 1,
                "state": TakeState.APPROVED,
                "file_name": f"c{number}.wav",
                "master_sha256": f"{number:064x}",
                "master_bytes": 1,
            }
            for number in numbers
        ]
        session.execute(sa.insert(Take), takes)

    world.server.in_database(fill)


@pytest.mark.slow
def test_five_thousand_takes_are_planned_in_one_go(world: World) -> None:
    five_thousand_takes(world)
    with paused(world):
        reported = begin(world)
        world.server.wait_for_jobs()
        found = batch(world, reported["id"])
        assert (found["state"], found["files"], found["waiting"]) == ("running", 10_000, 10_000)
        unfinished = [job for job in world.server.runtime.queue.unfinished() if job.studio_id == world.studio_id]
        assert len(unfinished) <= batches.LANES  # not a job a file: others never wait behind ten thousand
        world.approver.post(f"/v1/batches/{reported['id']}/cancel")
    items = sa.select(sa.func.count()).where(
        BatchItem.batch_id == UUID(reported["id"]), BatchItem.state == ItemState.MADE
    )
    assert world.server.in_database(lambda session: session.scalar(items)) == 0


@pytest.mark.slow
def test_a_take_that_waits_for_review_is_complete_once_its_files_are_made(world: World) -> None:
    add_cue(world, "laser")
    take_id = UUID(deliver_sound(world, "laser.wav", sine(hz=500, dbfs=-12, rate=96_000, seconds=0.2)))
    begin(world)
    world.server.wait_for_jobs()
    (reported,) = listed(world)
    assert (reported["state"], reported["kept"]) == (BatchState.DONE, 2)
    there = sa.select(sa.func.count()).where(RenderSet.take_id == take_id)
    assert world.server.in_database(lambda session: session.scalar(there)) == 1
