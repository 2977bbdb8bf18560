"""Challenges of passkeys, which the server signs instead of keeping, as plain functions."""

import hmac
import json
import secrets
from datetime import datetime, timedelta
from hashlib import sha256
from typing import Any
from urllib.parse import urlsplit

from app.accounts.errors import PasskeyRefused

CHALLENGE_LIFETIME = timedelta(minutes=5)
TIME_BYTES = 8
NONCE_BYTES = 16
MAX_PASSKEYS = 20
# What reading someone's JSON, base64 or CBOR can raise, besides the errors of `webauthn` itself.
MALFORMED = (AttributeError, LookupError, RecursionError, TypeError, ValueError)


def new_challenge(key: bytes, purpose: str, at: datetime) -> bytes:
    """Return a challenge that says when and for what it was made, signed by the server."""
    signed = microseconds_of(at).to_bytes(TIME_BYTES) + secrets.token_bytes(NONCE_BYTES)
    return signed + _signature(key, purpose, signed)


def challenge_in(credential: dict[str, Any], key: bytes, purpose: str, at: datetime) -> tuple[bytes, int]:
    """Return the challenge that a browser answered, and when it was made, in microseconds.

    Raises PasskeyRefused for a challenge that is not of this server, for another purpose, or too old.
    """
    from webauthn import base64url_to_bytes

    try:
        client_data = json.loads(base64url_to_bytes(credential["response"]["clientDataJSON"]))
        challenge = base64url_to_bytes(client_data["challenge"])
    except MALFORMED as error:
        raise refused("what the browser sent is not the answer of a passkey") from error
    signed, signature = challenge[: TIME_BYTES + NONCE_BYTES], challenge[TIME_BYTES + NONCE_BYTES :]
    if not hmac.compare_digest(signature, _signature(key, purpose, signed)):
        raise refused("this answer is not for a challenge of this server")
    made_at_us = int.from_bytes(signed[:TIME_BYTES])
    if microseconds_of(at) - made_at_us > CHALLENGE_LIFETIME // timedelta(microseconds=1):
        raise refused("the passkey took longer than five minutes")
    return challenge, made_at_us


def refused(message: str) -> PasskeyRefused:
    """Return the refusal of a passkey's answer."""
    return PasskeyRefused(message, fix="try again, or sign in with your password")


def microseconds_of(at: datetime) -> int:
    """Return an instant as microseconds of Unix time."""
    return int(at.timestamp() * 1_000_000)


def relying_party_of(base_url: str) -> tuple[str, str]:
    """Return the host name that passkeys are bound to, and the origin of our pages."""
    parts = urlsplit(base_url)
    return parts.hostname or "", f"{parts.scheme}://{parts.netloc}".lower()


def _signature(key: bytes, purpose: str, signed: bytes) -> bytes:
    return hmac.new(key, purpose.encode() + b":" + signed, sha256).digest()
