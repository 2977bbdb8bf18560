"""A web process's number of requests at once: people first, uploads after them, and every wait is bounded.

Each request with a session of its own takes a slot, readers and writers from separate pools; the others wait before
they take a thread or a connection. More slots would not answer sooner: one request computes at a time while the others
wait for the database. There must be more connections (15, or 40 on SQLite) and threads (40) than slots (12), because
each running request needs one of each.

People take turns: the first waiting request of one caller goes before the second of another, and no caller has all
slots. So a caller who sends a hundred slow requests waits for them alone.

Uploads come from machines that send the next file when one is done, and would use all of a processor. They have
low-priority queues: the first upload in line lets people go first, for at most `YIELD_TO_PEOPLE_S`.
"""

import asyncio
import contextlib
from collections import Counter, deque
from collections.abc import AsyncIterator, Iterator

import anyio
from anyio.lowlevel import RunVar

from app.core.errors import Refused

MAX_CONCURRENT = 4  # readers, and as many writers
MAX_CONCURRENT_OF_CALLER = 3  # of these, so that one is left for others
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


class _FairQueue:
    """Slots that callers take in turns, each caller's requests in their order."""

    def __init__(self, slots: int, most_of_caller: int) -> None:
        self._free = slots
        self._most_of_caller = most_of_caller
        self._running: Counter[str] = Counter()
        self._waiting: dict[str, deque[asyncio.Future[None]]] = {}  # the caller whose turn is next comes first

    @contextlib.asynccontextmanager
    async def slot(self, caller: str) -> AsyncIterator[None]:
        if caller in self._waiting or not self._may_run(caller):
            with _within(MAX_WAIT_S):
                await self._wait(caller)
        else:
            self._take(caller)
        try:
            yield
        finally:
            self._release(caller)

    def _may_run(self, caller: str) -> bool:
        return self._free > 0 and self._running[caller] < self._most_of_caller

    def _take(self, caller: str) -> None:
        self._free -= 1
        self._running[caller] += 1

    async def _wait(self, caller: str) -> None:
        turn = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(caller, deque()).append(turn)
        try:
            await turn
        except asyncio.CancelledError:
            if turn.done() and not turn.cancelled():
                self._release(caller)  # its turn came as it went away
            else:
                self._leave(caller, turn)
            raise

    def _leave(self, caller: str, turn: asyncio.Future[None]) -> None:
        turns = self._waiting.get(caller, deque())
        with contextlib.suppress(ValueError):  # passed over when it was its turn
            turns.remove(turn)
        if not turns:
            self._waiting.pop(caller, None)

    def _release(self, caller: str) -> None:
        self._free += 1
        self._running[caller] -= 1
        if not self._running[caller]:
            del self._running[caller]
        for waiting_caller in list(self._waiting):
            if self._may_run(waiting_caller):
                turns = self._waiting.pop(waiting_caller)
                while turns and (turn := turns.popleft()).cancelled():
                    continue
                if not turn.cancelled():
                    self._take(waiting_caller)
                    turn.set_result(None)
                if turns:
                    self._waiting[waiting_caller] = turns  # behind all others


class ConcurrencyLimiter:
    """The concurrency limits of one event loop."""

    def __init__(self) -> None:
        self._readers, self._writers = (_FairQueue(MAX_CONCURRENT, MAX_CONCURRENT_OF_CALLER) for _ in range(2))
        self._people_active = 0  # running or waiting
        self._no_person_active = asyncio.Event()
        self._no_person_active.set()
        self._uploads, self._finishes = (
            _LowPriorityQueue(MAX_CONCURRENT_UPLOADS, self._no_person_active),
            _LowPriorityQueue(MAX_CONCURRENT_FINISHES, self._no_person_active),
        )

    @contextlib.asynccontextmanager
    async def for_person(self, caller: str, *, reads: bool) -> AsyncIterator[None]:
        """Run a request of a caller, who is known by any text; raise Overloaded if it cannot begin in time."""
        self._people_active += 1
        self._no_person_active.clear()
        try:
            async with (self._readers if reads else self._writers).slot(caller):
                yield
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
        """Run the steps after an upload's last byte, after people; never refused, since the bytes are stored."""
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
