"""The head of a contract's record, signed by this server: what a party keeps to find a rollback of everything else."""

import base64
import json
from collections.abc import Iterator
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements import queries
from app.agreements.errors import BadHead
from app.agreements.models import Contract
from app.core import clock
from app.core.record import canonical
from app.core.server_keys import signing_key
from app.settings import Settings

FORMAT = 1
PURPOSE = "heads of records, Ed25519, version 1"
FACTS = ("format", "contract", "title", "studio", "designer", "length", "sha256", "at", "key")


def public_key_of(settings: Settings) -> str:
    """Return the public key of this server's heads, in hex."""
    key = signing_key(settings.secret_key.get_secret_value(), PURPOSE)
    return key.public_key().public_bytes_raw().hex()


def signed_checkpoint(settings: Settings, contract: Contract) -> dict[str, Any]:
    """Return the head of a contract's record as it is now, signed; it holds no more than both parties know."""
    facts = {
        "format": FORMAT,
        "contract": str(contract.id),
        "title": contract.title,
        "studio": contract.project.studio.name,
        "designer": contract.designer.name,
        "length": contract.record_length,
        "sha256": contract.record_sha256,
        "at": clock.now().isoformat(timespec="seconds"),
        "key": public_key_of(settings),
    }
    key = signing_key(settings.secret_key.get_secret_value(), PURPOSE)
    signature = key.sign(canonical(facts).encode())
    return {**facts, "signature": base64.b64encode(signature).decode()}


def read_head(text: str) -> dict[str, Any]:
    """Return the facts of a kept head, or of a mail that holds one; raise BadHead where its signature is not its own.

    Whether the key is this server's is for the caller to compare.
    """
    from cryptography.exceptions import InvalidSignature
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey

    begins, ends = text.find("{"), text.rfind("}")
    try:
        document = json.loads(text[begins : ends + 1])
        facts = {name: document[name] for name in FACTS}
        UUID(facts["contract"])
        if facts["format"] != FORMAT:
            raise BadHead(f"its format is {facts['format']!r}; this version reads format {FORMAT}")
        if not isinstance(facts["length"], int):
            raise BadHead("its length is not a number")
        signature = base64.b64decode(document["signature"], validate=True)
        Ed25519PublicKey.from_public_bytes(bytes.fromhex(facts["key"])).verify(signature, canonical(facts).encode())
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadHead(f"it is not a signed head of a record ({error})") from None
    except InvalidSignature:
        raise BadHead("it was altered: its signature is of other words") from None
    return facts


def faults_of_head(session: Session, settings: Settings, head: dict[str, Any]) -> Iterator[str]:
    """Yield, in words, where the server's record is not the one that a kept head was signed for."""
    if head["key"] != public_key_of(settings):
        yield f"it is signed by the key {head['key']}, and this server's is {public_key_of(settings)}"
    contract = queries.contract_by_id_or_none(session, UUID(head["contract"]))
    if contract is None:
        yield f"the contract {head['title']} is not on this server"
        return
    if contract.record_length < head["length"]:
        yield f"the record has {contract.record_length} entries, and had {head['length']} on {head['at']}"
        return
    sha256 = queries.event_sha256(session, contract.id, head["length"])
    if head["length"] and sha256 != head["sha256"]:
        yield f"entry {head['length']} is not the one that stood there on {head['at']}"
