"""Terms of agreed contracts in words of their own: the terms that a clause in force names."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.agreements.clauses.named_days import DAY_TERMS
from app.agreements.clauses.rules import Clause, TermValue, names_in
from app.agreements.models import Contract, ContractVersion
from app.agreements.rules import ContractState


def named_terms(session: Session, contracts: Collection[Contract]) -> dict[UUID, dict[str, TermValue]]:
    """Return by contract the terms that the standing clauses of its newest version name, over its framework's."""
    ids = {contract.id for contract in contracts} | {
        contract.framework_id for contract in contracts if contract.framework_id
    }
    newest = (
        select(ContractVersion.contract_id, func.max(ContractVersion.number).label("number"))
        .where(ContractVersion.contract_id.in_(ids))
        .group_by(ContractVersion.contract_id)
        .subquery()
    )
    rows = session.execute(
        select(ContractVersion.contract_id, ContractVersion.clauses, ContractVersion.terms).join(
            newest,
            (newest.c.contract_id == ContractVersion.contract_id) & (newest.c.number == ContractVersion.number),
        )
    )
    terms_by_contract: dict[UUID, dict[str, TermValue]] = {}
    for contract_id, clauses, terms in rows:
        named = names_in([clause for clause in map(Clause.of, clauses) if clause.stands])
        terms_by_contract[contract_id] = {name: value for name, value in terms.items() if name in named}
    of_none: dict[str, TermValue] = {}
    return {
        contract.id: (terms_by_contract.get(contract.framework_id, of_none) if contract.framework_id else of_none)
        | terms_by_contract.get(contract.id, of_none)
        for contract in contracts
    }


def contracts_with_days(session: Session) -> Sequence[Contract]:
    """Return the contracts that were agreed and leave a day open that was filled in, struck clauses included."""
    names_a_day = or_(*(ContractVersion.terms[term].as_string().like("2%") for term in DAY_TERMS))
    versions = select(ContractVersion.contract_id).where(names_a_day)
    return session.scalars(
        select(Contract)
        .where(
            Contract.id.in_(versions),
            Contract.agreed_at.is_not(None),
            Contract.state.in_((ContractState.AGREED, ContractState.ENDED)),
        )
        .options(joinedload(Contract.project))
        .order_by(Contract.id)
    ).all()
