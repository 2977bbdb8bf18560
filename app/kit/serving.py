"""Serves the web application, and drains connections before a stopping process closes its port."""

import gc
import socket
import threading
from collections.abc import Callable

import uvicorn
from starlette.datastructures import MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.kit.memory import collect_garbage
from app.kit.uvicorn_internals import BoundedHttpProtocol, SteppedServer

READY = frozenset({"/readyz", "/readyz/web"})
IS_LEAVING = "is_leaving"
STARTUP_FAILED = 3
GARBAGE_AFTER = 20_000  # objects: a page of the review queue makes as many, and nearly all go without a collector
IDLE_LINE_S = 150  # longer than proxies keep one (Caddy 120 s, nginx 60 s): no request is lost to a closing connection


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
    server = SteppedServer(config, stopping, drain_s)
    try:
        server.run([listening])
    except KeyboardInterrupt:  # the signal that ended it, raised once more
        pass
    finally:
        stopping.set()
    if not server.started:
        raise SystemExit(STARTUP_FAILED)


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

        if scope["type"] == "http" and scope["path"] in READY and self._is_leaving():
            await JSONResponse({"status": "stopping"}, 503)(scope, receive, say)
            return
        if scope["type"] == "http":
            scope.setdefault("state", {})[IS_LEAVING] = self._is_leaving  # for answers that go on until they are ended
        await self._app(scope, receive, say)
