"""Files that come to a bucket in parts: begin, part, list, complete, abort, each one signed request.

obstore has no calls for the steps, and one of them is done by the browser. Every part carries its
SHA-256, which the server verifies: some servers accept a truncated part.
Source: Amazon S3 API, "Uploading and copying objects using multipart upload".
"""

import base64
import hashlib
import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from pathlib import Path
from xml.etree import ElementTree as ET

import httpx

from app.core import metrics
from app.core.storage.retry_policy import RetryPolicy
from app.core.storage.signing import Signer
from app.core.storage.store import StoreUnavailable, key_refused

PART_BYTES = 16 << 20  # 5 GiB are 320 parts; S3 takes 10,000 of 5 MiB or more
PARTS_AT_ONCE = 4
SIGNED_FOR_S = 900
CHECKSUM = "x-amz-checksum-sha256"
BUSY = frozenset({408, 409, 429, 500, 502, 503, 504})


class MultipartGone(Exception):
    """The bucket knows no such upload: it was completed, was given up, or has expired."""


class AlreadyStored(Exception):
    """There is something under that key."""


@dataclass(frozen=True)
class Part:
    """A part that is in the bucket; numbers begin at 1."""

    number: int
    size_bytes: int
    etag: str
    sha256: str  # Base64, as S3 writes it


@dataclass(frozen=True)
class Unfinished:
    """An upload in parts that was begun and not ended."""

    key: str
    multipart_id: str
    begun_at: datetime


class Multipart:
    """The uploads in parts of one bucket."""

    def __init__(self, signer: Signer, bucket: str, patience: RetryPolicy) -> None:
        self._signer = signer
        self._bucket = bucket
        self._patience = patience

    @cached_property
    def _client(self) -> httpx.Client:
        return httpx.Client(
            timeout=httpx.Timeout(self._patience.read_timeout_s, connect=self._patience.connect_timeout_s)
        )

    def begin(self, key: str) -> str:
        """Begin an upload; return its id."""
        answer = self._ask("POST", key, {"uploads": ""}, signed={"x-amz-checksum-algorithm": "SHA256"})
        return _text(_tree(answer), "UploadId")

    def send(self, key: str, multipart_id: str, number: int, content: bytes) -> Part:
        """Send one part; the bucket keeps it only if its SHA-256 is right."""
        query = {"partNumber": str(number), "uploadId": multipart_id}
        headers = checksum_header(hashlib.sha256(content).digest())
        answer = self._ask("PUT", key, query, content=content, signed=headers)
        return Part(number, len(content), answer.headers["etag"], headers[CHECKSUM])

    def parts(self, key: str, multipart_id: str) -> list[Part]:
        """Return the parts that are in the bucket, by number; raise MultipartGone."""
        parts: list[Part] = []
        after = "0"
        while after:
            answer = self._ask("GET", key, {"uploadId": multipart_id, "part-number-marker": after})
            tree = _tree(answer)
            parts += [
                Part(
                    int(_text(part, "PartNumber")),
                    int(_text(part, "Size")),
                    _text(part, "ETag"),
                    _text(part, "ChecksumSHA256"),
                )
                for part in tree.iter("Part")
            ]
            after = _text(tree, "NextPartNumberMarker") if _text(tree, "IsTruncated") == "true" else ""
        return parts

    def complete(self, key: str, multipart_id: str, parts: Sequence[Part], *, if_absent: bool = False) -> None:
        """Make one object of the parts; raise MultipartGone, or AlreadyStored where it must be absent and is not."""
        body = ET.Element("CompleteMultipartUpload")
        for part in parts:
            child = ET.SubElement(body, "Part")
            ET.SubElement(child, "PartNumber").text = str(part.number)
            ET.SubElement(child, "ETag").text = part.etag
            ET.SubElement(child, "ChecksumSHA256").text = part.sha256
        only_if = {"If-None-Match": "*"} if if_absent else {}
        self._ask("POST", key, {"uploadId": multipart_id}, content=ET.tostring(body), unsigned=only_if)

    def abort(self, key: str, multipart_id: str) -> None:
        """Drop an upload with its parts; a missing one counts as dropped."""
        try:
            self._ask("DELETE", key, {"uploadId": multipart_id})
        except MultipartGone:
            return

    def unfinished(self, prefix: str) -> Iterator[Unfinished]:
        """Yield the uploads that were begun below a prefix and not ended."""
        query = {"uploads": "", "prefix": prefix}
        while True:
            tree = _tree(self._ask("GET", "", query))
            for upload in tree.iter("Upload"):
                begun_at = datetime.fromisoformat(_text(upload, "Initiated"))
                yield Unfinished(_text(upload, "Key"), _text(upload, "UploadId"), begun_at)
            if _text(tree, "IsTruncated") != "true":
                return
            query |= {
                "key-marker": _text(tree, "NextKeyMarker"),
                "upload-id-marker": _text(tree, "NextUploadIdMarker"),
            }

    def send_file(self, key: str, source: Path, *, if_absent: bool = True) -> None:
        """Store a large file; raise AlreadyStored or MultipartGone where the key must be absent and is not."""
        multipart_id = self.begin(key)
        try:
            with source.open("rb") as file, ThreadPoolExecutor(PARTS_AT_ONCE) as pool:
                size_bytes = os.fstat(file.fileno()).st_size

                def send(number: int) -> Part:
                    content = os.pread(file.fileno(), PART_BYTES, part_start(number))
                    return self.send(key, multipart_id, number, content)

                parts = list(pool.map(send, range(1, parts_of(size_bytes) + 1)))
            self.complete(key, multipart_id, parts, if_absent=if_absent)
        except BaseException:
            with suppress(StoreUnavailable):  # what cannot be dropped now is swept later
                self.abort(key, multipart_id)
            raise

    def _ask(
        self,
        method: str,
        key: str,
        query: Mapping[str, str],
        *,
        content: bytes = b"",
        signed: Mapping[str, str] | None = None,
        unsigned: Mapping[str, str] | None = None,
    ) -> httpx.Response:
        """Ask until there is an answer; headers that begin with x-amz- must be signed."""
        path = f"/{self._bucket}/{key}" if key else f"/{self._bucket}"
        headers = {**(signed or {}), **(unsigned or {})}
        failures = 0
        while True:
            url = self._signer.url(method, path, query, headers=signed, expires_in_s=SIGNED_FOR_S)
            try:
                return _understood(self._client.request(method, url, content=content, headers=headers))
            except (httpx.TransportError, _Busy) as error:
                failures += 1
                if not self._patience.pause(failures, error):
                    metrics.STORE_ERRORS.labels("parts").inc()
                    raise StoreUnavailable(
                        f"the store did not answer {failures} times ({type(error).__name__})", fix="try again later"
                    ) from error


class _Busy(Exception):
    """The server could not now."""


def checksum_header(sha256: bytes) -> dict[str, str]:
    """Return the header against which the server holds what it is sent."""
    return {CHECKSUM: base64.b64encode(sha256).decode()}


def parts_of(size_bytes: int) -> int:
    """Return the number of parts of a file of this size."""
    return max(1, -(-size_bytes // PART_BYTES))


def part_start(number: int) -> int:
    """Return the place of a part's first byte in the file."""
    return (number - 1) * PART_BYTES


def part_length(size_bytes: int, number: int) -> int:
    """Return the required length of a part of a file of this size."""
    return min(PART_BYTES, size_bytes - part_start(number))


def _understood(answer: httpx.Response) -> httpx.Response:
    """Return a successful answer; raise the error of any other."""
    code = _error_code(answer)
    if answer.status_code in BUSY or (code and answer.is_success):  # a completion fails by 200, too
        raise _Busy(f"{answer.status_code} {code}")
    if code == "NoSuchUpload":
        raise MultipartGone
    if answer.status_code == httpx.codes.PRECONDITION_FAILED:
        raise AlreadyStored
    if answer.status_code in (httpx.codes.UNAUTHORIZED, httpx.codes.FORBIDDEN):
        raise key_refused()
    if not answer.is_success:
        raise StoreUnavailable(f"the store refuses ({answer.status_code} {code})", fix="contact the operator")
    return answer


def _tree(answer: httpx.Response) -> ET.Element:
    """Parse an answer of our own store, without its namespace, which servers write differently."""
    tree = ET.fromstring(answer.content)  # noqa: S314
    for element in tree.iter():
        element.tag = element.tag.rpartition("}")[2]
    return tree


def _text(tree: ET.Element, name: str) -> str:
    text = tree.findtext(name)
    if text is None:
        raise StoreUnavailable(f"the store's answer lacks {name}; is its endpoint an S3 server?")
    return text


def _error_code(answer: httpx.Response) -> str:
    if not answer.content.lstrip().startswith(b"<") or b"<Error" not in answer.content[:400]:
        return ""
    return _tree(answer).findtext("Code") or "Error"
