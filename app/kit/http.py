"""Shared parts of endpoints: sessions, problem details, idempotency keys, request ids, pages."""

import itertools
import re
import time
from collections.abc import AsyncIterator, Iterator, Sequence
from contextlib import AbstractAsyncContextManager, contextmanager
from datetime import UTC, datetime
from functools import cached_property, partial
from typing import Annotated, Any, Generic, TypeVar
from uuid import UUID

import structlog
from fastapi import APIRouter, Depends, FastAPI, HTTPException, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from fastapi.routing import APIRoute
from pydantic import BaseModel, ConfigDict, Field
from sqlalchemy.exc import DBAPIError, IntegrityError, SQLAlchemyError
from sqlalchemy.exc import TimeoutError as PoolTimeout
from sqlalchemy.orm import Session
from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException as StarletteHTTPException
from starlette.routing import Match, compile_path
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app import logs
from app.kit import kill_points, metrics
from app.kit.bodies import BodyTooLarge, BodyTooSlow
from app.kit.concurrency import Slot, limiter
from app.kit.db import Database, is_conflict, is_unavailable, new_id
from app.kit.errors import FieldProblem, Invalid, Refused
from app.kit.idempotency import SAFE_METHODS as SAFE_METHODS
from app.kit.idempotency import RightsOf, SavedResponse, once
from app.kit.reach import NOBODY, Reach
from app.kit.runtime import Runtime
from app.kit.single_thread_route import LazySession, SingleThreadRoute

METHODS = SAFE_METHODS | {"POST", "PUT", "PATCH", "DELETE"}
GROUP_NAME = re.compile(r"\?P<\w+>")
REQUEST_ID = re.compile(r"[A-Za-z0-9._:-]{8,128}")
MAX_ERRORS = 100  # of one body, in one answer
UNLOGGED_ROUTES = frozenset({"/healthz", "/readyz", "/metrics"})  # asked every few seconds by machines
PROBLEM_TYPE = "application/problem+json"
UNAVAILABLE_RETRY_S = 5  # the Retry-After while the database is unavailable
log = structlog.get_logger(__name__)
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
        known = by_status.get(error.status)
        codes = f"{known['description']}, `{error.code()}`" if known else f"`{error.code()}`"
        by_status[error.status] = {"model": Problem, "description": codes}
    return by_status


def runtime_of(request: Request) -> Runtime:
    """Return what the running application was wired with."""
    runtime: Runtime = request.app.state.runtime
    return runtime


def database_of(request: Request) -> Database:
    """Return the database of the running application."""
    return runtime_of(request).database


async def _runtime(request: Request) -> Runtime:
    return runtime_of(request)  # async, so that no thread is sent for it


CurrentRuntime = Annotated[Runtime, Depends(_runtime)]


def set_reach(request: Request, reach: Reach) -> None:
    """Let the request's transaction reach what its caller may see, which is known before it begins."""
    request.state.reach = reach


async def _upload_slot() -> AsyncIterator[Slot]:
    async with limiter().for_upload() as slot:
        yield slot


# What uploads ask comes behind what people do; for what streams, which gives the seat back before.
UploadSlot = Annotated[Slot, Depends(_upload_slot, scope="function")]


def set_caller(request: Request, caller: str) -> None:
    """Name the caller by whose turn the request runs, before it is authenticated."""
    request.state.caller = caller


def person_slot(request: Request, *, reads: bool) -> AbstractAsyncContextManager[None]:
    """Return the slot of a person's request."""
    return limiter().for_person(getattr(request.state, "caller", ""), reads=reads)


async def _session(request: Request) -> LazySession:
    return LazySession(
        partial(person_slot, request, reads=request.method in SAFE_METHODS), partial(transaction, request)
    )


async def _upload_session(request: Request) -> LazySession:
    return LazySession(limiter().for_upload, partial(transaction, request))


@contextmanager
def transaction(request: Request) -> Iterator[Session]:
    """Give the transaction of a request, in the thread that it is used in."""
    database = database_of(request)
    reach: Reach = getattr(request.state, "reach", NOBODY)
    if request.method in SAFE_METHODS:
        with database.reading(reach) as session:
            yield session
        return
    with database.writing(reach) as session:
        pending: SavedResponse | None = getattr(request.state, "saved_response", None)
        if pending is not None:
            session.add(pending)
            session.flush()
        yield session
    kill_points.point("http.after_commit")


# The route opens it and commits before the answer leaves, so a failed commit cannot have answered 201.
DbSession = Annotated[Session, Depends(_session)]
UploadSession = Annotated[Session, Depends(_upload_session)]  # of what an upload becomes


class Route(SingleThreadRoute):
    """A route that replays the saved answer when a write comes again with the same Idempotency-Key."""

    async def answer(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer; out here, around the whole route, its transaction has been committed when the answer passes."""
        await once(super().answer, self.authentication)(scope, receive, send)


class Router(APIRouter):
    """A room's routes, which one look at an address rules out together: most requests are for other rooms."""

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Return whether any of them is requested."""
        return super().matches(scope) if self._addresses.match(scope["path"]) else (Match.NONE, {})

    @cached_property
    def _addresses(self) -> re.Pattern[str]:
        return re.compile("|".join(GROUP_NAME.sub("?:", compile_path(path)[0].pattern) for path in _paths(self)))


def _paths(router: APIRouter) -> Iterator[str]:
    for route in router.routes:
        if isinstance(route, APIRoute):
            yield route.path
        else:
            within: Any = route  # what FastAPI keeps of a router that another one includes
            if isinstance(within.original_router, Router):
                raise TypeError("a router within a Router does not know its whole addresses: make it an APIRouter")
            yield from (f"{router.prefix}{path}" for path in _paths(within.original_router))


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
    return BadCursor(f"{cursor[:60]!r} is no page cursor; use the `next` of the page before")


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


def place_cursor(cursor: str | None) -> tuple[int, int] | None:
    """Read a cursor that is a position and a number."""
    if cursor is None:
        return None
    before, _, after = cursor.partition(".")
    position, number = number_in(before), number_in(after)
    if position is None or number is None:
        raise bad_cursor(cursor)
    return position, number


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


def _problem(request: Request, status: int, code: str, detail: str, **more: Any) -> JSONResponse:
    problem = Problem(
        title=code.replace("-", " ").capitalize(),
        status=status,
        code=code,
        detail=detail,
        request_id=getattr(request.state, "request_id", None),
        **more,
    )
    headers = {"WWW-Authenticate": "Bearer"} if status == 401 else None
    return JSONResponse(problem.model_dump(mode="json"), status, headers, media_type=PROBLEM_TYPE)


def install(
    app: FastAPI, *, credential_cookies: Sequence[str], rights_of: RightsOf = lambda _session, _caller: frozenset()
) -> None:
    """Install error answers and request ids; name the cookies and rights that identify callers."""
    app.state.credential_cookies = credential_cookies
    app.state.rights_of = rights_of

    @app.exception_handler(Refused)
    def _refused(request: Request, error: Refused) -> JSONResponse:
        answer = _problem(request, error.status, error.code(), error.message, errors=error.errors, fix=error.fix)
        wait_s = UNAVAILABLE_RETRY_S if error.status == 503 else error.retry_after_s
        if wait_s is not None:
            answer.headers["Retry-After"] = str(wait_s)
        if isinstance(error, BodyTooLarge | BodyTooSlow):
            answer.headers["Connection"] = "close"  # the rest is not read
        return answer

    @app.exception_handler(RequestValidationError)
    def _invalid(request: Request, error: RequestValidationError) -> JSONResponse:
        errors: list[FieldProblem] = [
            {
                "where": ""
                if e["type"] == "json_invalid"
                else ".".join(str(part) for part in e["loc"] if part != "body"),
                "message": _in_words(e),
            }
            for e in itertools.islice(error.errors(), MAX_ERRORS)
        ]
        if (more := len(error.errors()) - MAX_ERRORS) > 0:
            errors.append({"where": "", "message": f"{more:,} more of this request are not listed"})
        detail = "; ".join(f"{e['where']}: {e['message']}" if e["where"] else e["message"] for e in errors[:5])
        return _problem(request, 422, "invalid-request", detail, errors=errors)

    @app.exception_handler(StarletteHTTPException)
    def _http(request: Request, error: HTTPException) -> JSONResponse:
        code = {404: "not-found", 405: "method-not-allowed", 413: "too-large"}.get(error.status_code, "http-error")
        return _problem(request, error.status_code, code, str(error.detail))

    @app.exception_handler(DBAPIError)
    @app.exception_handler(PoolTimeout)
    def _away(request: Request, error: SQLAlchemyError) -> JSONResponse:
        if is_conflict(error):
            if isinstance(error, IntegrityError) and getattr(request.state, "saved_response", None) is not None:
                raise error  # perhaps a duplicate request: the idempotency route looks for its saved answer
            log.warning("two changes at the same time", error=str(error))
            detail = "someone changed the same thing at the same moment; your change was not saved"
            return _problem(request, 409, "crossed", detail, fix="reload, then make your change again")
        if not is_unavailable(error):
            raise error
        log.warning("the database does not answer", error=str(error))
        detail, fix = "the database does not answer", "try again in a few seconds"
        if request.method not in SAFE_METHODS:  # the connection may have dropped before the commit was confirmed
            detail += "; it is not known whether your change was saved"
            fix = "check whether it was saved before you send it again; with the same Idempotency-Key it is done once"
        answer = _problem(request, 503, "database-away", detail, fix=fix)
        answer.headers["Retry-After"] = str(UNAVAILABLE_RETRY_S)
        return answer

    @app.exception_handler(Exception)
    def _broken(request: Request, _error: Exception) -> JSONResponse:
        answer = _problem(request, 500, "our-fault", "This is our fault; Nothing was partly saved.")
        # This answer is made outside all middleware below.
        answer.headers["X-Request-ID"] = getattr(request.state, "request_id", "")
        answer.headers.update(getattr(app.state, "security_headers", {}) | {"Cache-Control": "no-store"})
        return answer

    app.add_middleware(_Watched)


NUL_IN_ADDRESS = Problem(
    title="Bad address",
    status=400,
    code="bad-address",
    detail="the address holds the character U+0000 (%00), which no name here contains",
).model_dump(mode="json")


class _Watched:
    """Gives every request its id, counts and times it, and logs how it ended."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        begun, status = time.perf_counter(), 500
        if "\0" in scope["path"] or b"%00" in scope["query_string"]:
            answer = JSONResponse(NUL_IN_ADDRESS, 400, media_type=PROBLEM_TYPE)
            await answer(scope, receive, send)
            return
        request_id = _request_id(scope)
        scope.setdefault("state", {})["request_id"] = request_id

        async def say(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                MutableHeaders(scope=message)["X-Request-ID"] = request_id
            await send(message)

        with logs.bound({logs.REQUEST_ID: request_id}), metrics.IN_FLIGHT.track_inprogress():
            try:
                await self._app(scope, receive, say)
            except Exception:
                log.exception("request failed", method=scope["method"], route=_route(scope))
                raise
            finally:
                taken_s = time.perf_counter() - begun
                method, route = _method(scope), _route(scope)
                metrics.REQUESTS.labels(method, route, str(status)).inc()
                metrics.REQUEST_S.labels(method, route).observe(taken_s)
                if route not in UNLOGGED_ROUTES:
                    log.info("request", method=method, route=route, status=status, seconds=round(taken_s, 4))


def _request_id(scope: Scope) -> str:
    """Return the id that a proxy or client gave the request, or a new one if it gave none that is safe in a log."""
    given = Headers(scope=scope).get("x-request-id", "")
    return given if REQUEST_ID.fullmatch(given) else str(new_id())


def _method(scope: Scope) -> str:
    return scope["method"] if scope["method"] in METHODS else "other"


def _route(scope: Scope) -> str:
    """Return the path as the route declares it: an address may hold a secret, and there are too many for metrics."""
    return getattr(scope.get("route"), "path", "none")


def _in_words(error: Any) -> str:
    given, limits = error.get("input"), error.get("ctx", {})
    match error["type"]:
        case "missing":
            return "this is required"
        case "extra_forbidden":
            return "unknown field"
        case "string_too_short":
            return "this must not be empty" if not given else f"at least {limits['min_length']} characters are wanted"
        case "string_too_long":
            return f"this has {len(given)} characters; at most {limits['max_length']} are taken"
        case "json_invalid" if limits["error"].startswith("recursion"):
            return "this is nested deeper than 200 levels"
        case "json_invalid":
            return f"this is not valid JSON: {limits['error']}"
        case "uuid_parsing" | "uuid_type":
            return "this is not an id"
        case "enum" | "literal_error":
            return f"{_shown(given)} is none of {limits['expected']}"
    return str(error["msg"]).removeprefix("Value error, ")


def _shown(given: Any) -> str:
    return repr(given)[:60]
