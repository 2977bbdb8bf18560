"""Money on the screens that people start from: what is due and paid, which milestones come, and what is late."""

from collections import defaultdict
from collections.abc import Collection
from dataclasses import asdict
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.agreements.access import party_of
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import agreed_in, contract_for
from app.core import clock
from app.dashboards import queries, schemas
from app.dashboards.progress.service import Statuses
from app.dashboards.steps.questions import asked_questions
from app.money import queries as money_queries
from app.money.errors import MilestoneNotFound
from app.money.estimates.service import estimates_of
from app.money.invoices.service import invoice_read
from app.money.ledger.service import load_ledger_book
from app.money.overview import extra_round_read, figures, ledger_lines, milestones_read, priced_by_cue
from app.money.schedule_slip import Holder, Turn, growth_days, schedule_slip_of
from app.money.schemas import FiguresRead, InvoiceRead, MilestoneRead
from app.money.work.service import day_rate_read
from app.money.work.worked_hours import HourBook
from app.projects.service import ProjectAccess, project_access


def project_money(session: Session, actor: Actor, project_id: UUID) -> schemas.ProjectMoney:
    """Return the money of a project: those who act for the studio see every agreed contract, a designer their own.

    Raises TeamNeeded for the rest of the team. Only the two parties see how late a designer is.
    """
    access = project_access(session, actor, project_id)
    access.ensure_party()
    read = [
        _contract_money(session, contract, with_slips=party_of(actor, contract) is not None)
        for contract in agreed_in(session, actor, project_id)
    ]
    totals: dict[str, list[FiguresRead]] = defaultdict(list)
    for contract_read in read:
        totals[contract_read.currency].append(contract_read.figures)
    return schemas.ProjectMoney(
        contracts=read,
        totals=[schemas.CurrencyFigures(currency=currency, figures=_added(each)) for currency, each in totals.items()],
    )


def _added(figures_of_each: list[FiguresRead]) -> FiguresRead:
    names = FiguresRead.model_fields
    return FiguresRead(**{name: sum(getattr(figures_read, name) for figures_read in figures_of_each) for name in names})


def _contract_money(session: Session, contract: Contract, *, with_slips: bool) -> schemas.ContractMoney:
    book, terms = load_ledger_book(session, contract), terms_of(session, contract)
    milestones = milestones_read(session, contract, book)
    rounds, cues = money_queries.extra_rounds_of(session, contract.id), priced_by_cue(session, contract)
    invoices = [
        invoice_read(session, contract, book, invoice) for invoice in money_queries.invoices_of(session, contract.id)
    ]
    slips = _slips(session, contract.project_id, milestones) if with_slips else {}
    return schemas.ContractMoney(
        contract_id=contract.id,
        title=contract.title,
        designer=PersonBrief.model_validate(contract.designer),
        currency=contract.currency,
        release=contract.release_clause,
        kill_fee_in_work_bp=terms.kill_fee_in_work_bp,
        by_day=day_rate_read(terms, book),
        by_hour=HourBook(session, contract).read(),
        figures=FiguresRead(**asdict(figures(session, contract, book))),
        milestones=milestones,
        slips=list(slips.values()),
        slip_growth_days=growth_days([slip.days for slip in slips.values()]),
        proposed_rounds=[
            extra_round_read(session, contract, extra_round, terms, cues[extra_round.cue_id])
            for extra_round in rounds
            if extra_round.agreed_at is None and extra_round.dropped_at is None
        ],
        billable_minor=sum(line.amount_minor for line in book.billable),
        next_invoice=_next_number(session, contract),
        open_invoices=[invoice for invoice in invoices if invoice.state != "paid"],
        last_days_to_pay=_last_days_to_pay(invoices),
    )


def milestone_sheet(session: Session, actor: Actor, milestone_id: UUID) -> schemas.MilestoneSheet:
    """Return a milestone with its cues, its lateness, its estimates and its money; raise MilestoneNotFound unseen."""
    seen_milestone = plan_queries.milestone_by_id(session, milestone_id)
    contract = contract_for(session, actor, seen_milestone.contract_id) if seen_milestone else None
    if contract is None:
        raise MilestoneNotFound(f"no milestone {milestone_id}")
    access = project_access(session, actor, contract.project_id)
    book = load_ledger_book(session, contract)
    milestones = milestones_read(session, contract, book)
    milestone = next(milestone_read for milestone_read in milestones if milestone_read.id == milestone_id)
    listed = [cue.cue for cue in plan_queries.cues_of(session, contract.id) if cue.milestone_id == milestone_id]
    status = Statuses(session, access, listed).status
    is_party = party_of(actor, contract) is not None
    slips = _slips(session, contract.project_id, milestones) if is_party and contract.agreed_at else {}
    lines = [line for line in ledger_lines(session, contract) if line.milestone_id == milestone_id]
    invoiced = {line.invoice_id for line in lines}
    return schemas.MilestoneSheet(
        project_id=contract.project_id,
        contract_id=contract.id,
        contract_title=contract.title,
        contract_state=contract.state,
        designer=PersonBrief.model_validate(contract.designer),
        currency=contract.currency,
        release=contract.release_clause,
        milestone=milestone,
        cues=[schemas.MilestoneCue(**dict(cue), status=status[cue.cue.id]) for cue in milestone.cues],
        blocked_by=_blocking(session, access, {cue.id for cue in listed}),
        slip=slips.get(milestone_id),
        slips=list(slips.values()),
        slip_growth_days=growth_days([slip.days for slip in slips.values()]),
        estimates=estimates_of(session, contract) if is_party else None,
        lines=lines,
        invoices=[
            invoice_read(session, contract, book, invoice)
            for invoice in money_queries.invoices_of(session, contract.id)
            if invoice.id in invoiced
        ],
    )


def _blocking(session: Session, access: ProjectAccess, cue_ids: Collection[UUID]) -> list[schemas.AskedQuestion]:
    """Return the open questions that block cues; a designer sees only their own."""
    asked = queries.open_questions(session, access.project.id, asked_by=access.only_designer_id)
    return asked_questions(access.project, [row for row in asked if row[0].blocks and row[0].cue_id in cue_ids])


def _next_number(session: Session, contract: Contract) -> int:
    last = money_queries.last_invoice(session, contract.studio_id, contract.designer_id)
    return last.number + 1 if last else 1


def _last_days_to_pay(invoices: list[InvoiceRead]) -> int | None:
    return next((invoice.days_to_pay for invoice in reversed(invoices) if invoice.days_to_pay is not None), None)


def _slips(session: Session, project_id: UUID, milestones: list[MilestoneRead]) -> dict[UUID, schemas.MilestoneSlip]:
    """Return the lateness of each milestone that is finished or whose day is over."""
    now = clock.now()
    over = [
        milestone
        for milestone in milestones
        if milestone.due_on is not None and (milestone.done_at or milestone.due_on < now.date())
    ]
    unsettled = [cue.cue.id for open_milestone in over for cue in open_milestone.cues if cue.cut_in is None]
    turns = twiddle_factors(session, project_id, unsettled) if unsettled else {}
    slips: dict[UUID, schemas.MilestoneSlip] = {}
    for open_milestone in over:
        if open_milestone.due_on is None:
            continue
        of_cues = [_until(turns[cue.cue.id], cue.accepted_at) for cue in open_milestone.cues if cue.cut_in is None]
        slip = schedule_slip_of(open_milestone.due_on, open_milestone.done_at, of_cues, now)
        slips[open_milestone.id] = schemas.MilestoneSlip(
            milestone_id=open_milestone.id, name=open_milestone.name, due_on=open_milestone.due_on, **asdict(slip)
        )
    return slips


def _until(turns: list[Turn], accepted_at: datetime | None) -> list[Turn]:
    """Let an accepted cue count as the studio's from then on: the designer has nothing to do on it."""
    return [*turns, Turn(accepted_at, Holder.STUDIO)] if accepted_at else turns


def twiddle_factors(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, list[Turn]]:
    """Return the moments at which each cue passed to another person: sounds and questions pass it on, and answers."""
    turns: dict[UUID, list[Turn]] = defaultdict(list)
    for cue_id, at in queries.conforming_since(session, cue_ids):
        turns[cue_id].append(Turn(at, Holder.STUDIO))
    for cue_id, at in queries.changes_since(session, cue_ids):
        turns[cue_id].append(Turn(at, Holder.DESIGNER))
    for cue_id, asked_at, answered_at in queries.questions_since(session, project_id, cue_ids):
        turns[cue_id].append(Turn(asked_at, Holder.STUDIO))
        if answered_at is not None:
            turns[cue_id].append(Turn(answered_at, Holder.DESIGNER))
    return turns
