"""An endpoint does all that it does in one thread: who asks, its transaction, its work, and the JSON of its answer.

Left to FastAPI a request would change threads five times, each of which costs as much as a SELECT, and JSON would be
made where every other request waits for it.
"""

import functools
import inspect
from abc import ABC, abstractmethod
from collections.abc import Callable, Coroutine
from contextlib import AbstractAsyncContextManager, AbstractContextManager
from typing import Any

from fastapi import Request, Response
from fastapi.dependencies.models import Dependant
from fastapi.exceptions import RequestValidationError
from fastapi.routing import APIRoute
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.types import Receive, Scope, Send

from app.kit import bodies
from app.kit.errors import Refused
from app.kit.seats import Crowded

OK = 200


class Authentication(ABC):
    """A dependency that says who asks, which a route may also ask before it reads a large body."""

    @abstractmethod
    def authenticate(self, request: Request) -> Any:
        """Return who asks, or raise what the policy says."""


class Asking:
    """Who asks, for an endpoint that depends on it: nobody has looked yet.

    An endpoint that is no coroutine is given what this returns; a coroutine calls it, in a thread of its own.
    """

    def __init__(self, request: Request, look: Callable[[], Any]) -> None:
        request.state.asking = self
        self._look = look
        self.has_looked = False
        self.caller: Any = None

    def __call__(self) -> Any:
        """Return who asks, or raise what the policy says."""
        self.has_looked = True
        self.caller = self._look()
        return self.caller


class Pending:
    """A session that an endpoint depends on and that nobody opened yet, with the seat that it is used in."""

    def __init__(
        self,
        seat: Callable[[], AbstractAsyncContextManager[Any]],
        transaction: Callable[[], AbstractContextManager[Session]],
    ) -> None:
        self.seat = seat
        self.opened = transaction


class InOneTurn(APIRoute):
    """A route whose endpoint has one thread, and whose answer leaves once its transaction is committed.

    `max_body_size` is held here and not by FastAPI, whose answer would say neither number.
    """

    def __init__(
        self, path: str, endpoint: Callable[..., Any], *, max_body_size: int | None = None, **more: Any
    ) -> None:
        super().__init__(path, self._in_one_turn(endpoint), **more)
        self.body_limit = bodies.SMALL_BODY_BYTES if max_body_size is None else max_body_size
        self.authentication = _authentication_of(self.dependant)

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request whose body is within the limit; read a large one only once it is known who sends it."""
        if (length := bodies.content_length(scope)) != 0:
            receive = await self._bounded(scope, receive, length)
        await self.answer(scope, receive, send)

    async def answer(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request whose body is bounded."""
        await super().handle(scope, receive, send)

    async def _bounded(self, scope: Scope, receive: Receive, length: int | None) -> Receive:
        bodies.ensure_fits(length, self.body_limit)
        if self.body_field is None:
            return bodies.counted(receive, self.body_limit)
        if self.body_limit > bodies.SMALL_BODY_BYTES and self.authentication is not None:
            await run_in_threadpool(self.authentication.authenticate, Request(scope))
        return await bodies.read_whole(receive, length, self.body_limit)

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Let no answer out before it is known who asks, not even what is wrong with what was sent."""
        handle = super().get_route_handler()

        async def handle_in_turn(request: Request) -> Response:
            try:
                answer = await handle(bodies.JsonRequest(request.scope, request.receive))
            except Crowded:
                raise
            except (RequestValidationError, HTTPException, Refused) as error:
                if (asking := _unasked(request)) is not None:
                    await run_in_threadpool(asking)
                elif self.authentication is not None and not hasattr(request.state, "asking"):  # the body is no JSON
                    await run_in_threadpool(self.authentication.authenticate, request)
                if isinstance(error.__cause__, Refused):  # of the body, as FastAPI passes it on
                    raise error.__cause__ from None
                raise
            if _unasked(request) is not None:
                raise AssertionError(f"{self.name} never looked who asks")
            return answer

        return handle_in_turn

    def _in_one_turn(self, endpoint: Callable[..., Any]) -> Callable[..., Any]:
        if inspect.iscoroutinefunction(endpoint):
            return endpoint

        @functools.wraps(endpoint)
        async def answer(**given: Any) -> Any:
            turn = functools.partial(run_in_threadpool, self._answer, endpoint, given)
            for value in given.values():
                if isinstance(value, Pending):
                    async with value.seat():
                        return await turn()
            return await turn()

        return answer

    def _answer(self, endpoint: Callable[..., Any], given: dict[str, Any]) -> Any:
        known = {name: value() if isinstance(value, Asking) else value for name, value in given.items()}
        for name, value in known.items():
            if isinstance(value, Pending):
                with value.opened() as session:
                    answer = endpoint(**{**known, name: session})
                break
        else:
            answer = endpoint(**known)
        has_its_own = any(isinstance(value, Response) for value in given.values())  # headers and status; FastAPI's part
        return answer if has_its_own else self._as_json(answer)

    def _as_json(self, answer: Any) -> Any:
        """Return the answer as FastAPI would send it; as it is, where FastAPI has more to say or to refuse."""
        if self.response_field is None or isinstance(answer, Response):
            return answer
        shown, errors = self.response_field.validate(answer, loc=("response",))
        if errors:
            return answer
        return Response(
            self.response_field.serialize_json(shown), self.status_code or OK, media_type="application/json"
        )


def _unasked(request: Request) -> Asking | None:
    asking: Asking | None = getattr(request.state, "asking", None)
    return None if asking is None or asking.has_looked else asking


def _authentication_of(dependant: Dependant) -> Authentication | None:
    for dependency in dependant.dependencies:
        if isinstance(dependency.call, Authentication):
            return dependency.call
        if (found := _authentication_of(dependency)) is not None:
            return found
    return None
