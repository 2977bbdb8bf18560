"""Limits of request bodies: a size for each endpoint, the time that it may take, and bounded JSON."""

import asyncio
import math
import re
from collections.abc import Callable
from typing import Any, TypeVar

from fastapi import HTTPException, Request
from pydantic_core import from_json
from starlette.concurrency import run_in_threadpool
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.core.errors import Invalid, Refused

SMALL_BODY_BYTES = 256 << 10  # a form; the default
LARGE_BODY_BYTES = 8 << 20  # sheets, lists, specs and the text of contracts
REPORT_BODY_BYTES = 16 << 20  # a build's report: 20,000 files
FIRST_S = 20.0  # time allowed for any body, plus the time that its bytes take at LEAST_BYTES_PER_S
LEAST_BYTES_PER_S = 32 << 10
UNITS = ((1 << 30, "GiB"), (1 << 20, "MiB"), (1 << 10, "KiB"))
SUSPECT = re.compile(rb"\\u0000|[0-9]{16}|[eE][+-]?[0-9]{3}")  # NUL, and numbers that may be too large
MANY_NAMES = 50  # in one JSON object: more than the fields of any schema that comes in numbers
MAX_NAMES = 10_000  # in all objects with more; a schema refuses each unknown one by itself, which takes long
LARGEST_INTEGER = 2**53 - 1  # what every reader of JSON keeps exactly (RFC 8259, section 6)


class BodyTooLarge(Refused):
    """The body has more bytes than this route accepts."""

    status = 413


class BodyTooSlow(Refused):
    """The body did not come in time."""

    status = 408


class InvalidRequest(Invalid):
    """The body is no JSON."""


class TooManyNames(Invalid):
    """The large objects of a JSON body have more names than any schema takes."""


class Unstorable(Invalid):
    """A value cannot be stored: a character that databases reject, or a number outside the range of JSON."""


class BodyRefused(HTTPException):
    """Carries a refusal through FastAPI, which reads the body and passes on no other exception."""

    def __init__(self, refusal: Refused) -> None:
        super().__init__(refusal.status, refusal.message)
        self.refusal = refusal


Endpoint = TypeVar("Endpoint", bound=Callable[..., Any])


def accepts_body(limit: int, *, streamed: bool = False) -> Callable[[Endpoint], Endpoint]:
    """Declare the most bytes that an endpoint takes; above SMALL_BODY_BYTES its caller is authenticated first.

    A streamed body is counted only: its endpoint bounds the time that it takes.
    """

    def declare(endpoint: Endpoint) -> Endpoint:
        endpoint.body_limit = limit  # type: ignore[attr-defined]
        endpoint.body_is_streamed = streamed  # type: ignore[attr-defined]
        return endpoint

    return declare


class BodyLimits:
    """Reads the body of a request within the limits of its endpoint, once that endpoint asks for it.

    FastAPI has a `max_body_size` too. Its answer is no problem details and names neither number, and comes after the
    work is done where the endpoint reads no body.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, with a `receive` that raises BodyRefused."""
        length = content_length(scope) if scope["type"] == "http" else 0
        if length == 0:
            await self._app(scope, receive, send)
            return
        receive_again: Receive | None = None

        async def receive_bounded() -> Message:
            nonlocal receive_again
            try:
                if receive_again is None:
                    receive_again = await _bounded(scope, receive, length)
                return await receive_again()
            except Refused as refusal:
                raise BodyRefused(refusal) from None

        await self._app(scope, receive_bounded, send)


async def _bounded(scope: Scope, receive: Receive, length: int | None) -> Receive:
    endpoint = scope.get("endpoint")
    limit = getattr(endpoint, "body_limit", SMALL_BODY_BYTES)
    ensure_fits(length, limit)
    if getattr(endpoint, "body_is_streamed", False):
        return counted(receive, limit)
    request = Request(scope)
    if limit > SMALL_BODY_BYTES and not hasattr(request.state, "actor"):
        await run_in_threadpool(request.app.state.authenticate, request)
    body = await read_whole(receive, length, limit)
    if "json" in request.headers.get("content-type", ""):
        # A large one takes up to two seconds, in which others are to be answered.
        await run_in_threadpool(read_json, body) if len(body) > SMALL_BODY_BYTES else read_json(body)
    whole: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

    async def receive_again() -> Message:
        return whole.pop() if whole else await receive()

    return receive_again


def content_length(scope: Scope) -> int | None:
    """Return the length of the body; 0 where there is none, None where it is known only after reading."""
    for name, value in scope["headers"]:
        if name == b"content-length":
            return int(value[:19]) if value.isdigit() else None
        if name == b"transfer-encoding":
            return None
    return 0


def ensure_fits(length: int | None, limit: int) -> None:
    """Raise BodyTooLarge where it is known before reading that a body has more than `limit` bytes."""
    if length is not None and length > limit:
        raise _too_large(limit, size_in_words(length))


def counted(receive: Receive, limit: int) -> Receive:
    """Return `receive`, which raises BodyTooLarge at the first byte too many; for a body that is streamed."""
    size = 0

    async def receive_counted() -> Message:
        nonlocal size
        message = await receive()
        size += len(message.get("body", b""))
        if size > limit:
            raise _too_large(limit, "more")
        return message

    return receive_counted


async def read_whole(receive: Receive, length: int | None, limit: int) -> bytes:
    """Read a body; raise BodyTooLarge or BodyTooSlow."""
    receive_counted = counted(receive, limit)
    longest_s = FIRST_S + (limit if length is None else length) / LEAST_BYTES_PER_S
    pieces: list[bytes] = []
    try:
        async with asyncio.timeout(longest_s):
            while True:
                message = await receive_counted()
                pieces.append(message.get("body", b""))
                if not message.get("more_body", False):
                    return b"".join(pieces)
    except TimeoutError:
        raise BodyTooSlow(
            f"{size_in_words(sum(map(len, pieces)))} came in {longest_s:.0f} s, and the request was not complete"
        ) from None


def size_in_words(size: int) -> str:
    """Format a number of bytes for people."""
    for unit, name in UNITS:
        if size >= unit:
            return f"{size / unit:.1f}".removesuffix(".0") + f" {name}"
    return f"{size} bytes"


def _too_large(limit: int, received: str) -> BodyTooLarge:
    return BodyTooLarge(
        f"this request may have {size_in_words(limit)}; this one has {received}", fix="send less at once"
    )


def read_json(body: bytes) -> Any:
    """Read JSON; raise InvalidRequest if it is invalid or nested deeper than 200, Unstorable if it cannot be kept."""
    try:
        value = from_json(body, allow_inf_nan=False) if body else None
    except ValueError as error:
        is_deep = str(error).startswith("recursion")
        message = "this is nested deeper than 200 levels" if is_deep else f"this is not valid JSON: {error}"
        raise InvalidRequest(message, errors=[{"where": "", "message": message}]) from None
    if body.count(b":") > MAX_NAMES:
        _ensure_few_names(value)
    if SUSPECT.search(body):  # looking through every value takes longer than reading it
        _ensure_storable(value, "")
    return value


def _ensure_few_names(value: Any) -> None:
    names = 0
    left: list[Any] = [[value]]
    while left:
        node = left.pop()
        if isinstance(node, dict) and len(node) > MANY_NAMES:
            names += len(node)
        values = node.values() if isinstance(node, dict) else node
        left += [child for child in values if isinstance(child, dict | list)]
    if names > MAX_NAMES:
        raise TooManyNames(
            f"objects with more than {MANY_NAMES} names may have {MAX_NAMES:,} together; these have {names:,}"
        )


def _ensure_storable(value: Any, where: str) -> None:
    if isinstance(value, dict):
        for key, member in value.items():
            _ensure_storable(key, f"a name in {where}" if where else "a name")
            _ensure_storable(member, f"{where}.{key}" if where else key)
    elif isinstance(value, list):
        for index, element in enumerate(value):
            _ensure_storable(element, f"{where}.{index}" if where else str(index))
    elif isinstance(value, str) and "\0" in value:
        raise _unstorable(where, "the character U+0000 cannot be stored; take it out")
    elif isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        raise _unstorable(where, f"a whole number may be {LARGEST_INTEGER} at most; this one has more digits")
    elif isinstance(value, float) and math.isinf(value):
        raise _unstorable(where, "a number may be 1.8e308 at most; this one is larger")


def _unstorable(where: str, message: str) -> Unstorable:
    return Unstorable(f"{where}: {message}" if where else message, errors=[{"where": where, "message": message}])
