"""Several processes that serve one port: forked from one that has imported everything, so that they share its memory.

The kernel gives each new connection to one of them. One that ends unasked is replaced; when the first one is told to
stop, or is no more, all stop.
"""

import gc
import os
import signal
import socket
import sys
import threading
import time
import traceback
from collections.abc import Callable
from types import FrameType

import structlog

SETTLED_S = 10.0  # whoever ends sooner would end again: something is wrong that a new one does not mend
STOPS = frozenset({signal.SIGTERM, signal.SIGINT})
log = structlog.get_logger(__name__)


class PortTaken(Exception):
    """Nothing can listen there: says where, and how to mend it."""


def listener(host: str, port: int, *, shared: bool = False) -> socket.socket:
    """Return a socket that is bound and does not listen yet; several may be bound to a port that is shared.

    With port 0 the system chooses one.
    """
    try:
        if shared:
            _bound(host, port, shared=False).close()  # fails where a stranger listens, who may have shared it too
        return _bound(host, port, shared=shared)
    except OSError as error:
        raise PortTaken(
            f"nothing can listen on {host}:{port} ({error.strerror}); stop what does, or give another --port"
        ) from None


def beside(kept: socket.socket) -> socket.socket:
    """Return one more socket on a port that is shared."""
    return _bound(*kept.getsockname()[:2], shared=True)


def _bound(host: str, port: int, *, shared: bool) -> socket.socket:
    family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    made = socket.socket(family, kind)
    made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    if shared:
        made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
    made.bind(address)
    return made


def run_apart(work: Callable[[], None]) -> int:
    """Do something in a process of its own, and return its exit code."""
    return os.waitstatus_to_exitcode(os.waitpid(_fork(work), 0)[1])


class Siblings:
    """Processes that do the same work, each knowing its place."""

    def __init__(self, work: Callable[[int], None], count: int) -> None:
        self._work = work
        self._count = count
        self._begun: dict[int, tuple[int, float]] = {}  # process id: place, when it began
        self._told: signal.Signals | None = None
        self._life, self._lifeline = os.pipe()  # closes with this process, however that ends

    def run(self) -> int:
        """Keep them running until told to stop; return the exit code, or end by the signal that it was told with."""
        before = {number: signal.signal(number, self._stop) for number in STOPS}
        gc.collect()
        gc.freeze()  # what a collection looks through is copied for each process
        for place in range(self._count):
            self._start(place)
        code = 0
        while self._begun:
            pid, status = os.wait()
            place, begun = self._begun.pop(pid)
            if self._told:
                continue
            ended = os.waitstatus_to_exitcode(status)
            log.error("a web process ended", process=pid, place=place, code=ended)
            if time.monotonic() - begun < SETTLED_S:
                code = ended if ended > 0 else 1
                self._stop(signal.SIGTERM, None)
            else:
                self._start(place)
        for number, handler in before.items():
            signal.signal(number, handler)
        if self._told is signal.SIGTERM and not code:
            signal.raise_signal(signal.SIGTERM)  # so that whoever started this sees that it ended as it was told
        return code

    def _start(self, place: int) -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, STOPS)  # a signal in between would not reach the new one
        try:
            self._begun[_fork(lambda: self._sibling(place))] = place, time.monotonic()
        finally:
            signal.pthread_sigmask(signal.SIG_UNBLOCK, STOPS)

    def _sibling(self, place: int) -> None:
        os.setpgid(0, 0)  # Ctrl-C at a terminal reaches the first one, which passes it on once
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOPS)
        os.close(self._lifeline)
        threading.Thread(target=self._end_with_the_first, name="lifeline", daemon=True).start()
        self._work(place)

    def _end_with_the_first(self) -> None:
        os.read(self._life, 1)
        os.kill(os.getpid(), signal.SIGTERM)

    def _stop(self, number: int, _frame: FrameType | None) -> None:
        self._told = signal.Signals(number)
        for pid in self._begun:
            os.kill(pid, signal.SIGTERM)


def _fork(work: Callable[[], None]) -> int:
    sys.stdout.flush()
    sys.stderr.flush()
    if pid := os.fork():
        return pid
    code = 1
    try:
        work()
        code = 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
