"""Uploads that come to the bucket by themselves: nothing counts before it was read, and nothing is lost on the way."""

import asyncio
import hashlib
import socket
from collections.abc import AsyncIterator, Callable, Iterator
from datetime import timedelta
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from app.core import clock, kill_points
from app.core.db import Base, Database, new_id
from app.core.storage import BucketStore, FolderStore, multipart
from app.core.uploads import (
    ChecksumMismatch,
    PartsNotTaken,
    PartUnknown,
    SentInParts,
    Upload,
    UploadBusy,
    UploadNotFound,
    Uploads,
    UploadUnfinished,
    staged,
)
from tests.support.s3 import KEY, S3Server

STUDIO, OWNER = new_id(), new_id()
PART_BYTES = 5 << 20  # the least that S3 takes
CONTENT = bytes(range(256)) * 45_000  # 11.5 MB: two parts and a rest
SHA256 = hashlib.sha256(CONTENT).hexdigest()
ALL = [1, 2, 3]


class Killed(BaseException):
    """Simulates SIGKILL: nothing after it runs, but what `finally` does to open files, as the kernel would."""


@pytest.fixture(autouse=True)
def _small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(multipart, "PART_BYTES", PART_BYTES)


@pytest.fixture
def database(tmp_path: Path) -> Iterator[Database]:
    database = Database(f"sqlite:///{tmp_path / 'test.sqlite'}")
    Base.metadata.create_all(database.engine, tables=[Base.metadata.tables["core_uploads"]])
    yield database
    database.dispose()


@pytest.fixture
def bucket(s3: S3Server) -> str:
    return s3.new_bucket()


@pytest.fixture
def store(s3: S3Server, bucket: str, tmp_path: Path) -> BucketStore:
    return BucketStore(s3.address(bucket, "sounds"), KEY, tmp_path / "incoming", direct=True)


@pytest.fixture
def incoming(database: Database, store: BucketStore) -> Uploads:
    return Uploads(database, store)


@pytest.fixture
def send(s3: S3Server, incoming: Uploads) -> Callable[..., Upload]:
    """Send parts of a file as a browser does, and return the upload as it stands then."""

    def send_parts(upload: Upload, numbers: list[int] = ALL, content: bytes = CONTENT) -> Upload:
        for link in incoming.parts(found(incoming, upload), sha256s(numbers, content)).links:
            part = content[link.start : link.start + link.length]
            answer = s3.client.put(link.url, content=part, headers=link.headers)
            assert answer.status_code == 200, answer.text
        return found(incoming, upload)

    return send_parts


def begun(incoming: Uploads, length: int = len(CONTENT), **more: Any) -> Upload:
    return incoming.create(
        studio_id=STUDIO,
        owner_id=OWNER,
        scope="delivery",
        file_name="ambience.wav",
        length=length,
        max_length=1 << 40,
        **more,
    )


def sha256s(numbers: list[int], content: bytes = CONTENT) -> dict[int, bytes]:
    return {
        number: hashlib.sha256(content[(number - 1) * PART_BYTES : number * PART_BYTES]).digest() for number in numbers
    }


def found(incoming: Uploads, upload: Upload) -> Upload:
    return incoming.find(upload.id, owner_id=OWNER)


def in_bucket(s3: S3Server, bucket: str) -> list[str]:
    return [path.name for path in (s3.folder / bucket / "sounds").rglob("*") if path.is_file()]


@pytest.mark.slow
def test_parts_become_the_file_that_was_sent(s3, bucket, store, incoming, send):
    upload = begun(incoming)
    standing = incoming.parts(upload, {})
    assert (standing.part_bytes, standing.parts, standing.here, standing.links) == (PART_BYTES, 3, [], [])
    upload = send(upload, [2])
    assert (incoming.parts(upload, {}).here, incoming.offset(upload)) == ([2], 0)
    upload = send(upload, [1])
    assert (incoming.parts(upload, {}).here, incoming.offset(upload)) == ([1, 2], 2 * PART_BYTES)
    upload = send(upload, [3])
    assert incoming.offset(upload) == len(CONTENT)
    assert upload.sha256 is None  # until it was read
    upload = incoming.finish_parts(upload)
    assert (upload.sha256, incoming.offset(upload), incoming.expires_at(upload)) == (SHA256, len(CONTENT), None)
    assert store.read(STUDIO, SHA256) == CONTENT
    assert in_bucket(s3, bucket) == [SHA256]
    assert incoming.finish_parts(found(incoming, upload)).sha256 == SHA256


@pytest.mark.slow
@pytest.mark.parametrize("length", [1, PART_BYTES, PART_BYTES + 1])
def test_a_file_has_as_many_parts_as_it_needs(incoming, send, store, length):
    upload = begun(incoming, length)
    count = incoming.parts(upload, {}).parts
    assert count == (1 if length <= PART_BYTES else 2)
    upload = incoming.finish_parts(send(upload, list(range(1, count + 1)), CONTENT[:length]))
    assert store.read(STUDIO, upload.sha256) == CONTENT[:length]


@pytest.mark.slow
def test_the_same_file_twice_is_stored_once(s3, bucket, incoming, send):
    for _ in range(2):
        assert incoming.finish_parts(send(begun(incoming))).sha256 == SHA256
    assert in_bucket(s3, bucket) == [SHA256]


@pytest.mark.slow
def test_what_is_missing_is_named(incoming, send):
    upload = begun(incoming)
    with pytest.raises(UploadUnfinished, match="no part of this file"):
        incoming.finish_parts(upload)
    upload = send(upload, [2])
    with pytest.raises(UploadUnfinished, match="of 3 parts these are not in the store: 1, 3"):
        incoming.finish_parts(upload)
    assert incoming.finish_parts(send(upload, [1, 3])).sha256 == SHA256


def test_there_is_no_other_part(incoming):
    for number in (0, 4, -1):
        with pytest.raises(PartUnknown, match="comes in 3"):
            incoming.parts(begun(incoming), {number: bytes(32)})


def test_other_bytes_than_a_part_has_are_refused_by_its_link(s3, incoming):
    upload = begun(incoming)
    (link,) = incoming.parts(upload, sha256s([3])).links
    right = CONTENT[link.start :]
    for content in (right + b"x", right[:-1], b"", right[::-1]):
        assert s3.client.put(link.url, content=content, headers=link.headers).status_code in (400, 403)
    assert s3.client.put(link.url, content=right).status_code in (400, 403)  # without its SHA-256
    assert incoming.parts(found(incoming, upload), {}).here == []


@pytest.mark.slow
def test_a_part_that_broke_off_is_not_there(s3, incoming, send, store):
    upload = begun(incoming)
    (link,) = incoming.parts(upload, sha256s([1])).links
    to = urlsplit(link.url)
    headers = {"Host": to.netloc, "Content-Length": str(link.length), **link.headers}
    head = "".join(f"{name}: {value}\r\n" for name, value in headers.items())
    with socket.create_connection((to.hostname, to.port)) as line:
        line.sendall(f"PUT {to.path}?{to.query} HTTP/1.1\r\n{head}\r\n".encode() + CONTENT[: 3 << 20])
        line.shutdown(socket.SHUT_WR)
        assert line.recv(100).startswith(b"HTTP/1.1 400 ")
    assert incoming.parts(found(incoming, upload), {}).here == []
    assert incoming.finish_parts(send(upload)).sha256 == SHA256


@pytest.mark.slow
def test_a_part_that_came_twice_counts_as_it_came_last(incoming, send, store):
    upload = send(begun(incoming), content=CONTENT[::-1])
    assert incoming.finish_parts(send(upload)).sha256 == SHA256
    assert store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.slow
def test_once_it_is_whole_no_link_changes_it(s3, incoming, send, store):
    upload = begun(incoming)
    links = incoming.parts(upload, sha256s(ALL)).links
    incoming.finish_parts(send(upload))
    again = s3.client.put(links[0].url, content=CONTENT[:PART_BYTES], headers=links[0].headers)
    assert again.status_code == 404
    assert store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.slow
def test_other_bytes_than_announced_are_not_kept(s3, bucket, incoming, send):
    upload = send(begun(incoming, expected_sha256=SHA256), content=CONTENT[::-1])
    with pytest.raises(ChecksumMismatch, match="announced was"):
        incoming.finish_parts(upload)
    assert in_bucket(s3, bucket) == []
    assert incoming.finish_parts(send(upload)).sha256 == SHA256


@pytest.mark.slow
@pytest.mark.parametrize(
    "point", ["uploads.made_whole", "uploads.before_store", "uploads.after_store", "uploads.finished"]
)
def test_killed_anywhere_it_is_finished_by_the_next_request(
    s3, bucket, incoming, send, store, database, monkeypatch, point
):
    hits = []

    def die(name: str) -> None:
        if name == point and not hits:
            hits.append(name)
            raise Killed

    upload = send(begun(incoming))
    with monkeypatch.context() as patched:
        patched.setattr(kill_points, "point", die)
        with pytest.raises(Killed):
            incoming.finish_parts(upload)
    assert hits == [point]
    again = Uploads(database, store)
    if found(again, upload).sha256 is None:
        assert again.parts(found(again, upload), {}).here == ALL
        assert again.offset(found(again, upload)) == len(CONTENT)
    assert again.finish_parts(found(again, upload)).sha256 == SHA256
    assert store.read(STUDIO, SHA256) == CONTENT
    monkeypatch.setattr(staged, "KEPT_FOR", timedelta(seconds=-60))
    again.sweep()
    assert in_bucket(s3, bucket) == [SHA256]


@pytest.mark.slow
def test_a_second_who_finishes_waits_its_turn(incoming, send, store, monkeypatch):
    upload = send(begun(incoming))
    refused = []

    def finish_too(name: str) -> None:
        if name == "uploads.before_store":
            with pytest.raises(UploadBusy):
                incoming.finish_parts(upload)
            refused.append(name)

    monkeypatch.setattr(kill_points, "point", finish_too)
    assert incoming.finish_parts(upload).sha256 == SHA256
    assert refused


@pytest.mark.slow
def test_asked_for_twice_at_once_it_is_begun_once(incoming, send, store):
    upload = begun(incoming)
    incoming.parts(upload, {})
    incoming.parts(upload, {})  # the same row, read before the first was done
    assert len(list(store.multipart.unfinished(""))) == 1
    assert incoming.finish_parts(send(upload)).sha256 == SHA256


async def stream(content: bytes) -> AsyncIterator[bytes]:
    yield content


def test_one_file_comes_one_way(incoming, send):
    in_parts = send(begun(incoming), [1])
    with pytest.raises(SentInParts):
        asyncio.run(incoming.receive(in_parts, PART_BYTES, stream(CONTENT[PART_BYTES:])))
    through_us = begun(incoming)
    asyncio.run(incoming.receive(through_us, 0, stream(CONTENT[:10])))
    with pytest.raises(PartsNotTaken, match="came through the server"):
        incoming.parts(through_us, sha256s([1]))


@pytest.mark.slow
def test_a_store_that_browsers_do_not_reach_takes_no_parts(s3, bucket, database, tmp_path):
    for store in (
        FolderStore(tmp_path / "blobs"),
        BucketStore(s3.address(bucket, "sounds"), KEY, tmp_path / "incoming"),
    ):
        uploads = Uploads(database, store)
        with pytest.raises(PartsNotTaken, match="no part of"):
            uploads.parts(begun(uploads), sha256s([1]))


@pytest.mark.slow
def test_what_was_begun_is_finished_where_parts_are_taken_no_more(s3, bucket, incoming, send, database, tmp_path):
    upload = send(begun(incoming))
    later = Uploads(database, BucketStore(s3.address(bucket, "sounds"), KEY, tmp_path / "incoming"))
    assert later.finish_parts(found(later, upload)).sha256 == SHA256


def test_given_up_is_gone_from_the_bucket_too(s3, bucket, incoming, send, store):
    upload = send(begun(incoming), [1])
    incoming.give_up(upload)
    with pytest.raises(UploadNotFound):
        found(incoming, upload)
    assert list(store.multipart.unfinished("")) == []
    assert in_bucket(s3, bucket) == []


@pytest.mark.slow
def test_the_sweep_takes_what_expired_and_nothing_else(s3, bucket, incoming, send, store, database, monkeypatch):
    fresh = send(begun(incoming), [1])
    assert incoming.sweep() == 0
    expires_at = incoming.expires_at(fresh)
    assert expires_at is not None
    assert abs(expires_at - clock.now() - staged.KEPT_FOR) < timedelta(minutes=1)
    unowned = store.direct.begin(new_id(), len(CONTENT))  # its process died before it wrote the row
    half_sent = store.multipart.begin(f"sounds/{STUDIO}/ab/{SHA256}")
    monkeypatch.setattr(staged, "KEPT_FOR", timedelta(seconds=-60))
    assert incoming.sweep() >= 2
    left = [(each.key, each.multipart_id) for each in store.multipart.unfinished("")]
    assert left == [(f"sounds/{STUDIO}/ab/{SHA256}", half_sent)]
    assert unowned.multipart_id not in str(left)
    with pytest.raises(UploadNotFound):
        found(incoming, fresh)
    monkeypatch.setattr(staged, "ORPHANED_AFTER", timedelta(seconds=-60))
    assert incoming.sweep() == 1
    assert list(store.multipart.unfinished("")) == []


def test_what_vanished_from_the_bucket_was_given_up(incoming, send, store):
    upload = send(begun(incoming), [1])
    store.direct.forget(upload.id, upload.multipart_id)
    for ask in (lambda: incoming.parts(upload, {}), lambda: incoming.finish_parts(upload)):
        with pytest.raises(UploadNotFound, match="given up or has expired"):
            ask()
