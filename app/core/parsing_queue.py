"""The queue of parsing jobs of a web process, with limits in total and per caller."""

from collections import Counter
from collections.abc import Callable
from typing import Any, TypeVar
from uuid import UUID

import anyio
from anyio.lowlevel import RunVar
from fastapi import Request
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.core.errors import Refused

MAX_CONCURRENT = 2  # children of one web process
MAX_WAITING = 8  # for a child: the last one waits for 20 s at most
MAX_PER_CALLER = 3  # running or waiting

Result = TypeVar("Result")


class ParsingBusy(Refused):
    """The queue is full, for this caller or for the process."""

    status = 503


class _ParsingSlots:
    """Running and waiting parsing jobs of one event loop."""

    def __init__(self) -> None:
        self.free = anyio.CapacityLimiter(MAX_CONCURRENT)  # separate threads, so that those of other requests stay free
        self.of_caller: Counter[str] = Counter()


_PARSING_SLOTS: RunVar[_ParsingSlots] = RunVar("parsing_turns")


async def parse_request(
    request: Request,
    function: Callable[..., Result],
    *args: Any,
    refusal: type[Refused],
    permit: Callable[[Session, Any, UUID], object],
    whose: UUID,
) -> Result:
    """Parse a request's data before its transaction begins; see `Parsers.call`.

    `permit` is given a session that reads, the caller, and the id of the project or studio that `whose` names. It
    raises if they may not send this there: nothing is parsed for callers who are not signed in, or may not see
    the project or studio. An endpoint names its policy first, then what calls this, and its session last.
    """
    if hasattr(request.state, "session"):
        raise AssertionError("a parse would hold the slot of the request's session: let the session come after it")
    await run_in_threadpool(_ensure_permitted, request, permit, whose)
    caller = repr(request.state.reach)
    try:
        slots = _PARSING_SLOTS.get()
    except LookupError:
        _PARSING_SLOTS.set(slots := _ParsingSlots())
    if slots.of_caller[caller] >= MAX_PER_CALLER or slots.of_caller.total() >= MAX_CONCURRENT + MAX_WAITING:
        raise ParsingBusy("the server is reading other files; nothing was done", fix="try again in a few seconds")
    slots.of_caller[caller] += 1
    try:
        parsers = request.app.state.runtime.parsers
        return await anyio.to_thread.run_sync(
            lambda: parsers.call(function, *args, refusal=refusal), limiter=slots.free
        )
    finally:
        slots.of_caller[caller] -= 1
        if not slots.of_caller[caller]:
            del slots.of_caller[caller]


def _ensure_permitted(request: Request, permit: Callable[[Session, Any, UUID], object], whose: UUID) -> None:
    with request.app.state.runtime.database.reading(request.state.reach) as session:
        permit(session, request.state.actor, whose)
