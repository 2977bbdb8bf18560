"""The faults of a contract's text, its figures held against terms and plan."""

from collections.abc import Mapping, Sequence
from typing import Any

from sqlalchemy.orm import Session

from app.agreements.clauses.figures import plan_errors, text_errors
from app.agreements.clauses.rules import Clause
from app.agreements.errors import BadDraft
from app.agreements.models import Contract, ContractVersion
from app.agreements.plan.queries import milestones_of
from app.core.errors import FieldProblem


def text_faults(
    session: Session, contract: Contract, clauses: Sequence[Clause], terms: Mapping[str, Any], *, holdback_bp: int
) -> list[FieldProblem]:
    """Return the faults of a text: of its clauses, of its figures, and its omissions on the plan."""
    milestones = milestones_of(session, contract.id)
    faults = [
        *text_errors(clauses, terms, contract.kind),
        *plan_errors(
            clauses,
            contract.kind,
            has_amounts=any(milestone.amount_minor for milestone in milestones),
            has_deposit=any(milestone.amount_minor for milestone in milestones if milestone.is_deposit),
            has_holdback=holdback_bp > 0,
            is_joint=contract.joint_id is not None,
        ),
    ]
    return [FieldProblem(where=where, message=message) for where, message in faults]


def ensure_text_whole(session: Session, contract: Contract, version: ContractVersion, outcome: str) -> None:
    """Raise BadDraft, which begins with the outcome, where a version's text lacks a figure or contradicts one."""
    clauses = [Clause.of(row) for row in version.clauses]
    if problems := text_faults(session, contract, clauses, version.terms, holdback_bp=contract.holdback_bp):
        raise BadDraft(
            f"{outcome}; {problems[0]['message']}",
            errors=problems,
            fix="edit the draft, save it, and send it again",
        )
