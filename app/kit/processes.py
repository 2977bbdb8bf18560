"""Several processes that serve one port: forked from one that has imported everything, so that they share its memory.

The kernel distributes new connections among them. A process that exits unexpectedly is replaced; when the first
one is asked to stop, or is gone, all stop.
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

MIN_UPTIME_S = 10.0  # a process that exits sooner is not replaced: a new one would fail too
KILL_AFTER_S = 20.0  # from the request to stop
STOP_SIGNALS = frozenset({signal.SIGTERM, signal.SIGINT})
log = structlog.get_logger(__name__)


class PortTaken(Exception):
    """Nothing can listen there: says where, and how to fix it."""


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


def shared_listener(kept: socket.socket) -> socket.socket:
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


def run_in_subprocess(work: Callable[[], None]) -> int:
    """Run something in a forked process, and return its exit code."""
    return os.waitstatus_to_exitcode(os.waitpid(_fork(work), 0)[1])


def stop_with_input() -> None:
    """Stop this process once its standard input ends, as SIGTERM would: its parent is gone, however that ended.

    What does not stop in time is killed.
    """
    threading.Thread(target=_stop_with_input, name="end of input", daemon=True).start()


def _stop_with_input() -> None:
    while os.read(sys.stdin.fileno(), 1024):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(KILL_AFTER_S)
    os.kill(os.getpid(), signal.SIGKILL)


class PreforkSupervisor:
    """Processes that do the same work, each knowing its place."""

    def __init__(self, work: Callable[[int], None], count: int) -> None:
        self._work = work
        self._count = count
        self._children: dict[int, tuple[int, float]] = {}  # process id: place, when it began
        self._stop_signal: signal.Signals | None = None
        self._life, self._lifeline = os.pipe()  # closes with this process, however that ends

    def run(self) -> int:
        """Supervise them until a stop signal; return the exit code, or end by that signal."""
        before = {number: signal.signal(number, self._stop) for number in STOP_SIGNALS}
        gc.collect()
        gc.freeze()  # what a collection looks through is copied for each process
        for place in range(self._count):
            self._start(place)
        code = 0
        while self._children:
            pid, status = os.wait()
            place, begun = self._children.pop(pid)
            if self._stop_signal:
                continue
            ended = os.waitstatus_to_exitcode(status)
            log.error("a web process ended", process=pid, place=place, code=ended)
            if time.monotonic() - begun < MIN_UPTIME_S:
                code = ended if ended > 0 else 1
                self._stop(signal.SIGTERM, None)
            else:
                self._start(place)
        for number, handler in before.items():
            signal.signal(number, handler)
        if self._stop_signal is signal.SIGTERM and not code:
            signal.raise_signal(signal.SIGTERM)  # so that the parent process sees that the signal ended it
        return code

    def _start(self, place: int) -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, STOP_SIGNALS)  # a signal in between would not reach the new one
        try:
            self._children[_fork(lambda: self._run_worker(place))] = place, time.monotonic()
        finally:
            signal.pthread_sigmask(signal.SIG_UNBLOCK, STOP_SIGNALS)

    def _run_worker(self, place: int) -> None:
        os.setpgid(0, 0)  # Ctrl-C at a terminal reaches the first one, which passes it on once
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOP_SIGNALS)
        os.close(self._lifeline)
        threading.Thread(target=self._stop_with_supervisor, name="lifeline", daemon=True).start()
        self._work(place)

    def _stop_with_supervisor(self) -> None:
        os.read(self._life, 1)
        os.kill(os.getpid(), signal.SIGTERM)

    def _stop(self, number: int, _frame: FrameType | None) -> None:
        self._stop_signal = signal.Signals(number)
        for pid in self._children:
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
