"""Parses the headers of an upload: lengths, names, ids and digests; raises BadUploadHeader."""

import base64
import re
from uuid import UUID

from app.core.uploads import CHECKSUMS, Checksum
from app.deliveries.errors import BadUploadHeader

MAX_METADATA = 8_192  # characters; the name of a file may be long
HEX_SHA256 = re.compile(r"[0-9a-f]{64}")


def number_of_bytes(name: str, value: str | None) -> int:
    """Read a header that is a number of bytes; raise BadUploadHeader for anything else."""
    if value is None or not re.fullmatch("[0-9]{1,18}", value):
        raise BadUploadHeader(f"{name} is {value!r}; it must be a number of bytes")
    return int(value)


def named_values(header: str | None) -> dict[str, str]:
    """Read Upload-Metadata: names, each with a value in Base64."""
    if header is None or len(header) > 4 * MAX_METADATA:
        raise BadUploadHeader("Upload-Metadata must name delivery_id and file_name, in at most 32 KiB")
    pairs: dict[str, str] = {}
    for pair in header.split(","):
        name, _, value = pair.strip().partition(" ")
        pairs[name] = _text(name, value)
    return pairs


def _text(name: str, value: str) -> str:
    try:
        text = base64.b64decode(value.strip(), validate=True).decode()
    except ValueError:  # binascii.Error and UnicodeDecodeError are two of its kind
        raise BadUploadHeader(f"the value of {name!r} in Upload-Metadata is not UTF-8 in Base64") from None
    if "\0" in text:
        raise BadUploadHeader(f"the value of {name!r} in Upload-Metadata holds the character U+0000, which no name has")
    return text


def uuid_in(name: str, value: str) -> UUID:
    """Read an id out of Upload-Metadata."""
    try:
        return UUID(value)
    except ValueError:
        kind = name.removesuffix("_id")
        raise BadUploadHeader(f"{name} in Upload-Metadata is {value!r}; it must be the id of a {kind}") from None


def checksum_of(header: str | None) -> Checksum | None:
    """Read Upload-Checksum: an algorithm, a space, the digest in Base64."""
    if header is None:
        return None
    algorithm, _, value = header.strip().partition(" ")
    try:
        digest = base64.b64decode(value, validate=True)
    except ValueError:
        digest = b""
    if algorithm not in CHECKSUMS or not digest:
        raise BadUploadHeader("Upload-Checksum must be sha256 or sha1, a space and the digest in Base64")
    return Checksum(algorithm, digest)


def sha256_in_hex(value: str | None) -> str | None:
    """Read a SHA-256 in hex; return it in small letters."""
    if value is None:
        return None
    if not HEX_SHA256.fullmatch(value.strip().lower()):
        raise BadUploadHeader("a SHA-256 has 64 hexadecimal digits")
    return value.strip().lower()


def sha256_of_digest(header: str | None) -> str | None:
    """Read Repr-Digest; algorithms other than SHA-256 are the sender's business."""
    match = re.search(r"(?:^|,)\s*sha-256=:([A-Za-z0-9+/=]+):", header or "")
    if match is None:
        return None
    try:
        digest = base64.b64decode(match[1], validate=True)
    except ValueError:
        digest = b""
    if len(digest) != 32:
        raise BadUploadHeader("Repr-Digest must hold the 32 bytes of a SHA-256 in Base64")
    return digest.hex()
