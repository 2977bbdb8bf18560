"""The checksum that a sender gives for the bytes of one request."""

from dataclasses import dataclass

CHECKSUMS = ("sha256", "sha1")


@dataclass(frozen=True)
class Checksum:
    """The digest that they are to have."""

    algorithm: str
    digest: bytes
