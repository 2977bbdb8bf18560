"""How the web process is served."""

import gc
import socket
import threading
from collections.abc import Iterator
from typing import Any

import pytest

from app.kit import serving

pytestmark = pytest.mark.slow


@pytest.fixture
def same_threshold() -> Iterator[None]:
    threshold = gc.get_threshold()
    yield
    gc.set_threshold(*threshold)


@pytest.mark.usefixtures("same_threshold")
def test_what_was_imported_is_not_looked_through_again_and_the_collector_ends_with_the_server(
    monkeypatch: pytest.MonkeyPatch,
):
    imported: list[list[int]] = [[] for _ in range(10_000)]
    frozen: list[int] = []
    collectors: list[threading.Thread] = []

    def run(server: Any, _sockets: Any) -> None:
        frozen.append(gc.get_freeze_count())
        collectors.extend(thread for thread in threading.enumerate() if thread.name == "garbage")
        server.started = True

    monkeypatch.setattr(serving.SteppedServer, "run", run)
    before = gc.get_freeze_count()
    with socket.socket() as listening:
        serving.serve(lambda *_: None, listening, drain_s=0, finish_s=1)
    assert frozen[0] >= before + len(imported)
    assert len(collectors) == 1
    collectors[0].join(240)
    assert not collectors[0].is_alive()
