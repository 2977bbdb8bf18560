"""One take's whole way, with a kill at every step of it: check, render, verdict, pack."""

import hashlib
import io
import time
import zipfile
from typing import Any
from uuid import UUID

import httpx
import pytest

from app.builds.same_sounds.models import MasterFingerprint
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from tests.kill.effects import assert_done_once, is_idle, jobs_written, nothing_failed, rows, verdicts
from tests.kill.processes import ProcessServer, SomeOf, wait_until
from tests.support.deliver import add_cues, deliver, open_delivery, upload
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

pytestmark = [pytest.mark.kill, pytest.mark.slow]
SOUND = wav_bytes(sine(hz=440, dbfs=-6, seconds=0.2))
CHECK_POINTS = [f"conformance.{point}" for point in ("before_check", "after_check", "before_commit", "after_commit")]
RENDER_POINTS = [f"renders.{point}" for point in ("before_render", "after_render", "before_commit", "after_commit")]


def deliver_one(world: World) -> UUID:
    add_cues(world, {"name": "laser"})
    return UUID(deliver(world, "laser.wav", SOUND)["id"])


def state_of(server: ProcessServer, take_id: UUID) -> TakeState:
    with server.runtime.database.reading() as session:
        return session.get_one(Take, take_id).state


# One job does all of a take; one that killed its worker at all of these points would be parked for it.
@pytest.mark.parametrize(("points", "step"), [(CHECK_POINTS, 2), (RENDER_POINTS, 3)], ids=["checked", "rendered"])
@pytest.mark.killed_on("postgres")
def test_a_take_survives_a_kill_at_every_step(
    server: ProcessServer, world: World, some_of: SomeOf, points: list[str], step: int
) -> None:
    """Its job is taken over each time: before its verdict, between that and its drawing, and after it."""
    take_id = deliver_one(world)
    for point in some_of(points, step):
        server.wait_for_death(server.work(point), point)
    server.work()
    wait_until(lambda: is_idle(server))
    assert state_of(server, take_id) is TakeState.CONFORMING
    assert_done_once(server, take_id)
    assert rows(server, MasterFingerprint, studio_id=world.studio_id) == 1, "compared with other projects"


@pytest.mark.killed_on("postgres")
def test_a_verdict_and_a_pack_survive_kills(server: ProcessServer, world: World, some_of: SomeOf) -> None:
    """The verdict is given once, and the pack is whole."""
    take_id = deliver_one(world)
    server.work()
    wait_until(lambda: is_idle(server))

    verdict: dict[str, Any] = {"json": {"kind": "approve"}, "headers": {"Idempotency-Key": "one click"}}
    for point in some_of(("reviews.before_commit", "http.after_commit"), 2):
        recorded = int(point == "http.after_commit")
        web = server.serve(point)
        with pytest.raises(httpx.TransportError):
            world.signed_in(world.approver_id).post(f"/v1/takes/{take_id}/verdict", **verdict)
        server.wait_for_death(web, point)
        assert verdicts(server, take_id) == recorded
    server.serve()
    approver = world.signed_in(world.approver_id)
    approver.post(f"/v1/takes/{take_id}/verdict", json={"kind": "approve"})
    assert state_of(server, take_id) is TakeState.APPROVED
    assert verdicts(server, take_id) == 1
    wait_until(lambda: is_idle(server))
    assert jobs_written(server, "notifications.notify_approval") == 1

    def pack() -> httpx.Response:
        answer: httpx.Response = approver.get(f"/v1/projects/{world.project_id}/pack.zip", params={"masters": "true"})
        return answer

    whole = pack().content
    server.stop()
    web = server.serve("builds.entry_packed")
    with pytest.raises(httpx.TransportError):
        pack()
    server.wait_for_death(web, "builds.entry_packed")
    server.serve()
    assert hashlib.sha256(pack().content).digest() == hashlib.sha256(whole).digest()
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        assert archive.testzip() is None
        assert "laser.wav" in archive.namelist()


@pytest.mark.killed_on("sqlite")
def test_another_worker_takes_over(server: ProcessServer, world: World) -> None:
    """The job of a worker that was killed is done by one that was there all the time."""
    take_id = deliver_one(world)
    doomed = server.work("conformance.after_check")
    server.wait_for_death(doomed, "conformance.after_check")
    begun = time.monotonic()
    server.work()
    wait_until(lambda: is_idle(server))
    assert time.monotonic() - begun < 30
    assert_done_once(server, take_id)


@pytest.mark.killed_on("sqlite")
def test_each_file_of_a_zip_is_unpacked_once(server: ProcessServer, world: World) -> None:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w") as archive:
        for place in range(4):
            archive.writestr(f"{place}.wav", f"no sound, number {place}")
    delivery_id = open_delivery(world)
    body = {"upload_id": upload(world, delivery_id, "all.zip", whole.getvalue()), "file_name": "all.zip"}
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/archives", json=body).status_code == 201
    server.wait_for_death(server.work("deliveries.entry_unpacked"), "deliveries.entry_unpacked")
    server.work()
    wait_until(lambda: is_idle(server))
    shown: dict[str, Any] = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    assert sorted(take["file_name"] for take in shown["takes"]) == [f"{place}.wav" for place in range(4)]
    assert shown["archives"][0]["state"] == "unpacked"
    assert all(entry["taken"] for entry in shown["archives"][0]["entries"])
    assert nothing_failed(server)
