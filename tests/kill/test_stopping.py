"""A web process that is told to stop lets proxies turn away before it closes."""

import signal
import socket
import time

import httpx
import pytest

from tests.kill.processes import ProcessServer, wait_until

pytestmark = [pytest.mark.kill, pytest.mark.slow, pytest.mark.xdist_group("kill")]


DRAIN_S = 60.0  # the longest that there is


@pytest.mark.killed_on("sqlite")
def test_a_process_that_is_told_to_stop_says_so_and_finishes(server: ProcessServer) -> None:
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
    assert web.wait() == -signal.SIGTERM  # which uvicorn raises once more, having finished
    assert time.monotonic() - begun < DRAIN_S / 2


@pytest.mark.killed_on("sqlite")
def test_a_line_that_is_open_is_answered_after_the_door_is_shut(server: ProcessServer) -> None:
    """A proxy may have sent on it before it could know."""
    web = server.serve(drain_s=0.1)
    with (
        httpx.Client(base_url=f"http://127.0.0.1:{server.port}") as used,
        socket.create_connection(("127.0.0.1", server.port), timeout=30) as unused,
    ):
        assert used.get("/healthz").status_code == 200
        web.send(signal.SIGTERM)
        wait_until(lambda: is_shut(server.port))
        again = used.get("/healthz")
        assert (again.status_code, again.headers["connection"]) == (200, "close")
        unused.sendall(b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        assert unused.recv(4096).startswith(b"HTTP/1.1 200")
    assert web.wait() == -signal.SIGTERM  # which uvicorn raises once more, having finished


def is_shut(port: int) -> bool:
    """Whether no new line can be opened."""
    try:
        socket.create_connection(("127.0.0.1", port), timeout=0.1).close()
    except ConnectionRefusedError:
        return True
    except TimeoutError:
        pass  # asked while the process waits for its queue to run empty
    return False
