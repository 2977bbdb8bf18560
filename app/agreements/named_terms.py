"""What agreed contracts say in words of their own: the terms that a clause which stands names."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.agreements.clauses import Clause, TermValue, names_in
from app.agreements.models import Contract, ContractVersion


def named_terms(session: Session, contracts: Collection[Contract]) -> dict[UUID, dict[str, TermValue]]:
    """Return by contract the terms that the standing clauses of its newest version name, over its framework's."""
    ids = {one.id for one in contracts} | {one.framework_id for one in contracts if one.framework_id}
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
    own: dict[UUID, dict[str, TermValue]] = {}
    for contract_id, clauses, terms in rows:
        named = names_in([clause for clause in map(Clause.of, clauses) if clause.stands])
        own[contract_id] = {name: value for name, value in terms.items() if name in named}
    of_none: dict[str, TermValue] = {}
    return {
        one.id: (own.get(one.framework_id, of_none) if one.framework_id else of_none) | own.get(one.id, of_none)
        for one in contracts
    }
