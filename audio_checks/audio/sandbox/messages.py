"""Messages of caller and child: a request, and an answer that is not trusted."""

from __future__ import annotations

import dataclasses
import os
import socket
import struct
import time
from collections.abc import Callable
from typing import Any

from audio_checks.audio.sandbox.answers import ensure_declared, ensure_expected
from audio_checks.audio.sandbox.plain import decode
from audio_checks.errors import AudioChecksError, SandboxCrashed, SandboxOutOfMemory

CAN_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds")
NAME_BYTES = 256  # of a module's name on its way to the server
MEANWHILE_S = 0.1
LENGTH = struct.Struct("<cQ")
RETURNED, RAISED, NO_MEMORY, FAILED = b"r", b"e", b"m", b"f"
DETAIL_CHARACTERS = 8_000


@dataclasses.dataclass(frozen=True)
class Limits:
    """A child's limits for one call."""

    memory_bytes: int
    cpu_s: int
    file_bytes: int
    open_files: int
    result_bytes: int


@dataclasses.dataclass(frozen=True)
class Access:
    """The files that a child may reach for its whole life: absolute paths of files and folders."""

    reads: tuple[str, ...]
    writes: tuple[str, ...]
    scratch: str  # a folder for temporary files, also written to


def receive(
    work: socket.socket, count: int, deadline: float | None, meanwhile: Callable[[], None] | None = None
) -> bytes | None:
    """Return exactly `count` bytes, or None when the other end closed before; `meanwhile` is called now and then."""
    content = bytearray()
    while len(content) < count:
        if deadline is not None:
            left = deadline - time.monotonic()
            if left <= 0:
                raise TimeoutError
            work.settimeout(left if meanwhile is None else min(left, MEANWHILE_S))
        try:
            piece = work.recv(min(count - len(content), 1 << 20))
        except TimeoutError:
            if meanwhile is None:
                raise
            meanwhile()
            continue
        if not piece:
            return None
        content += piece
    return bytes(content)


def resolved(answer: tuple[bytes, bytes], function: Callable[..., Any]) -> Any:
    """Return or raise what the child answered; an answer is of the type that the called function declares."""
    kind, body = answer
    if kind == NO_MEMORY:
        raise SandboxOutOfMemory("the call wanted more memory than it may have")
    if kind == FAILED:
        detail = "".join(c if c.isprintable() or c == "\n" else "?" for c in body.decode("utf-8", "replace"))
        detail = detail[-DETAIL_CHARACTERS:]
        raise SandboxCrashed(f"the call failed: {detail.strip().splitlines()[-1] if detail.strip() else '?'}", detail)
    try:
        value = decode(body)
        if kind == RAISED:
            ensure_expected([value.args, vars(value)])
        else:
            ensure_expected(value)
            ensure_declared(value, function)
    except Exception as error:
        raise SandboxCrashed(f"the child's answer cannot be read: {error}") from error
    if kind == RAISED:
        raise value if isinstance(value, AudioChecksError) else SandboxCrashed("the child raised no error of ours")
    return value
