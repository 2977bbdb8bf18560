"""A web process that gets SIGTERM lets proxies turn away before it closes."""

import signal
import socket
import time
from contextlib import suppress

import httpx
import pytest

from tests.kill.processes import ProcessServer, free_port, wait_until

pytestmark = [pytest.mark.kill, pytest.mark.slow]


DRAIN_S = 60.0  # the longest that there is


@pytest.mark.killed_on("sqlite")
def test_a_process_that_is_asked_to_stop_says_so_and_finishes(server: ProcessServer) -> None:
    web = server.serve(drain_s=DRAIN_S)
    with httpx.Client(base_url=f"http://127.0.0.1:{server.port}") as line:
        before = line.get("/healthz")
        web.send(signal.SIGTERM)
        wait_until(lambda: httpx.get(f"http://127.0.0.1:{server.port}/readyz").json() == {"status": "stopping"})
        after = line.get("/healthz")
    assert "connection" not in before.headers
    assert (after.status_code, after.headers["connection"]) == (200, "close")
    begun = time.monotonic()
    web.send(signal.SIGTERM)  # a second time: now
    assert web.wait() == 0
    assert time.monotonic() - begun < DRAIN_S / 2


@pytest.mark.killed_on("sqlite")
def test_several_processes_answer_for_one_server_and_stop_together(server: ProcessServer) -> None:
    figures = two_free_ports()
    web = server.serve(web_processes=2, metrics_port=figures)

    def both_answered() -> bool:
        httpx.get(f"http://127.0.0.1:{server.port}/healthz")  # on a line of its own each time
        reported = [httpx.get(f"http://127.0.0.1:{port}/metrics").text for port in (figures, figures + 1)]
        return all('soundlist_requests_total{method="GET",route="/healthz"' in each for each in reported)

    wait_until(lambda: is_open(figures) and is_open(figures + 1))
    wait_until(both_answered)
    web.send(signal.SIGTERM)
    assert web.wait() == 0
    assert not any(map(is_open, (server.port, figures, figures + 1)))


def two_free_ports() -> int:
    """Return the first of two ports side by side that nobody listens on."""
    while True:
        port = free_port()
        with suppress(OSError), socket.socket() as following:
            following.bind(("127.0.0.1", port + 1))
            return port


def is_open(port: int) -> bool:
    """Whether a line can be opened."""
    with suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=5):
        return True
    return False
