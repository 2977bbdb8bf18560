"""What a decoder that was taken over would try, run as real code in a child: none of it leaves the sandbox."""

import ctypes
import os
import signal
import socket
import sqlite3
import struct
import sys
import time
from pathlib import Path

import pytest

from audio_checks import Sandbox, SandboxCrashed, SandboxOutOfMemory, SandboxTimedOut
from audio_checks.audio.sandbox import confinement, confinement_gaps, landlock, seccomp
from audio_checks.audio.sandbox.syscalls import ALLOWED, AUDIT_ARCH, JUDGED

SECRET = "correct-horse-battery-staple"
REFUSED = "PermissionError|Function not implemented"  # by the filter of system calls
needs_landlock = pytest.mark.skipif(not landlock.version(), reason="; ".join(confinement_gaps()))
needs_seccomp = pytest.mark.skipif(not seccomp.is_available(), reason="; ".join(confinement_gaps()))


# x86_64 and aarch64, as in the tables of `syscalls`; the child is given none of them.
NUMBERS = {
    "ptrace": (101, 117), "process_vm_readv": (310, 270), "process_vm_writev": (311, 271), "pidfd_open": (434, 434),
    "bpf": (321, 280), "keyctl": (250, 219), "userfaultfd": (323, 282), "io_uring_setup": (425, 425),
    "mount": (165, 40), "unshare": (272, 97), "setns": (308, 268), "memfd_create": (319, 279),
    "open_by_handle_at": (304, 265), "perf_event_open": (298, 241), "execveat": (322, 281), "prctl": (157, 167),
    "capset": (126, 91), "chmod": (90, None), "mknodat": (259, 33),
}  # fmt: skip


@pytest.fixture(scope="module")
def sandbox():
    before = os.environ.get("SOUNDLIST_SECRET_KEY")
    os.environ["SOUNDLIST_SECRET_KEY"] = SECRET
    box = Sandbox(timeout_s=20, memory_bytes=600 << 20, file_bytes=8 << 20)
    box.call(len, ())
    yield box
    box.close()
    if before is None:
        del os.environ["SOUNDLIST_SECRET_KEY"]
    else:
        os.environ["SOUNDLIST_SECRET_KEY"] = before


@pytest.fixture
def refused(sandbox):
    """Run code in a child, which must end by being refused."""

    def run(code, **files):
        with sandbox.child(**files) as child, pytest.raises(SandboxCrashed, match=REFUSED):
            child.call(exec, code)

    return run


class TestReadingSecrets:
    def test_the_environment_holds_none(self, sandbox):
        seen = sandbox.call(eval, "dict(__import__('os').environ)")
        assert SECRET not in seen.values()
        assert {name for name in seen if "SOUNDLIST" in name or "PYTHON" in name or "TOKEN" in name} == set()

    def test_nor_does_what_the_kernel_keeps_of_it(self, sandbox):
        with sandbox.child() as child:
            server = child.call(os.getppid)
        assert SECRET.encode() not in Path(f"/proc/{server}/environ").read_bytes()

    @needs_landlock
    @pytest.mark.parametrize(
        "path", ["/etc/passwd", "/etc/shadow", "/proc/self/environ", "/proc/{parent}/environ", "/proc/{caller}/environ"]
    )
    def test_no_file_of_the_system(self, refused, path):
        path = path.format(parent="'+str(__import__('os').getppid())+'", caller=os.getpid())
        refused(f"open('{path}').read()")

    @needs_landlock
    def test_no_database_and_no_other_sound(self, refused, sandbox, tmp_path):
        with sqlite3.connect(tmp_path / "soundlist.db") as database:
            database.execute("CREATE TABLE secrets (value)")
        (tmp_path / "mine.wav").write_bytes(b"mine")
        (tmp_path / "other.wav").write_bytes(b"another studio's")
        mine = {"reads": [tmp_path / "mine.wav"]}
        for name in ("soundlist.db", "other.wav"):
            refused(f"open({str(tmp_path / name)!r}, 'rb').read()", **mine)
        refused(f"__import__('os').listdir({str(tmp_path)!r})", **mine)
        with sandbox.child(**mine) as child:
            assert child.call(eval, f"open({str(tmp_path / 'mine.wav')!r}, 'rb').read()") == b"mine"

    def test_no_descriptor_of_the_caller(self, sandbox, tmp_path):
        with open(tmp_path / "log", "w") as log, socket.socket() as listening:
            os.set_inheritable(log.fileno(), True)
            os.set_inheritable(listening.fileno(), True)
            with sandbox.child() as child:
                found = child.call(open_descriptors)
        assert set(found) <= {0, 1, 2, 3}


def open_descriptors():
    found = []
    for number in range(64):
        try:
            os.fstat(number)
        except OSError:
            continue
        found.append(number)
    return found


@needs_landlock
class TestWriting:
    @pytest.mark.parametrize("name", ["new", "there", "folder/new", "shown"])
    def test_outside_of_what_was_given(self, refused, tmp_path, name):
        (tmp_path / "folder").mkdir(mode=0o777)
        for there in ("there", "shown"):
            (tmp_path / there).write_text("whole")
            (tmp_path / there).chmod(0o666)
        tmp_path.chmod(0o777)
        refused(f"open({str(tmp_path / name)!r}, 'w').write('x')", reads=[tmp_path / "shown"])
        assert (tmp_path / "there").read_text() == (tmp_path / "shown").read_text() == "whole"
        assert not list(tmp_path.glob("**/new"))

    @pytest.mark.parametrize(
        "code",
        [
            "os.symlink('/etc/passwd', out + '/link')",
            "os.link(master, out + '/link')",
            "os.rename(master, out + '/moved')",
            "os.mkfifo(out + '/pipe')",
            "os.chmod(master, 0o777)",
            "os.truncate(master, 0)",
            "os.unlink(master)",
            "os.open(master, os.O_RDONLY | os.O_TRUNC)",
            "os.setxattr(master, 'user.x', b'x')",
        ],
    )
    def test_nothing_is_made_of_a_master(self, refused, tmp_path, code):
        (tmp_path / "masters").mkdir()
        (tmp_path / "out").mkdir()
        master = tmp_path / "masters" / "master.wav"
        master.write_bytes(b"master")
        named = f"import os; master, out = {str(master)!r}, {str(tmp_path / 'out')!r}; "
        refused(named + code, reads=[tmp_path / "masters"], writes=[tmp_path / "out"])
        assert master.read_bytes() == b"master"
        assert list((tmp_path / "out").iterdir()) == []


@needs_seccomp
class TestConnecting:
    @pytest.mark.parametrize(
        "kind",
        [
            "AF_INET, SOCK_STREAM",
            "AF_INET, SOCK_DGRAM",
            "AF_INET6, SOCK_STREAM",
            "AF_UNIX, SOCK_STREAM",
            "AF_NETLINK, SOCK_RAW",
        ],
    )
    def test_no_socket_is_made(self, refused, kind):
        family, type_ = kind.split(", ")
        refused(f"import socket; socket.socket(socket.{family}, socket.{type_})")

    def test_nobody_is_reached_over_the_socket_that_is_there(self, refused, tmp_path):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as other:
            other.bind(str(tmp_path / "socket"))
            held = "import socket; held = socket.socket(fileno=3)\n"
            refused(f"{held}try: held.connect({str(tmp_path / 'socket')!r})\nfinally: held.detach()")
            other.setblocking(False)
            with pytest.raises(BlockingIOError):
                other.recv(1)


@needs_seccomp
class TestProcesses:
    @pytest.mark.parametrize(
        "code",
        [
            "os.execv('/bin/sh', ['sh', '-c', 'touch {trap}'])",
            "os.posix_spawn('/bin/sh', ['sh', '-c', 'touch {trap}'], {})",
            "__import__('subprocess').run(['/bin/sh', '-c', 'touch {trap}'])",
        ],
    )
    def test_no_shell_is_started(self, refused, tmp_path, code):
        tmp_path.chmod(0o777)
        refused("import os; " + code.replace("{trap}", str(tmp_path / "trap")))
        assert not (tmp_path / "trap").exists()

    def test_a_fork_bomb_does_not_go_off(self, refused):
        refused("import os\nwhile True: os.fork()")
        refused("import _posixsubprocess, os\nwhile True: os.forkpty()")

    def test_nor_one_of_threads(self, sandbox):
        with pytest.raises(SandboxCrashed, match="can't start new thread"):
            sandbox.call(exec, "import threading\nwhile True: threading.Thread(target=len, args=((),)).start()")

    @pytest.mark.parametrize("call", NUMBERS)
    def test_dangerous_system_calls_are_refused(self, sandbox, call):
        number = NUMBERS[call][AUDIT_ARCH[os.uname().machine][0]]
        if number is None:
            pytest.skip("this machine has no such call")
        assert sandbox.call(errno_of, number, os.getpid()) == 1

    @pytest.mark.parametrize("of", ["os.getppid()", "CALLER", "-1", "1"])
    def test_no_one_else_is_signalled(self, refused, of):
        refused(f"import os; CALLER = {os.getpid()}; os.kill({of}, 0)")
        refused(f"import os; CALLER = {os.getpid()}; os.kill({of}, {int(signal.SIGKILL)})")

    def test_limits_of_other_processes_cannot_be_changed(self, refused):
        refused(f"import resource; resource.prlimit({os.getpid()}, resource.RLIMIT_CPU, (1, 1))")


def errno_of(number, pid):
    libc = ctypes.CDLL(None, use_errno=True)
    return ctypes.get_errno() if libc.syscall(number, 16, pid, 0, 0, 0) == -1 else 0


class TestUsingUp:
    @pytest.mark.slow
    @pytest.mark.parametrize(
        "code",
        [
            "for n in range(10**6): open(f'{out}/{n}', 'wb').write(bytes(1 << 20))",
            "for n in range(10**6): open(f'{out}/{n}', 'wb').close()",
            "import os\nfor n in range(10**6): os.mkdir(f'{out}/{n}')",
            "open(f'{out}/one', 'wb').write(bytes(100 << 20))",
        ],
    )
    def test_the_disk_is_not_filled(self, sandbox, tmp_path, code):
        out = tmp_path / "out"
        out.mkdir()
        with sandbox.child(writes=[out]) as child, pytest.raises(SandboxCrashed, match=r"are allowed|File too large"):
            child.call(exec, f"out = {str(out)!r}\n{code}")
        assert len(list(out.iterdir())) < 200_000

    @pytest.mark.slow
    def test_an_endless_loop_ends(self):
        box = Sandbox(timeout_s=0.7)
        box.call(len, ())
        with pytest.raises(SandboxTimedOut):
            box.call(exec, "while True: pass")
        box.close()

    @pytest.mark.slow
    def test_a_huge_allocation_is_refused(self, sandbox):
        with pytest.raises(SandboxOutOfMemory):
            sandbox.call(bytearray, 64 << 30)

    def test_a_crash_is_an_answer(self, sandbox):
        with pytest.raises(SandboxCrashed, match="SIGSEGV"):
            sandbox.call(ctypes.string_at, 0)
        assert sandbox.call(len, "four") == 4


@pytest.mark.skipif(os.geteuid() != 0, reason="only root has a user to leave")
def test_a_child_of_root_drops_root(sandbox, tmp_path):
    assert sandbox.call(os.getresuid) == (confinement.UNPRIVILEGED_ID,) * 3
    with pytest.raises(SandboxCrashed, match=REFUSED):
        sandbox.call(os.setuid, 0)


@pytest.mark.slow
def test_the_filter_knows_both_machines():
    for machine in AUDIT_ARCH:
        content = seccomp.program(machine, 4_711)
        instructions = list(struct.iter_unpack("=HBBI", content))
        assert len(instructions) < 4_096
        for place, (code, then, otherwise, _) in enumerate(instructions):
            assert code in (seccomp.LOAD, seccomp.JUMP, seccomp.IF_EQUAL, seccomp.RETURN)
            assert place + max(then, otherwise) < len(instructions)
        assert instructions[-1] == (seccomp.RETURN, 0, 0, seccomp.ERRNO | 1)
    columns = list(zip(*(ALLOWED | JUDGED).values(), strict=True))
    for column in columns:
        numbers = [number for number in column if number is not None]
        assert len(numbers) == len(set(numbers))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("abi", "filters", "machine", "said"),
    [
        (0, True, "x86_64", ["This kernel has no Landlock: checks run without file confinement"]),
        (2, True, "aarch64", ["This kernel's Landlock cannot refuse to truncate files: Linux 6.2 or newer can"]),
        (7, False, "x86_64", ["This kernel has no seccomp filters: checks may open sockets and start processes"]),
        (7, True, "riscv64", ["No table of system calls for riscv64: checks run without a seccomp filter"]),
        (7, True, "x86_64", []),
    ],
)
def test_what_the_kernel_cannot_do_is_reported(monkeypatch, abi, filters, machine, said):
    monkeypatch.setattr(landlock, "version", lambda: abi)
    monkeypatch.setattr(seccomp, "is_available", lambda: filters)
    monkeypatch.setattr(confinement.platform, "machine", lambda: machine)
    monkeypatch.setattr(sys, "platform", "linux")
    assert list(confinement_gaps()) == said


@pytest.mark.slow  # other processes cost this one cache and time
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_process_is_confined_within_milliseconds():
    confinement.prepare()
    libraries = confinement.library_places()
    spent_ns = []
    for _ in range(7):
        reader, writer = os.pipe()
        if not (pid := os.fork()):
            started = time.process_time_ns()
            confinement.confine((), (), libraries)
            os.write(writer, struct.pack("<q", time.process_time_ns() - started))
            os._exit(0)
        spent_ns += struct.unpack("<q", os.read(reader, 8))
        os.waitpid(pid, 0)
        os.close(reader)
        os.close(writer)
    assert min(spent_ns) < 5_000_000  # about one on a free machine
