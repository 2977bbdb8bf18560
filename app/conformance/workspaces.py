"""Workspaces of takes: the master, and a child of the sandbox shared by the takes of one delivery."""

import os
import secrets
import shutil
import threading
import time
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Self
from uuid import UUID

from app.core.storage import Store
from audio_checks import Sandbox, SandboxChild

IDLE_S = 3.0  # a child that waits for its delivery's next take holds memory; it waits for twice as long at most
MAX_IDLE = 8
MAX_TAKES = 100
LARGE_BYTES = 64 << 20  # behind a larger master a child holds more than a new one costs


@dataclass
class _Lease:
    """A child, and the only folders that it reaches: masters to read, one take's at a time, and outputs to write."""

    child: SandboxChild
    delivery_id: UUID
    masters: Path
    outputs: Path
    folders: ExitStack
    takes: int = 0
    idle_since_s: float = 0.0

    def show(self, master: Path) -> Path:
        """Put a master where the child may read it, without copying it where the disk has links."""
        shown = self.masters / f"{self.takes}-{master.name}"
        try:
            os.link(master, shown)
        except OSError:
            shutil.copyfile(master, shown)
        return shown

    def clear(self) -> None:
        """Leave nothing of a take for the next one of its delivery."""
        for folder in (self.masters, self.outputs):
            for entry in folder.iterdir():
                if entry.is_dir() and not entry.is_symlink():
                    shutil.rmtree(entry)
                else:
                    entry.unlink()

    def end(self) -> None:
        """End the child, and remove its folders."""
        self.child.close()
        self.folders.close()


class SandboxPool:
    """Lends children of one sandbox; what served a take of a delivery serves more of it, and nothing else."""

    def __init__(self, sandbox: Sandbox) -> None:
        self._sandbox = sandbox
        self._lock = threading.Lock()
        self._idle: list[_Lease] = []  # who waits longest comes first
        self._sweeping = False

    def acquire(self, delivery_id: UUID, store: Store) -> _Lease:
        """Return a child that served this delivery and waits, or a new one; its folders are the store's."""
        with self._lock:
            for lease in reversed(self._idle):
                if lease.delivery_id == delivery_id:
                    self._idle.remove(lease)
                    return lease
        with ExitStack() as folders:
            folder = folders.enter_context(store.making())
            masters, outputs = folder / "masters", folder / "outputs"
            masters.mkdir()
            outputs.mkdir()
            child = self._sandbox.child(reads=[masters], writes=[outputs])
            return _Lease(child, delivery_id, masters, outputs, folders.pop_all())

    def release(self, lease: _Lease) -> None:
        """Keep a child for some seconds, for the next take of its delivery."""
        lease.takes += 1
        if lease.takes >= MAX_TAKES:
            lease.end()
            return
        try:
            lease.clear()
        except OSError:  # something in there still works: an honest child waits
            lease.end()
            return
        lease.idle_since_s = time.monotonic()
        with self._lock:
            self._idle.append(lease)
            ended, self._idle = self._idle[:-MAX_IDLE], self._idle[-MAX_IDLE:]
            if not self._sweeping:
                self._sweep_later()
        _end(ended)

    def _sweep_later(self) -> None:
        self._sweeping = True
        timer = threading.Timer(IDLE_S, self._sweep)
        timer.daemon = True
        timer.start()

    def _sweep(self) -> None:
        before_s = time.monotonic() - IDLE_S
        with self._lock:
            ended = [lease for lease in self._idle if lease.idle_since_s <= before_s]
            self._idle = [lease for lease in self._idle if lease.idle_since_s > before_s]
            self._sweeping = False
            if self._idle:
                self._sweep_later()
        _end(ended)


def _end(ended: list[_Lease]) -> None:
    for lease in ended:
        lease.end()


class TakeWorkspace:
    """The workspace of one take: one child for all of it, and its master, fetched once."""

    def __init__(self, store: Store, children: SandboxPool) -> None:
        self._store = store
        self._children = children
        self._held = ExitStack()
        self._lent: _Lease | None = None
        self._copy: Path | None = None
        self._shown: Path | None = None
        self._may_keep = True

    def __enter__(self) -> Self:
        """Begin nothing: child and master are there once they are asked for."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, _error: BaseException | None, _at: TracebackType | None
    ) -> None:
        """Give the child back, or have it ended where it may hold much or the work broke off; let the master go."""
        try:
            if self._lent is not None:
                if kind is None and self._may_keep:
                    self._children.release(self._lent)
                else:
                    self._lent.end()
        finally:
            self._held.close()

    def child(self, delivery_id: UUID) -> SandboxChild:
        """Return the child for the take, which is of this delivery."""
        if self._lent is None:
            self._lent = self._children.acquire(delivery_id, self._store)
        return self._lent.child

    def master(self, studio_id: UUID, sha256: str) -> Path:
        """Return the path of the take's master; raise BlobMissing or BlobAltered if the store no longer has it.

        The child can read it only if it was requested before the child started.
        """
        if self._copy is None:
            self._copy = self._held.enter_context(self._store.local_copy(studio_id, sha256))
            self._may_keep = self._copy.stat().st_size <= LARGE_BYTES
        if self._lent is None:
            return self._copy
        if self._shown is None:
            self._shown = self._lent.show(self._copy)
        return self._shown

    def new_place(self, delivery_id: UUID) -> Path:
        """Return the path of a folder that the child may make; its content is deleted with the workspace."""
        self.child(delivery_id)
        assert self._lent is not None  # noqa: S101 - child has lent it
        return self._lent.outputs / secrets.token_hex(8)
