"""How web processes are served: real ones, over real sockets."""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress

import httpx
import pytest

from app.core.web.serving import PortTaken, ensure_port_free
from tests.support.waiting import until

WITHIN_S = 240.0
PROGRAM = """
import sys
from app.core.web import serving

serving.HEAD_S = 1
port, processes, drain_s = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
serving.serve(sys.argv[4], "127.0.0.1", port, processes=processes, drain_s=drain_s, finish_s=20)
"""


class Served:
    """A server of its own, whose processes answer with their ids."""

    def __init__(self, *, processes: int = 1, drain_s: float = 0.0, factory: str = "application") -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]
        arguments = [str(self.port), str(processes), str(drain_s), f"tests.support.plain_web:{factory}"]
        self.process = subprocess.Popen([sys.executable, "-c", PROGRAM, *arguments])

    def started(self) -> "Served":
        """Return it once it answers."""
        until(lambda: self.answering() is not None)
        return self

    def answering(self) -> int | None:
        """Return the id of the process that answers a new line; None where none does."""
        with suppress(httpx.TransportError):
            return int(self.get("/").text)
        return None

    def get(self, path: str) -> httpx.Response:
        return httpx.get(f"http://127.0.0.1:{self.port}{path}", timeout=WITHIN_S)

    def pair(self) -> set[int]:
        """Return the ids of two processes, once both answer."""
        seen: set[int] = set()

        def both() -> bool:
            seen.update({pid for pid in [self.answering()] if pid})
            return len(seen) == 2

        until(both)
        return seen

    def answer_to(self, sent: bytes) -> bytes:
        """Return all that comes until the server closes the line."""
        came = b""
        with socket.create_connection(("127.0.0.1", self.port), timeout=WITHIN_S) as line:
            with suppress(ConnectionError):
                line.sendall(sent)
            with suppress(ConnectionError):
                while piece := line.recv(65_536):
                    came += piece
        return came


@pytest.fixture
def serve() -> Iterator[Callable[..., Served]]:
    servers: list[Served] = []

    def begin(**options: object) -> Served:
        servers.append(Served(**options))  # type: ignore[arg-type]
        return servers[-1].started()

    yield begin
    for each in servers:
        each.process.kill()  # the others end with it
        each.process.wait(WITHIN_S)


@pytest.fixture(scope="module")
def served() -> Iterator[Served]:
    server = Served().started()
    yield server
    server.process.terminate()
    assert server.process.wait(WITHIN_S) == 0


def head(*headers: str) -> bytes:
    return "\r\n".join(["GET / HTTP/1.1", "Host: 127.0.0.1:8000", *headers, "", ""]).encode()


@pytest.mark.slow
@pytest.mark.parametrize("sent", [b"", b"GET / HT", b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: "])
def test_a_head_that_does_not_end_is_cut(served: Served, sent: bytes):
    assert served.answer_to(sent) == b""


def test_the_second_head_on_a_line_may_not_trickle_either(served: Served):
    answer = served.answer_to(head() + b"GET /hea")
    assert answer.startswith(b"HTTP/1.1 200")
    assert answer.count(b"HTTP/1.1") == 1


@pytest.mark.parametrize(
    ("request_head", "status"),
    [
        (head(f"X-Much: {'a' * 30_000}", "Connection: close"), b"200"),  # Upload-Metadata may have 32 KiB
        (head(*[f"X-{number}: a" for number in range(200)]), b"431"),
        (b"GET / HTTP/1.1\r\nX-Endless: " + b"a" * 1_000_000, b"431"),
        (b"this is not HTTP\r\n\r\n", b"400"),
        (head("Content-Length: -5"), b"400"),
        (head(f"Content-Length: {'9' * 30}"), b"400"),
    ],
)
def test_a_head_beyond_the_limits_is_refused(served: Served, request_head: bytes, status: bytes):
    answer = served.answer_to(request_head)
    assert answer == b"" or answer.split()[1] == status  # cut where the server closed before all of it was sent
    assert status != b"200" or answer


def test_what_follows_a_request_of_two_lengths_is_no_second_request(served: Served):
    both = head("Content-Length: 5", "Transfer-Encoding: chunked")
    answer = served.answer_to(both + b"0\r\n\r\n" + head())
    assert answer.count(b"HTTP/1.1") == 1
    assert b"connection: close" in answer.lower()
    assert served.answer_to(head("Content-Length: 5", "Content-Length: 3")).startswith(b"HTTP/1.1 400")


def test_a_port_that_is_in_use_is_reported(served: Served):
    with pytest.raises(PortTaken, match=r"stop what does, or give another --port"):
        ensure_port_free("127.0.0.1", served.port)


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_request_on_its_way_is_answered_and_all_processes_stop(serve: Callable[..., Served], number: signal.Signals):
    server = serve(processes=2)
    server.pair()
    with httpx.stream("GET", f"http://127.0.0.1:{server.port}/slow", timeout=WITHIN_S) as answer:
        server.process.send_signal(number)
        assert answer.read() == b"begun, ended"
    assert server.process.wait(WITHIN_S) == 0
    assert server.answering() is None


@pytest.mark.slow
def test_a_leaving_process_says_so_and_goes_on_until_a_second_signal(serve: Callable[..., Served]):
    server = serve(drain_s=WITHIN_S)
    server.process.terminate()
    until(lambda: server.get("/readyz").status_code == 503)
    answer = server.get("/")
    assert (answer.status_code, answer.headers["connection"]) == (200, "close")
    server.process.terminate()
    assert server.process.wait(WITHIN_S / 2) == 0


@pytest.mark.slow
def test_one_that_dies_is_replaced_and_none_outlives_the_first(serve: Callable[..., Served]):
    server = serve(processes=2)
    dead, alive = server.pair()
    os.kill(dead, signal.SIGKILL)
    until(lambda: server.answering() not in (dead, alive, None))
    assert server.process.poll() is None
    with socket.create_connection(("127.0.0.1", server.port), timeout=WITHIN_S) as upload:
        upload.sendall(b"PUT /endless HTTP/1.1\r\nHost: x\r\nContent-Length: 5\r\n\r\nab")
        server.process.kill()
        until(lambda: server.answering() is None)
        with suppress(ConnectionResetError):
            assert upload.recv(1) == b"", "an upload that cannot end keeps nothing alive"


@pytest.mark.slow
def test_what_cannot_begin_is_not_begun_without_end():
    server = Served(factory="nothing_so_named")
    assert server.process.wait(WITHIN_S) == 1
