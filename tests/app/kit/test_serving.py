"""How the web process is served."""

import gc
import socket
from collections.abc import Iterator
from typing import Any

import pytest

from app.kit import serving


@pytest.fixture
def unfrozen() -> Iterator[None]:
    gc.unfreeze()
    yield
    gc.unfreeze()


@pytest.mark.usefixtures("unfrozen")
def test_what_was_imported_is_not_looked_through_again(monkeypatch: pytest.MonkeyPatch):
    frozen: list[int] = []

    def run(server: Any, _sockets: Any) -> None:
        frozen.append(gc.get_freeze_count())
        server.started = True

    monkeypatch.setattr(serving.SteppedServer, "run", run)
    with socket.socket() as listening:
        serving.serve(lambda *_: None, listening, drain_s=0, finish_s=1)
    assert frozen[0] > 10_000
