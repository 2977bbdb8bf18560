"""The sandbox: whatever a child does, the caller gets an answer or a named failure, and nothing stays."""

import contextlib
import ctypes
import gc
import math
import os
import pickle
import resource
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.sandbox import Sandbox, calls
from audio_checks.errors import (
    RenderRefused,
    SandboxCrashed,
    SandboxOutOfMemory,
    SandboxTimedOut,
    SpecError,
    Unreadable,
)
from audio_checks.wav import Chunk
from tests.support.waves import sine, write_wav


@pytest.fixture(scope="module")
def sandbox():
    box = Sandbox(timeout_s=20)
    yield box
    box.close()


@pytest.fixture
def own_sandbox():
    """A sandbox that a test may end, and whose time it may set."""
    box = Sandbox(timeout_s=60)
    box.call(len, ())  # the server's start is not what is timed
    yield box
    box.close()


def descendants():
    """Every process below this one, the dead but unburied included."""
    parents = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                text = (entry / "stat").read_text()
            except OSError:
                continue
            parents[int(entry.name)] = int(text.rpartition(")")[2].split()[1])
    below, wave = set(), {os.getpid()}
    while wave:
        wave = {pid for pid, parent in parents.items() if parent in wave}
        below |= wave
    return below


def test_results_come_back(sandbox):
    assert sandbox.call(len, [1, 2, 3]) == 3
    assert sandbox.call(sorted, [2, 1], reverse=True) == [2, 1]
    assert sandbox.call(os.getpid) not in (os.getpid(), sandbox.call(os.getpid))
    assert sandbox.call(eval, "-float('inf'), None, {'a': {1, 2}}, b'x' * 3") == (
        -math.inf,
        None,
        {"a": {1, 2}},
        b"xxx",
    )
    assert np.array_equal(sandbox.call(np.arange, 5.0), np.arange(5.0))
    assert sandbox.call(Chunk, "data", 44, 8) == Chunk("data", 44, 8)


def test_a_child_answers_calls_that_belong_together(sandbox):
    with sandbox.child() as child, sandbox.child() as other:
        pid = child.call(process_id)
        assert child.call(process_id) == pid != other.call(process_id)
        with pytest.raises(RenderRefused):
            child.call(refuse)  # an answer too
        assert child.call(process_id) == pid
        child.close()
        assert (later := child.call(process_id)) != pid
    assert {pid, later}.isdisjoint(descendants())


def process_id():
    return os.getpid()


def refuse():
    raise RenderRefused("m", "render:upwards", "f")


@pytest.mark.parametrize(
    ("failure", "function", "given"),
    [
        (SandboxCrashed, os.kill, None),
        (SandboxCrashed, int, "no number"),
        (SandboxOutOfMemory, bytes, 8 << 30),
        (SandboxTimedOut, time.sleep, 60),
    ],
)
def test_after_a_failure_the_next_call_gets_a_new_child(sandbox, failure, function, given):
    with sandbox.child() as child:
        pid = child.call(os.getpid)
        child.timeout_s = 0.7
        with pytest.raises(failure):
            child.call(function, *((pid, signal.SIGSEGV) if given is None else (given,)))
        assert pid not in descendants()
        child.timeout_s = 20.0
        assert child.call(os.getpid) != pid


def spend_cpu(seconds):
    begun = time.process_time()
    while time.process_time() < begun + seconds:
        pass
    return resource.getrlimit(resource.RLIMIT_CPU)[0] - time.process_time()


@pytest.mark.slow  # seconds of the clock count too
def test_the_time_of_a_call_is_not_taken_from_the_next(sandbox):
    sandbox.call(spend_cpu, 0.0)  # what the server loads for it is not its time
    with sandbox.child(timeout_s=5.0) as child:
        first, second = child.call(spend_cpu, 1.1), child.call(spend_cpu, 0.0)
    assert second > first > 4.0


@pytest.mark.slow
def test_large_arguments_and_results(sandbox):
    assert sandbox.call(bytes.upper, b"a" * 20_000_000) == b"A" * 20_000_000


def test_errors_of_ours_come_back_as_they_are(sandbox, tmp_path):
    (tmp_path / "song.wav").write_bytes(b"ID3" + bytes(100))
    with sandbox.child(reads=[tmp_path]) as child, pytest.raises(Unreadable, match="MP3") as refusal:
        child.call(AudioFile, str(tmp_path / "song.wav"))
    assert (refusal.value.rule, refusal.value.code) == ("R11", "container:mp3")
    assert refusal.value.fix


@pytest.mark.parametrize(
    "error",
    [
        Unreadable("m", "R1", "structure:truncated", "f"),
        SpecError("m", "limits.peak"),
        RenderRefused("m", "render:upwards", "f"),
        SandboxCrashed("m", "d", 11),
    ],
)
def test_errors_survive_pickling(error):
    twin = pickle.loads(pickle.dumps(error))  # noqa: S301
    assert (type(twin), str(twin), vars(twin)) == (type(error), "m", vars(error))


@pytest.mark.parametrize(
    ("call", "ending"),
    [
        ((ctypes.string_at, 0), signal.SIGSEGV),
        ((os.abort,), signal.SIGABRT),
        ((exec, "import os; os.kill(os.getpid(), 9)"), signal.SIGKILL),
        ((os._exit, 0), None),
        ((os._exit, 3), None),
        ((sys.exit, 0), None),
        ((exec, "raise KeyboardInterrupt"), None),
        ((exec, "1 / 0"), None),
        ((exec, "def f(): f()\nf()"), None),
        ((eval, "lambda: 1"), None),
        ((eval, "print"), None),
        ((eval, "__import__('subprocess').Popen"), None),
        ((open, "/dev/null"), None),
    ],
)
def test_crashes_have_a_name(sandbox, call, ending):
    with pytest.raises(SandboxCrashed) as failure:
        sandbox.call(*call)
    assert failure.value.signal == ending
    assert sandbox.call(len, "fine") == 4


def test_a_failure_names_its_place(sandbox):
    with pytest.raises(SandboxCrashed, match="ZeroDivisionError") as failure:
        sandbox.call(divmod, 1, 0)
    assert "Traceback" in failure.value.detail


@pytest.mark.slow
@pytest.mark.parametrize(
    "code",
    [
        "while True: pass",
        "import time\nwhile True:\n  try: time.sleep(9)\n  except BaseException: pass",
        "import signal, time\nfor n in range(1, 32):\n  try: signal.signal(n, signal.SIG_IGN)\n  except OSError: pass\n"
        "while True:\n  time.sleep(99)",
    ],
)
def test_what_does_not_end_is_ended(own_sandbox, code):
    own_sandbox.timeout_s = 0.7
    with pytest.raises(SandboxTimedOut):
        own_sandbox.call(exec, code)  # waiting for the code would never end
    own_sandbox.timeout_s = 60
    assert own_sandbox.call(len, "fine") == 4


@pytest.mark.slow
@pytest.mark.parametrize(
    "code",
    [
        "import os, time\nos.closerange(0, 200)\ntime.sleep(99)",
        "import os, time\nos.write(3, b'r' + b'\\xff' * 8)\ntime.sleep(99)",
        "import os, time\nos.write(3, b'r\\x05' + bytes(7) + b'junk!')\ntime.sleep(99)",
        "import os\nos.write(3, b'r\\x05' + bytes(7) + b'ju')\nos._exit(0)",
        "import os\nos.write(3, b'?\\x01' + bytes(7) + b'x')\nos._exit(0)",
        "import os\nos.write(3, b'e\\x04' + bytes(7) + b'K\\x01K\\x01')\nos._exit(0)",
    ],
)
def test_a_child_that_lies_or_hangs_up(own_sandbox, code):
    with pytest.raises(SandboxCrashed):
        own_sandbox.call(exec, code)
    assert own_sandbox.call(len, "fine") == 4


NAMES_A_PROGRAM = b'["enum","audio_checks.cli.__main__","x","y"]'


@pytest.mark.slow
def test_a_taken_over_child_cannot_run_code_here(own_sandbox, tmp_path):
    trap = tmp_path / "trap"
    for said, why in (
        (f"cos\nsystem\n(S'touch {trap}'\ntR.".encode(), "Expecting value"),
        (NAMES_A_PROGRAM, "may not come out"),
    ):
        evil = len(said).to_bytes(8, "little") + said
        code = f"import os\nos.write(3, b'r' + {len(evil).to_bytes(8, 'little')!r} + {evil!r})\nos._exit(0)"
        with pytest.raises(SandboxCrashed, match=why):
            own_sandbox.call(exec, code)
    assert not trap.exists()


@pytest.mark.slow
def test_nothing_stays_behind(own_sandbox):
    breed = (
        "import os, time\nfor _ in range(8):\n  if not os.fork():\n    os.setsid()\n    time.sleep(30)\n    os._exit(0)"
    )
    own_sandbox.timeout_s = 0.7
    before = descendants()
    assert len(before) >= 1  # the server
    for code in ("0", "import os; os._exit(1)", breed, breed + "\nos._exit(2)", breed + "\ntime.sleep(30)"):
        with contextlib.suppress(SandboxCrashed, SandboxTimedOut):
            own_sandbox.call(exec, code)
    deadline = time.monotonic() + 240
    while descendants() - before and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not descendants() - before


@pytest.mark.slow
def test_descriptors_of_the_caller_do_not_leak(own_sandbox):
    before = len(os.listdir("/proc/self/fd"))
    for _ in range(20):
        own_sandbox.call(len, ())
    with pytest.raises(SandboxCrashed):
        own_sandbox.call(os._exit, 1)
    assert len(os.listdir("/proc/self/fd")) == before
    with open("/dev/null"), pytest.raises(SandboxCrashed, match="Bad file descriptor"):
        own_sandbox.call(os.fstat, 4)


@pytest.mark.slow
def test_a_dead_server_is_replaced(own_sandbox):
    os.kill(own_sandbox.call(os.getppid), signal.SIGKILL)
    with contextlib.suppress(SandboxCrashed):  # the call that finds it dead
        own_sandbox.call(len, "fine")
    assert own_sandbox.call(len, "fine") == 4
    own_sandbox.close()
    assert own_sandbox.call(len, "fine") == 4


def test_threads_share_one_sandbox(sandbox):
    answers = {}

    def work(number):
        for turn in range(10):
            if turn == 5:
                with pytest.raises(SandboxCrashed):
                    sandbox.call(os._exit, number)
            answers[number, turn] = sandbox.call(pow, number, turn)

    threads = [threading.Thread(target=work, args=(number,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers == {(number, turn): number**turn for number in range(6) for turn in range(10)}


@pytest.mark.slow
def test_the_server_ends_with_its_caller():
    script = (
        "import os\nfrom audio_checks.audio.sandbox import Sandbox\n"
        "box = Sandbox()\nprint(box.call(os.getppid), flush=True)\n"
        "os.kill(os.getpid(), 9)"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300)
    server = Path(f"/proc/{int(done.stdout)}")
    deadline = time.monotonic() + 240
    while server.exists() and time.monotonic() < deadline and " Z " not in (server / "stat").read_text():
        time.sleep(0.01)
    assert not server.exists() or " Z " in (server / "stat").read_text()


@pytest.mark.slow
def test_without_fork_each_call_has_its_own_interpreter(monkeypatch, tmp_path):
    monkeypatch.setattr(calls, "CAN_FORK", False)
    path = write_wav(tmp_path / "beep.wav", sine(hz=997, seconds=0.1))
    box = Sandbox(timeout_s=20)
    assert box.call(len, "fine") == 4
    assert box.call(exec, "print('to standard output')") is None
    with pytest.raises(SandboxCrashed) as failure:
        box.call(ctypes.string_at, 0)
    assert failure.value.signal == signal.SIGSEGV
    with pytest.raises(SandboxTimedOut):
        Sandbox(timeout_s=0.5).call(time.sleep, 30)
    path.write_bytes(b"fLaC" + bytes(100))
    with box.child(reads=[path]) as child, pytest.raises(Unreadable, match="FLAC"):
        child.call(AudioFile, str(path))


def test_one_server_makes_the_children_of_all_calls(sandbox):
    assert len({sandbox.call(os.getpid) for _ in range(3)}) == 3
    servers = {sandbox.call(os.getppid) for _ in range(3)}
    assert len(servers) == 1
    assert os.getpid() not in servers


@pytest.mark.slow
def test_a_child_collects_nothing_of_what_it_shares(sandbox):
    assert sandbox.call(gc.get_freeze_count) > 10_000
