"""A contract's plan, ledger and figures as people read them."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import visible_contract
from app.agreements.clauses.terms import MoneyTerms
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.plan.service import advice_on, concepts_of, payments_of, price_of
from app.agreements.queries import contract_for
from app.agreements.record.authorship import SERVER
from app.agreements.rules import ContractState
from app.money import queries, schemas
from app.money.bonuses.service import bonus_of
from app.money.figures import Figures, figures_of, open_tax_minor, tax_minor
from app.money.ledger.book import LedgerBook, PricedCue, price_of_round, settle_shares
from app.money.ledger.rules import LineKind
from app.money.ledger.service import load_ledger_book, priced, rules_of
from app.money.models import ExtraRound
from app.projects.models import Project
from app.sound_lists.models import Cue
from app.sound_lists.rules import label
from app.sound_lists.service import visible_cue


def brief(cue: Cue, cue_prefix: str) -> schemas.ContractedCue:
    """Return a cue as contracts name it."""
    return schemas.ContractedCue(id=cue.id, label=label(cue_prefix, cue.number), name=cue.name)


def plan(session: Session, actor: Actor, contract_id: UUID) -> schemas.PlanRead:
    """Return the milestones of a contract with what happened to them, and the warnings about the plan."""
    contract = visible_contract(session, actor, contract_id)
    return plan_of(session, contract)


def plan_of(session: Session, contract: Contract) -> schemas.PlanRead:
    """Return the milestones of a contract that the caller was found to see."""
    price = price_of(session, contract, payments_of(session, contract))
    return schemas.PlanRead(
        contract_id=contract.id,
        state=contract.state,
        currency=contract.currency,
        milestones=milestones_read(session, contract, load_ledger_book(session, contract)),
        advice=[schemas.AdviceRead.model_validate(advice) for advice in advice_on(session, contract)],
        price=schemas.PriceRead.model_validate(price),
        concepts=schemas.ConceptsRead.model_validate(concepts_of(session, contract)),
    )


def milestones_read(session: Session, contract: Contract, book: LedgerBook) -> list[schemas.MilestoneRead]:
    """Return the milestones of a contract, each with its cues and sums."""
    cue_prefix = session.get_one(Project, contract.project_id).cue_prefix
    cues = plan_queries.cues_of(session, contract.id)
    owed, paid = _by_place(book, "owed"), _by_place(book, "paid")
    return [
        _milestone(milestone, [cue for cue in cues if cue.milestone_id == milestone.id], owed, paid, cue_prefix)
        for milestone in plan_queries.milestones_of(session, contract.id)
    ]


Place = tuple[UUID | None, UUID | None]  # milestone and cue


def _by_place(book: LedgerBook, what: str) -> Mapping[Place, int]:
    sums: Counter[Place] = Counter()
    for line in book.owed:
        if line.kind is not LineKind.TAX:
            amount_minor = line.amount_minor if what == "owed" else book.paid_minor(line.id)
            sums[line.milestone_id, line.cue_id] += amount_minor
    return sums


def _milestone(
    milestone: Milestone,
    cues: Sequence[ContractCue],
    owed: Mapping[Place, int],
    paid: Mapping[Place, int],
    cue_prefix: str,
) -> schemas.MilestoneRead:
    kept_cues = [cue for cue in cues if cue.cut_at is None]
    moments = [cue.accepted_at or cue.cut_at for cue in cues]
    saved = sum((cue.amount_minor or 0) - owed.get((milestone.id, cue.cue_id), 0) for cue in cues if cue.cut_at)
    return schemas.MilestoneRead(
        id=milestone.id,
        name=milestone.name,
        is_deposit=milestone.is_deposit,
        amount_minor=milestone.amount_minor,
        left_minor=milestone.amount_minor - max(saved, 0),
        owed_minor=sum(amount for (milestone_id, _), amount in owed.items() if milestone_id == milestone.id),
        paid_minor=sum(amount for (milestone_id, _), amount in paid.items() if milestone_id == milestone.id),
        due_on=milestone.due_on,
        tax_bp=milestone.tax_bp,
        accepted=sum(cue.accepted_at is not None for cue in kept_cues),
        wanted=len(kept_cues),
        done_at=max(moment for moment in moments if moment) if moments and all(moments) else None,
        cues=[
            schemas.MilestoneCueRead(
                cue=brief(cue.cue, cue_prefix),
                price_minor=cue.price_minor,
                amount_minor=cue.amount_minor,
                estimate_min=cue.estimate_min,
                accepted_at=cue.accepted_at,
                cut_in=cue.cut_in,
                owed_minor=owed.get((milestone.id, cue.cue_id), 0),
                paid_minor=paid.get((milestone.id, cue.cue_id), 0),
            )
            for cue in cues
        ],
    )


def figures(session: Session, contract: Contract, book: LedgerBook) -> Figures:
    """Return the figures of an agreed contract."""
    milestones = plan_queries.milestones_of(session, contract.id)
    deposit_minor = sum(milestone.amount_minor for milestone in milestones if milestone.is_deposit)
    time_minor = terms_of(session, contract).time_cap_minor
    cues = priced(plan_queries.cues_of(session, contract.id))
    is_ended = contract.state is ContractState.ENDED and all(cue.is_settled for cue in cues)
    return figures_of(book, cues, deposit_minor + time_minor, is_ended=is_ended)


def ledger(session: Session, actor: Actor, contract_id: UUID) -> schemas.LedgerRead:
    """Return a contract's ledger, line by line, and what it comes to."""
    contract = visible_contract(session, actor, contract_id)
    book = load_ledger_book(session, contract)
    return schemas.LedgerRead(
        contract_id=contract.id,
        currency=contract.currency,
        figures=schemas.FiguresRead(**asdict(figures(session, contract, book))),
        tax_minor=tax_minor(book),
        open_tax_minor=open_tax_minor(book),
        bonus=bonus_of(session, contract, book),
        lines=ledger_lines(session, contract),
    )


def ledger_lines(session: Session, contract: Contract) -> list[schemas.LedgerLineRead]:
    """Return every line of a contract's ledger in words, in the order of their writing."""
    cue_prefix = session.get_one(Project, contract.project_id).cue_prefix
    milestones = {milestone.id: milestone.name for milestone in plan_queries.milestones_of(session, contract.id)}
    numbers = {invoice.id: invoice.full_number for invoice in queries.invoices_of(session, contract.id)}
    references = {payment.id: payment.reference for payment in queries.payments_of(session, contract.id)}
    return [
        schemas.LedgerLineRead(
            id=line.id,
            at=line.created_at,
            kind=line.kind,
            amount_minor=line.amount_minor,
            clause=line.clause,
            cue=brief(line.cue, cue_prefix) if line.cue else None,
            milestone_id=line.milestone_id,
            milestone=milestones[line.milestone_id] if line.milestone_id else None,
            round_number=line.round_number,
            tax_bp=line.tax_bp,
            by=line.person.name if line.person else SERVER,
            about_id=line.about_id,
            invoice_id=invoice_id,
            invoice_number=numbers[invoice_id] if invoice_id else None,
            reference=references[line.payment_id] if line.payment_id else None,
        )
        for line, invoice_id in queries.ledger_of(session, contract.id)
    ]


def extra_rounds(session: Session, actor: Actor, contract_id: UUID) -> list[schemas.ExtraRoundRead]:
    """Return the rounds beyond the included ones, with their prices."""
    contract = visible_contract(session, actor, contract_id)
    terms, cues = terms_of(session, contract), priced_by_cue(session, contract)
    rounds = queries.extra_rounds_of(session, contract.id)
    return [extra_round_read(session, contract, extra_round, terms, cues[extra_round.cue_id]) for extra_round in rounds]


def extra_round(session: Session, proposed: ExtraRound) -> schemas.ExtraRoundRead:
    """Return one round beyond the included ones, with its price."""
    contract = session.get_one(Contract, proposed.contract_id)
    cue = priced_by_cue(session, contract)[proposed.cue_id]
    return extra_round_read(session, contract, proposed, terms_of(session, contract), cue)


def extra_round_read(
    session: Session, contract: Contract, proposed: ExtraRound, terms: MoneyTerms, cue: PricedCue
) -> schemas.ExtraRoundRead:
    """Return a round with its price by the terms."""
    cue_prefix = session.get_one(Project, contract.project_id).cue_prefix
    return schemas.ExtraRoundRead(
        id=proposed.id,
        contract_id=contract.id,
        cue=brief(proposed.cue, cue_prefix),
        number=proposed.number,
        included=terms.rounds_included,
        amount_minor=price_of_round(cue, terms.extra_round_bp),
        currency=contract.currency,
        state="agreed" if proposed.agreed_at else "dropped" if proposed.dropped_at else "proposed",
        proposed_at=proposed.proposed_at,
    )


def priced_by_cue(session: Session, contract: Contract) -> dict[UUID, PricedCue]:
    """Return the cues of an agreed contract with their prices, by their ids."""
    return {cue.cue_id: cue for cue in priced(plan_queries.cues_of(session, contract.id))}


def cue_money(session: Session, actor: Actor, cue_id: UUID) -> schemas.CueMoneyRead | None:
    """Return the sum that accepting a cue would make due; None where no contract in the caller's sight covers it."""
    visible_cue(session, actor, cue_id)
    covered = plan_queries.running_cue(session, cue_id, None)
    contract = contract_for(session, actor, covered.contract_id) if covered else None
    if covered is None or contract is None:
        return None
    terms, cues = terms_of(session, contract), priced(plan_queries.cues_of(session, contract.id))
    of_it = next(cue for cue in cues if cue.cue_id == cue_id)
    book, rules = load_ledger_book(session, contract), rules_of(contract, terms)

    def becomes_due(*, is_accepted: bool) -> int:
        after = [replace(cue, is_accepted=is_accepted) if cue.cue_id == cue_id else cue for cue in cues]
        return sum(entry.amount_minor for entry in settle_shares(book, after, rules))

    is_reversible = of_it.is_accepted and of_it.cut_in is None
    siblings = [cue for cue in cues if cue.milestone_id == of_it.milestone_id and cue.cut_in is None]
    milestones = {milestone.id: milestone.name for milestone in plan_queries.milestones_of(session, contract.id)}
    accepted = sum(cue.is_accepted for cue in siblings)
    return schemas.CueMoneyRead(
        contract_id=contract.id,
        currency=contract.currency,
        milestone=milestones[of_it.milestone_id],
        amount_minor=of_it.amount_minor,
        would_owe_minor=0 if of_it.is_settled else becomes_due(is_accepted=True),
        would_take_back_minor=-becomes_due(is_accepted=False) if is_reversible else 0,
        accepted=accepted,
        accepted_then=accepted + (not of_it.is_settled),
        wanted=len(siblings),
        rounds_included=terms.rounds_included,
        extra_round_minor=price_of_round(of_it, terms.extra_round_bp),
        extra_rounds=[
            extra_round_read(session, contract, extra_round, terms, of_it)
            for extra_round in queries.extra_rounds_of(session, contract.id)
            if extra_round.cue_id == cue_id
        ],
    )
