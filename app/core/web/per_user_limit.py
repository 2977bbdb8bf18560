"""A limit of one person's concurrent requests of a costly kind, so that others find a slot."""

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock
from uuid import UUID

from app.core.errors import Refused


class TooManyAtOnce(Refused):
    """The caller's earlier requests of this kind still run."""

    status = 429
    retry_after_s = 2


class PerUserLimit:
    """A concurrency limit for each person, in one process."""

    def __init__(self, most: int, noun: str) -> None:
        self._most, self._noun = most, noun
        self._running: Counter[UUID] = Counter()
        self._lock = Lock()

    @contextmanager
    def of(self, person_id: UUID) -> Iterator[None]:
        """Run a block as one of a person's; raise TooManyAtOnce where as many as are allowed run already."""
        with self._lock:
            if self._running[person_id] >= self._most:
                raise TooManyAtOnce(
                    f"{self._most} {self._noun} at once is the most for one person, and so many still run",
                    fix="try again in a few seconds",
                )
            self._running[person_id] += 1
        try:
            yield
        finally:
            with self._lock:
                self._running[person_id] -= 1
                if not self._running[person_id]:
                    del self._running[person_id]
