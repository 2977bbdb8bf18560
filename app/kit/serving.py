"""Serves the web application, and drains connections before a stopping process closes its port."""

import asyncio
import contextlib
import gc
import socket
import threading
import time
from collections.abc import Callable
from types import FrameType

import uvicorn
from starlette.datastructures import MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.kit.connections import BoundedHttpProtocol
from app.kit.handshakes import stop_handshakes
from app.kit.memory import collect_garbage

READY = "/readyz"
IS_LEAVING = "is_leaving"
STARTUP_FAILED = 3
GARBAGE_AFTER = 20_000  # objects: a page of the review queue makes as many, and nearly all go without a collector
IDLE_LINE_S = 150  # longer than proxies keep one (Caddy 120 s, nginx 60 s): no request is lost to a closing connection
ACCEPT_S = 0.1  # the event loop comes round many times
LINGER_S = 2.0  # a proxy finishes with its open connections, or sees that no new one opens


def serve(app: ASGIApp, listening: socket.socket, *, drain_s: float, finish_s: int) -> None:
    """Serve until SIGTERM or SIGINT; then go on for `drain_s` as not ready, and give open answers `finish_s` more.

    Without a `drain_s`, idle connections close at once.
    """
    # Imported objects are never freed; scanning them again would delay every few answers.
    gc.collect()
    gc.freeze()
    gc.set_threshold(GARBAGE_AFTER, *gc.get_threshold()[1:])
    stopping = threading.Event()
    collect_garbage(until=stopping)
    config = uvicorn.Config(
        _Draining(app, stopping.is_set), log_config=None, access_log=False, proxy_headers=False,
        server_header=False, timeout_graceful_shutdown=finish_s, timeout_keep_alive=IDLE_LINE_S,
        http=BoundedHttpProtocol, ws="none",
    )  # fmt: skip
    server = _Server(config, stopping, drain_s)
    with contextlib.suppress(KeyboardInterrupt):  # the signal that ended it, raised once more
        server.run([listening])
    if not server.started:
        raise SystemExit(STARTUP_FAILED)


class _Server(uvicorn.Server):
    """Stops in steps: is not ready, takes no new line, closes those it has; a second signal means now."""

    def __init__(self, config: uvicorn.Config, stopping: threading.Event, drain_s: float) -> None:
        super().__init__(config)
        self._stopping = stopping
        self._drain_s = drain_s
        self._hurries = not drain_s

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
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


class _Draining:
    """Reports a stopping process to health checks, and closes its connections after their current request."""

    def __init__(self, app: ASGIApp, is_leaving: Callable[[], bool]) -> None:
        self._app = app
        self._is_leaving = is_leaving

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        async def say(message: Message) -> None:
            if message["type"] == "http.response.start" and self._is_leaving():
                MutableHeaders(scope=message)["Connection"] = "close"
            await send(message)

        if scope["type"] == "http" and scope["path"] == READY and self._is_leaving():
            await JSONResponse({"status": "stopping"}, 503)(scope, receive, say)
            return
        if scope["type"] == "http":
            scope.setdefault("state", {})[IS_LEAVING] = self._is_leaving  # for answers that go on until they are ended
        await self._app(scope, receive, say)
