"""The contract that ordered a designer's work on a cue."""

from collections.abc import Collection, Mapping
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.deliveries.signals import ContractsNamed, Work
from app.money import queries


def newest_contracts(session: Session, work: Collection[Work]) -> dict[Work, Contract]:
    """Return the newest agreed contract for each piece of work that has one."""
    newest: dict[Work, Contract] = {}
    for cue_id, contract in queries.contracts_covering(session, {cue_id for cue_id, _ in work}):
        if (cue_id, contract.designer_id) in work:
            newest[cue_id, contract.designer_id] = contract
    return newest


def contract_references(session: Session, cue_prefix: str, work_of: Mapping[UUID, Work]) -> dict[UUID, str]:
    """Return the short name of the contract that ordered each take's work, as in `SW contract 2`, by the take's id."""
    contracts = newest_contracts(session, set(work_of.values()))
    return {
        take_id: f"{cue_prefix} contract {contracts[work].number}"
        for take_id, work in work_of.items()
        if work in contracts
    }


def answer_contract_references(session: Session, asked: ContractsNamed) -> dict[UUID, str]:
    """Return the short names of contracts to the room that asks for them."""
    return contract_references(session, asked.cue_prefix, asked.work_of)
