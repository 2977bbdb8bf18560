"""The days of agreed contracts that are near."""

from collections.abc import Collection
from datetime import date

from sqlalchemy.orm import Session

from app.agreements.clauses.named_days import NamedDay, named_days
from app.agreements.clauses.named_term_queries import named_terms
from app.agreements.models import Contract


def near_days(session: Session, contracts: Collection[Contract], today: date) -> list[tuple[Contract, NamedDay]]:
    """Return the days of contracts of which both parties are reminded now, the earliest first."""
    agreed = [contract for contract in contracts if contract.agreed_at is not None]
    terms = named_terms(session, agreed) if agreed else {}
    near = [
        (contract, named)
        for contract in agreed
        if contract.agreed_at
        for named in named_days(terms[contract.id], contract.agreed_at.date())
        if named.is_near(today)
    ]
    return sorted(near, key=lambda pair: pair[1].day)
