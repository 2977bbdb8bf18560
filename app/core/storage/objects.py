"""The objects of one bucket, by obstore: every request is safe to send twice, and is, where the server falters."""

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import TYPE_CHECKING, TypeVar

import obstore
from obstore.exceptions import AlreadyExistsError, BaseError, PermissionDeniedError, UnauthenticatedError
from obstore.store import S3Store

from app.core import metrics
from app.core.storage.retry_policy import RetryPolicy
from app.core.storage.signing import Key
from app.core.storage.store import READ_BYTES, Pieces, StoreUnavailable, key_refused
from app.settings import BucketAddress

if TYPE_CHECKING:
    from obstore import GetOptions
    from obstore.store import ClientConfig, S3Config

Answer = TypeVar("Answer")


@dataclass(frozen=True)
class ObjectState:
    """The size, the time of the last change and the ETag of an object."""

    size_bytes: int
    changed_at: datetime
    etag: str


class Objects:
    """The objects of one bucket."""

    def __init__(self, address: BucketAddress, key: Key, patience: RetryPolicy) -> None:
        self._patience = patience
        config: S3Config = {
            "endpoint": address.endpoint,
            "region": address.region,
            "access_key_id": key.id,
            "secret_access_key": key.secret,
            "virtual_hosted_style_request": False,
            "checksum_algorithm": "SHA256",  # some servers take a body that broke off for a whole one
        }
        if key.token:
            config["session_token"] = key.token
        self._bucket = S3Store(
            address.bucket,
            config=config,
            client_options=_client_options(address.endpoint, patience),
            retry_config={"max_retries": 0},  # asking again is ours: obstore does not for what it may not send twice
        )

    def size_bytes(self, key: str) -> int | None:
        """Return the size of an object; None if there is none."""
        state = self.state(key)
        return None if state is None else state.size_bytes

    def state(self, key: str) -> ObjectState | None:
        """Return the state of an object; None if there is none."""
        try:
            meta = self._asked("head", lambda: obstore.head(self._bucket, key))
        except FileNotFoundError:
            return None
        return ObjectState(meta["size"], meta["last_modified"], meta["e_tag"] or "")

    def is_renewed(self, key: str, sha256: str, *, since: datetime) -> bool:
        """Whether an object was stored since an instant and has the hash; only then it is read."""
        state = self.state(key)
        if state is None or state.changed_at < since:
            return False
        digest = hashlib.sha256()
        for piece in self.stream(key):
            digest.update(piece)
        return digest.hexdigest() == sha256

    def put(self, key: str, content: bytes) -> None:
        """Store an object in the place of what is there."""
        self._asked("put", lambda: obstore.put(self._bucket, key, content, use_multipart=False))

    def put_new(self, key: str, content: bytes) -> bool:
        """Store an object unless there is one; return whether it was stored.

        A server may hang up on who still sends what is there already, and its answer is lost: after a failure we look.
        """
        is_again = False

        def put() -> None:
            nonlocal is_again
            if is_again and self._is_there(key):
                raise AlreadyExistsError
            is_again = True
            obstore.put(self._bucket, key, content, mode="create", use_multipart=False)

        try:
            self._asked("put", put)
        except AlreadyExistsError:
            return False
        return True

    def stream(self, key: str, start: int = 0, end: int | None = None) -> Pieces:
        """Yield an object's bytes, going on where an answer broke off; raise FileNotFoundError."""
        failures = 0
        while end is None or start < end:
            try:
                answer = obstore.get(self._bucket, key, options=_span(start, end))
                end = answer.range[1]
                for piece in answer.stream(min_chunk_size=READ_BYTES):
                    start, failures = start + len(piece), 0
                    yield piece
                if start < end:
                    raise _BrokenOff(f"{end - start} bytes are missing")
                return
            except FileNotFoundError:
                raise
            except (BaseError, _BrokenOff) as error:
                failures += 1
                if not self._patience.pause(failures, error):
                    raise _unavailable("get", failures) from error

    def copy(self, source: str, target: str) -> None:
        """Let the server copy an object; raise FileNotFoundError."""
        self._asked("copy", lambda: obstore.copy(self._bucket, source, target))

    def delete(self, key: str) -> None:
        """Delete an object; one that is not there is deleted."""
        self._asked("delete", lambda: obstore.delete(self._bucket, key))

    def listed(self, prefix: str) -> Iterator[tuple[str, int, datetime]]:
        """Yield key, size and last change of each object whose key begins so."""
        failures, after = 0, None
        while True:
            try:
                for page in obstore.list(self._bucket, prefix=prefix, offset=after):
                    for entry in page:
                        after, failures = entry["path"], 0
                        yield entry["path"], entry["size"], entry["last_modified"]
                return
            except BaseError as error:
                failures += 1
                if not self._patience.pause(failures, error):
                    raise _unavailable("list", failures) from error

    def _is_there(self, key: str) -> bool:
        """Look once; the caller of `put` retries by itself."""
        try:
            obstore.head(self._bucket, key)
        except FileNotFoundError:
            return False
        return True

    def _asked(self, operation: str, ask: Callable[[], Answer]) -> Answer:
        failures = 0
        while True:
            try:
                return ask()
            except (FileNotFoundError, AlreadyExistsError):
                raise
            except (PermissionDeniedError, UnauthenticatedError) as error:
                metrics.STORE_ERRORS.labels(operation).inc()
                raise key_refused() from error
            except BaseError as error:
                failures += 1
                if not self._patience.pause(failures, error):
                    raise _unavailable(operation, failures) from error


class _BrokenOff(Exception):
    """An answer was shorter than announced."""


def _unavailable(operation: str, failures: int) -> StoreUnavailable:
    metrics.STORE_ERRORS.labels(operation).inc()
    return StoreUnavailable(f"the store did not answer a {operation} in {failures} tries", fix="try again later")


def _span(start: int, end: int | None) -> "GetOptions":
    if end is not None:
        return {"range": (start, end)}
    return {"range": {"offset": start}} if start else {}


def _client_options(endpoint: str, patience: RetryPolicy) -> "ClientConfig":
    return {
        "allow_http": endpoint.startswith("http://"),
        "connect_timeout": timedelta(seconds=patience.connect_timeout_s),
        "read_timeout": timedelta(seconds=patience.read_timeout_s),
        "timeout": timedelta(days=1),  # a large file may take its time, while it moves
    }
