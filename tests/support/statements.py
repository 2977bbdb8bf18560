"""What each test sends to the database, and the fewest tests that send all of it.

On SQLite every test runs, and what it sends is recorded. On PostgreSQL those marked `both_databases` run, and of the
others as few as are needed to send every recorded statement and to repeat every request that succeeded, by each kind
of person, for row policies differ by person.
"""

import heapq
import json
import re
import threading
from collections.abc import Hashable, Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from httpx2 import Client, Response
    from sqlalchemy import Engine

PARAMETERS = re.compile(r"\?(, \?)+")
ROWS = re.compile(r"\(\?\)(, \(\?\))+")
NAMED = re.compile(r"/(?!(?:v1|[a-z-]+)(?:/|$))[^/]+")  # a part of a path that is an id, a file, a secret
BACKGROUND = ("heartbeat", "looking for work")  # threads of the worker: they send the same at any time


@lru_cache(maxsize=20_000)
def without_values(statement: str) -> str:
    """Return a statement the same whatever the number of its parameters and rows."""
    return ROWS.sub("(?)", PARAMETERS.sub("?", statement))


class Recorder:
    """Writes a line for each test: its id, and everything it sent."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self.sent: set[str] = set()

    def watch(self, engine: "Engine") -> None:
        """Record the statements of an engine from now on, without their values and whatever the number of rows."""
        from sqlalchemy import event  # a second that tests of sounds alone do without

        def note(_connection: Any, _cursor: Any, statement: str, *_more: Any) -> None:
            if threading.current_thread().name not in BACKGROUND:
                self.sent.add(without_values(statement))

        event.listen(engine, "before_cursor_execute", note)

    def watch_requests(self, client: "Client", person: str) -> None:
        """Record from now on which requests of a person's browser succeed."""

        def note(response: "Response") -> None:
            if response.is_success:
                self.note_request(person, response.request.method, response.request.url.path)

        client.event_hooks["response"].append(note)

    def note_request(self, person: str, method: str, path: str) -> None:
        """Record a request that succeeded."""
        self.sent.add(f"{person}: {method} {NAMED.sub('/…', path)}")

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """Gather what one test of the server sends."""
        self.sent.clear()
        result = yield
        if "server" in getattr(item, "fixturenames", ()):
            self.write(item.nodeid)
        return result

    def write(self, test: str) -> None:
        """Add a line for a test."""
        with self._file.open("a") as file:
            file.write(json.dumps([test, sorted(self.sent.copy())]) + "\n")


def recorded(folder: Path) -> dict[str, set[str]]:
    """Return what each test of the last run on SQLite sent."""
    lines = (line for file in sorted(folder.glob("*.jsonl")) for line in file.read_text().splitlines())
    return {test: set(sent) for test, sent in map(json.loads, lines)}


def fewest(sent: Mapping[str, AbstractSet[Hashable]], always: Iterable[str] = ()) -> set[str]:
    """Return tests that together send everything: first those that always run, then whichever adds most."""
    chosen = set(always) & sent.keys()
    missing: set[Hashable] = set().union(*sent.values()) - set().union(*(sent[test] for test in chosen))
    offers = [(-len(what), test) for test, what in sent.items() if test not in chosen]
    heapq.heapify(offers)
    while missing:
        _, test = heapq.heappop(offers)
        gain = len(sent[test] & missing)
        if gain and offers and -gain > offers[0][0]:  # less than it was when last counted
            heapq.heappush(offers, (-gain, test))
        elif gain:
            chosen.add(test)
            missing -= sent[test]
    return chosen
