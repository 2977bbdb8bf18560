"""Memory that large requests needed at once goes back to the system."""

import json
import platform
import subprocess
import sys
import threading
import time
import weakref

import pytest

from app.kit import memory

MEASURE = """
import json, sys, threading
if sys.argv[1] == "set up":
    from app.kit.memory import return_free_memory
    return_free_memory()

def mib():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096 / 2**20

def work():
    bytes(20 << 20)  # freed: by default glibc then takes blocks of up to 20 MiB from its heaps
    barrier.wait()
    held = [[bytes(200 << 10) for _ in range(50)] for _ in range(2)]
    held.append([bytes(600) for _ in range(20)])
    del held[:2]
    barrier.wait()
    kept.append(held)
    done.wait()

barrier, done, kept = threading.Barrier(9), threading.Event(), []
threads = [threading.Thread(target=work) for _ in range(8)]
before = mib()
for thread in threads:
    thread.start()
barrier.wait()
barrier.wait()
print(json.dumps(mib() - before), flush=True)
done.set()
"""

BETWEEN = """
import json, threading, time
from app.kit import memory

def mib():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096 / 2**20

memory.return_free_memory()
before = mib()
blocks = [(bytearray(100_000), bytearray(1_000)) for _ in range(1_000)]
kept = [small for _, small in blocks]
del blocks
free = mib() - before
memory.COLLECT_EVERY_S = 0.05
memory.collect_garbage(until=threading.Event())
deadline = time.monotonic() + 240
while mib() - before > free / 2 and time.monotonic() < deadline:
    time.sleep(0.05)
print(json.dumps([free, mib() - before]))
"""


@pytest.mark.slow
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other allocators return memory by themselves")
def test_free_memory_of_many_threads_returns():
    def left_mib(how: str) -> float:
        done = subprocess.run(
            [sys.executable, "-c", MEASURE, how], capture_output=True, text=True, check=True, timeout=300
        )
        return float(json.loads(done.stdout))

    assert left_mib("as it is") > 100, "glibc keeps free memory: without this there is nothing to set up"
    assert left_mib("set up") < 30


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other allocators return memory by themselves")
def test_what_is_free_between_blocks_in_use_returns():
    done = subprocess.run([sys.executable, "-c", BETWEEN], capture_output=True, text=True, check=True, timeout=300)
    free_mib, left_mib = json.loads(done.stdout)
    assert free_mib > 60, "glibc keeps it: without this there is nothing to return"
    assert left_mib < 30


@pytest.mark.slow
def test_what_refers_to_itself_is_freed_while_nothing_else_happens(monkeypatch):
    class Refused:
        pass

    monkeypatch.setattr(memory, "COLLECT_EVERY_S", 0.01)
    refused, over = Refused(), threading.Event()
    refused.itself, freed = refused, weakref.ref(refused)
    memory.collect_garbage(until=over)
    try:
        del refused
        deadline = time.monotonic() + 240
        while freed() is not None and time.monotonic() < deadline:
            time.sleep(0.01)
        assert freed() is None
    finally:
        over.set()
