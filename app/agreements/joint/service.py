"""Joint work of two designers: a draft that is divided, and the split of its price."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import contract_to_change, visible_contract
from app.agreements.clauses.rules import Clause, library
from app.agreements.drafts.lifecycle import create_contract
from app.agreements.drafts.versions import add_version, newest_of
from app.agreements.errors import BadSplit
from app.agreements.joint.queries import other_contract
from app.agreements.joint.rules import CLAUSE, Share, divide, ensure_single, ensure_stands_alone, with_clause
from app.agreements.models import Contract
from app.agreements.plan.amounts import split
from app.agreements.plan.queries import milestones_of
from app.agreements.plan.service import enter_amounts, plan_of, save_plan
from app.agreements.rules import (
    ContractKind,
    ContractState,
    ensure_state,
    next_action_hint,
)
from app.core.db import new_id

TITLE_CHARS = 120


def divide_contract(
    session: Session, actor: Actor, contract_id: UUID, *, engagement_id: UUID, cue_ids: Collection[UUID], share: Share
) -> Contract:
    """Divide a draft between its designer and a second one, who has some of its cues; return the draft.

    The second designer's draft begins like this one. The amounts of both add up to what this one had, by the share of
    the second designer where it has a figure, else by the cues. Raises BadSplit where that cannot be.
    """
    contract = contract_to_change(session, actor, contract_id)
    ensure_state(contract.state, {ContractState.DRAFT}, next_action_hint(contract.state, contract.kind))
    ensure_single(contract.kind)
    ensure_stands_alone(contract.joint_id)
    first_plan, second_plan = divide(plan_of(session, contract), set(cue_ids))
    second = create_contract(
        session,
        actor,
        contract.project_id,
        engagement_id=engagement_id,
        kind=ContractKind.SINGLE,
        title=contract.title,
        currency=contract.currency,
        same_as_id=contract.id,
    )
    if second.designer_id == contract.designer_id:
        raise BadSplit(f"{second.designer.name} has this contract already", fix="choose another designer")
    second.title = f"{contract.title}, {second.designer.name}"[:TITLE_CHARS]
    contract.joint_id = second.joint_id = new_id()
    save_plan(session, actor, contract.id, first_plan)
    save_plan(session, actor, second.id, second_plan)
    if share.has_figure:
        _split(session, second, contract, share)
    (clause,) = [each.clause for each in library() if each.clause.key == CLAUSE]
    for part, other in ((contract, second), (second, contract)):
        newest = newest_of(session, part)
        clauses = with_clause([Clause.of(row) for row in newest.clauses], clause, stands=True)
        add_version(session, actor, part, clauses, newest.terms, note=f"Joint work with {other.designer.name}")
    return visible_contract(session, actor, contract.id)


def split_price(session: Session, actor: Actor, contract_id: UUID, share: Share) -> Contract:
    """Give this contract's designer another share of the milestones of joint work, both of whose contracts are drafts.

    The sum of both stays as it is. Raises BadSplit where that cannot be.
    """
    contract = contract_to_change(session, actor, contract_id)
    ensure_state(contract.state, {ContractState.DRAFT}, next_action_hint(contract.state, contract.kind))
    other = other_contract(session, contract)
    if other is None:
        raise BadSplit("this contract has one designer, who is paid all of it", fix="divide it with a second designer")
    _split(session, contract, other, share)
    return contract


def _split(session: Session, contract: Contract, other: Contract, share: Share) -> None:
    """Scale the milestones of both contracts, so that the first pays its share of what both pay now."""
    if contract.currency != other.currency:
        raise BadSplit(
            f"the contracts are in {contract.currency} and {other.currency}",
            fix="bring both into one currency in their drafts, then split the price",
        )
    whole_minor = sum(planned.amount_minor for each in (contract, other) for planned in milestones_of(session, each.id))
    share_minor = share.of(whole_minor, contract.currency)
    for part, part_minor in ((contract, share_minor), (other, whole_minor - share_minor)):
        milestones = milestones_of(session, part.id)
        if not milestones and part_minor:
            raise BadSplit(f"{part.title} has no milestones to pay for", fix="plan its milestones first")
        amounts = split(part_minor, [planned.amount_minor for planned in milestones]) if milestones else []
        enter_amounts(session, part, {planned.id: amount for planned, amount in zip(milestones, amounts, strict=True)})
