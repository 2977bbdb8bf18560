"""Processes that serve one port together: real ones, each answering with its id."""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress

import pytest

from app.kit.processes import PortTaken, listener
from tests.support.waiting import until

WITHIN_S = 240.0
PROGRAM = """
import os, sys
from app.kit import processes

processes.MIN_UPTIME_S = float(sys.argv[1])
kept = processes.listener("127.0.0.1", 0, shared=True)
print(kept.getsockname()[1], flush=True)


def work(place):
    listening = processes.shared_listener(kept)
    listening.listen()
    {work}


sys.exit(processes.PreforkSupervisor(work, 2).run())
"""
SEND_PID = """
    while True:
        line, _ = listening.accept()
        line.sendall(str(os.getpid()).encode())
        line.close()
"""
END_AT_ONCE = """
    if place == 1:
        sys.exit(2)
    listening.accept()
"""


class Run:
    """A program whose processes send their ids over each connection."""

    def __init__(self, work: str, settled_s: float) -> None:
        program = PROGRAM.replace("{work}", work.strip())
        self.process = subprocess.Popen(
            [sys.executable, "-c", program, str(settled_s)], stdout=subprocess.PIPE, text=True
        )
        assert self.process.stdout is not None
        self.port = int(self.process.stdout.readline())

    def who(self) -> int | None:
        """Return the id of the process that answers; None where none does."""
        with suppress(OSError), socket.create_connection(("127.0.0.1", self.port), timeout=WITHIN_S) as line:
            return int(line.recv(100) or 0) or None
        return None

    def pair(self) -> set[int]:
        """Return the ids of both, once both answer."""
        seen: set[int] = set()

        def both() -> bool:
            seen.update({pid for pid in [self.who()] if pid})
            return len(seen) == 2

        until(both)
        return seen


@pytest.fixture
def run() -> Iterator[Callable[..., Run]]:
    runs: list[Run] = []

    def begin(work: str, settled_s: float = 0.0) -> Run:
        runs.append(Run(work, settled_s))
        return runs[-1]

    yield begin
    for each in runs:
        each.process.kill()  # the others end with it
        each.process.communicate(timeout=WITHIN_S)


@pytest.mark.slow
@pytest.mark.parametrize(("number", "ends"), [(signal.SIGTERM, -signal.SIGTERM), (signal.SIGINT, 0)])
def test_all_answer_on_one_port_and_stop_together(run: Callable[..., Run], number: int, ends: int):
    server = run(SEND_PID)
    server.pair()
    server.process.send_signal(number)
    assert server.process.wait(WITHIN_S) == ends
    assert server.who() is None


@pytest.mark.slow
def test_one_that_dies_is_replaced(run: Callable[..., Run]):
    server = run(SEND_PID)
    dead, alive = server.pair()
    os.kill(dead, signal.SIGKILL)
    until(lambda: server.who() not in (dead, alive, None))
    assert server.process.poll() is None


@pytest.mark.slow
def test_none_outlives_the_first(run: Callable[..., Run]):
    server = run(SEND_PID)
    server.pair()
    server.process.kill()
    until(lambda: server.who() is None)


@pytest.mark.slow
def test_what_cannot_begin_is_not_begun_without_end(run: Callable[..., Run]):
    server = run(END_AT_ONCE, settled_s=60.0)
    assert server.process.wait(WITHIN_S) == 2  # the exit code of the process that could not begin


def test_a_port_that_is_in_use_is_reported():
    with listener("127.0.0.1", 0, shared=True) as taken:
        taken.listen()
        with pytest.raises(PortTaken, match=r"stop what does, or give another --port"):
            listener("127.0.0.1", taken.getsockname()[1], shared=True)
