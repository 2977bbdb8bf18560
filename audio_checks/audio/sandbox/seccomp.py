"""The seccomp filter of a throw-away child: a BPF program made of the table of system calls.

Source: Linux, Documentation/userspace-api/seccomp_filter.rst and include/uapi/linux/seccomp.h.
"""

from __future__ import annotations

import ctypes
import errno
import functools
import os
import platform
import struct
from collections.abc import Iterator

from audio_checks.audio.sandbox.c_library import c_library
from audio_checks.audio.sandbox.syscalls import ALLOWED, AUDIT_ARCH, JUDGED

PR_SET_SECCOMP, MODE_FILTER = 22, 2
LOAD, JUMP, IF_EQUAL, RETURN = 0x20, 0x05, 0x15, 0x06  # BPF_LD|W|ABS, BPF_JMP|JA, BPF_JMP|JEQ|K, BPF_RET|K
NUMBER, ARCHITECTURE, FIRST, SECOND = 0, 4, 16, 24  # offsets in struct seccomp_data, of the lower half of an argument
ALLOW, ERRNO, KILL_PROCESS = 0x7FFF0000, 0x00050000, 0x80000000
TERMINAL_IOCTLS = (0x5401, 0x5421, 0x5450, 0x5451)  # TCGETS, FIONBIO, FIONCLEX, FIOCLEX
DESCRIPTOR_FCNTLS = (0, 1, 2, 3, 4, 1030)  # F_DUPFD, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_DUPFD_CLOEXEC


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


@functools.cache
def is_available() -> bool:
    """Return whether this kernel takes filters, and the table knows this machine."""
    if platform.machine() not in AUDIT_ARCH:
        return False
    c_library().prctl(PR_SET_SECCOMP, MODE_FILTER, None, 0, 0)  # no filter: a kernel that takes them cannot read it
    return ctypes.get_errno() == errno.EFAULT


def program(machine: str, pid: int) -> bytes:
    """Return the filter for a machine and a process, as an array of struct sock_filter."""
    column, _ = AUDIT_ARCH[machine]
    instructions = list(_of_every_process(machine))
    for name in ("kill", "tgkill"):
        instructions += _if_argument(JUDGED[name][column], FIRST, (pid,))
    return b"".join([*instructions, _instruction(RETURN, ERRNO | errno.EPERM)])


@functools.cache
def _of_every_process(machine: str) -> tuple[bytes, ...]:
    """Return the part of the filter that the server makes once for all its children."""
    column, architecture = AUDIT_ARCH[machine]
    instructions = [
        _instruction(LOAD, ARCHITECTURE),
        _instruction(IF_EQUAL, architecture, then=1),
        _instruction(RETURN, KILL_PROCESS),
        _instruction(LOAD, NUMBER),
    ]
    allowed = [number for numbers in ALLOWED.values() if (number := numbers[column]) is not None]
    # One answer for all of them: the kernel goes through a new filter once for each call that it has.
    instructions += [_instruction(IF_EQUAL, number, then=len(allowed) - index) for index, number in enumerate(allowed)]
    instructions += [_instruction(JUMP, 1), _instruction(RETURN, ALLOW)]
    for name, offset, values in (
        ("ioctl", SECOND, TERMINAL_IOCTLS),
        ("fcntl", SECOND, DESCRIPTOR_FCNTLS),  # no owner of signals, no leases
        ("prlimit64", FIRST, (0,)),
    ):
        instructions += _if_argument(JUDGED[name][column], offset, values)
    # As a kernel without threads answers, so that libraries with pools of threads work without them: rayon does.
    refused = _instruction(RETURN, ERRNO | errno.ENOSYS)
    for name in ("clone", "clone3"):
        number = JUDGED[name][column]
        assert number is not None  # noqa: S101 - both machines have it
        instructions += [_instruction(IF_EQUAL, number, otherwise=1), refused]
    return tuple(instructions)


def install(pid: int) -> None:
    """Hold this thread to the filter for good; OSError where the kernel refuses."""
    content = program(platform.machine(), pid)
    filter_program = _Program(len(content) // 8, content)
    if c_library().prctl(PR_SET_SECCOMP, MODE_FILTER, ctypes.byref(filter_program), 0, 0):
        raise OSError(ctypes.get_errno(), f"seccomp: {os.strerror(ctypes.get_errno())}")


def _if_argument(number: int | None, offset: int, values: tuple[int, ...]) -> Iterator[bytes]:
    """Yield the code to allow a system call where the lower half of one argument is one of some values."""
    if number is None:
        return
    yield _instruction(IF_EQUAL, number, otherwise=2 * len(values) + 2)
    yield _instruction(LOAD, offset)
    for value in values:
        yield _instruction(IF_EQUAL, value, otherwise=1)
        yield _instruction(RETURN, ALLOW)
    yield _instruction(RETURN, ERRNO | errno.EPERM)


def _instruction(code: int, value: int, *, then: int = 0, otherwise: int = 0) -> bytes:
    return struct.pack("=HBBI", code, then, otherwise, value)
