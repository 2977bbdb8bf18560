"""Limits of request bodies: a size for each route, checked before and while the body is read, and bounded JSON."""

import asyncio
import math
import re
from json import JSONDecodeError
from typing import Any

from fastapi import Request
from pydantic_core import from_json
from starlette.concurrency import run_in_threadpool
from starlette.types import Message, Receive, Scope

from app.kit.errors import Invalid, Refused

# A route declares its `max_body_size`; above SMALL the caller is authenticated before the first byte is read.
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


class TooManyNames(Invalid):
    """The large objects of a JSON body have more names than any schema takes."""


class Unstorable(Invalid):
    """A value cannot be stored: a character that databases reject, or a number outside the range of JSON."""


def content_length(scope: Scope) -> int | None:
    """Return how long the body is; 0 where there is none, None where it is known only after reading."""
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


async def read_whole(receive: Receive, length: int | None, limit: int) -> Receive:
    """Read a body, and return a `receive` that gives it again; raise BodyTooLarge or BodyTooSlow."""
    receive_counted = counted(receive, limit)
    longest_s = FIRST_S + (limit if length is None else length) / LEAST_BYTES_PER_S
    pieces: list[bytes] = []
    try:
        async with asyncio.timeout(longest_s):
            while True:
                message = await receive_counted()
                pieces.append(message.get("body", b""))
                if not message.get("more_body", False):
                    break
    except TimeoutError:
        raise BodyTooSlow(
            f"{size_in_words(sum(map(len, pieces)))} came in {longest_s:.0f} s, and the request was not complete"
        ) from None
    whole: Message | None = message if len(pieces) == 1 else {"type": "http.request", "body": b"".join(pieces)}

    async def receive_again() -> Message:
        nonlocal whole
        if whole is None:
            return await receive()
        again, whole = whole, None
        return again

    return receive_again


def size_in_words(size: int) -> str:
    """Format a number of bytes for people."""
    for unit, name in UNITS:
        if size >= unit:
            return f"{size / unit:.1f}".removesuffix(".0") + f" {name}"
    return f"{size} bytes"


def _too_large(limit: int, found: str) -> BodyTooLarge:
    return BodyTooLarge(f"this request may have {size_in_words(limit)}; this one has {found}", fix="send less at once")


class JsonRequest(Request):
    """A request whose JSON is bounded in depth, in its integers and in the characters of its texts."""

    async def json(self) -> Any:
        """Read the body; invalid JSON, or JSON nested deeper than 200, is a JSONDecodeError."""
        if not hasattr(self, "_json"):
            body = await self.body()
            is_small = len(body) <= SMALL_BODY_BYTES
            # A large one takes up to two seconds, in which others are to be answered.
            self._json = read_json(body) if is_small else await run_in_threadpool(read_json, body)
        return self._json


def read_json(body: bytes) -> Any:
    """Read JSON; raise JSONDecodeError if it is invalid or nested too deep, Unstorable if a database rejects it."""
    try:
        value = from_json(body, allow_inf_nan=False)
    except ValueError as error:
        raise JSONDecodeError(str(error), "", 0) from None
    if body.count(b":") > MAX_NAMES:
        _ensure_few_names(value)
    if SUSPECT.search(body):  # looking through every value takes longer than reading it
        _ensure_storable(value, "")
    return value


def _ensure_few_names(value: Any) -> None:
    names = 0
    left: list[Any] = [[value]]
    while left:
        one = left.pop()
        if isinstance(one, dict) and len(one) > MANY_NAMES:
            names += len(one)
        values = one.values() if isinstance(one, dict) else one
        left += [each for each in values if isinstance(each, dict | list)]
    if names > MAX_NAMES:
        raise TooManyNames(
            f"objects with more than {MANY_NAMES} names may have {MAX_NAMES:,} together; these have {names:,}"
        )


def _ensure_storable(value: Any, where: str) -> None:
    if isinstance(value, dict):
        for key, one in value.items():
            _ensure_storable(key, f"a name in {where}" if where else "a name")
            _ensure_storable(one, f"{where}.{key}" if where else key)
    elif isinstance(value, list):
        for place, one in enumerate(value):
            _ensure_storable(one, f"{where}.{place}" if where else str(place))
    elif isinstance(value, str) and "\0" in value:
        raise _unstorable(where, "the character U+0000 cannot be stored; take it out")
    elif isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        raise _unstorable(where, f"a whole number may be {LARGEST_INTEGER} at most; this one has more digits")
    elif isinstance(value, float) and math.isinf(value):
        raise _unstorable(where, "a number may be 1.8e308 at most; this one is larger")


def _unstorable(where: str, message: str) -> Unstorable:
    return Unstorable(f"{where}: {message}" if where else message, errors=[{"where": where, "message": message}])
