"""A party's yes to the text of an amendment, given as to a contract itself."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import party_of, visible_contract
from app.agreements.errors import NotYourContract
from app.agreements.models import Contract
from app.agreements.queries import lock_contract
from app.agreements.record import service as record
from app.agreements.rules import Party, ensure_same_text
from app.agreements.signing.service import SignatureRequest, amendment_order_of, sign_text, yeses
from app.amendments import queries
from app.amendments.models import AmendmentAcceptance
from app.core.events import publish


def locked_for_party(session: Session, actor: Actor, contract_id: UUID) -> tuple[Contract, Party]:
    """Return a locked contract and the caller's party in it; raise NotYourContract for others who see it."""
    contract = visible_contract(session, actor, contract_id)
    party = party_of(actor, contract)
    if party is None:
        raise NotYourContract("only a producer of the studio and the contract's designer change it")
    return lock_contract(session, contract.id), party


def sign(
    session: Session,
    actor: Actor,
    contract: Contract,
    party: Party,
    *,
    kind: str,
    facts: dict[str, Any],
    text_sha256: str,
    signature: SignatureRequest,
) -> bool:
    """Record a yes to a text under the contract's lock; return whether all who sign it have given theirs.

    Raises TextChanged, AlreadyAccepted, NotASigner, NotYourTurn, SamePersonOnBothSides and AddressNotProven, as
    signing a contract does.
    """
    ensure_same_text(signature.text_sha256, text_sha256)
    given = queries.acceptances_of(session, contract.id, text_sha256)
    facts = {**facts, "text_sha256_of_amendment": text_sha256}
    _, turn = sign_text(
        session,
        actor,
        contract,
        party,
        signature,
        order=amendment_order_of(session, contract),
        given=given,
        new_acceptance=partial(AmendmentAcceptance, text_sha256=text_sha256),
        put_on_record=lambda signed: record.append(session, contract.id, kind, {**facts, **signed}, by=actor.person),
    )
    if Party.STUDIO in turn.parties and turn.signer is not None:
        publish(
            session,
            "amendment.signer_is_next",
            studio_id=contract.studio_id,
            contract_id=contract.id,
            person_id=turn.signer,
            what=_called(kind),
        )
    return not turn.parties


@dataclass(frozen=True)
class Signatures:
    """The number of signatures that a text needs, and whether the caller's is the next."""

    needed: int
    is_my_turn: bool


def signatures(
    session: Session,
    contract: Contract,
    given: Sequence[AmendmentAcceptance],
    person_id: UUID | None,
    party: Party | None,
) -> Signatures:
    """Return the state of a text's signatures, for a person of a party."""
    order = amendment_order_of(session, contract)
    turn = order.turn(yeses(given))
    is_mine = party is not None and person_id is not None and turn.is_of(party, person_id)
    return Signatures(1 + max(1, len(order.signers)), is_mine)


def _called(kind: str) -> str:
    """Return the name of a text, by the kind of its entries in the record."""
    return "a change order" if kind == "change_accepted" else "the settlement statement"
