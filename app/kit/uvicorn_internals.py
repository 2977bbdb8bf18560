"""Everything that Soundlist uses of uvicorn beside its documentation: pyproject.toml pins one exact version.

tests/app/kit/test_uvicorn_internals.py names each part, and fails where a newer version lacks it. None of it is for
speed. `BoundedHttpProtocol` limits how large and how slow a request's head may be, and what happens to an unread body:
uvicorn's protocol buffers a head of any size, waits for it without end, and reads on after an early answer. This holds
with or without a proxy in front. `SteppedServer` answers what is on its way while a process stops: uvicorn resets it.
"""

import asyncio
import json
import socket
import threading
import time
from collections.abc import Callable
from http import HTTPStatus
from types import FrameType
from typing import Any, cast

import uvicorn
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from app.kit.handshakes import stop_handshakes

MAX_HEAD_BYTES = 64 << 10  # request line and headers; Upload-Metadata alone may have 32 KiB
MAX_URL_BYTES = 16 << 10
MAX_HEADERS = 100
HEAD_S = 20.0  # from the first byte of a head to its last, and from the connection to its first byte
DRAIN_BYTES = 8 << 20  # of an unread body, after its answer: many clients send all before they read
DRAIN_S = 2.0
ACCEPT_S = 0.1  # the event loop comes round many times
LINGER_S = 2.0  # a proxy finishes with its open connections, or sees that no new one opens


class BoundedHttpProtocol(HttpToolsProtocol):
    """Uvicorn's HTTP/1.1, which cuts off heads that are too large or too slow, and unread bodies."""

    def __init__(self, *given: Any, **more: Any) -> None:
        super().__init__(*given, **more)
        self._in_head = False  # between the first byte of a head and its last
        self._in_body = False  # between the last byte of a head and that of its body
        self._head_bytes = 0
        self._refusal: tuple[HTTPStatus, str] | None = None
        self._head_timer: asyncio.TimerHandle | None = None
        self._drain_timer: asyncio.TimerHandle | None = None
        self._drained_bytes = 0
        self._closing: _LingeringTransport

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Wait no longer than HEAD_S for the first request."""
        self._closing = _LingeringTransport(transport, self)
        super().connection_made(cast(asyncio.Transport, self._closing))
        self._head_timer = self.loop.call_later(HEAD_S, self._head_is_late)

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the timers."""
        self._stop_head_timer()
        self._stop_draining()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Read on, unless this is the rest of an unread body."""
        if self._drain_timer is not None:
            self._drained_bytes += len(data)
            if self._drained_bytes > DRAIN_BYTES:
                self._closing.abandon()
                return
        if self._closing.is_lingering:
            return
        super().data_received(data)
        if self._in_head:
            self._head_bytes += len(data)
            if self._head_bytes > MAX_HEAD_BYTES:
                self._refuse_head()
        is_idle = not self._in_body and (self.cycle is None or self.cycle.response_complete)
        if is_idle and self._head_timer is None and not self._closing.is_closing():
            longest_s = HEAD_S if self._in_head else self.timeout_keep_alive
            self._head_timer = self.loop.call_later(longest_s, self._head_is_late)

    def on_message_begin(self) -> None:
        """Reset the count of header bytes."""
        self._in_head, self._head_bytes, self._head_so_far = True, 0, 0
        super().on_message_begin()

    def on_url(self, url: bytes) -> None:
        """Refuse an address that is too long."""
        super().on_url(url)
        if len(self.url) > MAX_URL_BYTES:
            self._refusal = (HTTPStatus.REQUEST_URI_TOO_LONG, f"an address may have {MAX_URL_BYTES:,} bytes")
            raise _HeadRejected
        self._head_so_far += len(url)

    def on_header(self, name: bytes, value: bytes) -> None:
        """Refuse headers that are too many or too large."""
        super().on_header(name, value)
        self._head_so_far += len(name) + len(value)
        if len(self.headers) > MAX_HEADERS or self._head_so_far > MAX_HEAD_BYTES:
            self._refusal = _TOO_LARGE
            raise _HeadRejected

    def on_headers_complete(self) -> None:
        """Begin the request; from here on the application bounds its body."""
        self._in_head, self._in_body = False, True
        self._stop_head_timer()
        super().on_headers_complete()

    def on_message_complete(self) -> None:
        """Take the next request on this connection."""
        self._in_body = False
        if not self._closing.is_lingering:
            self._stop_draining()
        super().on_message_complete()

    def on_response_complete(self) -> None:
        """Wait a moment for the rest of an unread body, so that its sender reads the answer."""
        super().on_response_complete()
        if self._in_body:
            self.drain()

    def drain(self) -> None:
        """Discard incoming bytes, up to DRAIN_BYTES within DRAIN_S; then close."""
        if self._drain_timer is None:
            self._drained_bytes = 0
            self._drain_timer = self.loop.call_later(DRAIN_S, self._closing.abandon)

    @property
    def has_unread(self) -> bool:
        """Whether the sender is still sending what was answered already."""
        return self._in_body or self._in_head

    def send_400_response(self, msg: str) -> None:
        """Answer invalid or oversized HTTP with a problem."""
        status, detail = self._refusal or (HTTPStatus.BAD_REQUEST, msg)
        self._in_body = True  # what follows is not read, and is not a request
        if self.cycle is None or self.cycle.response_complete:
            self._write_problem(status, detail)
        self.transport.close()

    def _refuse_head(self) -> None:
        self._refusal = _TOO_LARGE
        self.send_400_response("")

    def _head_is_late(self) -> None:
        self._head_timer = None
        if self._in_head:
            self._refusal = (HTTPStatus.REQUEST_TIMEOUT, f"the headers of a request may take {HEAD_S:g} s")
            self.send_400_response("")
        elif not self._closing.is_closing():
            self._closing.abandon()

    def _write_problem(self, status: HTTPStatus, detail: str) -> None:
        code = status.phrase.lower().replace(" ", "-")
        problem = {"type": "about:blank", "title": status.phrase, "status": status, "code": code, "detail": detail}
        body = json.dumps(problem).encode()
        head = (
            f"HTTP/1.1 {status.value} {status.phrase}\r\ncontent-type: application/problem+json\r\n"
            f"content-length: {len(body)}\r\ncache-control: no-store\r\nconnection: close\r\n\r\n"
        )
        self.transport.write(head.encode() + body)

    def _stop_head_timer(self) -> None:
        if self._head_timer is not None:
            self._head_timer.cancel()
            self._head_timer = None

    def _stop_draining(self) -> None:
        if self._drain_timer is not None:
            self._drain_timer.cancel()
            self._drain_timer = None


_TOO_LARGE = (
    HTTPStatus.REQUEST_HEADER_FIELDS_TOO_LARGE,
    f"the headers of a request may have {MAX_HEAD_BYTES:,} bytes and be {MAX_HEADERS}",
)


class _HeadRejected(Exception):
    """Stops the parser."""


class _LingeringTransport:
    """A transport that closes for writing only while its peer still sends: a reset would lose the answer."""

    def __init__(self, transport: asyncio.Transport, protocol: BoundedHttpProtocol) -> None:
        self._transport = transport
        self._protocol = protocol
        self.is_lingering = False
        self.write = transport.write
        self.pause_reading, self.resume_reading = transport.pause_reading, transport.resume_reading

    def __getattr__(self, name: str) -> Any:
        return getattr(self._transport, name)

    def is_closing(self) -> bool:
        """Whether no further request is taken."""
        return self.is_lingering or self._transport.is_closing()

    def close(self) -> None:
        """Close once the peer has read what was written, or after DRAIN_S."""
        if not self._protocol.has_unread or not self._transport.can_write_eof():
            self._transport.close()
        elif not self.is_closing():
            self.is_lingering = True
            self._transport.write_eof()
            self._protocol.drain()
            self._protocol.flow.resume_reading()

    def abandon(self) -> None:
        """Close at once."""
        self._transport.close()


class SteppedServer(uvicorn.Server):
    """Stops in steps: is not ready, takes no new line, closes those it has; a second signal means now."""

    def __init__(self, config: uvicorn.Config, stopping: threading.Event, drain_s: float) -> None:
        super().__init__(config)
        self._stopping = stopping
        self._drain_s = drain_s
        self._hurries = not drain_s

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Begin to stop; at a second signal, stop at once."""
        self._hurries = self._hurries or self._stopping.is_set()
        self._stopping.set()
        if self._hurries:
            super().handle_exit(sig, frame)
            return
        closing = threading.Timer(self._drain_s, super().handle_exit, (sig, frame))
        closing.daemon = True
        closing.start()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Answer what may be on its way on an open line before the lines close."""
        for listening in sockets or ():
            stop_handshakes(listening)
        await self._until(lambda: False, ACCEPT_S)
        for server in self.servers:
            server.close()
        await self._until(lambda: not self.server_state.connections, LINGER_S)
        await super().shutdown(sockets)

    async def _until(self, done: Callable[[], bool], longest_s: float) -> None:
        deadline = time.monotonic() + longest_s
        while not (self._hurries or done()) and time.monotonic() < deadline:
            await asyncio.sleep(0.02)
