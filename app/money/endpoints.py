"""The endpoints of plans, ledgers, invoices and payments."""

from uuid import UUID

from fastapi import APIRouter, Response

from app.accounts.errors import RecentSignInNeeded, SecondFactorRequired
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.drafts import documents
from app.agreements.errors import BadPlan, ContractNotFound, PlanLocked
from app.agreements.plan import service as plan
from app.agreements.plan.planned import PlannedCue, PlannedMilestone
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads, file_response
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED
from app.money import calendar, overview, payments, schemas, settlement
from app.money.bonuses import shipping
from app.money.errors import (
    CueNotInContract,
    DayInFuture,
    ExtraRoundNotFound,
    InvoiceNotFound,
    InvoiceNumberTaken,
    NoInterestDue,
    NoShippingBonus,
    NotAgreed,
    NothingToInvoice,
    OtherPartyNeeded,
    Overpayment,
    PaymentNotFound,
    RefundTooLarge,
    RoundAlreadySettled,
)
from app.money.estimates import service as estimates
from app.money.invoices import service as invoices
from app.money.invoices import text as invoice_text
from app.money.invoices.numbers import file_part
from app.projects.errors import ProducerNeeded, ProjectNotFound
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["money"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.get("/contracts/{contract_id}/milestones", responses=problems(ContractNotFound))
def read_plan(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.PlanRead:
    """Return the milestones of a contract with what happened to them, and the warnings about the plan."""
    return overview.plan(session, actor, contract_id)


@router.get(
    "/contracts/{contract_id}/milestones/proposal",
    responses=problems(ContractNotFound, ProducerNeeded),
)
def propose_plan(
    contract_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
    total_minor: schemas.Minor | None = None,
) -> schemas.PlanProposal:
    """Return milestones by the due dates and categories of the sound list, to begin a plan from; nothing is saved."""
    proposed = plan.propose_plan(session, actor, contract_id, total_minor=total_minor)
    return schemas.PlanProposal(milestones=[schemas.ProposedMilestoneRead(**vars(milestone)) for milestone in proposed])


@router.put(
    "/contracts/{contract_id}/milestones",
    responses=problems(ContractNotFound, ProducerNeeded, PlanLocked, BadPlan),
)
@accepts_body(LARGE_BODY_BYTES)
def save_plan(
    contract_id: UUID, body: schemas.PlanSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.PlanRead:
    """Replace the plan of a draft; warnings about it are returned and do not stop it."""
    return overview.plan_of(session, plan.save_plan(session, actor, contract_id, _planned(body)))


def _planned(body: schemas.PlanSet) -> list[PlannedMilestone]:
    return [
        PlannedMilestone(
            name=milestone.name,
            amount_minor=milestone.amount_minor,
            due_on=milestone.due_on,
            is_deposit=milestone.is_deposit,
            tax_bp=milestone.tax_bp,
            cues=[PlannedCue(cue.cue_id, cue.price_minor, cue.estimate_min) for cue in milestone.cues],
        )
        for milestone in body.milestones
    ]


@router.post(
    "/contracts/{contract_id}/plan-check",
    responses=problems(ContractNotFound, ProducerNeeded),
)
@accepts_body(LARGE_BODY_BYTES)
def check_plan(
    contract_id: UUID, body: schemas.PlanSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.PlanChecked:
    """Return the errors and warnings of a plan, with reasons; nothing is saved."""
    faults, advice, price, concepts = plan.review_plan(session, actor, contract_id, _planned(body))
    return schemas.PlanChecked(
        faults=[schemas.PlanFault(**fault) for fault in faults],
        advice=[schemas.AdviceRead.model_validate(advised) for advised in advice],
        price=schemas.PriceRead.model_validate(price),
        concepts=schemas.ConceptsRead.model_validate(concepts),
    )


@router.post(
    "/contracts/{contract_id}/shipped",
    responses=problems(ContractNotFound, ProducerNeeded, SecondFactorRequired, NoShippingBonus, DayInFuture),
)
def say_game_shipped(
    contract_id: UUID, body: schemas.Shipped, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.LedgerRead:
    """Say that the game has shipped, which makes the bonus due that waits for it."""
    shipping.say_shipped(session, actor, contract_id, shipped_on=body.shipped_on)
    return overview.ledger(session, actor, contract_id)


@router.get("/contracts/{contract_id}/ledger", responses=problems(ContractNotFound))
def read_ledger(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.LedgerRead:
    """Return a contract's ledger line by line, and what it comes to."""
    return overview.ledger(session, actor, contract_id)


@router.get("/contracts/{contract_id}/extra-rounds", responses=problems(ContractNotFound))
def read_extra_rounds(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[schemas.ExtraRoundRead]:
    """Return the rounds beyond the included ones, with their prices."""
    return overview.extra_rounds(session, actor, contract_id)


@router.post(
    "/extra-rounds/{extra_round_id}/agree",
    responses=problems(ExtraRoundNotFound, OtherPartyNeeded, ProducerNeeded, SecondFactorRequired, RoundAlreadySettled),
)
def agree_extra_round(
    extra_round_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ExtraRoundRead:
    """Agree to the price of a further round; it is due at once."""
    return overview.extra_round(session, settlement.agree_extra_round(session, actor, extra_round_id))


@router.post(
    "/extra-rounds/{extra_round_id}/drop", responses=problems(ExtraRoundNotFound, OtherPartyNeeded, RoundAlreadySettled)
)
def drop_extra_round(
    extra_round_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.ExtraRoundRead:
    """Let a further round go without its price."""
    return overview.extra_round(session, settlement.drop_extra_round(session, actor, extra_round_id))


@router.get(
    "/contracts/{contract_id}/invoice-draft",
    responses=problems(ContractNotFound, OtherPartyNeeded, NotAgreed, NothingToInvoice),
)
def read_invoice_draft(
    contract_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.DESIGNER),
    full_number: schemas.InvoiceNumber = "",
) -> schemas.InvoiceDraft:
    """Return the content of an invoice if it were issued now, under this number or the one after the last."""
    return invoices.draft_invoice(session, actor, contract_id, full_number=full_number)


@router.get("/contracts/{contract_id}/invoices", responses=problems(ContractNotFound))
def list_invoices(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[schemas.InvoiceRead]:
    """Return the invoices of a contract, the oldest first."""
    return invoices.invoices(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/invoices",
    status_code=201,
    responses=problems(ContractNotFound, OtherPartyNeeded, NotAgreed, NothingToInvoice, InvoiceNumberTaken),
)
def issue_invoice(
    contract_id: UUID, body: schemas.InvoiceIssue, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.InvoiceRead:
    """Issue an invoice over everything that is due and on none yet."""
    issued = invoices.issue_invoice(
        session,
        actor,
        contract_id,
        full_number=body.full_number,
        seller=body.seller,
        buyer=body.buyer,
        po_number=body.po_number,
        note=body.note,
    )
    return invoices.invoice(session, actor, issued.id)


@router.get("/invoices/{invoice_id}", responses=problems(InvoiceNotFound))
def read_invoice(invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.InvoiceRead:
    """Return an invoice with its lines and payments."""
    return invoices.invoice(session, actor, invoice_id)


@router.get(
    "/invoices/{invoice_id}/invoice.pdf",
    **downloads(documents.PDF, InvoiceNotFound, DocumentTooLarge, TypesettingBusy),
)
def read_invoice_pdf(invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Response:
    """Return an invoice as PDF; the same invoice is the same bytes."""
    issued = invoices.invoice(session, actor, invoice_id)
    name = f"invoice-{file_part(issued.full_number)}.pdf"
    return file_response(invoice_text.pdf_of(issued), documents.PDF, name, inline=True)


@router.post(
    "/invoices/{invoice_id}/late-interest",
    status_code=201,
    responses=problems(InvoiceNotFound, OtherPartyNeeded, NoInterestDue),
)
def charge_late_interest(
    invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.InvoiceRead:
    """Make the interest that an invoice bears by today due; it goes on the next invoice."""
    return invoices.charge_late_interest(session, actor, invoice_id)


@router.post(
    "/invoices/{invoice_id}/payments",
    status_code=201,
    responses=problems(InvoiceNotFound, ProducerNeeded, SecondFactorRequired, Overpayment, DayInFuture),
)
def record_payment(
    invoice_id: UUID, body: schemas.PaymentAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.InvoiceRead:
    """Record the payment of an invoice, in part or whole."""
    payments.record_payment(
        session,
        actor,
        invoice_id,
        amount_minor=body.amount_minor,
        reference=body.reference,
        paid_on=body.paid_on,
    )
    return invoices.invoice(session, actor, invoice_id)


@router.post(
    "/payments/{payment_id}/refunds",
    status_code=201,
    responses=problems(PaymentNotFound, ProducerNeeded, SecondFactorRequired, RefundTooLarge, DayInFuture),
)
def refund_payment(
    payment_id: UUID, body: schemas.PaymentAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.InvoiceRead:
    """Record that a payment went back, in part or whole."""
    refund = payments.refund_payment(
        session,
        actor,
        payment_id,
        amount_minor=body.amount_minor,
        reference=body.reference,
        paid_on=body.paid_on,
    )
    return invoices.invoice(session, actor, refund.invoice_id)


@router.get("/cues/{cue_id}/money", responses=problems(CueNotFound))
def read_cue_money(
    cue_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.CueMoneyRead | None:
    """Return the sum that accepting a cue would make due, and its rounds; null where no contract covers it."""
    return overview.cue_money(session, actor, cue_id)


@router.get("/contracts/{contract_id}/estimates", responses=problems(ContractNotFound, ProducerNeeded))
def read_estimates(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.EstimatesRead:
    """Return estimates against actual values; for the two parties only."""
    return estimates.estimates(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/work-logs",
    status_code=204,
    responses=problems(ContractNotFound, OtherPartyNeeded, NotAgreed, CueNotInContract),
)
def log_work(
    contract_id: UUID, body: schemas.WorkLogAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> None:
    """Note time that went into a cue."""
    estimates.log_work(session, actor, contract_id, cue_id=body.cue_id, minutes=body.minutes, worked_on=body.worked_on)


@_unsaved_router.post(
    "/projects/{project_id}/calendar", status_code=201, responses=problems(ProjectNotFound, RecentSignInNeeded)
)
def make_calendar(
    project_id: UUID,
    runtime: CurrentRuntime,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT, recent_sign_in=True),
) -> schemas.CalendarLinkMade:
    """Make the secret address of the caller's calendar; an earlier one loses its worth."""
    secret = calendar.make_link(session, actor, project_id)
    return schemas.CalendarLinkMade(url=f"{runtime.settings.base_url}/v1/calendars/{secret}")


@router.delete("/projects/{project_id}/calendar", status_code=204, responses=problems(ProjectNotFound))
def withdraw_calendar(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> None:
    """Revoke the addresses of the caller's calendar."""
    calendar.withdraw_links(session, actor, project_id)


router.include_router(_unsaved_router)
