"""How many requests a web process runs at once: people first, uploads after them, and every wait is bounded.

Each request with a session of its own takes a slot, readers and writers from separate pools; the others wait before
they take a thread or a connection. More slots would not answer sooner: one request computes at a time while the others
wait for the database. There must be more connections (30, or 40 on SQLite) and threads (40) than slots, because each
running request needs one of each.

Uploads come from machines that send the next file when one is done, and would use all of a processor. They have
low-priority queues: the first upload in line lets people go first, for at most `YIELD_TO_PEOPLE_S`.
"""

import asyncio
import contextlib
from collections.abc import AsyncIterator, Iterator

import anyio
from anyio.lowlevel import RunVar

from app.kit.errors import Refused

MAX_CONCURRENT = 4  # readers, and as many writers
MAX_CONCURRENT_UPLOADS = 2  # uploads that begin, continue or become takes
MAX_CONCURRENT_FINISHES = 2  # uploads being synced, hashed and stored; bounded so that they delay no request
YIELD_TO_PEOPLE_S = 0.03  # so the upload queue moves 30 times a second, however many people use the server
MAX_WAIT_S = 20.0  # then the client has given up or retried; an endless queue would use all memory


class Overloaded(Refused):
    """The process could not begin this request in time."""

    status = 503


class Slot:
    """A slot of a low-priority queue, released at the end or earlier."""

    def __init__(self, slots: anyio.Semaphore) -> None:
        self._slots = slots
        self._is_released = False

    def release(self) -> None:
        """Release the slot to the next in line; the rest of the request needs none."""
        if not self._is_released:
            self._is_released = True
            self._slots.release()


class _LowPriorityQueue:
    """Slots that are given out while no person is being served, or after waiting long enough."""

    def __init__(self, slots: int, no_person_active: asyncio.Event) -> None:
        self._slots = anyio.Semaphore(slots)
        self._first_in_line = anyio.Lock()  # the others wait for it in order
        self._no_person_active = no_person_active

    @contextlib.asynccontextmanager
    async def slot(self, longest_s: float | None) -> AsyncIterator[Slot]:
        with _within(longest_s):
            async with self._first_in_line:
                with anyio.move_on_after(YIELD_TO_PEOPLE_S):
                    await self._no_person_active.wait()
                await self._slots.acquire()
        slot = Slot(self._slots)
        try:
            yield slot
        finally:
            slot.release()


class ConcurrencyLimiter:
    """The concurrency limits of one event loop."""

    def __init__(self) -> None:
        self._readers, self._writers = anyio.Semaphore(MAX_CONCURRENT), anyio.Semaphore(MAX_CONCURRENT)
        self._people_active = 0  # running or waiting
        self._no_person_active = asyncio.Event()
        self._no_person_active.set()
        self._uploads, self._finishes = (
            _LowPriorityQueue(MAX_CONCURRENT_UPLOADS, self._no_person_active),
            _LowPriorityQueue(MAX_CONCURRENT_FINISHES, self._no_person_active),
        )

    @contextlib.asynccontextmanager
    async def for_person(self, *, reads: bool) -> AsyncIterator[None]:
        """Run a person's request; raise Overloaded if it cannot begin in time."""
        slots = self._readers if reads else self._writers
        self._people_active += 1
        self._no_person_active.clear()
        try:
            await _acquire(slots)
            try:
                yield
            finally:
                slots.release()
        finally:
            self._people_active -= 1
            if not self._people_active:
                self._no_person_active.set()

    @contextlib.asynccontextmanager
    async def for_upload(self) -> AsyncIterator[Slot]:
        """Run a short step of an upload, after people; raise Overloaded if it cannot begin in time."""
        async with self._uploads.slot(MAX_WAIT_S) as slot:
            yield slot

    @contextlib.asynccontextmanager
    async def for_upload_finish(self) -> AsyncIterator[None]:
        """Run what follows the last byte of an upload, after people; never refused, since the bytes are stored."""
        async with self._finishes.slot(None):
            yield


_LIMITER: RunVar[ConcurrencyLimiter] = RunVar("concurrency_limiter")


def limiter() -> ConcurrencyLimiter:
    """Return the limiter of the running event loop."""
    try:
        return _LIMITER.get()
    except LookupError:
        _LIMITER.set(made := ConcurrencyLimiter())
        return made


async def _acquire(slots: anyio.Semaphore) -> None:
    with contextlib.suppress(anyio.WouldBlock):
        slots.acquire_nowait()  # without a timer when one is free
        return
    with _within(MAX_WAIT_S):
        await slots.acquire()


@contextlib.contextmanager
def _within(longest_s: float | None) -> Iterator[None]:
    try:
        with anyio.fail_after(longest_s):
            yield
    except TimeoutError:
        raise Overloaded(
            "the server is busy; nothing was done",
            fix="try again in a few seconds",
        ) from None
