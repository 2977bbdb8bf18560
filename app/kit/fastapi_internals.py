"""Everything that Soundlist uses of FastAPI and Starlette beside their documentation: both versions are pinned exactly.

tests/app/kit/test_fastapi_internals.py names each part, and fails where a newer version lacks it. What each buys was
measured in processor time, as the least of five runs in one process.
"""

import re
from collections.abc import Iterator
from functools import cached_property
from typing import Any

from fastapi import APIRouter, Response
from fastapi.routing import APIRoute, iter_route_contexts
from starlette.routing import Match, compile_path
from starlette.types import Receive, Scope, Send

GROUP_NAME = re.compile(r"\?P<\w+>")
OK = 200


class Router(APIRouter):
    """A room's routes, which one look at an address rules out together: most requests are for other rooms.

    Without it FastAPI tries every route of every room before the one that is requested. It saves 0.25 to 1.4 ms of a
    request, 17 to 65 % of one that is refused for want of a sign-in.
    """

    def include_router(self, router: APIRouter, *given: Any, **more: Any) -> None:
        """Include another router, which is a plain APIRouter: a Router would not know its whole addresses."""
        if isinstance(router, Router):
            raise TypeError("a router within a Router does not know its whole addresses: make it an APIRouter")
        super().include_router(router, *given, **more)

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Return whether any of them is requested."""
        return super().matches(scope) if self._addresses.match(scope["path"]) else (Match.NONE, {})

    @cached_property
    def _addresses(self) -> re.Pattern[str]:
        paths = (context.path or "" for context in iter_route_contexts(self.routes))
        return re.compile("|".join(GROUP_NAME.sub("?:", compile_path(path)[0].pattern) for path in paths))


class InterceptedRoute(APIRoute):
    """A route whose request passes `answer` before FastAPI parses anything of it.

    What is done there needs the route that was found: limits of its body, its answer kept for an Idempotency-Key. A
    middleware runs before the route is known, a dependency after the body was read.
    """

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        await self.answer(scope, receive, send)

    async def answer(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request as FastAPI does."""
        await super().handle(scope, receive, send)

    @property
    def reads_body(self) -> bool:
        """Whether FastAPI reads the body, which is not a stream then."""
        return self.body_field is not None

    def dependencies_called(self) -> Iterator[Any]:
        """Yield what is called for the endpoint's parameters: dependencies and theirs, the nearest first."""
        waiting = list(self.dependant.dependencies)
        while waiting:
            dependency = waiting.pop(0)
            if dependency.call is not None:
                yield dependency.call
            waiting[:0] = dependency.dependencies

    def as_json(self, answer: Any) -> Any:
        """Return the answer as FastAPI would send it; as it is, where FastAPI has more to say or to refuse.

        FastAPI makes the JSON on the event loop, where every other request waits: called in the thread of the endpoint,
        this saves the loop 15 % of its time for 50 rows, and 51 % for 500.
        """
        if self.response_field is None or isinstance(answer, Response):
            return answer
        shown, errors = self.response_field.validate(answer, loc=("response",))
        if errors:
            return answer
        return Response(
            self.response_field.serialize_json(shown), self.status_code or OK, media_type="application/json"
        )
