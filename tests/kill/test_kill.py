"""SIGKILL at named points of real processes: nothing acknowledged is lost, and everything happens once."""

import hashlib
import io
import os
import random
import signal
import socket
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast
from uuid import UUID

import httpx
import pytest
import sqlalchemy as sa
from sqlalchemy import func, select

from app.accounts.endpoints import SESSION_COOKIE
from app.conformance.models import CheckRun
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.kit.uploads import Uploads
from tests.kill.processes import ProcessServer, wait_until
from tests.support.deliver import BYTES, TUS, deliver, metadata, open_delivery, upload
from tests.support.server import RunningServer, World
from tests.support.waves import sine, wav_bytes

pytestmark = [pytest.mark.kill, pytest.mark.slow]
CONTENT = random.Random(1).randbytes(3_000_000)
SHA256 = hashlib.sha256(CONTENT).hexdigest()
HALF = 1_234_567


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ProcessServer]:
    server = ProcessServer(tmp_path)
    yield server
    server.close()


@pytest.fixture
def world(server: ProcessServer) -> World:
    return World(cast(RunningServer, server))


def begin(world: World) -> tuple[str, str]:
    """Begin an upload; return its delivery and its address."""
    delivery_id = open_delivery(world)
    names = metadata(delivery_id=delivery_id, file_name="laser.wav")
    headers = TUS | {"Upload-Length": str(len(CONTENT)), "Upload-Metadata": names}
    return delivery_id, world.designer.post("/v1/uploads", headers=headers).headers["location"]


def send(world: World, location: str, offset: int, content: bytes) -> httpx.Response:
    headers = TUS | BYTES | {"Upload-Offset": str(offset)}
    return cast(httpx.Response, world.designer.patch(location, headers=headers, content=content))


def offset_of(world: World, location: str) -> int:
    return int(world.designer.head(location, headers=TUS).headers["upload-offset"])


def test_killed_web_process_loses_no_byte(server: ProcessServer, world: World) -> None:
    """One upload survives a kill in its middle and one at every step of its end."""
    web = server.serve("uploads.received")
    delivery_id, location = begin(world)
    with pytest.raises(httpx.TransportError):
        send(world, location, 0, CONTENT[:HALF])
    server.wait_for_death(web, "uploads.received")

    web = server.serve("uploads.before_store")
    assert offset_of(world, location) == HALF
    with pytest.raises(httpx.TransportError):
        send(world, location, HALF, CONTENT[HALF:])
    server.wait_for_death(web, "uploads.before_store")

    for point in ("uploads.after_store", "uploads.finished"):  # whoever asks next finishes it, and dies of it
        web = server.serve(point)
        with pytest.raises(httpx.TransportError):
            world.designer.head(location, headers=TUS)
        server.wait_for_death(web, point)

    server.serve()
    assert offset_of(world, location) == len(CONTENT)
    body = {"upload_id": location.rpartition("/")[2], "file_name": "laser.wav"}
    made = [world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body) for _ in range(2)]
    assert [answer.status_code for answer in made] == [201, 201]
    assert made[0].json()["id"] == made[1].json()["id"]
    assert world.designer.get(f"/v1/takes/{made[0].json()['id']}/master").content == CONTENT
    Uploads(server.runtime.database, server.runtime.store).sweep()
    assert list(server.runtime.store.root.glob("*/.uploads/*")) == []


def test_killed_while_bytes_stream_in(server: ProcessServer, world: World) -> None:
    """The kill comes from outside, with the request half read."""
    web = server.serve()
    _, location = begin(world)
    sent = 2_500_000
    head = "".join(
        f"{name}: {value}\r\n"
        for name, value in (
            TUS
            | BYTES
            | {
                "Host": f"127.0.0.1:{server.port}",
                "Cookie": f"{SESSION_COOKIE}={world.designer.cookies[SESSION_COOKIE]}",
                "X-CSRF-Token": world.designer.headers["x-csrf-token"],
                "Upload-Offset": "0",
                "Content-Length": str(len(CONTENT)),
            }
        ).items()
    )
    staging = server.runtime.store.root / str(world.studio_id) / ".uploads" / location.rpartition("/")[2]
    with socket.create_connection(("127.0.0.1", server.port)) as line:
        line.sendall(f"PATCH {location} HTTP/1.1\r\n{head}\r\n".encode() + CONTENT[:sent])
        wait_until(lambda: staging.stat().st_size > 1_000_000)
        os.kill(web.pid, signal.SIGKILL)
        web.wait()
    server.serve()
    here = offset_of(world, location)
    assert 1_000_000 < here <= sent
    assert send(world, location, here, CONTENT[here:]).status_code == 204
    assert server.runtime.store.read(world.studio_id, SHA256) == CONTENT


def test_killed_worker_judges_once(server: ProcessServer, world: World) -> None:
    """One take survives a kill at every step of its check; its verdict is given and told once."""
    take = deliver(world, "laser.wav", wav_bytes(sine(hz=440, dbfs=-6, seconds=0.2)))
    points = ["before_check", "after_check", "before_commit", "after_commit"]
    for point in points:
        assert told(server, "notifications.tell_check") == 0
        server.wait_for_death(server.work(f"conformance.{point}"), f"conformance.{point}")
    server.work()
    wait_until(lambda: no_jobs_left(server))
    assert state_of(server, take["id"]) is TakeState.CONFORMING
    assert told(server, "notifications.tell_check") == 1
    with server.runtime.database.reading() as session:
        assert session.scalar(select(func.count()).where(CheckRun.take_id == UUID(take["id"]))) == 1


def test_killed_worker_unpacks_each_file_once(server: ProcessServer, world: World) -> None:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w") as archive:
        for place in range(4):
            archive.writestr(f"{place}.wav", f"no sound, number {place}")
    delivery_id = open_delivery(world)
    body = {"upload_id": upload(world, delivery_id, "all.zip", whole.getvalue()), "file_name": "all.zip"}
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/archives", json=body).status_code == 201
    server.wait_for_death(server.work("deliveries.entry_unpacked"), "deliveries.entry_unpacked")
    server.work()
    wait_until(lambda: no_jobs_left(server))
    shown: dict[str, Any] = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    assert sorted(take["file_name"] for take in shown["takes"]) == [f"{place}.wav" for place in range(4)]
    assert shown["archives"][0]["state"] == "unpacked"
    assert all(entry["taken"] for entry in shown["archives"][0]["entries"])


def no_jobs_left(server: ProcessServer) -> bool:
    """Whether nothing runs or waits for its turn; what waits for a later hour may."""
    query = sa.text("select count(*) from workflow_status where status in ('ENQUEUED', 'PENDING')")
    with server.runtime.database.reading() as session:
        return bool(session.scalar(query) == 0)


def told(server: ProcessServer, job: str) -> int:
    """Return how many jobs of a name were ever written."""
    with server.runtime.database.reading() as session:
        query = sa.text("select count(*) from workflow_status where workflow_uuid like :ending")
        return int(session.scalar(query, {"ending": f"%:{job}"}) or 0)


def state_of(server: ProcessServer, take_id: str) -> TakeState:
    with server.runtime.database.reading() as session:
        return session.get_one(Take, UUID(take_id)).state
