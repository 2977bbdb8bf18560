"""Whose turn it is in a web process: people first, what uploads ask behind them, and nobody waits without end.

Requests with a session of their own that run at once have a seat, as many that read as that write; others wait
before they take a thread or a connection. More would be answered no sooner: one runs at a time, while the others ask
the database. Connections (30, or 40 on SQLite) and threads (40) must be more than seats, for whoever has a seat wants
one of each at once.

Uploads come from machines that send the next file when one is done, and take all that is left of a processor. They
sit in a back row, and whoever stands first in its line lets people go first, but no longer than `GIVES_WAY_S`.
"""

import asyncio
import contextlib
from collections.abc import AsyncIterator, Iterator

import anyio
from anyio.lowlevel import RunVar

from app.kit.errors import Refused

SEATS = 4  # of those who read, and as many of those who write
BACK_SEATS = 2  # of uploads that begin, go on or become takes
END_SEATS = 2  # of files that are synced, hashed and stored: many that end together stand before nobody's request
GIVES_WAY_S = 0.03  # so that a line of uploads moves by thirty a second however many people come
LONGEST_WAIT_S = 20.0  # for a seat; whoever asked is gone or asks again, and a line without end takes all memory


class Crowded(Refused):
    """More was asked for than this process could answer in time."""

    status = 503


class Seat:
    """A place in the back row, given back at the end or before it."""

    def __init__(self, row: anyio.Semaphore) -> None:
        self._row = row
        self._is_left = False

    def leave(self) -> None:
        """Give it to the next; what follows needs none."""
        if not self._is_left:
            self._is_left = True
            self._row.release()


class _BackRow:
    """Seats whose line moves while no person is being served, or has done so for long enough."""

    def __init__(self, seats: int, nobody_in: asyncio.Event) -> None:
        self._seats = anyio.Semaphore(seats)
        self._head = anyio.Lock()  # who stands first; the others wait for that, in their order
        self._nobody_in = nobody_in

    @contextlib.asynccontextmanager
    async def seat(self, longest_s: float | None) -> AsyncIterator[Seat]:
        with _within(longest_s):
            async with self._head:
                with anyio.move_on_after(GIVES_WAY_S):
                    await self._nobody_in.wait()
                await self._seats.acquire()
        seat = Seat(self._seats)
        try:
            yield seat
        finally:
            seat.leave()


class Seats:
    """The seats of one event loop."""

    def __init__(self) -> None:
        self._readers, self._writers = anyio.Semaphore(SEATS), anyio.Semaphore(SEATS)
        self._people_in = 0  # being served, or waiting for it
        self._nobody_in = asyncio.Event()
        self._nobody_in.set()
        self._back, self._end = _BackRow(BACK_SEATS, self._nobody_in), _BackRow(END_SEATS, self._nobody_in)

    @contextlib.asynccontextmanager
    async def for_person(self, *, reads: bool) -> AsyncIterator[None]:
        """Serve somebody who waits for the answer; raise Crowded where that takes too long to begin."""
        seats = self._readers if reads else self._writers
        self._people_in += 1
        self._nobody_in.clear()
        try:
            await _take(seats)
            try:
                yield
            finally:
                seats.release()
        finally:
            self._people_in -= 1
            if not self._people_in:
                self._nobody_in.set()

    @contextlib.asynccontextmanager
    async def for_upload(self) -> AsyncIterator[Seat]:
        """Serve what is short of an upload, once people let it; raise Crowded where that takes too long."""
        async with self._back.seat(LONGEST_WAIT_S) as seat:
            yield seat

    @contextlib.asynccontextmanager
    async def for_end_of_upload(self) -> AsyncIterator[None]:
        """Serve what follows the last byte, once people let it; it is never refused, since the bytes are here."""
        async with self._end.seat(None):
            yield


_SEATS: RunVar[Seats] = RunVar("seats")


def seats() -> Seats:
    """Return the seats of the event loop that runs."""
    try:
        return _SEATS.get()
    except LookupError:
        _SEATS.set(made := Seats())
        return made


async def _take(seats: anyio.Semaphore) -> None:
    with contextlib.suppress(anyio.WouldBlock):
        seats.acquire_nowait()  # without a timer, where one is free
        return
    with _within(LONGEST_WAIT_S):
        await seats.acquire()


@contextlib.contextmanager
def _within(longest_s: float | None) -> Iterator[None]:
    try:
        with anyio.fail_after(longest_s):
            yield
    except TimeoutError:
        raise Crowded(
            f"this server did not come to it within {longest_s:g} s, and nothing was done",
            fix="try again in a few seconds",
        ) from None
