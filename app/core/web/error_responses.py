"""Refusals and failures as problem details, and the id and log line of every request."""

import itertools
import re
import time
from collections.abc import Callable, Sequence
from typing import Any

import structlog
from fastapi import FastAPI, HTTPException, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from sqlalchemy.exc import DBAPIError, IntegrityError, SQLAlchemyError
from sqlalchemy.exc import TimeoutError as PoolTimeout
from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException as StarletteHTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app import logs
from app.core import metrics
from app.core.db import is_conflict, is_full, is_unavailable, new_id
from app.core.errors import FieldProblem, Refused
from app.core.plural import verb
from app.core.web.bodies import BodyLimits, BodyRefused, BodyTooLarge, BodyTooSlow
from app.core.web.http import PROBLEM_TYPE, Problem
from app.core.web.idempotency import SAFE_METHODS, IdempotentWrites, Replayed, RightsOf

METHODS = SAFE_METHODS | {"POST", "PUT", "PATCH", "DELETE"}
REQUEST_ID = re.compile(r"[A-Za-z0-9._:-]{8,128}")
MAX_ERRORS = 100  # of one body, in one answer
UNLOGGED_ROUTES = frozenset({"/healthz", "/readyz", "/readyz/web", "/metrics"})  # asked every few seconds by machines
UNAVAILABLE_RETRY_S = 5  # the Retry-After while the database is unavailable
log = structlog.get_logger(__name__)


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
    app: FastAPI,
    *,
    credential_cookies: Sequence[str],
    rights_of: RightsOf = lambda _session, _caller: frozenset(),
    caller_key: Callable[[Request], str] = lambda _request: "",
    authenticate: Callable[[Request], object] = lambda _request: None,
) -> None:
    """Install error answers and request ids; name the cookies and rights that identify callers."""
    app.state.caller_key = caller_key
    app.state.authenticate = authenticate
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

    @app.exception_handler(BodyRefused)
    def _body_refused(request: Request, error: BodyRefused) -> JSONResponse:
        return _refused(request, error.refusal)

    @app.exception_handler(Replayed)
    def _replayed(_request: Request, error: Replayed) -> Response:
        return error.answer

    @app.exception_handler(RequestValidationError)
    def _invalid(request: Request, error: RequestValidationError) -> JSONResponse:
        errors: list[FieldProblem] = [
            {
                "where": ".".join(str(part) for part in e["loc"] if part != "body"),
                "message": _in_words(e),
            }
            for e in itertools.islice(error.errors(), MAX_ERRORS)
        ]
        if (more := len(error.errors()) - MAX_ERRORS) > 0:
            errors.append(
                {"where": "", "message": f"{more:,} more of this request {verb(more, 'is', 'are')} not listed"}
            )
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
            attempt = getattr(request.state, "attempt", None)
            if isinstance(error, IntegrityError) and attempt is not None and attempt.saved_response is not None:
                raise error  # perhaps a duplicate request: IdempotentWrites looks for its saved answer
            log.warning("two changes at the same time", error=str(error))
            detail = "someone changed the same thing at the same moment; your change was not saved"
            return _problem(request, 409, "crossed", detail, fix="reload, then make your change again")
        if is_full(error):
            log.error("the database is full", error=str(error))
            detail = "the server's disk is full; your change was not saved"
            return _problem(
                request, 507, "disk-full", detail, fix="ask the operator to free disk space, then try again"
            )
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

    app.add_middleware(BodyLimits)
    app.add_middleware(IdempotentWrites)
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
        case "uuid_parsing" | "uuid_type":
            return "this is not an id"
        case "enum" | "literal_error":
            return f"{_shown(given)} is none of {limits['expected']}"
    return str(error["msg"]).removeprefix("Value error, ")


def _shown(given: Any) -> str:
    return repr(given)[:60]
