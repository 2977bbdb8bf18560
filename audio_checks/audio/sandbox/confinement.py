"""Rights that a throw-away child drops before it reads a stranger's first byte, and those this kernel cannot take.

In this order: root's user and capabilities, new privileges, files (Landlock), system calls (seccomp). See
docs/decisions/0016-what-a-child-may-reach.md.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import platform
import site
import struct
import sys
import sysconfig
from collections.abc import Sequence

from audio_checks.audio.sandbox import landlock, seccomp
from audio_checks.audio.sandbox.c_library import c_library
from audio_checks.audio.sandbox.syscalls import AUDIT_ARCH

UNPRIVILEGED_ID = 65_532  # of a user who owns no files
PR_SET_PDEATHSIG, PR_SET_KEEPCAPS, PR_SET_NO_NEW_PRIVS = 1, 8, 38
CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH = 1 << 1, 1 << 2
CAPABILITIES_VERSION_3 = 0x20080522
SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib")
SYSTEM_FILES = ("/etc/ld.so.cache", "/etc/localtime", "/usr/share/zoneinfo", "/dev/urandom")
DEVICE = "/dev/null"


def gaps() -> tuple[str, ...]:
    """Return a sentence for each part of the confinement that this system cannot give; none where all is there."""
    if sys.platform != "linux":
        return ("This system is not Linux: checks run without confinement of files and system calls",)
    missing = []
    abi = landlock.version()
    if not abi:
        missing.append("This kernel has no Landlock: checks run without file confinement")
    elif abi < 3:
        missing.append("This kernel's Landlock cannot refuse to truncate files: Linux 6.2 or newer can")
    if platform.machine() not in AUDIT_ARCH:
        missing.append(f"No table of system calls for {platform.machine()}: checks run without a seccomp filter")
    elif not seccomp.is_available():
        missing.append("This kernel has no seccomp filters: checks may open sockets and start processes")
    return tuple(missing)


def confine(reads: Sequence[str], writes: Sequence[str], libraries: Sequence[str]) -> None:
    """Hold this process, which has one thread, for good to what a call needs.

    Parameters
    ----------
    reads, writes : sequence of str
        Absolute paths of files and folders that it may read, and that it may also write.
    libraries : sequence of str
        What its code and its libraries are read from; see `library_places`.

    Raises
    ------
    OSError
        The kernel has a part of the confinement and refuses to apply it.
    """
    if sys.platform != "linux":
        return
    libc = c_library()
    libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    if os.geteuid() == 0:
        _leave_root(libc, writes)
    libc.prctl(PR_SET_PDEATHSIG, 9, 0, 0, 0)  # a change of user has cleared it
    if landlock.version():
        landlock.restrict((*libraries, *SYSTEM_LIBRARIES, *SYSTEM_FILES, *reads), (DEVICE, *writes))
    if seccomp.is_available():
        seccomp.install(os.getpid())


def prepare() -> None:
    """Find out, and make, what is the same for every child of this process."""
    gaps()
    if platform.machine() in AUDIT_ARCH:
        seccomp.program(platform.machine(), 0)


def library_places() -> list[str]:
    """Return the folders and files that this interpreter's code comes from.

    Of a folder that is not the interpreter's own only the packages and modules that are loaded: a checkout may
    contain data next to its code.
    """
    folders = {sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")}
    folders |= {*site.getsitepackages(), os.path.join(sys.base_prefix, "lib"), os.environ.get("NUMBA_CACHE_DIR", "")}
    folders |= set(os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep))
    folders |= {entry for entry in sys.path if os.path.basename(entry) in ("site-packages", "dist-packages")}
    folders = {os.path.realpath(folder) for folder in folders if os.path.isabs(folder)}
    inside = tuple(folder + os.sep for folder in folders)
    places = set(folders)
    for name, module in list(sys.modules.items()):
        if "." not in name:
            module_paths = [*getattr(module, "__path__", ()), getattr(module, "__file__", None)]
            places |= {path for path in module_paths if isinstance(path, str) and not path.startswith(inside)}
    absolute_paths = sorted(path for path in places if os.path.isabs(path))
    return [path for path in absolute_paths if not any(path.startswith(other + os.sep) for other in absolute_paths)]


def _leave_root(libc: ctypes.CDLL, writes: Sequence[str]) -> None:
    """Become a user that owns nothing; keep of root's rights only that to open files that another user owns.

    What is written to belongs to that user from now on. Where the rights to change user were taken from root, as in
    a container without capabilities, nothing changes.
    """
    header = struct.pack("=Ii", CAPABILITIES_VERSION_3, 0)
    held = ctypes.create_string_buffer(24)
    libc.capget(header, held)
    permitted = struct.unpack("=6I", held.raw)[1]
    kept = permitted & CAP_DAC_READ_SEARCH or permitted & CAP_DAC_OVERRIDE
    with contextlib.suppress(PermissionError):
        for path in writes:
            with contextlib.suppress(FileNotFoundError):
                os.chown(path, UNPRIVILEGED_ID, UNPRIVILEGED_ID, follow_symlinks=False)
        libc.prctl(PR_SET_KEEPCAPS, 1, 0, 0, 0)
        os.setgroups([])
        os.setresgid(UNPRIVILEGED_ID, UNPRIVILEGED_ID, UNPRIVILEGED_ID)
        os.setresuid(UNPRIVILEGED_ID, UNPRIVILEGED_ID, UNPRIVILEGED_ID)
    if libc.capset(header, struct.pack("=6I", kept, kept, 0, 0, 0, 0)):
        raise OSError(ctypes.get_errno(), f"capset: {os.strerror(ctypes.get_errno())}")
