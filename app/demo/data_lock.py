"""Locks on the demo's data folder: one demo at a time, and none before the processes of a killed one have ended."""

import fcntl
import os
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import IO, Self

LEFT_BEHIND_WITHIN_S = 30.0  # what a killed demo leaves behind ends by itself, sooner than this
LOOK_EVERY_S = 0.2


class InUse(Exception):
    """Other processes use this data folder."""


class DataLock:
    """The right to use a data folder: of this process, and of the server and worker that it starts.

    The kernel gives a lock back once the last process that has its file open is gone, however that ended.
    """

    def __init__(
        self, data_dir: Path, begin: Callable[[str], None], *, patience_s: float = LEFT_BEHIND_WITHIN_S
    ) -> None:
        self._data_dir = data_dir
        self._begin = begin
        self._patience_s = patience_s
        self._demo = (data_dir / "soundlist.lock").open("a+")
        self._processes = (data_dir / "processes.lock").open("a+")

    def __enter__(self) -> Self:
        try:
            self._take()
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(self, *_error: object) -> None:
        self._close()

    @property
    def inherited(self) -> int:
        """The descriptor that the server and the worker keep open."""
        return self._processes.fileno()

    def record_processes(self, process_ids: Sequence[int]) -> None:
        """Write down who keeps the folder in use if this process is killed."""
        _write(self._processes, process_ids)

    def _take(self) -> None:
        if not _is_taken(self._demo):
            raise InUse(
                f"{self._data_dir} is in use by another soundlist demo{_processes_in(self._demo)}; "
                "stop it, or choose another folder: make run DATA=another-folder"
            )
        _write(self._demo, [os.getpid()])
        if _is_taken(self._processes):
            return
        self._begin("Waiting for the server and the worker of a demo that was killed")
        deadline = time.monotonic() + self._patience_s
        while not _is_taken(self._processes):
            if time.monotonic() > deadline:
                raise InUse(
                    f"{self._data_dir} is in use by what a killed demo left{_processes_in(self._processes)}; end it by "
                    "kill -9 and the process, or choose another folder: make run DATA=another-folder"
                )
            time.sleep(LOOK_EVERY_S)

    def _close(self) -> None:
        self._demo.close()
        self._processes.close()


def _is_taken(file: IO[str]) -> bool:
    """Take the lock on a file; return False where another process has it."""
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _write(file: IO[str], process_ids: Sequence[int]) -> None:
    file.truncate(0)
    file.write(" ".join(map(str, process_ids)))
    file.flush()


def _processes_in(file: IO[str]) -> str:
    file.seek(0)
    ids = file.read().split()
    return f", process{'es' if len(ids) > 1 else ''} {' and '.join(ids)}" if ids else ""
