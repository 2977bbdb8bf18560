"""Serves the web application by Granian: its processes, the limits of a request's head, and how they stop."""

import asyncio
import gc
import multiprocessing
import os
import signal
import socket
import threading
from types import FrameType

from starlette.datastructures import MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

READY = frozenset({"/readyz", "/readyz/web"})
IS_LEAVING = "is_leaving"
HEAD_S = 20  # from the connection, or the answer before, to the last byte of a head: an unused line closes with it
HEAD_BUFFER_BYTES = 64 << 10  # of a line, before a head of more is refused
MAX_LINES = 4_096  # of one process; each open page keeps one
MAX_PROCESS_BYTES = 1 << 30  # a process that holds more is replaced once its requests are answered
GARBAGE_AFTER = 20_000  # objects: a page of the review queue makes as many, and nearly all go without a collector


class PortTaken(Exception):
    """Nothing can listen there: says where, and how to fix it."""


def ensure_port_free(host: str, port: int) -> None:
    """Raise PortTaken where something listens; Granian would share the port with it."""
    family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    with socket.socket(family, kind) as bound:
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            bound.bind(address)
        except OSError as error:
            raise PortTaken(
                f"nothing can listen on {host}:{port} ({error.strerror}); stop what does, or give another --port"
            ) from None


def serve(factory: str, host: str, port: int, *, processes: int, drain_s: float, finish_s: int) -> None:
    """Serve the application of a factory, named `module:function`, until SIGTERM or SIGINT.

    Then go on for `drain_s` as not ready, and give open answers `finish_s` more. A second signal ends the first wait.
    """
    # Here, so that workers and other commands load no server.
    from granian import Granian
    from granian.constants import HTTPModes, Interfaces
    from granian.http import HTTP1Settings
    from granian.log import LogLevels

    ensure_port_free(host, port)
    server = Granian(
        factory,
        host,
        port,
        factory=True,
        interface=Interfaces.ASGI,
        workers=processes,
        http=HTTPModes.http1,
        http1_settings=HTTP1Settings(header_read_timeout=HEAD_S * 1000, max_buffer_size=HEAD_BUFFER_BYTES),
        websockets=False,
        backpressure=MAX_LINES,
        log_level=LogLevels.warning,
        respawn_failed_workers=True,
        workers_max_rss=MAX_PROCESS_BYTES >> 20,
        workers_kill_timeout=finish_s,
    )
    server.on_startup(lambda: _drain_before_stopping(drain_s))
    gc.collect()
    gc.freeze()  # what was imported is shared with the processes that are forked, and never freed
    server.serve()


def _drain_before_stopping(drain_s: float) -> None:
    """Put a wait before what a signal does, in which the processes say that they are leaving."""
    stops = {number: signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGINT)}
    is_leaving = not drain_s

    def stop(number: int, frame: FrameType | None) -> None:
        nonlocal is_leaving
        handler = stops[signal.Signals(number)]
        if not callable(handler):
            return
        if is_leaving:
            handler(number, frame)
            return
        is_leaving = True
        for process in multiprocessing.active_children():
            if process.pid is not None:
                os.kill(process.pid, signal.SIGUSR1)
        waiting = threading.Timer(drain_s, handler, (number, frame))
        waiting.daemon = True
        waiting.start()

    for number in stops:
        signal.signal(number, stop)


class Draining:
    """The application in a process of the server: once it is to leave, health checks and clients are told so.

    A process ends with the one that forked it, however that ended.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self._is_leaving = False

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer; a leaving process closes each line after its request."""
        if scope["type"] == "lifespan":
            asyncio.get_running_loop().add_signal_handler(signal.SIGUSR1, self._leave)
            threading.Thread(target=_stop_with_parent, name="parent", daemon=True).start()
            gc.set_threshold(GARBAGE_AFTER, *gc.get_threshold()[1:])
            await self._app(scope, receive, send)
            return

        async def send_closing(message: Message) -> None:
            if message["type"] == "http.response.start" and self._is_leaving:
                MutableHeaders(scope=message)["Connection"] = "close"
            await send(message)

        if self._is_leaving and scope["path"] in READY:
            await JSONResponse({"status": "stopping"}, 503)(scope, receive, send_closing)
            return
        scope.setdefault("state", {})[IS_LEAVING] = lambda: self._is_leaving  # for answers that have no end
        await self._app(scope, receive, send_closing)

    def _leave(self) -> None:
        self._is_leaving = True


def _stop_with_parent() -> None:
    if (parent := multiprocessing.parent_process()) is not None:
        parent.join()
        os.kill(os.getpid(), signal.SIGKILL)  # nobody is left to bound the wait for open requests
