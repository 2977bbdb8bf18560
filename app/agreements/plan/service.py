"""A contract's plan: milestones with dates, cues and amounts; free in a draft, fixed when both have agreed."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import contract_for_producer, contract_to_change
from app.agreements.clauses.terms import PriceMode
from app.agreements.errors import BadPlan, PlanLocked, UnderContract
from app.agreements.joint.queries import other_contract
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.amounts import split
from app.agreements.plan.planned import PlannedCue, PlannedMilestone
from app.agreements.plan.proposal import DEPOSIT_BP, ProposedMilestone, WantedCue, propose_milestones
from app.agreements.plan.queries import terms_of
from app.agreements.plan.validation import Advice, PlannedPayment, check_plan
from app.agreements.record import service as record
from app.agreements.rules import KIND_WORDS, ContractKind, ContractState, next_action_hint
from app.core.errors import FieldProblem
from app.core.money import BASIS_POINTS, money
from app.hiring.queries import bid_behind
from app.hiring.rules import total_minor as total_of_bid
from app.sound_lists.rules import CueState

LARGEST_MINOR = 10**12  # of one milestone


@dataclass(frozen=True)
class Price:
    """The total of a plan, with its deposit in it, beside the bid that its contract began from."""

    total_minor: int
    deposit_minor: int
    bid_minor: int | None = None  # None: the contract began from no bid
    bid_currency: str | None = None
    above_bid_minor: int | None = None  # negative below it; None where it is in another currency


@dataclass(frozen=True)
class Concepts:
    """The cues of a plan that are an idea still, of how many, and what is paid for them."""

    count: int
    cues: int
    amount_minor: int


def concepts_in(session: Session, contract: Contract, plan: Sequence[PlannedMilestone]) -> Concepts:
    """Return the number of concept cues in a plan, and the sum that it pays for them."""
    cue_ids = [cue.cue_id for planned in plan for cue in planned.cues]
    cues_in_project = plan_queries.cues_in_project(session, contract.project_id, cue_ids)
    concepts = {cue.id for cue in cues_in_project if cue.state is CueState.CONCEPT}
    paid_minor = 0
    for planned in plan:
        if planned.cues and planned.whole_minor >= 0:
            shares = split(planned.whole_minor, [max(cue.price_minor or 0, 0) for cue in planned.cues])
            paid_minor += sum(share for cue, share in zip(planned.cues, shares, strict=True) if cue.cue_id in concepts)
    return Concepts(len(concepts), len(set(cue_ids)), paid_minor)


def concepts_of(session: Session, contract: Contract) -> Concepts:
    """Return the number of concepts among the cues of a contract's plan, and its pay for them."""
    return concepts_in(session, contract, plan_of(session, contract))


def plan_of(session: Session, contract: Contract) -> list[PlannedMilestone]:
    """Return the plan of a contract as it is written."""
    covered = plan_queries.cues_of(session, contract.id)
    return [
        PlannedMilestone(
            milestone.name,
            milestone.amount_minor,
            milestone.due_on,
            is_deposit=milestone.is_deposit,
            tax_bp=milestone.tax_bp,
            cues=[
                PlannedCue(cue.cue_id, cue.price_minor, cue.estimate_min)
                for cue in covered
                if cue.milestone_id == milestone.id
            ],
        )
        for milestone in plan_queries.milestones_of(session, contract.id)
    ]


def price_of(session: Session, contract: Contract, payments: Sequence[PlannedPayment]) -> Price:
    """Return the price of a plan beside the bid."""
    total_minor = sum(payment.amount_minor for payment in payments)
    deposit_minor = sum(payment.amount_minor for payment in payments if payment.is_deposit)
    bid = bid_behind(session, contract.id)
    if bid is None or bid.sent is None:
        return Price(total_minor, deposit_minor)
    bid_minor, currency = total_of_bid(bid.sent["lines"]), bid.posting.currency
    above = total_minor - bid_minor if currency == contract.currency else None
    return Price(total_minor, deposit_minor, bid_minor, currency, above)


def payments_of(session: Session, contract: Contract) -> list[PlannedPayment]:
    """Return the milestones of a contract as its plan is checked."""
    cues = Counter(cue.milestone_id for cue in plan_queries.cues_of(session, contract.id))
    return [
        PlannedPayment(
            name=milestone.name,
            amount_minor=milestone.amount_minor,
            due_on=milestone.due_on,
            cues=cues[milestone.id],
            is_deposit=milestone.is_deposit,
        )
        for milestone in plan_queries.milestones_of(session, contract.id)
    ]


def _beside_bid(price: Price, currency: str) -> list[Advice]:
    """Return the warning that a plan comes to another sum than the bid."""
    if not price.above_bid_minor or price.bid_minor is None or not price.total_minor:
        return []
    is_above = price.above_bid_minor > 0
    return [
        Advice(
            "above-bid" if is_above else "below-bid",
            f"The price is {money(price.total_minor, currency)}, {money(abs(price.above_bid_minor), currency)} "
            f"{'above' if is_above else 'below'} the bid of {money(price.bid_minor, currency)}.",
            "The bid is the whole price, and a deposit is a part of it.",
            excess=abs(price.above_bid_minor),
        )
    ]


def review_plan(
    session: Session, actor: Actor, contract_id: UUID, plan: Sequence[PlannedMilestone]
) -> tuple[list[FieldProblem], list[Advice], Price, Concepts]:
    """Return the errors and warnings of a plan while it is written, its price and its concepts; nothing is saved."""
    contract = contract_for_producer(session, actor, contract_id)
    payments = [
        PlannedPayment(
            milestone.name,
            milestone.whole_minor,
            milestone.due_on,
            len(milestone.cues),
            is_deposit=milestone.is_deposit,
        )
        for milestone in plan
    ]
    cue_ids = [cue.cue_id for milestone in plan for cue in milestone.cues]
    price = price_of(session, contract, payments)
    advice = [
        *check_plan(payments, contract.currency),
        *_beside_bid(price, contract.currency),
        *_covered_elsewhere(session, contract, cue_ids),
    ]
    return _faults(session, contract, plan), advice, price, concepts_in(session, contract, plan)


def propose_plan(
    session: Session, actor: Actor, contract_id: UUID, *, total_minor: int | None
) -> list[ProposedMilestone]:
    """Return milestones to begin a plan from, over the cues that no agreed contract covers; nothing is saved."""
    contract = contract_for_producer(session, actor, contract_id)
    of_other = _cue_ids_of_other(session, contract)
    cues = [cue for cue in plan_queries.wanted_cues(session, contract.project_id) if cue.id not in of_other]
    return propose_milestones(
        [WantedCue(cue.id, cue.category, cue.due_on) for cue in cues],
        today=plan_queries.today_of(session, contract),
        total_minor=total_minor,
        deposit_bp=contract.deposit_bp or DEPOSIT_BP,
    )


def save_plan(session: Session, actor: Actor, contract_id: UUID, plan: Sequence[PlannedMilestone]) -> Contract:
    """Put a plan in the place of a draft's plan; raise BadPlan with every problem that it has."""
    contract = contract_to_change(session, actor, contract_id)
    if contract.state is not ContractState.DRAFT:
        raise PlanLocked(
            f"this contract is {contract.state.value}, so its plan can't be edited",
            fix=next_action_hint(contract.state, contract.kind),
        )
    if contract.kind in (ContractKind.NDA, ContractKind.FRAMEWORK):
        raise PlanLocked(
            f"a {KIND_WORDS[contract.kind]} has no milestones",
            fix="plan the contract that orders the work",
        )
    if faults := _faults(session, contract, plan):
        raise BadPlan("; ".join(fault["message"] for fault in faults[:5]), errors=faults)
    session.execute(delete(ContractCue).where(ContractCue.contract_id == contract.id))
    session.execute(delete(Milestone).where(Milestone.contract_id == contract.id))
    position = 0
    for number, planned in enumerate(plan, start=1):
        of = {"studio_id": contract.studio_id, "project_id": contract.project_id, "contract_id": contract.id}
        milestone = Milestone(
            **of,
            position=number,
            name=planned.name,
            is_deposit=planned.is_deposit,
            amount_minor=planned.whole_minor,
            due_on=planned.due_on,
            tax_bp=planned.tax_bp,
        )
        session.add(milestone)
        session.flush()
        for cue in planned.cues:
            position += 1
            session.add(ContractCue(**of, milestone_id=milestone.id, position=position, **vars(cue)))
    whole = sum(planned.whole_minor for planned in plan)
    deposit = sum(planned.whole_minor for planned in plan if planned.is_deposit)
    contract.deposit_bp = (2 * deposit * BASIS_POINTS + whole) // (2 * whole) if whole else 0
    session.flush()
    return contract


def enter_amounts(session: Session, contract: Contract, amounts: Mapping[UUID, int]) -> None:
    """Give milestones of a draft other amounts; the prices of their cues keep their shares of them."""
    cues = plan_queries.cues_of(session, contract.id)
    for milestone in plan_queries.milestones_of(session, contract.id):
        if milestone.id not in amounts:
            continue
        milestone.amount_minor = amounts[milestone.id]
        milestone_cues = [cue for cue in cues if cue.milestone_id == milestone.id]
        if milestone_cues and all(cue.price_minor is not None for cue in milestone_cues):
            for cue, price_minor in zip(milestone_cues, _shares(milestone, milestone_cues), strict=True):
                cue.price_minor = price_minor
        else:
            for cue in milestone_cues:
                cue.price_minor = None  # it was a price in the other currency
    session.flush()


def _faults(session: Session, contract: Contract, plan: Sequence[PlannedMilestone]) -> list[FieldProblem]:
    faults: list[FieldProblem] = []

    def report(where: str, message: str) -> None:
        faults.append(FieldProblem(where=where, message=message))

    planned_cue_ids = [cue.cue_id for planned in plan for cue in planned.cues]
    cues_by_id = {cue.id: cue for cue in plan_queries.cues_in_project(session, contract.project_id, planned_cue_ids)}
    of_other = _cue_ids_of_other(session, contract)
    for index, planned in enumerate(plan):
        at = f"milestones.{index}"
        if planned.is_deposit and planned.cues:
            report(at, f"{planned.name} is a deposit, which is due at signing; move its cues into a milestone")
        if not 0 <= planned.whole_minor <= LARGEST_MINOR:
            report(at, f"{planned.name} pays {planned.whole_minor}; wanted 0 to {LARGEST_MINOR} in whole minor units")
        prices = [cue.price_minor for cue in planned.cues]
        if planned.amount_minor is not None and None not in prices and prices:
            added = sum(price or 0 for price in prices)
            if added != planned.amount_minor:
                report(
                    at,
                    f"the cues of {planned.name} add up to {money(added, contract.currency)}, "
                    f"and it pays {money(planned.amount_minor, contract.currency)}; leave one of them out",
                )
        elif planned.amount_minor is None and None in prices:
            report(at, f"{planned.name} has no amount, and one of its cues has no price; enter one of them")
        for cue in planned.cues:
            if cue.cue_id not in cues_by_id:
                report(at, f"{planned.name}: there is no cue {cue.cue_id} in this project")
            elif cues_by_id[cue.cue_id].state is CueState.CUT:
                report(at, f"{planned.name}: {cues_by_id[cue.cue_id].name} was cut")
            elif cue.cue_id in of_other:
                report(
                    at,
                    f"{planned.name}: {cues_by_id[cue.cue_id].name} is the other designer's of this joint work; "
                    "take it out of the plan there first",
                )
    for cue_id, times in Counter(planned_cue_ids).items():
        if times > 1 and cue_id in cues_by_id:
            report(
                "milestones", f"{cues_by_id[cue_id].name} is in the plan {times} times; a cue belongs to one milestone"
            )
    return faults


def _cue_ids_of_other(session: Session, contract: Contract) -> set[UUID]:
    """Return the cues that the other contract of joint work covers."""
    other = other_contract(session, contract)
    return {cue.cue_id for cue in plan_queries.cues_of(session, other.id)} if other else set()


def advice_on(session: Session, contract: Contract) -> list[Advice]:
    """Return the warnings about a contract's plan, with reasons."""
    payments = payments_of(session, contract)
    advice = check_plan(payments, contract.currency)
    if contract.state in (ContractState.DRAFT, ContractState.SENT):
        covered = plan_queries.cues_of(session, contract.id)
        advice += _beside_bid(price_of(session, contract, payments), contract.currency)
        advice += _covered_elsewhere(session, contract, [cue.cue_id for cue in covered])
    return advice


def _covered_elsewhere(session: Session, contract: Contract, cue_ids: Sequence[UUID]) -> list[Advice]:
    return [
        Advice(
            "covered-elsewhere",
            f"{cue} is part of {title}, which is signed.",
            "Two contracts would pay for it twice; remove it from one of them before signing.",
            subject=cue,
        )
        for cue, title in plan_queries.covered_elsewhere(session, contract.id, cue_ids)
    ]


def activate_plan(session: Session, contract: Contract, *, person_id: UUID) -> None:
    """Fix the price of every cue now that both have agreed.

    Raises UnderContract where a cue is not settled under another contract, NothingToSplit for an amount without cues.
    """
    milestones = plan_queries.milestones_of(session, contract.id)
    cues = plan_queries.cues_of(session, contract.id)
    taken = plan_queries.covered_elsewhere(session, contract.id, [cue.cue_id for cue in cues])
    if taken:
        named = ", ".join(f"{cue} ({title})" for cue, title in taken)
        raise UnderContract(
            f"another contract covers {named}",
            fix="the studio recalls this one and takes these cues out of its plan, or ends the other one",
        )
    by_day = terms_of(session, contract).price_mode is PriceMode.DAY_RATE
    for milestone in milestones:
        milestone_cues = [cue for cue in cues if cue.milestone_id == milestone.id]
        if not milestone.is_deposit and (milestone_cues or (milestone.amount_minor and not by_day)):
            for cue, amount_minor in zip(milestone_cues, _shares(milestone, milestone_cues), strict=True):
                cue.amount_minor = amount_minor
    session.flush()
    record_plan(session, contract, person_id=person_id)


def record_plan(session: Session, contract: Contract, *, person_id: UUID) -> None:
    """Write milestones, dates, amounts and the prices of cues into a contract's record, where it has a plan."""
    milestones = plan_queries.milestones_of(session, contract.id)
    cues = plan_queries.cues_of(session, contract.id)
    plan = [
        {
            "name": milestone.name,
            "amount": money(milestone.amount_minor, contract.currency),
            "due_on": milestone.due_on.isoformat() if milestone.due_on else "",
            "cues": sum(cue.milestone_id == milestone.id for cue in cues),
            "cue_ids": sorted(str(cue.cue_id) for cue in cues if cue.milestone_id == milestone.id),
        }
        for milestone in milestones
    ]
    if plan:
        record.append(session, contract.id, "planned", {"milestones": plan}, by=person_id)


def _shares(milestone: Milestone, cues: Sequence[ContractCue]) -> list[int]:
    return split(milestone.amount_minor, [cue.price_minor or 0 for cue in cues])
