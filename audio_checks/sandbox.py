"""Calls in a throw-away child: what it does to itself, the caller survives.

On POSIX a small server process, warm with the modules that calls need, forks one child for each
call, or for a few calls that belong together, limits it, watches it and reaps it. Where there is no
fork, each call gets a new interpreter with a time limit alone.
"""

from __future__ import annotations

import contextlib
import ctypes
import dataclasses
import enum
import functools
import gc
import io
import os
import pickle
import selectors
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import traceback
import weakref
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, ParamSpec, Self, TypeVar

with contextlib.suppress(ImportError):  # where there is no fork there are no limits either
    import resource

from audio_checks.errors import (
    AudioChecksError,
    SandboxCrashed,
    SandboxFailed,
    SandboxOutOfMemory,
    SandboxTimedOut,
)

P = ParamSpec("P")
R = TypeVar("R")

NAME_BYTES = 256  # of a module's name on its way to the server
LENGTH = struct.Struct("<cQ")
RETURNED, RAISED, NO_MEMORY, FAILED = b"r", b"e", b"m", b"f"
DETAIL_CHARACTERS = 8_000
START_S = 60.0  # for the server to import what calls need, on a busy machine
GRACE_S = 5.0  # for the server to tell how a child ended
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
ENVIRONMENT = {
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    # What the server lets go of must leave no holes in its heap: see _settle_memory.
    "MALLOC_MMAP_THRESHOLD_": str(64 << 10),
    # Where the system has huge pages to give, a block of samples is a few of them and not hundreds of small ones.
    "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1",
}
M_TRIM_THRESHOLD, M_TOP_PAD, M_MMAP_THRESHOLD = -1, -2, -3  # of glibc's mallopt

# What may be made from a child's answer, beside classes that carry data: a child whose decoder was
# taken over must not run code here.
PLAIN = {("builtins", name) for name in ("set", "frozenset", "complex", "bytearray", "slice", "range")} | {
    ("datetime", "datetime"),
    ("datetime", "timedelta"),
    ("datetime", "timezone"),
    ("datetime", "date"),
    ("collections", "OrderedDict"),
    ("pathlib", "PosixPath"),
    ("pathlib", "PurePosixPath"),
    ("pathlib", "WindowsPath"),
    ("pathlib", "PureWindowsPath"),
    ("pathlib._local", "PosixPath"),
    ("pathlib._local", "PurePosixPath"),
    ("uuid", "UUID"),
    ("decimal", "Decimal"),
    ("fractions", "Fraction"),
    ("numpy", "ndarray"),
    ("numpy", "dtype"),
    ("numpy._core.multiarray", "_reconstruct"),
    ("numpy._core.multiarray", "scalar"),
    ("numpy._core.numeric", "_frombuffer"),
    ("_codecs", "encode"),
}


@dataclasses.dataclass(frozen=True)
class _Limits:
    memory_bytes: int
    cpu_s: int
    file_bytes: int
    open_files: int
    result_bytes: int


_inside = False


def is_inside() -> bool:
    """Tell whether this process is a throw-away child itself, so that no other is needed, nor allowed."""
    return _inside


def _settle_inside() -> None:
    global _inside  # noqa: PLW0603 - of this process, which ends with its one call
    _inside = True


class Sandbox:
    """Runs calls in throw-away children. Threads may share one.

    Parameters
    ----------
    timeout_s : float
        For one call, by the clock and in CPU time; a `SandboxChild` may give its calls another.
    memory_bytes : int
        Of address space, the interpreter and its libraries included.
    file_bytes : int
        The largest file that a call may write.
    result_bytes : int
        The largest result, pickled.
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
        self._limits = _Limits(memory_bytes, int(timeout_s) + 2, file_bytes, 64, result_bytes)
        self._preload = tuple(preload)
        self._rehearsal = (rehearsal.__module__, rehearsal.__qualname__) if rehearsal else None
        self._lock = threading.Lock()
        self._server: _Server | None = None

    def call(self, function: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> R:
        """Return what the function returns, from a child.

        The function is one that can be imported by name; arguments and result can be pickled. A
        result is made of plain values, numpy arrays and the data classes of audio_checks.

        Raises
        ------
        SandboxTimedOut, SandboxOutOfMemory, SandboxCrashed
            When the child gave no result.
        AudioChecksError
            When the function raised it.
        """
        with self.child() as child:
            return child.call(function, *args, **kwargs)

    def child(self, *, timeout_s: float | None = None) -> SandboxChild:
        """Return what answers a few calls that belong together, in the time given; to be closed after the last."""
        return SandboxChild(self, timeout_s=self.timeout_s if timeout_s is None else timeout_s)

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
    """Answers calls one after the other in one throw-away child; where that fails, the next call gets a new one.

    What one call does to the child the next one meets, so that they must be about the same stranger's
    file. One thread at a time.

    Parameters
    ----------
    sandbox : Sandbox
        Whose limits hold, but for the time.
    timeout_s : float
        For one call, by the clock and in CPU time; the next may be given another by setting it.
    """

    def __init__(self, sandbox: Sandbox, *, timeout_s: float) -> None:
        self.timeout_s = timeout_s
        self._sandbox = sandbox
        self._line: tuple[socket.socket, socket.socket] | None = None

    def __enter__(self) -> Self:
        """Begin nothing: the child is made for the first call."""
        return self

    def __exit__(self, *_: object) -> None:
        """Have the child ended."""
        self.close()

    def call(self, function: Callable[P, R], /, *args: P.args, **kwargs: P.kwargs) -> R:
        """Return what the function returns, as `Sandbox.call` does; see there for what is raised."""
        limits = dataclasses.replace(self._sandbox._limits, cpu_s=int(self.timeout_s) + 2)
        request = pickle.dumps((limits, function, args, kwargs), protocol=5)
        try:
            if not CAN_FORK:
                return _resolved(_in_new_process(request, time.monotonic() + self.timeout_s))  # type: ignore[no-any-return]
            if self._line is None:
                self._line = self._sandbox._fork(getattr(function, "__module__", None) or "")
            return _resolved(_exchange(*self._line, request, time.monotonic() + self.timeout_s, limits))  # type: ignore[no-any-return]
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


class _Server:
    """The parent's end of one server process."""

    def __init__(self, preload: Sequence[str], rehearsal: tuple[str, str] | None) -> None:
        self._control, theirs = socket.socketpair()
        with theirs:
            told = f"{theirs.fileno()}, {tuple(preload)!r}, {rehearsal!r}"
            code = f"from audio_checks.sandbox import serve; serve({told})"
            self._process = subprocess.Popen(
                [sys.executable, "-P", "-c", code],
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
    """Return this process's environment and import path, and what libraries in a child are told."""
    path = os.pathsep.join(entry or os.getcwd() for entry in sys.path)
    return {**os.environ, **ENVIRONMENT, "PYTHONPATH": path}


def _end_server(control: socket.socket, process: subprocess.Popen[bytes]) -> None:
    control.close()
    try:
        process.wait(GRACE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _exchange(
    work: socket.socket, status: socket.socket, request: bytes, deadline: float, limits: _Limits
) -> tuple[bytes, bytes]:
    """Send the request and take the answer."""
    try:
        answer = _converse(work, request, deadline, limits)
    except TimeoutError:
        raise SandboxTimedOut("the call took too long and was stopped") from None
    if answer is None:
        raise _ending(status, deadline)
    return answer


def _converse(work: socket.socket, request: bytes, deadline: float, limits: _Limits) -> tuple[bytes, bytes] | None:
    """Return the child's answer, or None when it closed its end without one."""
    with contextlib.suppress(BrokenPipeError, ConnectionResetError):
        work.settimeout(max(deadline - time.monotonic(), 0.001))
        work.sendall(LENGTH.pack(RETURNED, len(request)) + request)
    with contextlib.suppress(ConnectionResetError):
        head = _receive(work, LENGTH.size, deadline)
        if head is not None:
            kind, length = LENGTH.unpack(head)
            if length > limits.result_bytes:
                raise SandboxCrashed(f"the result has {length} bytes; {limits.result_bytes} are allowed")
            body = _receive(work, length, deadline)
            if body is not None:
                return kind, body
    return None


def _finish(status: socket.socket) -> None:
    """Have the child ended, and wait until nothing of it is left."""
    with contextlib.suppress(OSError):
        status.shutdown(socket.SHUT_WR)
        status.settimeout(GRACE_S)
        while status.recv(16):
            pass


def _receive(work: socket.socket, count: int, deadline: float | None) -> bytes | None:
    """Return exactly `count` bytes, or None when the other end closed before."""
    content = bytearray()
    while len(content) < count:
        if deadline is not None:
            left = deadline - time.monotonic()
            if left <= 0:
                raise TimeoutError
            work.settimeout(left)
        piece = work.recv(min(count - len(content), 1 << 20))
        if not piece:
            return None
        content += piece
    return bytes(content)


def _ending(status: socket.socket, deadline: float) -> SandboxFailed:
    """Tell how a child ended that gave no answer."""
    try:
        told = _receive(status, 4, min(deadline, time.monotonic() + GRACE_S))
    except (TimeoutError, ConnectionResetError):
        return SandboxCrashed("the child closed its connection and went on without an answer; it was stopped")
    if told is None:
        return SandboxCrashed("the sandbox's server ended while the call ran")
    code = os.waitstatus_to_exitcode(struct.unpack("<i", told)[0])
    if code == -signal.SIGXCPU:
        return SandboxTimedOut("the call used up its CPU time")
    if code < 0:
        name = signal.Signals(-code).name if -code in set(signal.Signals) else f"signal {-code}"
        return SandboxCrashed(f"the child was ended by {name}", signal=-code)
    return SandboxCrashed(f"the child left with exit code {code} and without an answer")


def _resolved(answer: tuple[bytes, bytes]) -> Any:
    """Return or raise what the child answered."""
    kind, body = answer
    if kind == NO_MEMORY:
        raise SandboxOutOfMemory("the call wanted more memory than it may have")
    if kind == FAILED:
        detail = "".join(c if c.isprintable() or c == "\n" else "?" for c in body.decode("utf-8", "replace"))
        detail = detail[-DETAIL_CHARACTERS:]
        raise SandboxCrashed(f"the call failed: {detail.strip().splitlines()[-1] if detail.strip() else '?'}", detail)
    try:
        value = _Unpickler(io.BytesIO(body)).load()
    except Exception as error:
        raise SandboxCrashed(f"the child's answer cannot be read: {error}") from error
    if kind == RAISED:
        raise value if isinstance(value, AudioChecksError) else SandboxCrashed("the child raised no error of ours")
    return value


class _Unpickler(pickle.Unpickler):
    """Makes plain values, numpy arrays, and data classes, enumerations and errors of audio_checks."""

    def find_class(self, module: str, name: str) -> Any:
        if (module, name) in PLAIN:
            return super().find_class(module, name)
        if module.partition(".")[0] == "audio_checks" and "." not in name:
            found = super().find_class(module, name)
            if isinstance(found, type) and (
                dataclasses.is_dataclass(found) or issubclass(found, (AudioChecksError, enum.Enum))
            ):
                return found
        raise pickle.UnpicklingError(f"{module}.{name} may not come out of a sandbox")


def _in_new_process(request: bytes, deadline: float) -> tuple[bytes, bytes]:
    """Run one request in an interpreter of its own: for systems that cannot fork. No limit but time."""
    with subprocess.Popen(
        [sys.executable, "-P", "-c", "from audio_checks.sandbox import serve_once; serve_once()"],
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


def serve_once() -> None:
    """Answer the request on standard input, and leave."""
    _settle_inside()
    output = os.dup(1)
    os.dup2(2, 1)
    kind, body = _answer(sys.stdin.buffer.read())
    with os.fdopen(output, "wb") as stream:
        stream.write(LENGTH.pack(kind, len(body)) + body)


def serve(control_descriptor: int, preload: Sequence[str], rehearsal: tuple[str, str] | None = None) -> None:
    """Fork a child for each request until the control socket closes. Runs in the server process."""
    for name in preload:
        with contextlib.suppress(ImportError):
            import_module(name)
    if rehearsal:
        with contextlib.suppress(Exception):  # calls fail with words of their own, if they fail too
            getattr(import_module(rehearsal[0]), rehearsal[1])()
    # A collection in a child would write to all that it shares with this process, and so copy it.
    gc.collect()
    gc.freeze()
    _settle_memory()
    control = socket.socket(fileno=control_descriptor)
    _prctl(PR_SET_CHILD_SUBREAPER, 1)
    wake_reader, wake_writer = socket.socketpair()
    wake_writer.setblocking(False)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    signal.set_wakeup_fd(wake_writer.fileno(), warn_on_full_buffer=False)
    selector = selectors.DefaultSelector()
    selector.register(control, selectors.EVENT_READ)
    selector.register(wake_reader, selectors.EVENT_READ)
    running: dict[int, socket.socket] = {}
    control.sendall(b"!")
    try:
        while True:
            for key, _ in selector.select():
                if key.fileobj is control:
                    _fork(control, selector, running)
                elif key.fileobj is wake_reader:
                    wake_reader.recv(4_096)
                    _reap(selector, running)
                elif key.data in running:  # the caller has what it wanted, or waits no longer
                    _kill(key.data)
                    selector.unregister(key.fileobj)
    except EOFError:
        pass
    finally:
        for pid in running:
            _kill(pid)


def _fork(control: socket.socket, selector: selectors.BaseSelector, running: dict[int, socket.socket]) -> None:
    """Take one request from the control socket and fork its child."""
    name, descriptors, _, _ = socket.recv_fds(control, NAME_BYTES, 2)
    if not name:
        raise EOFError
    if len(descriptors) != 2:
        for descriptor in descriptors:
            os.close(descriptor)
        return
    module = name.rstrip(b"\0").decode()
    if module.partition(".")[0] == "audio_checks" and module not in sys.modules:
        with contextlib.suppress(Exception):
            import_module(module)
    work, status = descriptors
    pid = os.fork()
    if not pid:
        _be_child(work)
    os.close(work)
    running[pid] = socket.socket(fileno=status)
    selector.register(running[pid], selectors.EVENT_READ, pid)


def _reap(selector: selectors.BaseSelector, running: dict[int, socket.socket]) -> None:
    """Bury what has died, tell the callers how, and end what the dead have left behind."""
    ended: list[tuple[socket.socket, int]] = []
    with contextlib.suppress(ChildProcessError):
        while (death := os.waitpid(-1, os.WNOHANG))[0]:
            pid, how = death
            if pid in running:
                ended.append((running.pop(pid), how))
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.killpg(pid, signal.SIGKILL)
    orphans = Path(f"/proc/self/task/{os.getpid()}/children")
    with contextlib.suppress(OSError):
        for orphan in {int(word) for word in orphans.read_text().split()} - set(running):
            _kill(orphan)
    for status, how in ended:
        with contextlib.suppress(KeyError):
            selector.unregister(status)
        with contextlib.suppress(OSError):
            status.sendall(struct.pack("<i", how))
        status.close()


def _kill(pid: int) -> None:
    """End a child of the server and its group; it is not reaped yet, so the number is still its own."""
    for end in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError, PermissionError):
            end(pid, signal.SIGKILL)


def _be_child(work: int) -> None:
    """Answer requests until there are no more, and leave without a trace."""
    code = 1
    _settle_inside()
    try:
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        os.setsid()
        _prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        null = os.open(os.devnull, os.O_RDWR)
        for standard in (0, 1, 2):
            os.dup2(null, standard)
        os.dup2(work, 3)
        os.closerange(4, 1 << 16)
        connection = socket.socket(fileno=3)
        while head := _receive(connection, LENGTH.size, None):
            request = _receive(connection, LENGTH.unpack(head)[1], None)
            if request is None:
                break
            kind, body = _answer(request)
            connection.sendall(LENGTH.pack(kind, len(body)) + body)
            code = 0
    except OSError:
        pass
    finally:
        os._exit(code)


def _prctl(option: int, value: int) -> None:
    """Set a trait of this process where the system is Linux."""
    with contextlib.suppress(OSError, AttributeError, TypeError):
        _libc().prctl(option, value, 0, 0, 0)


@functools.cache
def _libc() -> ctypes.CDLL:
    return ctypes.CDLL(None)


def _settle_memory() -> None:
    """Have children take memory that is new, in large pieces, and keep it until they end.

    What is free but was written to before is shared with the server, and each page of it that a child writes to
    is copied first. And glibc would give a block of samples back to the system when it is let go of, and take and
    clear the same pages for the next one.
    """
    with contextlib.suppress(OSError, AttributeError, TypeError):
        _libc().malloc_trim(0)
        _libc().mallopt(M_MMAP_THRESHOLD, 32 << 20)
        _libc().mallopt(M_TRIM_THRESHOLD, 256 << 20)
        _libc().mallopt(M_TOP_PAD, 16 << 20)


def _limit(limits: _Limits) -> None:
    """Take from this process what it does not need."""
    for kind, most in (
        (resource.RLIMIT_AS, limits.memory_bytes),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NOFILE, limits.open_files),
        (resource.RLIMIT_FSIZE, limits.file_bytes),
        (resource.RLIMIT_NPROC, 0),
    ):
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(kind, (most, most))
    with contextlib.suppress(ValueError, OSError):
        # For this call: what those before it took is not its own. The hard limit would hold for all of them together.
        used = resource.getrusage(resource.RUSAGE_SELF)
        _, hard = resource.getrlimit(resource.RLIMIT_CPU)
        resource.setrlimit(resource.RLIMIT_CPU, (int(used.ru_utime + used.ru_stime) + limits.cpu_s, hard))


def _answer(request: bytes) -> tuple[bytes, bytes]:
    """Run a request; return the kind of its answer, and the answer pickled."""
    limits: _Limits | None = None
    try:
        limits, function, args, kwargs = pickle.loads(request)  # noqa: S301 - it comes from the caller
        if CAN_FORK:
            _limit(limits)
        kind, value = RETURNED, function(*args, **kwargs)
    except AudioChecksError as error:
        kind, value = RAISED, error.with_traceback(None)
    except MemoryError:
        return NO_MEMORY, b""
    except BaseException:
        return FAILED, traceback.format_exc()[-DETAIL_CHARACTERS:].encode("utf-8", "replace")
    try:
        body = pickle.dumps(value, protocol=5)
    except MemoryError:
        return NO_MEMORY, b""
    except Exception:
        return FAILED, traceback.format_exc()[-DETAIL_CHARACTERS:].encode("utf-8", "replace")
    if limits is not None and len(body) > limits.result_bytes:
        return FAILED, f"the result has {len(body)} bytes; {limits.result_bytes} are allowed".encode()
    return kind, body
