"""A contract with its text, invoice and change order, as part of one of everything."""

from typing import TYPE_CHECKING
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.rules import Clause
from app.agreements.drafts.documents import sha256_of as text_sha256_of
from app.agreements.models import Contract, ContractCue, ContractTemplate, ContractVersion, Milestone
from app.agreements.rules import ContractKind, ContractState, Party
from app.amendments.models import ChangeOrder
from app.core import clock
from app.money.ledger.rules import LineKind
from app.money.models import ExtraRound, Invoice, InvoiceLine, LedgerLine, OwnTime, Payment, WorkedDay
from app.projects.queries import any_engagement_of

if TYPE_CHECKING:
    from tests.house.objects import House


def add_contract(session: Session, of: dict[str, UUID], cue_id: UUID, house: "House") -> dict[str, UUID | int]:
    """Add a contract that both agreed to, with an invoice that was paid in part; return ids by path names."""
    engagement = any_engagement_of(session, of["project_id"], house.designer_id)
    assert engagement is not None
    contract = Contract(
        **of,
        engagement_id=engagement.id,
        designer_id=house.designer_id,
        number=1,
        title="Effects",
        kind=ContractKind.SINGLE,
        state=ContractState.AGREED,
        agreed_at=clock.now(),
        currency="USD",
        created_by=house.producer_id,
    )
    session.add(contract)
    session.flush()
    of_it = {**of, "contract_id": contract.id}
    milestone = Milestone(**of_it, position=1, name="Alpha", amount_minor=18_000)
    session.add(milestone)
    session.flush()
    covered = ContractCue(**of_it, milestone_id=milestone.id, cue_id=cue_id, position=1, amount_minor=18_000)
    extra = ExtraRound(**of_it, cue_id=cue_id, number=3, proposed_by=house.approver_id)
    invoice = Invoice(
        **of_it,
        designer_id=house.designer_id,
        number=1,
        full_number="PRJ-001",
        issued_on=clock.now().date(),
        due_on=clock.now().date(),
        seller="Sound designer",
        buyer="Studio",
        issued_by=house.designer_id,
    )
    session.add_all([covered, extra, invoice])
    session.flush()
    payment = Payment(
        **of_it,
        invoice_id=invoice.id,
        amount_minor=9_000,
        reference="T-1",
        paid_on=clock.now().date(),
        recorded_by=house.producer_id,
    )
    session.add(payment)
    session.flush()
    due = LedgerLine(
        **of_it,
        kind=LineKind.ACCEPTED,
        amount_minor=18_000,
        clause="acceptance",
        cue_id=cue_id,
        milestone_id=milestone.id,
        person_id=house.approver_id,
    )
    session.add(due)
    session.flush()
    paid = LedgerLine(
        **of_it,
        kind=LineKind.PAID,
        amount_minor=9_000,
        clause="payment",
        cue_id=cue_id,
        milestone_id=milestone.id,
        about_id=due.id,
        payment_id=payment.id,
        person_id=house.producer_id,
    )
    own_time = OwnTime(
        **of, person_id=house.designer_id, cue_id=cue_id, minutes=90, worked_on=clock.now().date(), note=""
    )
    worked = WorkedDay(
        **of_it,
        milestone_id=milestone.id,
        worked_on=clock.now().date(),
        quarters=4,
        note="",
        logged_by=house.designer_id,
    )
    session.add_all([worked, own_time])
    text = "# Change order 1 to Effects"
    order = ChangeOrder(
        **of_it,
        number=1,
        party=Party.DESIGNER,
        proposed_by=house.designer_id,
        reason="The level grew",
        begins_at_once=False,
        changes=[{"kind": "cut_cue", "cue_id": str(cue_id)}],
        text=text,
        text_sha256=text_sha256_of(text),
    )
    session.add(order)
    session.add_all([paid, InvoiceLine(**of, ledger_line_id=due.id, invoice_id=invoice.id, text="Shield hit")])
    session.flush()
    template_id = _add_text(session, of, contract.id, house)
    return {
        "contract_id": contract.id,
        "template_id": template_id,
        "extra_round_id": extra.id,
        "invoice_id": invoice.id,
        "payment_id": payment.id,
        "milestone_id": milestone.id,
        "own_time_id": own_time.id,
        "worked_day_id": worked.id,
        "change_order_number": order.number,
    }


def _add_text(session: Session, of: dict[str, UUID], contract_id: UUID, house: "House") -> UUID:
    """Add the text that both agreed to, and the template that it began from; return the template's id."""
    clauses = [Clause("parties", "Parties", "Between {studio} and {designer}.").as_row()]
    version = ContractVersion(
        **of,
        contract_id=contract_id,
        number=1,
        clauses=clauses,
        terms={},
        text="# Effects\n",
        text_sha256="0" * 64,
        created_by=house.producer_id,
        sent_at=clock.now(),
        pdf_sha256=house.sha256,
        pdf_bytes=house.file_bytes,
    )
    template = ContractTemplate(
        studio_id=house.studio_id,
        name="Effects",
        kind=ContractKind.SINGLE,
        clauses=clauses,
        terms={},
        created_by=house.producer_id,
    )
    session.add_all([version, template])
    session.flush()
    return template.id
