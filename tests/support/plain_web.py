"""An application that needs nothing, in the processes of the server as they are."""

import asyncio
import os
from collections.abc import AsyncIterator

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, StreamingResponse
from starlette.routing import Route
from starlette.types import ASGIApp

from app.core.web.serving import Draining

SLOW_S = 1.0


async def _process(_request: Request) -> PlainTextResponse:
    return PlainTextResponse(str(os.getpid()))


async def _slow(_request: Request) -> StreamingResponse:
    async def late() -> AsyncIterator[str]:
        yield "begun, "
        await asyncio.sleep(SLOW_S)
        yield "ended"

    return StreamingResponse(late())


async def _endless(request: Request) -> PlainTextResponse:
    await request.body()  # of which the rest never comes
    return PlainTextResponse("read")


def application() -> ASGIApp:
    """Return the application of one process."""
    paths = {"/": _process, "/readyz": _process, "/slow": _slow, "/endless": _endless}
    return Draining(Starlette(routes=[Route(path, answer, methods=["GET", "PUT"]) for path, answer in paths.items()]))
