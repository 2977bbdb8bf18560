"""Keys of this server that follow from its secret key, so that every process of it has the same ones."""

import hashlib
import hmac
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # cryptography is loaded by what signs
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

P256_ORDER = 0xFFFFFFFF00000000FFFFFFFFFFFFFFFFBCE6FAADA7179E84F3B9CAC2FC632551


def derived(secret: str, purpose: str, length: int) -> bytes:
    """Return bytes for one purpose that follow from a secret (HKDF with SHA-256, RFC 5869)."""
    key = hmac.digest(b"soundlist", secret.encode(), hashlib.sha256)
    found, block = b"", b""
    for number in range(1, -(-length // 32) + 1):
        block = hmac.digest(key, block + purpose.encode() + bytes([number]), hashlib.sha256)
        found += block
    return found[:length]


def signing_key(secret: str, purpose: str) -> "Ed25519PrivateKey":
    """Return the Ed25519 key of this server for one purpose."""
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

    return Ed25519PrivateKey.from_private_bytes(derived(secret, purpose, 32))


def certificate_key(secret: str, purpose: str) -> "EllipticCurvePrivateKey":
    """Return the P-256 key of this server for one purpose."""
    from cryptography.hazmat.primitives.asymmetric import ec

    # 16 bytes more than the order has leave no measurable bias (FIPS 186-5, A.2.1).
    number = int.from_bytes(derived(secret, purpose, 48)) % (P256_ORDER - 1) + 1
    return ec.derive_private_key(number, ec.SECP256R1())
