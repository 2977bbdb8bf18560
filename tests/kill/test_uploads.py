"""Kills while files come in: not a byte that was acknowledged is lost."""

import hashlib
import os
import random
import signal
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import cast

import httpx
import pytest

from app.accounts.authentication import SESSION_COOKIE
from app.core.uploads import Uploads
from tests.kill.processes import ProcessServer, SomeOf, Zygote, wait_until
from tests.support.deliver import BYTES, TUS, metadata, open_delivery
from tests.support.s3 import S3Server
from tests.support.server import RunningServer, World

pytestmark = [pytest.mark.kill, pytest.mark.slow]
CONTENT = random.Random(1).randbytes(3_000_000)
SHA256 = hashlib.sha256(CONTENT).hexdigest()
HALF = 1_234_567


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


@pytest.mark.killed_on("sqlite")
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

    for point in (
        "uploads.after_store",
        "uploads.finished",
    ):  # the next process finishes it, and dies of it
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


@pytest.mark.killed_on("sqlite")
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


@pytest.fixture
def server_with_bucket(zygote: Zygote, tmp_path: Path, database_to_kill: str, s3: S3Server) -> Iterator[ProcessServer]:
    server = ProcessServer(zygote, tmp_path, database_url=database_to_kill, **s3.settings(store_direct=True))
    yield server
    server.close()


@pytest.mark.killed_on("sqlite")
def test_killed_while_it_finishes_what_is_in_the_bucket(
    server_with_bucket: ProcessServer, s3: S3Server, some_of: SomeOf
) -> None:
    """A file that went to the bucket in parts is whole in the end, whichever process died of finishing it."""
    server = server_with_bucket
    world = World(cast(RunningServer, server))
    delivery_id, location = begin(world)
    part = {"number": 1, "sha256": SHA256}
    (link,) = world.designer.post(f"{location}/parts", json={"parts": [part]}).json()["links"]
    assert s3.client.put(link["url"], content=CONTENT, headers=link["headers"]).status_code == 200
    for point in some_of(("made_whole", "before_store", "after_store", "finished"), 3):
        web = server.serve(f"uploads.{point}")
        with pytest.raises(httpx.TransportError):
            world.signed_in(world.designer_id).post(f"{location}/finish")
        server.wait_for_death(web, f"uploads.{point}")
    server.serve()
    designer = world.signed_in(world.designer_id)
    assert designer.post(f"{location}/finish").json()["sha256"] == SHA256
    body = {"upload_id": location.rpartition("/")[2], "file_name": "laser.wav"}
    made = [designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body) for _ in range(2)]
    assert [answer.status_code for answer in made] == [201, 201]
    assert made[0].json()["id"] == made[1].json()["id"]
    assert server.runtime.store.read(world.studio_id, SHA256) == CONTENT
