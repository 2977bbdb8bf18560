"""Files that arrive whole or not at all: to a name beside their place, checked by their hash, then renamed."""

import os
import shutil
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from app.client.errors import NotFetched, Refusal, ServerUnreachable
from app.client.paths import BLOCK_BYTES, part_of, place_of, sha256_of
from app.client.planning import Write
from app.client.server import CUT, RETRY_DELAYS_S, RangeRefused, Server, wait
from app.client.terminal import Progress

AT_ONCE = 4


class _Cut(Exception):
    """A download ended before its last byte."""


class Downloads:
    """The files of one pull. After the server was unreachable once, no other file waits for it."""

    def __init__(self, server: Server, root: Path, progress: Progress) -> None:
        self._server, self._root, self._progress = server, root, progress
        self._lock = threading.Lock()
        self._unreachable: ServerUnreachable | None = None

    def run(self, writes: Sequence[Write]) -> Iterator[tuple[Write, Exception | None]]:
        """Yield each file once it is in its place, or why it is not."""
        with ThreadPoolExecutor(AT_ONCE) as pool:
            yield from zip(writes, pool.map(self._tried, writes), strict=True)

    def _tried(self, write: Write) -> Exception | None:
        try:
            self._put(write)
        except (NotFetched, Refusal, ServerUnreachable) as error:
            return error
        except OSError as error:
            return NotFetched(f"it cannot be written: {error.strerror or error}")
        return None

    def _put(self, write: Write) -> None:
        """Put one file in its place."""
        entry = write.wanted.entry
        write.place.parent.mkdir(parents=True, exist_ok=True)
        place_of(self._root, entry.path)  # once more: the folder may have changed
        part = part_of(write.place, entry.path, entry.sha256)
        if write.copy_of is not None:
            shutil.copyfile(write.copy_of, part)
            if _digest(part) != entry.sha256:
                part.unlink()
        if _digest(part) != entry.sha256:
            try:
                self._fetch(write, part)
            except NotFetched:
                part.unlink(missing_ok=True)
                raise
        if write.place.exists():
            shutil.copymode(write.place, part)
        part.replace(write.place)
        with self._lock:
            self._progress.add_file()

    def _fetch(self, write: Write, part: Path) -> None:
        """Download one file to its part, going on where an earlier download was cut."""
        tries = iter((*RETRY_DELAYS_S, None))
        from_start = False
        while True:
            if self._unreachable is not None:
                raise self._unreachable
            before = _size(part)
            try:
                self._download(write, part)
                if _digest(part) == write.wanted.entry.sha256:
                    return
                part.unlink()
                if before == 0 or from_start:
                    raise NotFetched("what the server sent is not the approved file: its hash is another")
                from_start = True
            except RangeRefused:
                part.unlink(missing_ok=True)
                if before == 0 or from_start:
                    raise NotFetched("what the server sends is shorter than the approved file") from None
                from_start = True
            except (_Cut, ServerUnreachable) as error:
                if _size(part) > before:
                    tries = iter((*RETRY_DELAYS_S, None))  # it moves: only tries without a byte are counted
                delay_s = next(tries)
                if delay_s is None:
                    raise self._given_up(error) from None
                wait(delay_s, error)

    def _given_up(self, error: Exception) -> ServerUnreachable:
        if not isinstance(error, ServerUnreachable):
            error = ServerUnreachable("the download was cut again and again")
        self._unreachable = error
        return error

    def _download(self, write: Write, part: Path) -> None:
        size_bytes, have = write.wanted.size_bytes, _size(part)
        if have >= size_bytes:
            part.unlink(missing_ok=True)
            have = 0
        headers = {"Range": f"bytes={have}-"} if have else {}
        with self._server.open(self._server.source.server + write.wanted.url, headers) as answer:
            is_rest = answer.status == 206 and (answer.headers.get("content-range") or "").startswith(f"bytes {have}-")
            if answer.status == 206 and not is_rest:
                raise NotFetched("the server sent another part of the file than was asked for")
            with part.open("ab" if is_rest else "wb") as file:
                arrived = have if is_rest else 0
                for block in _blocks(answer.read):
                    arrived += len(block)
                    if arrived > size_bytes:
                        raise NotFetched(f"the server sent more than the {size_bytes} bytes of the approved file")
                    file.write(block)
                    with self._lock:
                        self._progress.add_bytes(len(block))
                file.flush()
                os.fsync(file.fileno())
        if arrived < size_bytes:
            raise _Cut


def _blocks(read: Callable[[int], bytes]) -> Iterator[bytes]:
    """Yield the arriving bytes; raise _Cut where the connection breaks."""
    while True:
        try:
            block = read(BLOCK_BYTES)
        except CUT:
            raise _Cut from None
        if not block:
            return
        yield block


def _size(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


def _digest(path: Path) -> str:
    """Return the hash of a file; empty where there is none."""
    return sha256_of(path) if path.exists() else ""


def remove_old_parts(root: Path, folders: set[Path]) -> None:
    """Remove the leftovers of cut downloads of earlier versions from some folders."""
    for folder in {root, *folders}:
        for part in folder.glob(".soundlist-*.part"):
            part.unlink(missing_ok=True)
