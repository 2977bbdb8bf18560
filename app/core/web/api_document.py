"""The OpenAPI document, over HTTP."""

import asyncio
import json
from typing import Any

from fastapi import FastAPI, Request, Response
from starlette.concurrency import run_in_threadpool

from app.core.web.http import PROBLEM_TYPE, Problem

SCHEMA_REF = "#/components/schemas/{model}"
PROBLEM = {"$ref": SCHEMA_REF.format(model=Problem.__name__)}
PROBLEM_RESPONSE = {
    "description": "Problem details (RFC 9457): the request is refused, or failed.",
    "content": {PROBLEM_TYPE: {"schema": PROBLEM}},
}
FASTAPI_INVALID = "HTTPValidationError", "ValidationError"  # what FastAPI would answer, if error_responses did not


class Application(FastAPI):
    """An application whose OpenAPI document describes the problem details that `error_responses` sends.

    Every operation answers `default` with one shared response. Its description lists the codes that its endpoint
    declares with `problems`; requests may also be refused with codes that belong to no endpoint.
    """

    def openapi(self) -> dict[str, Any]:
        """Return the document, built when first requested."""
        if self.openapi_schema is None:
            document = super().openapi()
            for methods in document["paths"].values():
                for operation in methods.values():
                    _share_problem_response(operation)
            components = document["components"]
            for model in FASTAPI_INVALID:
                components["schemas"].pop(model, None)
            components["responses"] = {Problem.__name__: PROBLEM_RESPONSE}
            self.openapi_schema = document
        return self.openapi_schema


def _share_problem_response(operation: dict[str, Any]) -> None:
    responses: dict[str, dict[str, Any]] = operation["responses"]
    codes = {}
    for status in sorted(responses):
        if _sends(responses[status], Problem.__name__):
            codes[status] = responses.pop(status)["description"]
        elif _sends(responses[status], FASTAPI_INVALID[0]):
            del responses[status]
    if "parameters" in operation or "requestBody" in operation:
        codes["422"] = ", ".join(filter(None, ["`invalid-request`", codes.get("422")]))
    if codes:
        listed = "; ".join(f"{status} {codes[status]}" for status in sorted(codes))
        operation["description"] = f"{operation['description']}\n\nProblem codes: {listed}."
    responses["default"] = {"$ref": f"#/components/responses/{Problem.__name__}"}


def _sends(response: dict[str, Any], model: str) -> bool:
    reference = {"$ref": SCHEMA_REF.format(model=model)}
    return any(media.get("schema") == reference for media in response.get("content", {}).values())


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
