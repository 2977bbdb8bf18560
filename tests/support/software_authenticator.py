"""A passkey authenticator in software: makes keys and signs challenges as a phone would (WebAuthn Level 3)."""

import hashlib
import json
import secrets
from base64 import urlsafe_b64encode
from typing import Any

import cbor2
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import ec

USER_PRESENT, USER_VERIFIED, CREDENTIAL_INCLUDED = 0x01, 0x04, 0x40


def _text(data: bytes) -> str:
    return urlsafe_b64encode(data).rstrip(b"=").decode()


class SoftwareAuthenticator:
    """One passkey of one person."""

    def __init__(self, origin: str, *, is_verifying: bool = True) -> None:
        self.origin, self.credential_id = origin, secrets.token_bytes(32)
        self.flags = USER_PRESENT | (USER_VERIFIED if is_verifying else 0)
        self._key = ec.generate_private_key(ec.SECP256R1())
        self.sign_count = 0

    def make(self, options: dict[str, Any]) -> dict[str, Any]:
        """Return what `navigator.credentials.create` would, as JSON."""
        numbers = self._key.public_key().public_numbers()
        cose_key = {1: 2, 3: -7, -1: 1, -2: numbers.x.to_bytes(32), -3: numbers.y.to_bytes(32)}  # RFC 9053, ES256
        attested = bytes(16) + len(self.credential_id).to_bytes(2) + self.credential_id + cbor2.dumps(cose_key)
        data = self._authenticator_data(options["rp"]["id"], CREDENTIAL_INCLUDED) + attested
        attestation = cbor2.dumps({"fmt": "none", "attStmt": {}, "authData": data})
        client_data = self._client_data("webauthn.create", options["challenge"])
        return self._credential({"clientDataJSON": _text(client_data), "attestationObject": _text(attestation)})

    def answer(self, options: dict[str, Any]) -> dict[str, Any]:
        """Return what `navigator.credentials.get` would, as JSON."""
        self.sign_count += 1
        data = self._authenticator_data(options["rpId"])
        client_data = self._client_data("webauthn.get", options["challenge"])
        signature = self._key.sign(data + hashlib.sha256(client_data).digest(), ec.ECDSA(hashes.SHA256()))
        return self._credential(
            {"clientDataJSON": _text(client_data), "authenticatorData": _text(data), "signature": _text(signature)}
        )

    def _authenticator_data(self, host: str, more_flags: int = 0) -> bytes:
        return hashlib.sha256(host.encode()).digest() + bytes([self.flags | more_flags]) + self.sign_count.to_bytes(4)

    def _client_data(self, kind: str, challenge: str) -> bytes:
        return json.dumps({"type": kind, "challenge": challenge, "origin": self.origin}).encode()

    def _credential(self, response: dict[str, str]) -> dict[str, Any]:
        id_ = _text(self.credential_id)
        return {"id": id_, "rawId": id_, "type": "public-key", "response": response, "clientExtensionResults": {}}
