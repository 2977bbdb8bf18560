"""A party's yes to the text of an amendment, given as to a contract itself."""

from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import record
from app.agreements.access import party_of, visible_contract
from app.agreements.errors import AlreadyAccepted, NotYourContract
from app.agreements.models import Contract
from app.agreements.queries import lock_contract
from app.agreements.rules import Party, ensure_another_person, ensure_same_text
from app.agreements.signing import Signature, facts_of_signature, proof_of
from app.amendments import queries
from app.amendments.models import AmendmentAcceptance


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
    signature: Signature,
) -> bool:
    """Record a yes to a text under the contract's lock; return whether both parties have given theirs.

    Raises TextChanged, AlreadyAccepted, SamePersonOnBothSides and AddressNotProven, as signing a contract does.
    """
    ensure_same_text(signature.text_sha256, text_sha256)
    given = queries.acceptances_of(session, contract.id, text_sha256)
    if any(each.party is party for each in given):
        raise AlreadyAccepted(f"the {party} has signed this text already; the other party has not")
    person = session.get_one(Person, actor.person)
    ensure_another_person(person.id, person.email, [(each.person_id, each.email) for each in given])
    acceptance = AmendmentAcceptance(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        text_sha256=text_sha256,
        party=party,
        person_id=person.id,
        name=signature.name,
        email=person.email,
        email_proof=person.email_proof,
        address=signature.address,
        agent=signature.agent,
        code_entered_at=proof_of(session, person, signature),
    )
    session.add(acceptance)
    session.flush()
    record.append(
        session,
        contract.id,
        kind,
        {
            **facts,
            "text_sha256_of_amendment": text_sha256,
            **facts_of_signature(person, party, signature),
        },
        by=person.id,
    )
    return bool(given)
