"""Calls in a throw-away child, as their caller makes them."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import pickle
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time
import weakref
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import ParamSpec, Self, TypeVar

from audio_checks.audio.sandbox.messages import (
    CAN_FORK,
    LENGTH,
    NAME_BYTES,
    RETURNED,
    Access,
    Limits,
    receive,
    resolved,
)
from audio_checks.errors import AudioChecksError, SandboxCrashed, SandboxFailed, SandboxTimedOut
from audio_checks.system.isolation import isolated_python, library_environment

P = ParamSpec("P")
R = TypeVar("R")

START_S = 60.0  # for the server to import what calls need, on a busy machine
MOST_FILES = 1_000  # that a call may have written at a time
GRACE_S = 5.0  # for the server to report how a child ended
ENVIRONMENT = {
    "PATH": os.defpath,  # pydub looks there for programs as it is imported; a child can run none
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    # What the server lets go of must leave no holes in its heap: see _freeze_memory of the server.
    "MALLOC_MMAP_THRESHOLD_": str(64 << 10),
    # Where the system has huge pages to give, a block of samples is a few of them and not hundreds of small ones.
    "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1",
}


class Sandbox:
    """Runs calls in throw-away children. Threads may share one.

    Parameters
    ----------
    timeout_s : float
        For one call, by the clock and in CPU time; a `SandboxChild` may give its calls another.
    memory_bytes : int
        Of address space, the interpreter and its libraries included.
    file_bytes : int
        The largest file that a call may write, and on POSIX about as much as all of them may have together: that is
        looked at ten times a second.
    result_bytes : int
        The largest result, as it is sent.
    preload : sequence of str
        Modules that the server imports before it forks; missing ones are passed over. Modules of
        audio_checks that hold called functions are added as they come.
    rehearsal : callable, optional
        What the server calls once before it forks, so that no child has to load what calls load when
        they first run: modules, tables, weights. One that can be imported by name, starts no thread and
        opens no stranger's file. Where there is no fork it is not called.
    """

    def __init__(
        self,
        *,
        timeout_s: float = 60.0,
        memory_bytes: int = 1 << 30,
        file_bytes: int = 4 << 30,
        result_bytes: int = 64 << 20,
        preload: Sequence[str] = ("numpy", "audio_checks"),
        rehearsal: Callable[[], object] | None = None,
    ) -> None:
        self.timeout_s = timeout_s
        self._limits = Limits(memory_bytes, int(timeout_s) + 2, file_bytes, 64, result_bytes)
        self._preload = tuple(preload)
        self._rehearsal = (rehearsal.__module__, rehearsal.__qualname__) if rehearsal else None
        self._lock = threading.Lock()
        self._server: _Server | None = None

    def call(self, function: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> R:
        """Return the function's result, from a child.

        The function is one that can be imported by name; arguments can be pickled. A result is made of
        plain values, numpy arrays, paths and the data classes of audio_checks that this process has loaded, and is of
        the type that the function declares to return, down to its entries and the keys of a TypedDict. It reaches no
        file; `child` gives it some.

        Raises
        ------
        SandboxTimedOut, SandboxOutOfMemory, SandboxCrashed
            When the child gave no result.
        AudioChecksError
            When the function raised it.
        """
        with self.child() as child:
            return child.call(function, *args, **kwargs)

    def child(
        self,
        *,
        timeout_s: float | None = None,
        reads: Iterable[str | os.PathLike[str]] = (),
        writes: Iterable[str | os.PathLike[str]] = (),
    ) -> SandboxChild:
        """Return a child for a few calls that belong together; to be closed after the last.

        Parameters
        ----------
        timeout_s : float, optional
            For each call, by the clock and in CPU time; else the sandbox's.
        reads : iterable of path
            Files and folders that the calls may read. Where Linux has Landlock they reach no other file but their
            code; see `confinement_gaps`.
        writes : iterable of path
            Files and folders that they may also write. Where this process is root, they belong to an unprivileged
            user afterwards.
        """
        return SandboxChild(
            self, timeout_s=self.timeout_s if timeout_s is None else timeout_s, reads=reads, writes=writes
        )

    def close(self) -> None:
        """End the server and its children; another call starts it again."""
        with self._lock:
            if self._server is not None:
                self._server.close()
                self._server = None

    def _fork(self, module: str) -> tuple[socket.socket, socket.socket]:
        for attempt in (1, 2):
            with self._lock:
                try:
                    if self._server is None or not self._server.alive():
                        if self._server is not None:
                            self._server.close()
                        self._server = _Server(self._preload, self._rehearsal)
                    return self._server.fork(module)
                except OSError:
                    if attempt == 2:
                        raise SandboxCrashed("the sandbox's server cannot be reached") from None
        raise AssertionError("the second attempt returns or raises")


class SandboxChild:
    """Answers calls one after the other in one disposable child; where that fails, the next call gets a new one.

    What one call does to the child the next one meets, so that they must be about files of one
    stranger. One thread at a time.

    Parameters
    ----------
    sandbox : Sandbox
        Whose limits hold, but for the time.
    timeout_s : float
        For one call, by the clock and in CPU time; the next may be given another by setting it.
    reads, writes : iterable of path
        See `Sandbox.child`.
    """

    def __init__(
        self,
        sandbox: Sandbox,
        *,
        timeout_s: float,
        reads: Iterable[str | os.PathLike[str]] = (),
        writes: Iterable[str | os.PathLike[str]] = (),
    ) -> None:
        self.timeout_s = timeout_s
        self._sandbox = sandbox
        self._reads = tuple(os.path.abspath(path) for path in reads)
        self._writes = tuple(os.path.abspath(path) for path in writes)
        self._scratch: str | None = None
        self._line: tuple[socket.socket, socket.socket] | None = None

    def __enter__(self) -> Self:
        """Begin nothing: the child is made for the first call."""
        return self

    def __exit__(self, *_: object) -> None:
        """Have the child ended."""
        self.close()

    def call(self, function: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> R:
        """Return the function's result, as `Sandbox.call` does; see there for the errors raised."""
        limits = dataclasses.replace(self._sandbox._limits, cpu_s=int(self.timeout_s) + 2)
        if self._scratch is None:
            self._scratch = tempfile.mkdtemp(prefix="audio-checks-")
        access = Access(self._reads, self._writes, self._scratch)
        request = pickle.dumps((limits, access, function, args, kwargs), protocol=5)
        try:
            if not CAN_FORK:
                return resolved(_in_new_process(request, time.monotonic() + self.timeout_s), function)  # type: ignore[no-any-return]
            if self._line is None:
                self._line = self._sandbox._fork(getattr(function, "__module__", None) or "")
            watch = partial(_ensure_disk_limit, (self._scratch, *self._writes), limits.file_bytes)
            answer = _exchange(*self._line, request, time.monotonic() + self.timeout_s, limits, watch)
            return resolved(answer, function)  # type: ignore[no-any-return]
        except AudioChecksError as error:
            if isinstance(error, SandboxFailed):  # an error of ours is an answer
                self.close()
            raise
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Have the child ended, and wait until nothing of it is left; another call gets a new one."""
        if self._line is not None:
            (work, status), self._line = self._line, None
            with work, status:
                _finish(status)
        if self._scratch is not None:
            shutil.rmtree(self._scratch, ignore_errors=True)
            self._scratch = None


class _Server:
    """The parent's end of one server process."""

    def __init__(self, preload: Sequence[str], rehearsal: tuple[str, str] | None) -> None:
        self._control, theirs = socket.socketpair()
        with theirs:
            reply = f"{theirs.fileno()}, {tuple(preload)!r}, {rehearsal!r}"
            code = f"from audio_checks.audio.sandbox.server import serve; serve({reply})"
            self._process = subprocess.Popen(
                isolated_python(code, *preload, *(rehearsal[:1] if rehearsal else ())),
                pass_fds=(theirs.fileno(),),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                start_new_session=True,  # Ctrl-C is for the caller, who ends the server by closing its socket
                env=_environment(),
            )
        self.close = weakref.finalize(self, _end_server, self._control, self._process)
        self._control.settimeout(START_S)
        if not self._control.recv(1):
            raise ConnectionError("the server did not start")
        self._control.settimeout(None)

    def alive(self) -> bool:
        return self._process.poll() is None

    def fork(self, module: str) -> tuple[socket.socket, socket.socket]:
        """Ask for a child; return the socket to it, and the socket that ends it when closed."""
        work, childs = socket.socketpair()
        status, servers = socket.socketpair()
        name = module.encode("utf-8", "replace")[:NAME_BYTES].ljust(NAME_BYTES, b"\0")
        with childs, servers:
            try:
                socket.send_fds(self._control, [name], [childs.fileno(), servers.fileno()])
            except BaseException:
                work.close()
                status.close()
                raise
        return work, status


def _environment() -> dict[str, str]:
    """Return the environment of a child: settings of libraries, nothing else of this process's."""
    return {**library_environment(), **ENVIRONMENT}


def _end_server(control: socket.socket, process: subprocess.Popen[bytes]) -> None:
    control.close()
    try:
        process.wait(GRACE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _exchange(
    work: socket.socket,
    status: socket.socket,
    request: bytes,
    deadline: float,
    limits: Limits,
    watch: Callable[[], None],
) -> tuple[bytes, bytes]:
    """Send the request and take the answer."""
    try:
        answer = _converse(work, request, deadline, limits, watch)
    except TimeoutError:
        raise SandboxTimedOut("the call took too long and was stopped") from None
    if answer is None:
        raise _ending(status, deadline)
    return answer


def _converse(
    work: socket.socket, request: bytes, deadline: float, limits: Limits, watch: Callable[[], None]
) -> tuple[bytes, bytes] | None:
    """Return the child's answer, or None when it closed its end without one."""
    with contextlib.suppress(BrokenPipeError, ConnectionResetError):
        work.settimeout(max(deadline - time.monotonic(), 0.001))
        work.sendall(LENGTH.pack(RETURNED, len(request)) + request)
    with contextlib.suppress(ConnectionResetError):
        head = receive(work, LENGTH.size, deadline, watch)
        if head is not None:
            kind, length = LENGTH.unpack(head)
            if length > limits.result_bytes:
                raise SandboxCrashed(f"the result has {length} bytes; {limits.result_bytes} are allowed")
            body = receive(work, length, deadline)
            if body is not None:
                return kind, body
    return None


def _ensure_disk_limit(places: Iterable[str], most_bytes: int) -> None:
    """Raise SandboxCrashed where a child has filled more of the disk than it may."""
    count = size_bytes = 0
    left = list(places)
    while left:
        path = left.pop()
        try:
            entries = list(os.scandir(path)) if os.path.isdir(path) else []
            entry_stats = [entry.stat(follow_symlinks=False) for entry in entries]
            left += [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
        except OSError:  # it went meanwhile
            continue
        count += len(entry_stats)
        size_bytes += sum(entry_stat.st_size for entry_stat in entry_stats)
        if count > MOST_FILES or size_bytes > most_bytes:
            raise SandboxCrashed(
                f"the call wrote {count} files of {size_bytes} bytes; {MOST_FILES} of {most_bytes} are allowed"
            )


def _finish(status: socket.socket) -> None:
    """Have the child ended, and wait until nothing of it is left."""
    with contextlib.suppress(OSError):
        status.shutdown(socket.SHUT_WR)
        status.settimeout(GRACE_S)
        while status.recv(16):
            pass


def _ending(status: socket.socket, deadline: float) -> SandboxFailed:
    """Return the end of a child that gave no answer."""
    try:
        reply = receive(status, 4, min(deadline, time.monotonic() + GRACE_S))
    except (TimeoutError, ConnectionResetError):
        return SandboxCrashed("the child closed its connection and went on without an answer; it was stopped")
    if reply is None:
        return SandboxCrashed("the sandbox's server ended while the call ran")
    code = os.waitstatus_to_exitcode(struct.unpack("<i", reply)[0])
    if code == -signal.SIGXCPU:
        return SandboxTimedOut("the call used up its CPU time")
    if code < 0:
        name = signal.Signals(-code).name if -code in set(signal.Signals) else f"signal {-code}"
        return SandboxCrashed(f"the child was ended by {name}", signal=-code)
    return SandboxCrashed(f"the child left with exit code {code} and without an answer")


def _in_new_process(request: bytes, deadline: float) -> tuple[bytes, bytes]:
    """Run one request in a new interpreter: for systems that cannot fork. No limit but time."""
    with subprocess.Popen(
        isolated_python("from audio_checks.audio.sandbox.child import serve_once; serve_once()"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=_environment(),
    ) as process:
        try:
            output, _ = process.communicate(request, timeout=max(deadline - time.monotonic(), 0.001))
        except subprocess.TimeoutExpired:
            process.kill()
            raise SandboxTimedOut("the call took too long and was stopped") from None
    if len(output) < LENGTH.size:
        code_or_signal = process.returncode
        raise SandboxCrashed(
            f"the child ended with code {code_or_signal} and without an answer",
            signal=-code_or_signal if code_or_signal < 0 else None,
        )
    kind, _ = LENGTH.unpack(output[: LENGTH.size])
    return kind, output[LENGTH.size :]
