"""Shared parts of endpoints: sessions, problem details, idempotency keys, pages."""

from collections.abc import AsyncIterator, Iterator
from contextlib import AbstractContextManager, asynccontextmanager, contextmanager
from datetime import UTC, date, datetime
from typing import Annotated, Any, Generic, TypeVar
from uuid import UUID

import anyio
from fastapi import Depends, Request
from pydantic import BaseModel, ConfigDict, Field
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.core import kill_points
from app.core.access_scope import NOBODY, AccessScope
from app.core.db import Database, bind_reach
from app.core.errors import FieldProblem, Invalid, Refused
from app.core.runtime import Runtime
from app.core.web.concurrency import Slot, limiter
from app.core.web.idempotency import SAFE_METHODS as SAFE_METHODS
from app.core.web.idempotency import claim

PROBLEM_TYPE = "application/problem+json"
Item = TypeVar("Item")


class Schema(BaseModel):
    """The base of every body: unknown keys are refused when reading, attributes are accepted when answering."""

    model_config = ConfigDict(from_attributes=True, extra="forbid", str_strip_whitespace=True)


class Problem(BaseModel):
    """Problem details (RFC 9457); `code` never changes for one condition."""

    type: str = "about:blank"
    title: str
    status: int
    code: str
    detail: str
    fix: str | None = None
    errors: list[FieldProblem] = []
    request_id: str | None = None


def problems(*errors: type[Refused]) -> dict[int | str, dict[str, Any]]:
    """Return the `responses` of an endpoint that can refuse in these ways."""
    by_status: dict[int | str, dict[str, Any]] = {}
    for error in errors:
        responses = by_status.get(error.status)
        codes = f"{responses['description']}, `{error.code()}`" if responses else f"`{error.code()}`"
        by_status[error.status] = {"model": Problem, "description": codes}
    return by_status


def runtime_of(request: Request) -> Runtime:
    """Return the runtime of the running application."""
    runtime: Runtime = request.app.state.runtime
    return runtime


def database_of(request: Request) -> Database:
    """Return the database of the running application."""
    return runtime_of(request).database


async def _runtime(request: Request) -> Runtime:
    return runtime_of(request)  # async, so that no thread is sent for it


CurrentRuntime = Annotated[Runtime, Depends(_runtime)]


def set_reach(request: Request, reach: AccessScope) -> None:
    """Let the request's transaction reach what its caller may see, which is known before it begins."""
    request.state.reach = reach
    session: Session | None = getattr(request.state, "session", None)
    if session is not None:
        bind_reach(session, reach)


async def _upload_slot() -> AsyncIterator[Slot]:
    async with limiter().for_upload() as slot:
        yield slot


# What uploads ask comes behind what people do; for what streams, which gives the seat back before.
UploadSlot = Annotated[Slot, Depends(_upload_slot, scope="function")]


@asynccontextmanager
async def person_slot(request: Request, *, reads: bool) -> AsyncIterator[None]:
    """Hold the slot of a person's request, by the turn of its caller, who is not authenticated yet."""
    async with limiter().for_person(request.app.state.caller_key(request), reads=reads):
        yield


async def _session(request: Request) -> AsyncIterator[Session]:
    async with person_slot(request, reads=request.method in SAFE_METHODS), _ending_in_thread(request) as session:
        yield session


async def _upload_session(request: Request) -> AsyncIterator[Session]:
    async with limiter().for_upload(), _ending_in_thread(request) as session:
        yield session


@asynccontextmanager
async def _ending_in_thread(request: Request) -> AsyncIterator[Session]:
    """Give the transaction of a request, which nothing is sent for before it is used, and end it in a thread."""
    opened: AbstractContextManager[Session] = transaction(request)
    session = request.state.session = opened.__enter__()
    try:
        yield session
    except BaseException as error:
        with anyio.CancelScope(shield=True):
            await run_in_threadpool(opened.__exit__, type(error), error, error.__traceback__)
        raise
    await run_in_threadpool(opened.__exit__, None, None, None)


CLIENT_ADDRESS = "client address"  # of the request, in the information of its session


@contextmanager
def transaction(request: Request) -> Iterator[Session]:
    """Give the transaction of a request."""
    database = database_of(request)
    reach: AccessScope = getattr(request.state, "reach", NOBODY)
    if request.method in SAFE_METHODS:
        with database.reading(reach) as session:
            yield session
        return
    with database.writing(reach) as session:
        session.info[CLIENT_ADDRESS] = request.client.host if request.client else ""
        claim(request, session)
        yield session
    kill_points.point("http.after_commit")


# Committed before the answer leaves, so a failed commit cannot have answered 201.
DbSession = Annotated[Session, Depends(_session, scope="function")]
UploadSession = Annotated[Session, Depends(_upload_session, scope="function")]  # of what an upload becomes


class Page(BaseModel, Generic[Item]):
    """One page of a list; `next` is the cursor of the following page, null at the end."""

    items: list[Item]  # a sequence would be made into Python values before it is made into JSON
    next: str | None = None


class BadCursor(Invalid):
    """The page cursor is not one of ours."""


LARGEST_NUMBER = 2**31 - 1  # what an integer column holds on both databases
Whole = Annotated[int, Field(ge=-LARGEST_NUMBER, le=LARGEST_NUMBER)]


def number_in(text: str, largest: int = LARGEST_NUMBER) -> int | None:
    """Return the whole number that a text is; None for any other text, for a larger one, and for digits like ²."""
    if not (text.isascii() and text.isdecimal() and len(text) <= len(str(largest))):
        return None
    number = int(text)
    return number if number <= largest else None


def cursor_of(*values: str | int | UUID | None) -> str:
    """Pack the sort key of the last row of a page."""
    return ".".join("" if value is None else str(value) for value in values)


def bad_cursor(cursor: str) -> BadCursor:
    """Return the error for an invalid cursor."""
    return BadCursor(f"{cursor[:60]!r} is not a page cursor; use the `next` of the page before")


def uuid_cursor(cursor: str | None) -> UUID | None:
    """Read a cursor that is one id."""
    if cursor is None:
        return None
    try:
        return UUID(cursor)
    except ValueError:
        raise bad_cursor(cursor) from None


def number_cursor(cursor: str | None) -> int | None:
    """Read a cursor that is one number."""
    if cursor is None:
        return None
    if (number := number_in(cursor)) is None:
        raise bad_cursor(cursor)
    return number


def numbers_cursor(cursor: str | None, *, count: int) -> tuple[int, ...] | None:
    """Read a cursor that is some numbers, such as a position and a number."""
    if cursor is None:
        return None
    numbers = tuple(number for part in cursor.split(".") if (number := number_in(part)) is not None)
    if len(numbers) != count or cursor.count(".") != count - 1:
        raise bad_cursor(cursor)
    return numbers


def place_cursor(cursor: str | None) -> tuple[int, int] | None:
    """Read a cursor that is a position and a number."""
    numbers = numbers_cursor(cursor, count=2)
    return None if numbers is None else (numbers[0], numbers[1])


def instant_cursor(cursor: str | None) -> tuple[datetime, UUID] | None:
    """Read a cursor that is an instant with its zone and an id."""
    if cursor is None:
        return None
    at, _, id_ = cursor.rpartition(".")
    try:
        instant = datetime.fromisoformat(at)
        if instant.tzinfo is None:
            raise ValueError(at)
        return instant.astimezone(UTC), UUID(id_)
    except (ValueError, OverflowError):
        raise bad_cursor(cursor) from None


def day_cursor(cursor: str | None) -> tuple[date, UUID] | None:
    """Read a cursor that is a day and an id."""
    if cursor is None:
        return None
    day, _, id_ = cursor.partition(".")
    try:
        return date.fromisoformat(day), UUID(id_)
    except ValueError:
        raise bad_cursor(cursor) from None
