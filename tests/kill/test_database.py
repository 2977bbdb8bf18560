"""Kills of the database under running processes: they wait for it, and go on by themselves when it is back."""

import signal
import time
from functools import partial
from uuid import UUID

import pytest

from app.deliveries.models import Delivery
from tests.kill.effects import assert_done_once, is_idle, jobs_written, nothing_failed, rows, verdicts
from tests.kill.processes import Process, ProcessServer, SomeOf, wait_until
from tests.support.deliver import BYTES, TUS, add_cues, metadata, open_delivery
from tests.support.postgres import Postgres
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

pytestmark = [pytest.mark.kill, pytest.mark.slow]
SOUND = wav_bytes(sine(hz=440, dbfs=-6, seconds=0.2))


def die_and_come_back(server: ProcessServer, postgres: Postgres, point: str) -> None:
    server.wait_for_kill(point)
    postgres.kill()  # what the postmaster left behind
    time.sleep(1.0)  # who uses it finds it gone
    postgres.start()


def instead_of(web: Process, server: ProcessServer, point: str, postgres: Postgres) -> Process:
    """Let a web process end in peace, and start one that will kill the database."""
    web.send(signal.SIGTERM)
    web.wait()
    return server.serve(point, victim=postgres.pid)


@pytest.mark.killed_on("postgres", only=True)
def test_a_killed_database_loses_nothing_and_stops_nobody(
    server: ProcessServer, world: World, durable_postgres: Postgres, some_of: SomeOf
) -> None:
    """It dies while an upload ends, while a check and a render are recorded, and while a verdict is given."""
    (cue,) = add_cues(world, {"name": "laser"})
    delivery_id = open_delivery(world)

    point = "uploads.before_store"
    web = server.serve(point, victim=durable_postgres.pid)
    designer = world.signed_in(world.designer_id)
    names = metadata(delivery_id=delivery_id, file_name="laser.wav")
    headers = TUS | {"Upload-Length": str(len(SOUND)), "Upload-Metadata": names}
    location = designer.post("/v1/uploads", headers=headers).headers["location"]
    ending = designer.patch(location, headers=TUS | BYTES | {"Upload-Offset": "0"}, content=SOUND)
    die_and_come_back(server, durable_postgres, point)
    if ending.status_code != 204:  # its own session may outlive the server by that moment
        assert (ending.status_code, ending.json()["code"]) == (503, "database-away")
    assert int(designer.head(location, headers=TUS).headers["upload-offset"]) == len(SOUND)
    body = {"upload_id": location.rpartition("/")[2], "file_name": "laser.wav"}
    made = designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body)
    assert made.status_code == 201
    take_id = UUID(made.json()["id"])
    assert made.json()["cue"]["id"] == cue["id"]

    for point in some_of(("conformance.before_commit", "renders.before_commit"), 2):
        worker = server.work(point, victim=durable_postgres.pid)
        die_and_come_back(server, durable_postgres, point)
        if point.startswith("renders"):
            wait_until(lambda: is_idle(server))  # by the same process, which was not signalled
            assert worker.poll() is None
        else:
            worker.send(signal.SIGKILL)
            worker.wait()
    assert_done_once(server, take_id)

    point = "reviews.before_commit"
    web = instead_of(web, server, point, durable_postgres)
    verdict = partial(world.signed_in(world.approver_id).post, f"/v1/takes/{take_id}/verdict", json={"kind": "approve"})
    answer = verdict()
    die_and_come_back(server, durable_postgres, point)
    assert answer.status_code in (200, 503)
    assert verdicts(server, take_id) == 1 or answer.status_code == 503, "what was acknowledged is there"
    if verdicts(server, take_id) == 0:
        assert verdict().status_code == 200
    wait_until(lambda: is_idle(server))
    assert verdicts(server, take_id) == 1
    assert jobs_written(server, "notifications.notify_approval") == 1

    point = "http.after_commit"
    web = instead_of(web, server, point, durable_postgres)
    opened = world.signed_in(world.designer_id).post(f"/v1/projects/{world.project_id}/deliveries", json={})
    die_and_come_back(server, durable_postgres, point)
    assert opened.status_code == 201
    assert rows(server, Delivery, id=UUID(opened.json()["id"])) == 1
    assert nothing_failed(server)
