"""Passwords as argon2id hashes, few at once."""

import secrets
import threading
import unicodedata
from functools import cache

from pwdlib import PasswordHash

MAX_CONCURRENT_HASHES = 2  # each takes 64 MiB and a tenth of a second of four threads

_hasher = PasswordHash.recommended()
_gate = threading.BoundedSemaphore(MAX_CONCURRENT_HASHES)


def hash_of(password: str) -> str:
    """Return the hash under which a password is kept."""
    with _gate:
        return _hasher.hash(_plain(password))


def matches(password: str, password_hash: str | None) -> bool:
    """Whether a password is the hashed one; where there is no hash, finding out takes as long."""
    no_account = _dummy_hash()
    with _gate:
        return _hasher.verify(_plain(password), password_hash or no_account) and password_hash is not None


@cache
def _dummy_hash() -> str:
    return hash_of(secrets.token_urlsafe())


def _plain(password: str) -> str:
    return unicodedata.normalize("NFKC", password)  # the same letters typed on another system
