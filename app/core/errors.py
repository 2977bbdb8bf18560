"""Refusals that a caller meets: each subclass is one fact, with one stable code and one status."""

import re
from collections.abc import Sequence
from typing import ClassVar

from typing_extensions import TypedDict


class FieldProblem(TypedDict):
    """The error of one field or one row of a request."""

    where: str
    message: str


class Refused(Exception):
    """A request that cannot be granted: says what was found, what was wanted and how to fix it."""

    status: ClassVar[int] = 400
    retry_after_s: int | None = None  # how long to wait, where the same request may be granted later

    def __init__(self, message: str, *, errors: Sequence[FieldProblem] = (), fix: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.errors = list(errors)
        self.fix = fix

    @classmethod
    def code(cls) -> str:
        """Return the name that clients rely on: DeliveryNotFound reads `delivery-not-found`."""
        return re.sub(r"(?<!^)(?=[A-Z])", "-", cls.__name__).lower()


class NotFound(Refused):
    """The named object does not exist, or may not be seen: the answer is the same."""

    status = 404


class Forbidden(Refused):
    """The caller sees the thing and still may not do this."""

    status = 403


class Conflict(Refused):
    """The request does not fit the state that things are in now."""

    status = 409


class Invalid(Refused):
    """The request is well-formed but invalid."""

    status = 422
