"""Mails about contracts: their states, signatures, invoices and acceptance without a decision."""

import json
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.clauses.facts import format_long_date
from app.agreements.models import Contract
from app.agreements.queries import lock_contract
from app.agreements.record import signed_checkpoints as heads
from app.agreements.rules import ContractState, Party
from app.agreements.signing.service import people_to_sign
from app.core import clock
from app.core.jobs.queue import Payload
from app.core.money import money
from app.core.plural import counted
from app.core.runtime import Runtime
from app.money.models import Invoice, WorkedDay
from app.money.work.service import called_work
from app.notifications import queries
from app.notifications.kinds import notice
from app.notifications.notifier import Notifier, cue_label
from app.notifications.preferences.rules import News
from app.projects.models import Project
from app.sound_lists.models import Cue


@notice(
    *("contract.sent", "contract.change_requested", "contract.agreed", "contract.notice_given", "contract.settled"),
    *("change_order.proposed", "change_order.agreed"),
    topics={"contract": News.CONTRACTS, "deposit": News.CONTRACTS},
)
def notify_contract(runtime: Runtime, payload: Payload) -> None:
    """Notify the party whose step is next of a contract's new state, and both once it is agreed."""
    with runtime.database.writing() as session:
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        project = session.get_one(Project, contract.project_id)
        designer = queries.address_of(session, contract.designer_id)
        producers = queries.producer_addresses(session, project.studio_id)
        title = contract.title
        recipients, subject, line = {
            "contract.sent": (
                _first_to_sign(session, contract) or {designer},
                "a contract needs your signature",
                f"{title} needs your signature: read it, then sign it or request a change.",
            ),
            "contract.change_requested": (
                producers,
                "a change to a contract is requested",
                f"{title}: {payload.get('text') or ''}",
            ),
            "contract.notice_given": (
                producers | {designer},
                "notice was given on a contract",
                f"{title}: notice was given. Its page Terminate contract says what each cue is owed.",
            ),
            "change_order.proposed": (
                {designer} if payload.get("party") == "studio" else producers,
                "a change order is proposed",
                f"{title}: a change order is proposed. Read what it changes, then sign or refuse it.",
            ),
            "change_order.agreed": (
                producers | {designer},
                "a change order is in force",
                f"{title}: both sides have signed a change order, and it is in force.",
            ),
            "contract.settled": (
                producers | {designer},
                "a contract has ended",
                f"{title}: it is settled and has ended. What is owed is due.",
            ),
            "contract.agreed": (producers | {designer}, "a contract is signed", f"{title}: both sides have signed."),
        }[payload["event"]]
        notifier = Notifier(runtime, session, project, payload["event_id"])
        if payload["event"] == "contract.agreed" and (deposit := queries.deposit_of(session, contract.id)):
            due = f"The deposit of {money(deposit, contract.currency)} is due"
            name = session.get_one(Person, contract.designer_id).name
            lines = {designer: f"{due}: issue the invoice for it."}
            lines |= dict.fromkeys(producers, f"{due}: {name} invoices it, and the invoice says by when it is paid.")
            for recipient, words in lines.items():
                notifier.notify(recipient, "deposit", "the deposit is due", words, page="money")
        for recipient in recipients:
            notifier.notify(recipient, f"contract:{payload['event']}", subject, line, page=f"contracts/{contract.id}")


def _first_to_sign(session: Session, contract: Contract) -> set[str]:
    """Return the addresses of those who sign first, where an order was set; else of the designer, who reads first."""
    if contract.state is not ContractState.SENT or contract.signs_first is not Party.STUDIO:
        return set()
    return {queries.address_of(session, person_id) for person_id in people_to_sign(session, contract)}


@notice("contract.signed_once")
def notify_signature(runtime: Runtime, payload: Payload) -> None:
    """Notify those whose turn it is now that a contract needs their signature."""
    with runtime.database.writing() as session:
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        if contract.state is not ContractState.SENT:
            return  # signed by both, or recalled meanwhile
        project = session.get_one(Project, contract.project_id)
        recipients = {queries.address_of(session, person_id) for person_id in people_to_sign(session, contract)}
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"{contract.title} is signed by the {payload['party']} and needs your signature."
        for recipient in recipients:
            notifier.notify(
                recipient, "contract:signed", "a contract needs your signature", line, page=f"contracts/{contract.id}"
            )


@notice("amendment.signer_is_next")
def notify_signer(runtime: Runtime, payload: Payload) -> None:
    """Notify the studio's signer whose turn it is that a change order or a statement needs their signature."""
    with runtime.database.writing() as session:
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        project = session.get_one(Project, contract.project_id)
        signer = queries.address_of(session, UUID(payload["person_id"]))
        line = f"{contract.title}: {payload['what']} needs your signature."
        notifier = Notifier(runtime, session, project, payload["event_id"])
        page = f"contracts/{contract.id}"
        notifier.notify(signer, "contract:signer", "a text needs your signature", line, page=page)


@notice("invoice.issued", topics={"invoices": News.CONTRACTS})
def notify_invoice(runtime: Runtime, payload: Payload) -> None:
    """Notify the producers of an invoice: its sum, and the day until which it is to be paid."""
    with runtime.database.writing() as session:
        invoice = session.get_one(Invoice, UUID(payload["invoice_id"]))
        project = session.get_one(Project, invoice.project_id)
        contract = session.get_one(Contract, invoice.contract_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = (
            f"Invoice {invoice.full_number} for {contract.title}: {payload['total']}, to be paid by "
            f"{format_long_date(invoice.due_on)}. Record the payment once it is made."
        )
        for recipient in queries.producer_addresses(session, project.studio_id):
            notifier.notify(recipient, "invoices", "an invoice to pay", line, page="money")


@notice("work.logged", topics={"work": News.CONTRACTS})
def notify_work_logged(runtime: Runtime, payload: Payload) -> None:
    """Notify the producers of days or hours to agree to, unless that is done or they were taken back."""
    with runtime.database.writing() as session:
        day = session.get(WorkedDay, UUID(payload["worked_day_id"]))
        if day is None or day.agreed_at is not None or day.refused_at is not None:
            return
        contract, project = session.get_one(Contract, day.contract_id), session.get_one(Project, day.project_id)
        name = session.get_one(Person, contract.designer_id).name
        line = f"{contract.title}: {name} logged {called_work(day)}. Agree to it, or refuse it and say why."
        notifier = Notifier(runtime, session, project, payload["event_id"])
        for recipient in queries.producer_addresses(session, project.studio_id):
            notifier.notify(recipient, "work", "logged work to agree to", line, page="money")


@notice("work.refused")
def notify_work_refused(runtime: Runtime, payload: Payload) -> None:
    """Notify the designer of days or hours that the studio refused, and why."""
    with runtime.database.writing() as session:
        day = session.get(WorkedDay, UUID(payload["worked_day_id"]))
        if day is None or day.refused_at is None:
            return
        contract, project = session.get_one(Contract, day.contract_id), session.get_one(Project, day.project_id)
        line = f"{contract.title}: {called_work(day)} was refused: “{day.refusal}”. Correct it and send it again."
        designer = queries.address_of(session, contract.designer_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        notifier.notify(designer, "work", "logged work was refused", line, page="money")


@notice("approver.reminded", topics={"reminders": News.SOUNDS})
def notify_reminder(runtime: Runtime, payload: Payload) -> None:
    """Remind the approver of the day after which a cue is deemed accepted."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        last_day = date.fromisoformat(payload["last_day"])
        undecided = payload.get("undecided") or []
        line = f"{cue_label(project, cue)} needs your review. " + (
            f"One delivery has {'; '.join(undecided)} for the same place: approve the one that you mean. "
            "Until somebody chooses, it is not accepted automatically."
            if undecided
            else f"Without a response it is accepted automatically after {format_long_date(last_day)}, "
            "as agreed in its contract."
        )
        approver = queries.address_of(session, UUID(payload["approver_id"]))
        notifier = Notifier(runtime, session, project, payload["event_id"])
        notifier.notify(approver, "reminders", "sounds to review soon", line, page="review")


@notice("cue.deemed_accepted", topics={"silence": News.SOUNDS})
def notify_deemed_acceptance(runtime: Runtime, payload: Payload) -> None:
    """Notify designer, approver and producers that a cue was deemed accepted."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        days = counted(int(payload["days"]), "working day")
        line = (
            f"{cue_label(project, cue)} was accepted automatically: no response within {days}, "
            f"as agreed in {contract.title}. It is paid like any other accepted cue."
        )
        people = {
            queries.address_of(session, contract.designer_id),
            *queries.approver_addresses(session, project, cue.category),
            *queries.producer_addresses(session, project.studio_id),
        }
        notifier = Notifier(runtime, session, project, payload["event_id"])
        for recipient in people:
            notifier.notify(recipient, "silence", "sounds auto-accepted", line, page="sound-list")


@notice(topics={"head": News.CONTRACTS})
def mail_heads(runtime: Runtime, _payload: Payload) -> None:
    """Mail the signed heads of records that have grown to both parties, once a day for each contract."""
    today = clock.now().date()
    with runtime.database.reading() as session:
        contract_ids = queries.contracts_with_new_heads(session, today)
    for contract_id in contract_ids:
        with runtime.database.writing() as session:
            contract = lock_contract(session, contract_id)
            head = heads.signed_checkpoint(runtime.settings, contract)
            recipients = {queries.address_of(session, contract.designer_id)}
            recipients |= queries.producer_addresses(session, contract.studio_id)
            project = session.get_one(Project, contract.project_id)
            notifier = Notifier(runtime, session, project, f"head:{contract_id}:{contract.record_length}")
            line = (
                f"{contract.title}: its audit trail has {contract.record_length} entries. Keep this email: with it, "
                f"`soundlist verify --head` finds entries that were taken away or rewritten.\n\n{json.dumps(head)}"
            )
            for recipient in recipients:
                notifier.notify(
                    recipient,
                    f"head:{contract_id}",
                    "the audit trail of a contract",
                    line,
                    page=f"contracts/{contract_id}/record",
                )
            contract.head_mailed_length, contract.head_mailed_on = contract.record_length, today
