"""A connection to the bucket that fails: retried where that can help, refused in words where not, nothing half-kept."""

import hashlib
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from app.core.db import new_id
from app.core.storage import BucketStore, StoreUnavailable, multipart
from app.core.storage.retry_policy import RetryPolicy
from tests.support.s3 import KEY, FaultyLine, S3Server, faulty_line

STUDIO = new_id()
CONTENT = bytes(range(256)) * 12_000  # 3 MB: several reads
SHA256 = hashlib.sha256(CONTENT).hexdigest()
PART_BYTES = 5 << 20  # the least that S3 takes
LARGE = CONTENT * 2  # two parts of an upload
LARGE_SHA256 = hashlib.sha256(LARGE).hexdigest()
HASTY = RetryPolicy(tries=3, first_delay_s=0.01, max_delay_s=0.02, connect_timeout_s=2.0, read_timeout_s=1.0)
PATIENT = replace(HASTY, connect_timeout_s=120.0, read_timeout_s=120.0)  # a busy server is none that fails
READING, WRITING = "GET", "PUT|POST"
FLEETING = ["503", "refused", pytest.param("silent", marks=pytest.mark.slow)]  # silence is told by time


@pytest.fixture(autouse=True)
def _small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(multipart, "PART_BYTES", PART_BYTES)


@pytest.fixture
def line(s3: S3Server) -> Iterator[FaultyLine]:
    with faulty_line(s3) as line:
        yield line


@pytest.fixture
def bucket(s3: S3Server) -> str:
    return s3.new_bucket()


@pytest.fixture
def store(request: pytest.FixtureRequest, line: FaultyLine, bucket: str, tmp_path: Path) -> BucketStore:
    patience = HASTY if request.node.get_closest_marker("slow") else PATIENT
    address = line.server.address(bucket, "sounds", line.endpoint)
    return BucketStore(address, KEY, tmp_path / "incoming", patience=patience)


def kept(s3: S3Server, bucket: str) -> list[bytes]:
    return [path.read_bytes() for path in (s3.folder / bucket / "sounds").rglob("*") if path.is_file()]


@pytest.mark.parametrize("kind", [*FLEETING, "cut off", "lost answer"])
@pytest.mark.parametrize("content", [CONTENT, LARGE], ids=["3 MB", "6 MB"])
def test_a_put_that_fails_twice_is_done_the_third_time(
    s3: S3Server, bucket: str, store: BucketStore, line: FaultyLine, kind: str, content: bytes
):
    fault = line.fail(kind, times=2, method=WRITING)
    assert store.put(STUDIO, [content]).sha256 == hashlib.sha256(content).hexdigest()
    assert fault.hits == (1 if kind == "lost answer" and content == CONTENT else 2)  # it was there: seen, not put again
    assert kept(s3, bucket) == [content]


def test_a_server_that_hangs_up_on_who_sends_what_is_there_is_not_sent_it_again(store: BucketStore, line: FaultyLine):
    store.put(STUDIO, [CONTENT])
    fault = line.fail("refused", times=100, method="PUT")
    assert store.put(STUDIO, [CONTENT]).sha256 == SHA256
    assert fault.hits == 1


@pytest.mark.parametrize(("method", "path"), [("POST", "uploads="), ("PUT", "partNumber=2"), ("POST", "uploadId=")])
def test_every_step_of_a_large_put_may_lose_its_answer(
    s3: S3Server, bucket: str, store: BucketStore, line: FaultyLine, method: str, path: str
):
    fault = line.fail("lost answer", method=method, path=path)
    store.put(STUDIO, [LARGE])
    assert fault.hits == 1
    assert kept(s3, bucket) == [LARGE]


@pytest.mark.parametrize("kind", FLEETING)
@pytest.mark.parametrize("content", [CONTENT, LARGE], ids=["3 MB", "6 MB"])
def test_a_put_that_cannot_be_done_is_reported_and_leaves_nothing(
    s3: S3Server, bucket: str, store: BucketStore, line: FaultyLine, kind: str, content: bytes
):
    line.fail(kind, times=100, method="PUT")
    with pytest.raises(StoreUnavailable, match="did not answer"):
        store.put(STUDIO, [content])
    assert kept(s3, bucket) == []
    assert [path for path in store.staging_root.iterdir() if path.is_file()] == []
    assert list(store.multipart.unfinished("")) == []


@pytest.mark.parametrize("kind", FLEETING)
def test_a_read_that_fails_twice_is_done_the_third_time(store: BucketStore, line: FaultyLine, kind: str):
    store.put(STUDIO, [CONTENT])
    fault = line.fail(kind, times=2, method=READING)
    assert store.read(STUDIO, SHA256) == CONTENT
    assert fault.hits == 2


@pytest.mark.slow
def test_an_answer_that_breaks_off_is_gone_on_with(store: BucketStore, line: FaultyLine):
    store.put(STUDIO, [LARGE])
    fault = line.fail("truncated", times=4, method=READING, after_bytes=1_200_000)
    line.asked.clear()
    with store.local_copy(STUDIO, LARGE_SHA256) as path:
        assert path.read_bytes() == LARGE
    assert fault.hits == 4  # each brought some, so none counts as one in a row
    assert len(line.asked) == 5


@pytest.mark.parametrize("kind", [*FLEETING, "truncated"])
def test_a_read_that_cannot_be_done_is_reported(store: BucketStore, line: FaultyLine, kind: str):
    store.put(STUDIO, [CONTENT])
    line.fail(kind, times=100, method=READING, after_bytes=0)
    with pytest.raises(StoreUnavailable, match="did not answer a get in 3 tries"), store.local_copy(STUDIO, SHA256):
        pass
    assert [path for path in store.staging_root.iterdir() if path.is_file()] == []


@pytest.mark.slow
def test_a_slow_line_is_no_failure_while_it_moves(store: BucketStore, line: FaultyLine):
    store.put(STUDIO, [CONTENT])
    line.fail("slow", method=READING)
    line.asked.clear()
    begun = time.monotonic()
    assert store.read(STUDIO, SHA256) == CONTENT
    assert time.monotonic() - begun > HASTY.read_timeout_s
    assert len(line.asked) == 1


def test_a_list_that_fails_in_the_middle_is_gone_on_with(store: BucketStore, line: FaultyLine):
    stored = {store.put(STUDIO, [bytes([number])]).sha256 for number in range(5)}
    line.fail("truncated", method=READING, path="list-type")
    assert {blob.sha256 for _, blob in store.blobs()} == stored


def test_whether_it_is_ready_is_answered_soon(store: BucketStore, line: FaultyLine):
    fault = line.fail("503", times=100)
    with pytest.raises(Exception, match="does not answer as an S3 server does"):
        store.ensure_ready()
    assert fault.hits == 1  # a probe asks again by itself
