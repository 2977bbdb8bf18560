"""Keys of this server that follow from its secret key, so that every process of it has the same ones."""

import hashlib
import hmac
import secrets
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # cryptography is loaded by what signs
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
    from cryptography.hazmat.primitives.ciphers.aead import AESGCM

NONCE_BYTES = 12
P256_ORDER = 0xFFFFFFFF00000000FFFFFFFFFFFFFFFFBCE6FAADA7179E84F3B9CAC2FC632551


def derived(secret: str, purpose: str, length: int) -> bytes:
    """Return bytes for one purpose that follow from a secret (HKDF with SHA-256, RFC 5869)."""
    key = hmac.digest(b"soundlist", secret.encode(), hashlib.sha256)
    key_bytes, block = b"", b""
    for number in range(1, -(-length // 32) + 1):
        block = hmac.digest(key, block + purpose.encode() + bytes([number]), hashlib.sha256)
        key_bytes += block
    return key_bytes[:length]


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


def sealed(secret: str, purpose: str, text: str, *, context: bytes) -> bytes:
    """Encrypt a text with the server's key for one purpose (AES-256-GCM); it opens for the same context only."""
    nonce = secrets.token_bytes(NONCE_BYTES)
    return nonce + _cipher(secret, purpose).encrypt(nonce, text.encode(), context)


def unsealed(secret: str, purpose: str, content: bytes, *, context: bytes) -> str:
    """Decrypt the output of `sealed`; raise cryptography's InvalidTag for anything else."""
    nonce, encrypted = content[:NONCE_BYTES], content[NONCE_BYTES:]
    return _cipher(secret, purpose).decrypt(nonce, encrypted, context).decode()


def _cipher(secret: str, purpose: str) -> "AESGCM":
    from cryptography.hazmat.primitives.ciphers.aead import AESGCM

    return AESGCM(derived(secret, purpose, 32))
