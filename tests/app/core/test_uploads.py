"""Nothing that was acknowledged is ever lost, wherever the process or the line breaks."""

import asyncio
import hashlib
import os
import resource
import threading
import time
from collections.abc import AsyncIterator, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from app.core import kill_points
from app.core.db import Base, Database, new_id
from app.core.storage import FolderStore
from app.core.uploads import (
    CHECKSUMS,
    Checksum,
    ChecksumMismatch,
    MinimumRate,
    OffsetMismatch,
    StoreFull,
    Upload,
    UploadBusy,
    UploadNotFound,
    Uploads,
    UploadStalled,
    UploadTooLong,
    UploadUnfinished,
    finished_upload,
)
from app.core.uploads import (
    staged as uploads,
)

STUDIO, OWNER = new_id(), new_id()
CONTENT = bytes(range(256)) * 20_000  # 5 MB, so that it is written in several pieces
SHA256 = hashlib.sha256(CONTENT).hexdigest()


class TimerLoop(asyncio.SelectorEventLoop):
    """A loop whose clock moves by its timers alone: no wait takes real time, and no load of the machine is seen."""

    _now_s = 0.0

    def time(self) -> float:
        return self._now_s

    def _run_once(self) -> None:
        if not self._ready and self._scheduled:
            self._now_s = max(self._now_s, self._scheduled[0].when())
        super()._run_once()


class Killed(BaseException):
    """Simulates SIGKILL: nothing after it runs, but what `finally` does to open files, as the kernel would."""


@pytest.fixture
def database(tmp_path: Path) -> Iterator[Database]:
    database = Database(f"sqlite:///{tmp_path / 'test.sqlite'}")
    Base.metadata.create_all(database.engine, tables=[Base.metadata.tables["core_uploads"]])
    yield database
    database.dispose()


@pytest.fixture
def store(tmp_path: Path) -> FolderStore:
    return FolderStore(tmp_path / "blobs")


@pytest.fixture
def incoming(database: Database, store: FolderStore) -> Uploads:
    return Uploads(database, store)


def begun(incoming: Uploads, length: int = len(CONTENT), **more: Any) -> Upload:
    return incoming.create(
        studio_id=STUDIO,
        owner_id=OWNER,
        scope="delivery",
        file_name="laser.wav",
        length=length,
        max_length=1 << 40,
        **more,
    )


async def stream(content: bytes, *, breaks_after: int | None = None) -> AsyncIterator[bytes]:
    for start in range(0, len(content) if breaks_after is None else breaks_after, 65_536):
        yield content[start : start + 65_536]
    if breaks_after is not None:
        raise ConnectionResetError("the line dropped")


def send(incoming: Uploads, upload: Upload, offset: int, content: bytes, **more: Any) -> Upload:
    return asyncio.run(incoming.receive(upload, offset, stream(content), **more))


def staged(store: FolderStore) -> list[Path]:
    return list(store.root.glob(f"*/{uploads.STAGING}/*"))


def find(incoming: Uploads, upload: Upload) -> Upload:
    return incoming.find(upload.id, owner_id=OWNER)


def grow_old(path: Path, seconds: float) -> None:
    os.utime(path, (time.time() - seconds,) * 2)


def test_pieces_become_the_file_that_was_sent(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming)
    upload = send(incoming, upload, 0, CONTENT[:1_000_003])
    assert (upload.sha256, incoming.offset(upload)) == (None, 1_000_003)
    upload = send(incoming, upload, 1_000_003, CONTENT[1_000_003:])
    assert upload.sha256 == SHA256
    assert store.read(STUDIO, SHA256) == CONTENT
    assert staged(store) == []
    assert incoming.expires_at(upload) is None


def test_a_file_of_no_bytes_is_finished_at_once(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming, 0)
    assert upload.sha256 == hashlib.sha256(b"").hexdigest()
    assert store.read(STUDIO, upload.sha256) == b""


def test_the_same_file_twice_is_stored_once(incoming: Uploads, store: FolderStore) -> None:
    for _ in range(2):
        assert send(incoming, begun(incoming), 0, CONTENT).sha256 == SHA256
    assert store.read(STUDIO, SHA256) == CONTENT
    assert staged(store) == []


@pytest.mark.parametrize("offset", [0, 999, 1_001, len(CONTENT)])
def test_bytes_that_do_not_continue_are_refused(incoming: Uploads, offset: int) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT[:1_000])
    with pytest.raises(OffsetMismatch, match="1000 bytes are here"):
        send(incoming, upload, offset, CONTENT[1_000:])
    assert incoming.offset(upload) == 1_000


@pytest.mark.slow
def test_a_broken_line_keeps_what_came(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming)
    with pytest.raises(ConnectionResetError):
        asyncio.run(incoming.receive(upload, 0, stream(CONTENT, breaks_after=40 * 65_536)))
    here = incoming.offset(upload)
    assert here == 40 * 65_536
    assert send(incoming, upload, here, CONTENT[here:]).sha256 == SHA256


@pytest.mark.parametrize("pause_s", [5.0, 0.05], ids=["silent", "trickling"])
def test_a_slow_sender_frees_the_upload(database: Database, store: FolderStore, pause_s: float) -> None:
    incoming = Uploads(database, store, pace=MinimumRate(bytes_per_s=1_000, window_s=0.3))

    async def slow() -> AsyncIterator[bytes]:
        for at in range(0, len(CONTENT), 10):
            yield CONTENT[at : at + 10]
            await asyncio.sleep(pause_s)

    upload = begun(incoming)
    with pytest.raises(UploadStalled, match=r"bytes came in 0.3 s; an upload sends 300 or more"):
        asyncio.run(incoming.receive(upload, 0, slow()))
    here = incoming.offset(upload)
    assert 10 <= here < 300
    assert send(incoming, upload, here, CONTENT[here:]).sha256 == SHA256


@pytest.mark.slow
def test_a_sender_at_the_minimum_rate_is_waited_for(database: Database, store: FolderStore) -> None:
    incoming = Uploads(database, store, pace=MinimumRate(bytes_per_s=100, window_s=50))

    async def steady() -> AsyncIterator[bytes]:
        for at in range(0, 20_000, 1_000):  # 180 s in all, more than three windows, 111 bytes a second
            yield CONTENT[at : at + 1_000]
            await asyncio.sleep(9)

    with asyncio.Runner(loop_factory=TimerLoop) as runner:
        upload = runner.run(incoming.receive(begun(incoming, 20_000), 0, steady()))
    assert upload.sha256 == hashlib.sha256(CONTENT[:20_000]).hexdigest()


@pytest.mark.slow
def test_the_time_to_write_is_not_the_senders(
    database: Database, store: FolderStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(uploads, "_write", lambda *given, write=uploads._write: (time.sleep(0.3), write(*given)))
    incoming = Uploads(database, store, pace=MinimumRate(bytes_per_s=100 << 20, window_s=0.2))  # 20 MiB in 0.2 s
    assert send(incoming, begun(incoming), 0, CONTENT).sha256 == SHA256  # five slow writes


def test_a_second_writer_is_asked_to_wait(incoming: Uploads) -> None:
    upload = begun(incoming)

    async def both() -> None:
        first_has_begun, second_is_done = asyncio.Event(), asyncio.Event()

        async def slow() -> AsyncIterator[bytes]:
            yield CONTENT[:100]
            first_has_begun.set()
            await second_is_done.wait()
            yield CONTENT[100:]

        first = asyncio.create_task(incoming.receive(upload, 0, slow()))
        await first_has_begun.wait()
        with pytest.raises(UploadBusy):
            await incoming.receive(upload, 0, stream(b"x" * 100))
        second_is_done.set()
        assert (await first).sha256 == SHA256

    asyncio.run(both())


@pytest.mark.slow
def test_files_that_end_together_are_finished_two_at_a_time(incoming: Uploads, monkeypatch: pytest.MonkeyPatch) -> None:
    counting, now, most = threading.Lock(), 0, 0
    finish = Uploads._finish

    def counted(uploads: Uploads, upload: Upload) -> Upload:
        nonlocal now, most
        with counting:
            now, most = now + 1, max(most, now + 1)
        time.sleep(0.05)  # others would come in meanwhile
        finished = finish(uploads, upload)
        with counting:
            now -= 1
        return finished

    monkeypatch.setattr(Uploads, "_finish", counted)
    uploads = [begun(incoming) for _ in range(6)]

    async def all_at_once() -> list[Upload]:
        return await asyncio.gather(*(incoming.receive(each, 0, stream(CONTENT)) for each in uploads))

    assert all(each.sha256 for each in asyncio.run(all_at_once()))
    assert most == 2


@pytest.mark.parametrize("announced", [None, 11])
def test_more_than_announced_is_refused(incoming: Uploads, announced: int | None) -> None:
    upload = begun(incoming, 10)
    with pytest.raises(UploadTooLong):
        send(incoming, upload, 0, b"12345678901", announced=announced)
    assert incoming.offset(upload) == 0
    assert send(incoming, upload, 0, b"1234567890").sha256 == hashlib.sha256(b"1234567890").hexdigest()


def test_a_finished_upload_takes_nothing_more(incoming: Uploads, store: FolderStore) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT)
    assert send(incoming, upload, len(CONTENT), b"").sha256 == SHA256
    with pytest.raises(UploadTooLong):
        send(incoming, upload, len(CONTENT), b"x")
    with pytest.raises(OffsetMismatch):
        send(incoming, upload, 0, CONTENT)
    assert store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.parametrize("algorithm", CHECKSUMS)
def test_bytes_with_a_wrong_checksum_are_not_kept(incoming: Uploads, algorithm: str) -> None:
    upload = begun(incoming)
    right = Checksum(algorithm, hashlib.new(algorithm, CONTENT[:1_000]).digest())
    with pytest.raises(ChecksumMismatch):
        send(incoming, upload, 0, CONTENT[1:1_001], checksum=right)
    assert incoming.offset(upload) == 0
    assert incoming.offset(send(incoming, upload, 0, CONTENT[:1_000], checksum=right)) == 1_000


def test_bytes_that_no_checksum_could_prove_are_not_kept(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming)
    proof = Checksum("sha256", hashlib.sha256(CONTENT).digest())
    with pytest.raises(ConnectionResetError):
        asyncio.run(incoming.receive(upload, 0, stream(CONTENT, breaks_after=2_000_000), checksum=proof))
    assert incoming.offset(upload) == 0
    assert [path.name for path in staged(store)] == [str(upload.id)]


def test_a_file_other_than_announced_starts_again(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming, expected_sha256=SHA256)
    with pytest.raises(ChecksumMismatch, match="announced was"):
        send(incoming, upload, 0, CONTENT[::-1])
    assert incoming.offset(upload) == 0
    assert send(incoming, upload, 0, CONTENT).sha256 == SHA256
    assert store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.parametrize(
    "point", ["uploads.received", "uploads.before_store", "uploads.after_store", "uploads.finished"]
)
def test_killed_anywhere_it_is_finished_by_the_next_request(
    incoming: Uploads, store: FolderStore, database: Database, monkeypatch: pytest.MonkeyPatch, point: str
) -> None:
    hits: list[str] = []

    def die(name: str) -> None:
        if name == point and not hits:
            hits.append(name)
            raise Killed

    upload = begun(incoming)
    with monkeypatch.context() as patched:
        patched.setattr(kill_points, "point", die)
        with pytest.raises(Killed):
            send(incoming, upload, 0, CONTENT)
    assert hits == [point]
    found = find(Uploads(database, FolderStore(store.root)), upload)
    assert (found.sha256, incoming.offset(found)) == (SHA256, len(CONTENT))
    assert store.read(STUDIO, SHA256) == CONTENT
    incoming.sweep()
    assert staged(store) == []


def test_what_belongs_to_another_person_is_not_found(incoming: Uploads, database: Database) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT)
    with pytest.raises(UploadNotFound):
        incoming.find(upload.id, owner_id=new_id())
    with database.writing() as session:
        found = finished_upload(session, upload.id, owner_id=OWNER, scope="delivery")
        assert (found.sha256, found.size_bytes, found.file_name) == (SHA256, len(CONTENT), "laser.wav")
        for owner_id, scope in ((new_id(), "delivery"), (OWNER, "another delivery")):
            with pytest.raises(UploadNotFound):
                finished_upload(session, upload.id, owner_id=owner_id, scope=scope)


def test_an_unfinished_upload_is_no_file_yet(incoming: Uploads, database: Database) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT[:-1])
    with database.writing() as session, pytest.raises(UploadUnfinished):
        finished_upload(session, upload.id, owner_id=OWNER, scope="delivery")


def test_too_long_for_one_file(incoming: Uploads, store: FolderStore) -> None:
    with pytest.raises(UploadTooLong, match="1099511627777"):
        begun(incoming, (1 << 40) + 1)
    assert staged(store) == []


def test_a_full_disk_is_said_before_and_while_bytes_come(
    incoming: Uploads, database: Database, store: FolderStore
) -> None:
    with pytest.raises(StoreFull):
        begun(Uploads(database, store, reserve_bytes=1 << 60))
    upload = begun(incoming)
    with largest_file(1_000_000), pytest.raises(StoreFull, match="could not write"):
        send(incoming, upload, 0, CONTENT)
    here = incoming.offset(upload)
    assert here == 1_000_000
    assert send(incoming, upload, here, CONTENT[here:]).sha256 == SHA256


def test_a_file_without_a_row_is_never_reported_finished(incoming: Uploads, database: Database) -> None:
    upload = begun(incoming)
    with database.writing() as session:
        session.delete(session.get_one(Upload, upload.id))
    with pytest.raises(UploadNotFound):
        send(incoming, upload, 0, CONTENT)
    assert upload.sha256 is None


@contextmanager
def largest_file(size_bytes: int) -> Iterator[None]:
    """Let the kernel refuse to write beyond this size."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size_bytes, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
