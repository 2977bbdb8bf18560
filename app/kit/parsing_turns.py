"""Whose turn it is to have something parsed in a web process, and for how many at once."""

from collections import Counter
from collections.abc import Callable
from typing import Any, TypeVar

import anyio
from anyio.lowlevel import RunVar
from fastapi import Request
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.kit.errors import Refused

AT_ONCE = 2  # children of one web process
MOST_WAITING = 8  # for a child: the last one waits for 20 s at most
MOST_OF_ONE_CALLER = 3  # running or waiting

Result = TypeVar("Result")


class ParsingBusy(Refused):
    """The process parses as much as it can at once, for the caller or for everybody."""

    status = 503


class _Turns:
    """Who parses and who waits, in one event loop."""

    def __init__(self) -> None:
        self.free = anyio.CapacityLimiter(AT_ONCE)  # threads of their own, so that those of other requests stay free
        self.of_caller: Counter[str] = Counter()


_TURNS: RunVar[_Turns] = RunVar("parsing_turns")


async def parse_request(
    request: Request,
    function: Callable[..., Result],
    *args: Any,
    refusal: type[Refused],
    permit: Callable[[Session, Any], object],
) -> Result:
    """Return what a function makes of what a request brought, before its transaction begins; see `Parsers.call`.

    `permit` is given a session that reads, and the caller. It raises where they may not send this: nothing is parsed
    for somebody who is not signed in, or may not see what it is for.
    """
    await run_in_threadpool(_ensure_permitted, request, permit)
    caller = repr(request.state.reach)
    try:
        turns = _TURNS.get()
    except LookupError:
        _TURNS.set(turns := _Turns())
    if turns.of_caller[caller] >= MOST_OF_ONE_CALLER or turns.of_caller.total() >= AT_ONCE + MOST_WAITING:
        raise ParsingBusy("the server is reading other files; nothing was done", fix="try again in a few seconds")
    turns.of_caller[caller] += 1
    try:
        parsers = request.app.state.runtime.parsers
        return await anyio.to_thread.run_sync(
            lambda: parsers.call(function, *args, refusal=refusal), limiter=turns.free
        )
    finally:
        turns.of_caller[caller] -= 1
        if not turns.of_caller[caller]:
            del turns.of_caller[caller]


def _ensure_permitted(request: Request, permit: Callable[[Session, Any], object]) -> None:
    actor = request.state.asking()
    with request.app.state.runtime.database.reading(request.state.reach) as session:
        permit(session, actor)
