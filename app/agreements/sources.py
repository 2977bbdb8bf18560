"""Contracts that want the sources of sounds before acceptance, or before an invoice."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.terms import SourcesNeeded
from app.agreements.models import Contract
from app.agreements.plan.queries import running_cue, terms_of
from app.deliveries.signals import SourcesDue
from app.deliveries.sources.queries import approved_takes_of
from app.deliveries.sources.service import ensure_stated


def ensure_stated_to_accept(session: Session, due: SourcesDue) -> None:
    """Raise SourcesMissing where a contract wants the sources of a take before it is accepted."""
    take = due.take
    covered = running_cue(session, take.cue_id, {take.designer_id}) if take.cue_id else None
    if covered is not None:
        contract = session.get_one(Contract, covered.contract_id)
        if terms_of(session, contract).sources_needed is SourcesNeeded.BEFORE_ACCEPTANCE:
            ensure_stated(session, [take])


def ensure_stated_to_invoice(session: Session, contract: Contract, cue_ids: Collection[UUID]) -> None:
    """Raise SourcesMissing where a contract wants the sources of accepted cues before they are invoiced."""
    if terms_of(session, contract).sources_needed is SourcesNeeded.BEFORE_INVOICE:
        ensure_stated(session, approved_takes_of(session, cue_ids, contract.designer_id))
