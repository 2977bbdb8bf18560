"""Uploads over lines that trickle or drop: they are cut, and nothing that came is lost."""

import select
import socket
from collections.abc import Iterator

import pytest
from starlette import types as asgi

from app.accounts.authentication import SESSION_COOKIE
from tests.app.deliveries.test_upload_endpoints import CONTENT, SHA256, begin, patch, staged
from tests.support.deliver import BYTES, TUS, open_delivery
from tests.support.listening import listening
from tests.support.server import RunningServer, World
from tests.support.waiting import until


class Door:
    """Leads from a real socket to the application, and counts the bytes of bodies that it took."""

    port: int
    taken_bytes = 0

    def __init__(self, application: asgi.ASGIApp) -> None:
        self._application = application

    async def __call__(self, scope: asgi.Scope, receive: asgi.Receive, send: asgi.Send) -> None:
        async def counted() -> asgi.Message:
            message = await receive()
            self.taken_bytes += len(message.get("body", b""))
            return message

        await self._application(scope, counted, send)


@pytest.fixture
def door(server: RunningServer) -> Iterator[Door]:
    door = Door(server.application)
    with listening(door, lifespan="off") as door.port:
        yield door


def request_head(world: World, method: str, path: str, headers: dict[str, str]) -> bytes:
    """Return the head of a request that the designer's browser sends."""
    whole = {
        "Host": "127.0.0.1:8000",
        "Cookie": f"{SESSION_COOKIE}={world.designer.cookies[SESSION_COOKIE]}",
        "X-CSRF-Token": world.designer.headers["x-csrf-token"],
    } | headers
    lines = [f"{method} {path} HTTP/1.1", *(f"{name}: {value}" for name, value in whole.items()), "", ""]
    return "\r\n".join(lines).encode()


def drop(
    world: World, door: Door, method: str, path: str, headers: dict[str, str], body: bytes, *, after_bytes: int
) -> None:
    """Send a request's head and only a part of its body, and drop the connection when so much has been taken."""
    with socket.create_connection(("127.0.0.1", door.port)) as connection:
        connection.sendall(request_head(world, method, path, headers) + body)
        until(lambda: door.taken_bytes == after_bytes)


def trickle(world: World, door: Door, method: str, path: str, headers: dict[str, str]) -> bytes:
    """Send a body 10 bytes at a time, for as long as the server takes them; return its answer."""
    with socket.create_connection(("127.0.0.1", door.port)) as connection:
        connection.sendall(request_head(world, method, path, headers))
        for at in range(0, len(CONTENT), 10):
            connection.sendall(CONTENT[at : at + 10])
            if select.select([connection], [], [], 0.02)[0]:
                return connection.recv(65_536)
    raise AssertionError("the server took the whole body")


@pytest.fixture
def strict_pace(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ask of uploads 2,000 bytes in each 0.4 s; 10 bytes every 0.02 s are 200 at most."""
    monkeypatch.setattr(server.runtime.settings, "upload_min_rate", 5_000)
    monkeypatch.setattr(server.runtime.settings, "upload_window_s", 0.4)


@pytest.mark.usefixtures("strict_pace")
def test_an_upload_that_trickles_is_cut_and_can_be_continued(world: World, door: Door) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    headers = TUS | BYTES | {"Upload-Offset": "0", "Content-Length": str(len(CONTENT))}
    answer = trickle(world, door, "PATCH", location, headers)
    assert answer.startswith(b"HTTP/1.1 408 ")
    assert b"upload-stalled" in answer
    assert b"an upload sends 2,000 or more" in answer
    here = int(world.designer.head(location, headers=TUS).headers["upload-offset"])
    assert 10 <= here < 2_000
    assert patch(world.designer, location, here, CONTENT[here:]).status_code == 204
    assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT


@pytest.mark.usefixtures("strict_pace")
def test_a_put_that_trickles_is_cut_and_leaves_nothing_behind(world: World, door: Door) -> None:
    path = f"/v1/uploads?delivery_id={open_delivery(world)}&file_name=laser.wav"
    answer = trickle(world, door, "PUT", path, {"Content-Length": str(len(CONTENT))})
    assert answer.startswith(b"HTTP/1.1 408 ")
    assert b"upload-stalled" in answer
    assert staged(world.server, world.studio_id) == []


def test_a_line_that_drops_in_mid_body_loses_nothing_that_came(world: World, door: Door) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    headers = TUS | BYTES | {"Upload-Offset": "0", "Content-Length": str(len(CONTENT))}
    drop(world, door, "PATCH", location, headers, CONTENT[:123_456], after_bytes=123_456)
    until(lambda: patch(world.designer, location, 123_456, CONTENT[123_456:]).status_code == 204)
    assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT


def test_a_put_that_drops_in_mid_body_leaves_nothing_behind(world: World, door: Door) -> None:
    path = f"/v1/uploads?delivery_id={open_delivery(world)}&file_name=laser.wav"
    headers = {"Content-Length": str(len(CONTENT))}
    drop(world, door, "PUT", path, headers, CONTENT[:123_456], after_bytes=123_456)
    until(lambda: not staged(world.server, world.studio_id))


def test_a_chunked_body_that_drops_keeps_what_came(world: World, door: Door) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    headers = TUS | BYTES | {"Upload-Offset": "0", "Transfer-Encoding": "chunked"}
    body = b"3e8\r\n" + CONTENT[:1_000] + b"\r\nffff\r\n" + CONTENT[1_000:1_500]
    drop(world, door, "PATCH", location, headers, body, after_bytes=1_500)
    until(lambda: world.designer.head(location, headers=TUS).headers["upload-offset"] == "1500")
