"""Idempotency keys: a write that comes again is answered with what was saved, if its caller still may ask for it."""

import hashlib
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa
from fastapi import Request, Response
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Mapped, Session, mapped_column
from starlette.concurrency import run_in_threadpool
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.kit import clock
from app.kit.db import Base, Database
from app.kit.errors import Conflict, Forbidden, NotFound
from app.kit.single_thread_route import Authentication

SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
MAX_SAVED_BYTES = 256 << 10  # a longer answer is not saved
KEPT_FOR = timedelta(days=2)  # clients try again within minutes

# A caller's rights, as "place:id:right"; a caller who lost one gets no answer saved under it.
RightsOf = Callable[[Session, Any], frozenset[str]]


class IdempotencyKeyReused(Conflict):
    """The same Idempotency-Key came with another request."""


class AlreadyProcessed(Conflict):
    """The request with this Idempotency-Key was carried out; its answer was not kept."""


class NoLongerExists(NotFound):
    """The request was carried out, and its caller has left the studio or project since."""


class NoLongerAllowed(Forbidden):
    """The request was carried out, and its caller has lost a role since."""


class SavedResponse(Base):
    """The answer to a write that carried an Idempotency-Key, written in the write's own transaction."""

    __tablename__ = "kit_saved_responses"

    key: Mapped[str] = mapped_column(primary_key=True)  # hash of caller, method, path and Idempotency-Key
    request_sha256: Mapped[str]
    status: Mapped[int | None]
    media_type: Mapped[str | None]
    body: Mapped[str | None]
    rights: Mapped[str | None]  # of the caller once it was carried out; with spaces between
    created_at: Mapped[datetime] = mapped_column(default=clock.now, index=True)


def once(route: ASGIApp, authentication: Authentication | None) -> ASGIApp:
    """Return the route, which does a write with an Idempotency-Key once however often it comes."""

    async def answer_once(scope: Scope, receive: Receive, send: Send) -> None:
        request = Request(scope, receive)
        given = request.headers.get("idempotency-key")
        is_json = request.headers.get("content-type", "application/json").startswith("application/json")
        if given is None or request.method in SAFE_METHODS or not is_json:
            await route(scope, receive, send)
            return
        body = await request.body()
        credentials = [request.cookies.get(name, "") for name in request.app.state.credential_cookies]
        caller = "\0".join([request.headers.get("authorization", ""), *credentials])
        key = _digest(caller, request.method, str(request.url), given)
        request_sha256 = hashlib.sha256(body).hexdigest()
        database: Database = request.app.state.runtime.database
        if (saved := await run_in_threadpool(_saved, database, key)) is not None:
            answer = await run_in_threadpool(_replay, request, authentication, saved, request_sha256)
            await answer(scope, receive, send)
            return
        request.state.saved_response = SavedResponse(key=key, request_sha256=request_sha256)
        heard: list[Message] = []
        unread: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

        async def receive_again() -> Message:
            return unread.pop() if unread else await receive()

        async def hear(message: Message) -> None:
            heard.append(message)

        try:
            await route(scope, receive_again, hear)
        except IntegrityError:
            if (saved := await run_in_threadpool(_saved, database, key)) is None:
                request.state.saved_response = None
                raise
            # A duplicate of this request was faster.
            answer = await run_in_threadpool(_replay, request, authentication, saved, request_sha256)
            await answer(scope, receive, send)
            return
        await run_in_threadpool(_keep, request, key, heard)
        for message in heard:
            await send(message)

    return answer_once


def delete_expired_responses(database: Database) -> None:
    """Delete expired answers."""
    with database.writing() as session:
        session.execute(sa.delete(SavedResponse).where(SavedResponse.created_at < clock.now() - KEPT_FOR))


def _digest(*parts: str) -> str:
    return hashlib.sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()


def _saved(database: Database, key: str) -> SavedResponse | None:
    with database.reading() as session:
        return session.get(SavedResponse, key)


def _keep(request: Request, key: str, heard: Sequence[Message]) -> None:
    caller = getattr(getattr(request.state, "lazy_authentication", None), "caller", None)
    database: Database = request.app.state.runtime.database
    with database.writing() as session:
        saved = session.get(SavedResponse, key)
        if saved is None:  # the request was refused, and may be tried again
            return
        headers = {bytes(name).lower(): bytes(value) for name, value in heard[0].get("headers", [])}
        saved.status = heard[0]["status"]
        saved.media_type = headers.get(b"content-type", b"application/json").decode()
        saved.rights = " ".join(sorted(request.app.state.rights_of(session, caller)))
        body = b"".join(message.get("body", b"") for message in heard[1:])
        if len(body) <= MAX_SAVED_BYTES:
            saved.body = body.decode()


def _replay(
    request: Request, authentication: Authentication | None, saved: SavedResponse, request_sha256: str
) -> Response:
    """Return the saved answer, or raise what its caller is refused by now."""
    caller = None if authentication is None else authentication.authenticate(request)
    if saved.request_sha256 != request_sha256:
        raise IdempotencyKeyReused(
            "this Idempotency-Key was used before with another body; use a new key for a new request"
        )
    with request.app.state.runtime.database.reading() as session:
        _ensure_still_may((saved.rights or "").split(), request.app.state.rights_of(session, caller))
    if saved.status is None or saved.body is None:
        raise AlreadyProcessed("this request was carried out before; read the list to see what it made")
    answer = Response(saved.body, status_code=saved.status, media_type=saved.media_type)
    answer.headers["Idempotent-Replayed"] = "true"
    return answer


def _ensure_still_may(then: Iterable[str], now: frozenset[str]) -> None:
    lost = set(then) - now
    places = {right.rpartition(":")[0] for right in now}
    if any(right.rpartition(":")[0] not in places for right in lost):
        raise NoLongerExists("this request was carried out before you left; nothing is here for you now")
    if lost:
        raise NoLongerAllowed("this request was carried out when you had more rights; ask the producer for them")
