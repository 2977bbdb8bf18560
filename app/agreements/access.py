"""Sight of a contract, and permission to change it."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.agreements.errors import ContractNotFound, SamePersonOnBothSides
from app.agreements.models import Contract
from app.agreements.queries import contract_for, lock_together
from app.agreements.rules import Party
from app.projects.errors import ProducerNeeded


def party_of(actor: Actor, contract: Contract) -> Party | None:
    """Return the party for which the caller acts; None for read-only access."""
    if actor.person_id == contract.designer_id:
        return Party.DESIGNER
    return Party.STUDIO if Role.PRODUCER in actor.roles_in(contract.studio_id) else None


def visible_contract(session: Session, actor: Actor, contract_id: UUID) -> Contract:
    """Return a contract that the caller may see; raise ContractNotFound otherwise."""
    contract = contract_for(session, actor, contract_id)
    if contract is None:
        raise ContractNotFound(f"no contract {contract_id}")
    return contract


def contract_for_producer(session: Session, actor: Actor, contract_id: UUID) -> Contract:
    """Return a contract for a producer of its studio.

    Raises ProducerNeeded for all others, SamePersonOnBothSides for its own designer.
    """
    contract = visible_contract(session, actor, contract_id)
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio can do this")
    if actor.person_id == contract.designer_id:
        raise SamePersonOnBothSides(
            "you are this contract's designer, so you do not act for the studio in it",
            fix="have another producer of the studio do it",
        )
    return contract


def contract_to_change(session: Session, actor: Actor, contract_id: UUID) -> Contract:
    """Return a locked contract; raise ProducerNeeded for all but the studio's producers."""
    return lock_together(session, contract_for_producer(session, actor, contract_id))
