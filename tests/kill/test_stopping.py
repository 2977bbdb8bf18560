"""A web process that is told to stop lets proxies turn away before it closes."""

import signal
import time

import httpx
import pytest

from tests.kill.processes import ProcessServer, wait_until

pytestmark = [pytest.mark.kill, pytest.mark.slow, pytest.mark.xdist_group("kill")]


@pytest.mark.killed_on("sqlite")
def test_a_process_that_is_told_to_stop_says_so_and_finishes(server: ProcessServer) -> None:
    web = server.serve(drain_s=1.0)
    with httpx.Client(base_url=f"http://127.0.0.1:{server.port}") as line:
        before = line.get("/healthz")
        web.send(signal.SIGTERM)
        wait_until(lambda: httpx.get(f"http://127.0.0.1:{server.port}/readyz").json() == {"status": "stopping"})
        after = line.get("/healthz")
    assert "connection" not in before.headers
    assert (after.status_code, after.headers["connection"]) == (200, "close")
    begun = time.monotonic()
    web.send(signal.SIGTERM)  # a second time: now
    web.wait()
    assert time.monotonic() - begun < 0.9
