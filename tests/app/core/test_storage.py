"""What every store promises, asked of the folder and of a bucket on a real S3 server."""

import hashlib
import os
import re
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.core.db import new_id
from app.core.storage import (
    BlobAltered,
    BlobMissing,
    BucketStore,
    FolderStore,
    Store,
    StoredBlob,
    StoreUnavailable,
    StoreUnready,
    multipart,
    open_store,
)
from app.settings import Settings
from tests.support.blobs import blob_file
from tests.support.s3 import KEY, S3Server

STUDIO, OTHER_STUDIO = new_id(), new_id()
CONTENT = bytes(range(256)) * 20_000  # 5 MB
SHA256 = hashlib.sha256(CONTENT).hexdigest()
PART_BYTES = 5 << 20  # the least that S3 takes
LARGE = CONTENT + CONTENT[:1_000_000]  # two parts of an upload to a bucket
LARGE_SHA256 = hashlib.sha256(LARGE).hexdigest()


@pytest.fixture(autouse=True)
def _small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(multipart, "PART_BYTES", PART_BYTES)


@pytest.fixture(params=["folder", pytest.param("bucket", marks=pytest.mark.slow)])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Store:
    if request.param == "folder":
        return FolderStore(tmp_path / "blobs")
    s3: S3Server = request.getfixturevalue("s3")
    return BucketStore(s3.address(s3.new_bucket(), "studio/sounds"), KEY, tmp_path / "incoming")


def pieces(content: bytes, length: int = 300_000) -> Iterator[bytes]:
    for start in range(0, len(content), length):
        yield content[start : start + length]


def orphaned(store: Store) -> list[Path]:
    return [path for path in store.staging_root.glob(".*") if path.is_file()]


@pytest.mark.parametrize("content", [b"", b"x", CONTENT, LARGE], ids=["nothing", "a byte", "5 MB", "6 MB"])
def test_what_is_put_is_given_back(store: Store, content: bytes, tmp_path: Path):
    stored = store.put(STUDIO, pieces(content))
    assert stored == StoredBlob(hashlib.sha256(content).hexdigest(), len(content))
    assert store.size_bytes(STUDIO, stored.sha256) == len(content)
    assert store.read(STUDIO, stored.sha256) == content
    with store.local_copy(STUDIO, stored.sha256) as path:
        assert path.read_bytes() == content
    with store.open(STUDIO, stored.sha256) as file:
        assert file.read(1000) + file.read() == content
    assert orphaned(store) == []


def test_a_file_is_stored_and_stays(store: Store, tmp_path: Path):
    source = tmp_path / "laser.wav"
    source.write_bytes(CONTENT)
    assert store.put_file(STUDIO, source).sha256 == SHA256
    assert source.read_bytes() == store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.parametrize("content", [b"", CONTENT, LARGE], ids=["nothing", "5 MB", "6 MB"])
def test_what_is_made_in_a_folder_of_the_store_is_kept_when_that_is_gone(store: Store, content: bytes):
    with store.making() as folder:
        made = folder / "render.wav"
        made.write_bytes(content)
        (folder / "ab").mkdir()  # as deep as a blob lies, and none
        (folder / "ab" / "part.wav").write_bytes(content)
        stored = store.save_renders(STUDIO, made)
        assert (
            store.save_renders(STUDIO, made) == stored == StoredBlob(hashlib.sha256(content).hexdigest(), len(content))
        )
        assert made.read_bytes() == content
        assert list(store.blobs()) == [(STUDIO, stored)]
    assert store.read(STUDIO, stored.sha256) == content
    assert list(store.staging_root.glob(".*")) == []


@pytest.mark.parametrize("content", [CONTENT, LARGE], ids=["5 MB", "6 MB"])
def test_the_same_bytes_twice_are_stored_once(store: Store, content: bytes):
    assert store.put(STUDIO, [content]) == store.put(STUDIO, pieces(content))
    assert [blob.size_bytes for _, blob in store.blobs()] == [len(content)]


def test_nothing_is_shared_between_studios(store: Store):
    store.put(STUDIO, [CONTENT])
    with pytest.raises(BlobMissing):
        store.read(OTHER_STUDIO, SHA256)
    store.put(OTHER_STUDIO, [CONTENT])
    assert sorted(store.blobs(), key=str) == sorted(
        [(STUDIO, StoredBlob(SHA256, len(CONTENT))), (OTHER_STUDIO, StoredBlob(SHA256, len(CONTENT)))], key=str
    )


@pytest.mark.parametrize(
    ("start", "end"), [(0, 1), (0, None), (1, 256), (4_999_999, None), (255, 3_000_001), (5_119_999, 5_120_000)]
)
def test_a_range_is_read_by_itself(store: Store, start: int, end: int | None):
    store.put(STUDIO, [CONTENT])
    assert b"".join(store.stream(STUDIO, SHA256, start, end)) == CONTENT[start:end]


@pytest.mark.slow
def test_what_is_missing_is_said_before_a_byte_is_given(store: Store):
    with pytest.raises(BlobMissing, match=SHA256):
        store.size_bytes(STUDIO, SHA256)
    with pytest.raises(BlobMissing):
        store.open(STUDIO, SHA256)
    with pytest.raises(BlobMissing), store.local_copy(STUDIO, SHA256):
        pass
    assert orphaned(store) == []


@pytest.mark.parametrize(("content", "sha256"), [(CONTENT, SHA256), (LARGE, LARGE_SHA256)], ids=["5 MB", "6 MB"])
@pytest.mark.parametrize("fault", ["one bit", "cut short", "empty", "gone"])
def test_what_was_altered_is_refused_everywhere_and_healed_by_the_same_bytes(
    store: Store, content: bytes, sha256: str, fault: str
):
    store.put(STUDIO, [content])
    file = blob_file(store, STUDIO, sha256)
    file.chmod(0o640)
    altered = {"one bit": content[:-1] + bytes([content[-1] ^ 1]), "cut short": content[:-1], "empty": b""}
    if fault == "gone":
        file.unlink()
    else:
        file.write_bytes(altered[fault])
    expected = BlobMissing if fault == "gone" else BlobAltered
    given: list[bytes] = []
    with pytest.raises(expected):
        given.extend(store.stream(STUDIO, sha256))
    assert sum(map(len, given)) < max(1, len(altered.get(fault, b"")))  # the end is held back
    for read in (store.read, store.verify, store.ensure_intact):
        with pytest.raises(expected):
            read(STUDIO, sha256)
    with pytest.raises(expected), store.local_copy(STUDIO, sha256):
        pass
    assert store.put(STUDIO, [content]).sha256 == sha256
    store.ensure_intact(STUDIO, sha256)
    assert store.read(STUDIO, sha256) == content
    assert orphaned(store) == []
    store.delete(STUDIO, sha256)
    store.delete(STUDIO, sha256)
    assert list(store.blobs()) == []


def test_what_is_stored_again_counts_as_new(store: Store, monkeypatch: pytest.MonkeyPatch):
    sha256 = store.put(STUDIO, [b"a sound"]).sha256
    file = blob_file(store, STUDIO, sha256)
    long_ago = time.time() - 7200
    os.utime(file, (long_ago, long_ago))
    assert store.stored_at(STUDIO, sha256).timestamp() < time.time() - 3600
    store.put(STUDIO, [b"a sound"])
    assert store.stored_at(STUDIO, sha256).timestamp() > time.time() - 3600


def test_many_sizes_are_asked_at_once(store: Store):
    sizes = {store.put(STUDIO, [b"x" * length]).sha256: length for length in range(1, 20)}
    assert store.sizes_bytes(STUDIO, [*sizes, SHA256]) == sizes


def test_chunks_that_break_off_leave_nothing_behind(store: Store):
    def broken() -> Iterator[bytes]:
        yield CONTENT
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        store.put(STUDIO, broken())
    assert orphaned(store) == []
    assert list(store.blobs()) == []


def test_ready_means_written_read_and_let_go(store: Store):
    store.ensure_ready()
    assert list(store.blobs()) == []
    assert orphaned(store) == []


def test_a_folder_that_cannot_be_written_to_is_reported(tmp_path: Path):
    (tmp_path / "blobs").write_text("a file where a folder is wanted")
    with pytest.raises(StoreUnready, match=r"cannot be written to \(.+\); give the folder"):
        FolderStore(tmp_path / "blobs").ensure_ready()


def test_a_full_disk_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    store = FolderStore(tmp_path / "blobs")
    monkeypatch.setattr("tempfile.mkstemp", lambda **_: (os.open("/dev/full", os.O_WRONLY), str(tmp_path / "gone")))
    with pytest.raises(StoreUnavailable, match="No space left on device"):
        store.put(STUDIO, [CONTENT])


class TestBucket:
    def bucket(self, s3: S3Server, tmp_path: Path, name: str | None = None, **more: object) -> BucketStore:
        return BucketStore(s3.address(name or s3.new_bucket(), "sounds"), KEY, tmp_path / "incoming", **more)

    def test_a_blob_that_was_altered_is_not_given_to_be_judged(self, s3: S3Server, tmp_path: Path):
        bucket = s3.new_bucket()
        store = self.bucket(s3, tmp_path, bucket)
        store.put(STUDIO, [CONTENT])
        (stored,) = (s3.folder / bucket).rglob(SHA256)
        stored.write_bytes(CONTENT[::-1])
        with pytest.raises(BlobAltered, match="is not given out"), store.local_copy(STUDIO, SHA256):
            pass
        stored.write_bytes(CONTENT[:-1])
        assert store.put(STUDIO, [CONTENT]).sha256 == SHA256
        assert store.read(STUDIO, SHA256) == CONTENT
        assert orphaned(store) == []

    @pytest.mark.slow
    def test_what_is_under_a_hash_is_never_put_again(self, s3: S3Server, tmp_path: Path):
        bucket = s3.new_bucket()
        store = self.bucket(s3, tmp_path, bucket)
        for content, sha256 in ((CONTENT, SHA256), (LARGE, LARGE_SHA256)):
            store.put(STUDIO, [content])
            (stored,) = (s3.folder / bucket).rglob(sha256)
            first = stored.stat()
            store.put(STUDIO, [content])
            assert (stored.stat().st_ino, stored.stat().st_mtime_ns) == (first.st_ino, first.st_mtime_ns)

    def test_two_who_send_one_large_file_at_once_store_it_once(self, s3: S3Server, tmp_path: Path):
        store = self.bucket(s3, tmp_path)
        source = tmp_path / "large"
        source.write_bytes(LARGE)
        store.multipart.send_file(store.key(STUDIO, LARGE_SHA256), source)
        assert not store._sent(
            store.key(STUDIO, LARGE_SHA256), source
        )  # a caller that looked before the other was done
        assert store.read(STUDIO, LARGE_SHA256) == LARGE
        assert list(store.multipart.unfinished("")) == []

    @pytest.mark.parametrize(
        ("changed", "reported"),
        [
            ({"bucket": "nobody-made-it"}, "the store's bucket is not there"),
            ({"endpoint": "http://127.0.0.1:1"}, "does not answer as an S3 server does"),
        ],
    )
    def test_a_misconfigured_bucket_is_reported(
        self, s3: S3Server, tmp_path: Path, changed: dict[str, str], reported: str
    ):
        settings = s3.settings(data_dir=tmp_path)
        if "bucket" in changed:
            settings["store_url"] = re.sub("//[^/]+/", f"//{changed['bucket']}/", settings["store_url"], count=1)
        if "endpoint" in changed:
            settings["store_url"] = settings["store_url"].replace(s3.endpoint, changed["endpoint"])
        with pytest.raises(StoreUnready, match=reported) as said:
            open_store(Settings(**settings)).ensure_ready()
        assert "127.0.0.1" not in str(said.value)

    @pytest.mark.slow
    def test_a_wrong_key_is_reported(self, s3: S3Server, tmp_path: Path):
        settings = s3.settings(data_dir=tmp_path, aws_secret_access_key="another")
        store = open_store(Settings(**settings))
        with pytest.raises(StoreUnready, match="refuses our key; see that AWS_ACCESS_KEY_ID"):
            store.ensure_ready()
        with pytest.raises(StoreUnavailable, match="refuses our key"):
            store.put(STUDIO, [CONTENT])
        with pytest.raises(StoreUnavailable, match="refuses our key"):
            store.multipart.begin("sounds/laser")

    def test_without_disk_nothing_is_copied(self, s3: S3Server, tmp_path: Path):
        store = self.bucket(s3, tmp_path)
        store.put(STUDIO, [CONTENT])
        shutil.rmtree(store.staging_root)
        store.staging_root.write_text("a file where a folder is wanted")
        with pytest.raises(StoreUnavailable, match="could not write to its disk"), store.local_copy(STUDIO, SHA256):
            pass
