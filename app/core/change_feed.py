"""Sends changes to open pages: one reader for each web process, whatever the number of pages.

An open page holds no thread and no database connection. While a page is open, the reader sends one SELECT
every `READ_EVERY_S`. LISTEN and NOTIFY of PostgreSQL would avoid it, but take a lock under which every commit
that notifies waits for the one before it, and SQLite would still need a reader.
"""

import asyncio
import time
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import ClassVar, Protocol
from uuid import UUID

import structlog
from anyio.to_thread import run_sync
from prometheus_client import Gauge

from app.core.changes import (
    KEPT_FOR,
    LATE_S,
    Change,
    Scope,
    changes_since,
    forget_old_changes,
    instant_id,
    instant_of,
    merged,
)
from app.core.db import Database
from app.core.errors import Refused

READ_EVERY_S = 0.25
CHECK_SIGHT_EVERY_S = 5.0  # a stream ends within this time after its viewer signs out
FORGET_EVERY_S = 60.0
UNAVAILABLE_PAUSE_S = 2.0  # while the database is unavailable
MAX_STREAMS = 2_000  # of one web process
MAX_STREAMS_OF_ONE_PERSON = 20
STREAMS = Gauge("soundlist_event_streams", "Pages that receive changes from this process.")
log = structlog.get_logger(__name__)


@dataclass(frozen=True)
class Viewer:
    """A person with an open page, and the hash of their session; None in the demo, which has no session."""

    person_id: UUID
    session_sha256: str | None


class Audience(Protocol):
    """The changes that a viewer may see."""

    def visible_rooms(self, scope: Scope, rooms: Collection[str]) -> set[str]:
        """Return the rooms of a project whose changes the viewer may see."""


LookUp = Callable[[Database, Collection[Viewer]], Mapping[Viewer, Audience]]  # without viewers who are signed out


class TooManyStreams(Refused):
    """Too many pages are open: this one must poll for changes."""

    status: ClassVar[int] = 429
    retry_after_s = 60


@dataclass(eq=False)
class Stream:
    """Changes not yet sent to one open page: each room of each project at most once."""

    viewer: Viewer
    sight: Audience
    pending: dict[Scope, set[str]] = field(default_factory=dict)
    is_over: bool = False
    woken: asyncio.Event = field(default_factory=asyncio.Event)

    def add(self, changed: Mapping[Scope, Collection[str]]) -> None:
        """Queue the changes that the viewer may see."""
        for scope, rooms in changed.items():
            if seen := self.sight.visible_rooms(scope, rooms):
                self.pending.setdefault(scope, set()).update(seen)
                self.woken.set()

    def end(self) -> None:
        """Close the stream after the event that it is sending."""
        self.is_over = True
        self.woken.set()

    async def next(self, longest_s: float) -> dict[Scope, set[str]]:
        """Return changes as soon as there are any; nothing after `longest_s`, or when the stream is closed."""
        try:
            async with asyncio.timeout(longest_s):
                await self.woken.wait()
        except TimeoutError:
            return {}
        self.woken.clear()
        changed, self.pending = self.pending, {}
        return changed


class ChangeFeed:
    """The streams of one event loop, and the task that reads changes while there are streams."""

    def __init__(self, database: Database, look_up: LookUp, granting_rooms: Collection[str]) -> None:
        self._database = database
        self._look_up = look_up
        self._granting_rooms = frozenset(granting_rooms)  # a change there may change what a viewer sees
        self._streams: set[Stream] = set()
        self._reading: asyncio.Task[None] | None = None
        self._is_leaving: Callable[[], bool] = bool  # returns False
        self._seen: set[UUID] = set()
        self._read_at = 0.0

    def ensure_stream_limit(self, person_id: UUID) -> None:
        """Raise TooManyStreams if a person, or the whole process, has reached its limit."""
        own_streams = sum(stream.viewer.person_id == person_id for stream in self._streams)
        if own_streams >= MAX_STREAMS_OF_ONE_PERSON or len(self._streams) >= MAX_STREAMS:
            raise TooManyStreams("too many pages are open", fix="ask for what you show every minute instead")

    @contextmanager
    def watching(self, viewer: Viewer, sight: Audience, is_leaving: Callable[[], bool]) -> Iterator[Stream]:
        """Open a stream for the length of the block."""
        stream = Stream(viewer, sight)
        self._is_leaving = is_leaving
        self._streams.add(stream)
        STREAMS.inc()
        if self._reading is None or self._reading.done():
            self._reading = asyncio.create_task(self._read())
        try:
            yield stream
        finally:
            self._streams.discard(stream)
            STREAMS.dec()

    async def replay(self, stream: Stream, last_seen: UUID) -> bool:
        """Add the changes since an event was sent; return whether the log still reaches back that far."""
        at_s = instant_of(last_seen)
        if not time.time() - KEPT_FOR.total_seconds() + LATE_S < at_s <= time.time() + LATE_S:
            return False
        since = instant_id(at_s - LATE_S - READ_EVERY_S)
        stream.add(merged(await run_sync(changes_since, self._database, since)))
        return True

    async def _read(self) -> None:
        self._seen, self._read_at = set(), time.time()
        checked_at = forgot_at = time.monotonic()
        is_unavailable = False
        while self._streams:
            await asyncio.sleep(UNAVAILABLE_PAUSE_S if is_unavailable else READ_EVERY_S)
            if self._is_leaving():
                for stream in self._streams:
                    stream.end()
                return
            try:
                changed = merged(await run_sync(self._unseen))
                is_due = time.monotonic() - checked_at > CHECK_SIGHT_EVERY_S
                if is_due or any(rooms & self._granting_rooms for rooms in changed.values()):
                    await self._check_sight()  # first: viewers who lost access by this change do not receive it
                    checked_at = time.monotonic()
                for stream in self._streams:
                    stream.add(changed)
                if time.monotonic() - forgot_at > FORGET_EVERY_S:
                    forgot_at = time.monotonic()
                    await run_sync(forget_old_changes, self._database)
                is_unavailable = False
            except Exception:  # pages poll meanwhile, and receive these changes too
                if not is_unavailable:
                    log.exception("changes could not be read")
                is_unavailable = True

    def _unseen(self) -> list[Change]:
        read_at, since = time.time(), instant_id(self._read_at - LATE_S)
        fresh = [change for change in changes_since(self._database, since) if change.id not in self._seen]
        self._seen = {id_ for id_ in self._seen if id_ > since} | {change.id for change in fresh}
        self._read_at = read_at
        return fresh

    async def _check_sight(self) -> None:
        streams = list(self._streams)
        sights = await run_sync(self._look_up, self._database, {stream.viewer for stream in streams})
        for stream in streams:
            if (sight := sights.get(stream.viewer)) is None:
                stream.end()
            else:
                stream.sight = sight
