"""What the record holds of a contract's tables, so that `soundlist verify` finds an altered price, date or term."""

import hashlib
from collections.abc import Mapping, Sequence
from typing import Any

from app.agreements.models import Contract, ContractCue, ContractVersion, Milestone
from app.kit.record import canonical


def sealed(facts: Mapping[str, Any]) -> str:
    """Return the SHA-256 of facts, as hex digits."""
    return hashlib.sha256(canonical(facts).encode()).hexdigest()


def sealed_milestone(milestone: Milestone, cues: Sequence[ContractCue]) -> dict[str, Any]:
    """Return which milestone it is, which cues it has, and the SHA-256 of its terms and of the prices of its cues."""
    prices = {str(cue.cue_id): [cue.price_minor, cue.amount_minor] for cue in cues}
    facts = {
        "name": milestone.name,
        "is_deposit": milestone.is_deposit,
        "amount_minor": milestone.amount_minor,
        "due_on": milestone.due_on.isoformat() if milestone.due_on else None,
        "tax_bp": milestone.tax_bp,
        "cues": prices,
    }
    return {"id": str(milestone.id), "cue_ids": sorted(prices), "sha256": sealed(facts)}


def sealed_terms(contract: Contract, version: ContractVersion) -> str:
    """Return the SHA-256 of what money is calculated by: clauses, terms, currency and framework."""
    return sealed(
        {
            "clauses": version.clauses,
            "terms": version.terms,
            "currency": contract.currency,
            "framework": str(contract.framework_id) if contract.framework_id else None,
        }
    )
