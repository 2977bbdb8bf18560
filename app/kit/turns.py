"""An endpoint's transaction is begun, used and ended in the endpoint's own thread.

As a dependency that FastAPI opens and closes it would change threads three times, which costs as much as a SELECT.
"""

import functools
import inspect
from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any

from fastapi.routing import APIRoute
from sqlalchemy.orm import Session


class Pending:
    """A session that an endpoint depends on and that nobody opened yet."""

    def __init__(self, transaction: Callable[[], AbstractContextManager[Session]]) -> None:
        self.opened = transaction


class InOneTurn(APIRoute):
    """A route whose endpoint is given its session open, and whose answer leaves once that is committed."""

    def __init__(self, path: str, endpoint: Callable[..., Any], **more: Any) -> None:
        super().__init__(path, _in_one_turn(endpoint), **more)


def _in_one_turn(endpoint: Callable[..., Any]) -> Callable[..., Any]:
    if inspect.iscoroutinefunction(endpoint):
        return endpoint

    @functools.wraps(endpoint)
    def answer(**given: Any) -> Any:
        for name, value in given.items():
            if isinstance(value, Pending):
                with value.opened() as session:
                    return endpoint(**{**given, name: session})
        return endpoint(**given)

    return answer
