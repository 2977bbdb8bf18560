"""The server process: warm with what calls need, it forks a child for each, watches it and reaps it."""

from __future__ import annotations

import contextlib
import ctypes
import functools
import gc
import os
import selectors
import signal
import socket
import struct
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from audio_checks.audio.sandbox import child
from audio_checks.audio.sandbox.child import answer, enter_sandbox
from audio_checks.audio.sandbox.confinement import library_places, prepare
from audio_checks.audio.sandbox.messages import LENGTH, NAME_BYTES, receive

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
M_TRIM_THRESHOLD, M_TOP_PAD, M_MMAP_THRESHOLD = -1, -2, -3  # of glibc's mallopt


def serve(control_descriptor: int, preload: Sequence[str], rehearsal: tuple[str, str] | None = None) -> None:
    """Fork a child for each request until the control socket closes. Runs in the server process."""
    for name in preload:
        with contextlib.suppress(ImportError):
            import_module(name)
    if rehearsal:
        with contextlib.suppress(Exception):  # calls report their own error, if they fail too
            getattr(import_module(rehearsal[0]), rehearsal[1])()
    child.libraries = library_places()
    prepare()
    # A collection in a child would write to all that it shares with this process, and so copy it.
    gc.collect()
    gc.freeze()
    _freeze_memory()
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
    if module and module not in sys.modules:  # a child may read its code, and need not find it
        with contextlib.suppress(Exception):
            import_module(module)
        child.libraries = library_places()
    work, status = descriptors
    pid = os.fork()
    if not pid:
        _run_child(work)
    os.close(work)
    running[pid] = socket.socket(fileno=status)
    selector.register(running[pid], selectors.EVENT_READ, pid)


def _reap(selector: selectors.BaseSelector, running: dict[int, socket.socket]) -> None:
    """Reap ended children, report their exit status to the callers, and kill processes that they left behind."""
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


def _run_child(work: int) -> None:
    """Answer requests until there are no more, and leave without a trace."""
    code = 1
    enter_sandbox()
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
        while head := receive(connection, LENGTH.size, None):
            request = receive(connection, LENGTH.unpack(head)[1], None)
            if request is None:
                break
            kind, body = answer(request)
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


def _freeze_memory() -> None:
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
