"""The OpenAPI document, over HTTP."""

import asyncio
import json

from fastapi import FastAPI, Request, Response
from starlette.concurrency import run_in_threadpool


class ApiDocument:
    """Serves the OpenAPI document of an application; it is built once, when first requested.

    Building takes two seconds of processor time, so it runs in a thread: on the event loop, as FastAPI has it, every
    other request would wait. The requests that wait for it hold no thread.
    """

    def __init__(self, app: FastAPI) -> None:
        self._app = app
        self._building = asyncio.Lock()
        self._body: bytes | None = None

    async def respond(self, _request: Request) -> Response:
        """Return the document as JSON."""
        async with self._building:
            if self._body is None:
                self._body = await run_in_threadpool(self._built)
        return Response(self._body, media_type="application/json")

    def _built(self) -> bytes:
        return json.dumps(self._app.openapi(), ensure_ascii=False, separators=(",", ":")).encode()
