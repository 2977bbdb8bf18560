"""Idempotency keys: a write that comes again is answered with what was saved, if its caller still may ask for it."""

import hashlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa
from fastapi import Depends, Request, Response
from sqlalchemy.exc import DBAPIError, IntegrityError
from sqlalchemy.orm import Mapped, Session, mapped_column
from starlette.concurrency import run_in_threadpool
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.core import clock
from app.core.db import Base, Database
from app.core.errors import Conflict, Forbidden, NotFound
from app.core.web.bodies import content_length

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

    __tablename__ = "core_saved_responses"

    key: Mapped[str] = mapped_column(primary_key=True)  # hash of caller, method, path and Idempotency-Key
    request_sha256: Mapped[str]
    status: Mapped[int | None]
    media_type: Mapped[str | None]
    body: Mapped[str | None]
    rights: Mapped[str | None]  # of the caller once it was carried out; with spaces between
    created_at: Mapped[datetime] = mapped_column(default=clock.now, index=True)


class Replayed(Exception):
    """The request was answered before; carries that answer."""

    def __init__(self, answer: Response) -> None:
        super().__init__()
        self.answer = answer


@dataclass
class Attempt:
    """One request that carries an Idempotency-Key."""

    key: str
    body_sha256: Any = field(default_factory=hashlib.sha256)  # of what has been read so far
    received: list[Message] = field(default_factory=list)
    saved_response: SavedResponse | None = None  # written in the request's transaction


class IdempotentWrites:
    """Does a write with an Idempotency-Key once, however often it comes.

    The policy of its endpoint looks for the saved answer (`ensure_first`), once it has admitted the caller. Out here
    the transaction has been committed when the answer passes, and that answer is saved.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, and save the answer to a write with a key."""
        attempt = _attempt(Request(scope)) if scope["type"] == "http" else None
        if attempt is None:
            await self._app(scope, receive, send)
            return
        request = Request(scope)
        request.state.attempt = attempt
        heard: list[Message] = []

        async def receive_hashed() -> Message:
            message = await receive()
            attempt.received.append(message)
            attempt.body_sha256.update(message.get("body", b""))
            return message

        async def hear(message: Message) -> None:
            heard.append(message)

        try:
            await self._app(scope, receive_hashed, hear)
        except IntegrityError as error:
            await self._answer_after_duplicate(request, attempt, error, send)
            return
        if attempt.saved_response is not None:
            await run_in_threadpool(_keep, request, attempt.key, heard)
        for message in heard:
            await send(message)

    async def _answer_after_duplicate(
        self, request: Request, attempt: Attempt, error: IntegrityError, send: Send
    ) -> None:
        """Answer as the duplicate of a request that was faster, or as two changes at the same moment."""
        attempt.saved_response = None
        attempt.body_sha256, received = hashlib.sha256(), list(attempt.received)
        database: Database = request.app.state.runtime.database
        if await run_in_threadpool(_saved, database, attempt.key) is None:
            conflict = request.app.exception_handlers[DBAPIError](request, error)
            await conflict(request.scope, request.receive, send)
            return

        async def receive_again() -> Message:
            message = received.pop(0)
            attempt.body_sha256.update(message.get("body", b""))
            return message

        await self._app(request.scope, receive_again, send)


def _attempt(request: Request) -> Attempt | None:
    given = request.headers.get("idempotency-key")
    if given is None or request.method in SAFE_METHODS:
        return None
    is_json = request.headers.get("content-type", "application/json").startswith("application/json")
    if not is_json or ("content-type" not in request.headers and content_length(request.scope) != 0):
        return None
    credentials = [request.cookies.get(name, "") for name in request.app.state.credential_cookies]
    caller = "\0".join([request.headers.get("authorization", ""), *credentials])
    return Attempt(_digest(caller, request.method, str(request.url), given))


def ensure_first(request: Request, caller: Any) -> None:
    """Raise Replayed with the saved answer, or what its caller is refused by now; else have this answer saved."""
    attempt: Attempt | None = getattr(request.state, "attempt", None)
    if attempt is None:
        return
    request_sha256 = attempt.body_sha256.hexdigest()
    saved = _saved(request.app.state.runtime.database, attempt.key)
    if saved is not None:
        raise Replayed(_replay(request, caller, saved, request_sha256))
    attempt.saved_response = SavedResponse(key=attempt.key, request_sha256=request_sha256)
    session: Session | None = getattr(request.state, "session", None)
    if session is not None:
        claim(request, session)


def claim(request: Request, session: Session) -> None:
    """Have a request's transaction write its key, so that a duplicate waits for it."""
    attempt: Attempt | None = getattr(request.state, "attempt", None)
    if attempt is not None and attempt.saved_response is not None:
        session.add(attempt.saved_response)


async def _save_nothing(request: Request) -> None:
    request.state.attempt = None


UNSAVED = (Depends(_save_nothing),)  # of a router whose answers carry a secret: none is kept to be replayed


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
    caller = getattr(request.state, "actor", None)
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


def _replay(request: Request, caller: Any, saved: SavedResponse, request_sha256: str) -> Response:
    """Return the saved answer, or raise what its caller is refused by now."""
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
