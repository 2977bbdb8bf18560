"""Memory, files and results of the sandbox's children: what they get, keep and are refused."""

import platform
import resource

import numpy as np
import pytest

from audio_checks.audio.sandbox import Sandbox
from audio_checks.errors import (
    SandboxCrashed,
    SandboxOutOfMemory,
)


@pytest.fixture(scope="module")
def sandbox():
    box = Sandbox(timeout_s=20)
    yield box
    box.close()


def faults_of_samples_taken_again():
    """New pages that this process is given for a block of samples as large as one it has just let go of."""
    block = np.ones(1 << 20)
    del block
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    np.ones(1 << 20)
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc can be set up to keep memory")
def test_a_child_keeps_the_memory_that_it_was_given(sandbox):
    pages = (8 << 20) // resource.getpagesize()
    assert sandbox.call(faults_of_samples_taken_again) < pages / 100


@pytest.mark.slow
@pytest.mark.parametrize("code", ["bytearray(4 << 30)", "[bytearray(1 << 24) for _ in range(1000)]", "'x' * (1 << 34)"])
def test_memory_is_limited(code):
    box = Sandbox(timeout_s=20, memory_bytes=400 << 20)
    try:
        with pytest.raises(SandboxOutOfMemory):
            box.call(exec, code)
        assert box.call(len, "fine") == 4
    finally:
        box.close()


@pytest.mark.slow
def test_a_large_result_is_refused():
    box = Sandbox(timeout_s=20, result_bytes=1_000)
    try:
        assert len(box.call(bytes, 900)) == 900
        with pytest.raises(SandboxCrashed, match="1000 are allowed"):
            box.call(bytes, 1_000)
    finally:
        box.close()


@pytest.mark.slow
def test_files_and_descriptors_are_limited(tmp_path):
    box = Sandbox(timeout_s=20, file_bytes=10_000)
    try:
        with box.child(writes=[tmp_path]) as child, pytest.raises(SandboxCrashed, match=r"File too large|are allowed"):
            child.call(
                exec,
                f"open({str(tmp_path / 'big')!r}, 'wb', buffering=0).write(bytes(9000)) and "
                f"open({str(tmp_path / 'big')!r}, 'ab', buffering=0).write(bytes(9000)) and "
                f"open({str(tmp_path / 'big')!r}, 'ab', buffering=0).write(bytes(9000))",
            )
        with pytest.raises(SandboxCrashed, match="Too many open files"):
            box.call(exec, "files = [open('/dev/null') for _ in range(100)]")
    finally:
        box.close()


def faults_of_blocks(count):
    """Take, fill and let go of so many blocks of 8 MiB; return the pages that the system had to give for it."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _ in range(count):
        np.ones(1 << 20)
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before


@pytest.mark.slow
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other allocators are not set up")
def test_memory_that_was_let_go_of_is_used_again(sandbox):
    assert sandbox.call(faults_of_blocks, 20) < 2 * (8 << 20) / resource.getpagesize()
