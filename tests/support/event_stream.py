"""A browser that listens for changes, on a connection of its own."""

import json
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any

import httpx

from tests.support.waiting import until


@dataclass
class Event:
    """One event as it came."""

    id: str
    name: str
    data: dict[str, Any]


@dataclass
class Listener:
    """What came so far."""

    events: list[Event] = field(default_factory=list)
    is_over: bool = False

    def rooms_of(self, project_id: Any) -> set[str]:
        """Return the rooms of a project that changed."""
        changes = [event.data for event in self.events if event.name == "change"]
        return {room for data in changes if data["project_id"] == str(project_id) for room in data["rooms"]}


@contextmanager
def listening_for_changes(address: str, cookies: Any, **headers: str) -> Iterator[Listener]:
    """Listen in a thread until the block ends, from the moment that the stream is open."""
    listener = Listener()
    with httpx.Client(base_url=address, cookies=dict(cookies), headers=headers, timeout=300) as client:
        request = client.build_request("GET", "/v1/events")
        answer = client.send(request, stream=True)
        assert answer.status_code == 200, answer.read()
        assert answer.headers["content-type"].startswith("text/event-stream")

        def listen() -> None:
            fields: dict[str, str] = {}
            try:
                for line in answer.iter_lines():
                    name, _, value = line.partition(": ")
                    if line:
                        fields[name] = value
                    elif "data" in fields:
                        listener.events.append(Event(fields["id"], fields["event"], json.loads(fields["data"])))
                        fields = {}
            except httpx.HTTPError:
                pass  # it was closed here
            listener.is_over = True

        thread = threading.Thread(target=listen, daemon=True)
        thread.start()
        until(lambda: bool(listener.events))
        try:
            yield listener
        finally:
            line = answer.extensions["network_stream"].get_extra_info("socket")
            with suppress(OSError):
                line.shutdown(socket.SHUT_RDWR)  # which wakes the thread: closing alone would leave it waiting
            thread.join(5)
            answer.close()
