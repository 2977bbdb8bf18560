"""Serves the web application, and lets a proxy turn away before a process that is told to stop closes its door."""

import contextlib
import gc
import threading
from collections.abc import Callable
from types import FrameType

import uvicorn
from starlette.datastructures import MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

READY = "/readyz"
STARTUP_FAILED = 3
IDLE_LINE_S = 150  # longer than proxies keep one (Caddy 120 s, nginx 60 s): whoever sends last must not lose a request


def serve(app: ASGIApp, *, host: str, port: int, drain_s: float, finish_s: int) -> None:
    """Serve until SIGTERM or SIGINT; then go on for `drain_s` as not ready, and give open answers `finish_s` more."""
    # What the imports made lives for ever; looking through it again would hold up every few answers.
    gc.collect()
    gc.freeze()
    stopping = threading.Event()
    config = uvicorn.Config(
        _Leaving(app, stopping.is_set), host=host, port=port, log_config=None, access_log=False, proxy_headers=False,
        server_header=False, timeout_graceful_shutdown=finish_s, timeout_keep_alive=IDLE_LINE_S,
    )  # fmt: skip
    server = _Server(config, stopping, drain_s)
    with contextlib.suppress(KeyboardInterrupt):  # the signal that ended it, raised once more
        server.run()
    if not server.started:
        raise SystemExit(STARTUP_FAILED)


class _Server(uvicorn.Server):
    """Stops in two steps; a second signal means now."""

    def __init__(self, config: uvicorn.Config, stopping: threading.Event, drain_s: float) -> None:
        super().__init__(config)
        self._stopping = stopping
        self._drain_s = drain_s

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        if self._stopping.is_set() or not self._drain_s:
            super().handle_exit(sig, frame)
            return
        self._stopping.set()
        closing = threading.Timer(self._drain_s, super().handle_exit, (sig, frame))
        closing.daemon = True
        closing.start()


class _Leaving:
    """Once the process is told to stop: says so to health checks, and asks for no further request on a connection."""

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
        await self._app(scope, receive, say)
