"""A webhook's message on an event: read from the database when it is written, a moment after the event."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.models import Contract
from app.builds.audits.models import BuildAudit
from app.builds.models import Build, SealedPack
from app.core.money import money
from app.core.plural import counted
from app.money.models import Invoice, Payment
from app.notifications.notifier import cue_label
from app.notifications.queries import changes_of, take_with_place
from app.projects.models import Project
from app.reviews.models import Feedback
from app.sound_lists.models import Cue, Question
from app.webhooks.bodies import Message
from app.webhooks.rules import EVENTS

Payload = Mapping[str, Any]


class EventText(NamedTuple):
    """The words of an event, the page of its project that it is about, and its ids."""

    project: Project
    text: str
    page: str
    data: dict[str, Any]


def message_of(session: Session, base_url: str, payload: Payload) -> tuple[UUID, Message]:
    """Return the project of an event, and what is sent of it."""
    event_text = WORDS[payload["event"]](session, payload)
    project = event_text.project
    url = f"{base_url}/projects/{project.id}/{event_text.page}".rstrip("/")
    data = {"project": {"id": str(project.id), "name": project.name}, **event_text.data}
    return project.id, Message(EVENTS[payload["event"]], f"{project.name}: {event_text.text}", url, data)


def _take(session: Session, payload: Payload) -> EventText:
    take, project, cue = take_with_place(session, UUID(payload["take_id"]))
    what = {
        "take.in_review": "passed the check and is ready for review",
        "take.returned": "was returned by the check",
        "take.approved": "is approved",
    }[payload["event"]]
    data = {
        "take": {
            "id": str(take.id),
            "number": take.number,
            "variation": take.variation,
            "file_name": take.file_name,
        },
        "cue": {"id": str(cue.id), "label": cue_label(project, cue)} if cue else None,
    }
    number = f", version {take.number}" if take.number else ""
    page = f"review/{cue.id}" if cue else "sound-list"
    return EventText(project, f"{cue_label(project, cue)}{number} ({take.file_name}) {what}.", page, data)


def _changes(session: Session, payload: Payload) -> EventText:
    sending = session.get_one(Feedback, UUID(payload["feedback_id"]))
    project = session.get_one(Project, sending.project_id)
    lines, requests = [], []
    for change, take, cue in changes_of(session, sending.id):
        lines.append(f"{cue_label(project, cue)}, version {take.number}: {change.text}")
        requests.append({"id": str(change.id), "take_id": str(take.id), "cue_id": str(cue.id), "text": change.text})
    head = f"{counted(len(lines), 'change', 'changes')} requested"
    text = "\n".join([head, *([sending.note] if sending.note else []), *lines])
    return EventText(project, text, "review", {"feedback_id": str(sending.id), "change_requests": requests})


def _question(session: Session, payload: Payload) -> EventText:
    question = session.get_one(Question, UUID(payload["question_id"]))
    project, cue = session.get_one(Project, question.project_id), session.get_one(Cue, question.cue_id)
    data = {"question_id": str(question.id), "cue": {"id": str(cue.id), "label": cue_label(project, cue)}}
    name = session.get_one(Person, question.asked_by).name
    return EventText(
        project, f"{name} asks about {cue_label(project, cue)}: {question.text}", f"sound-list/cues/{cue.id}", data
    )


def _list(session: Session, payload: Payload) -> EventText:
    project = session.get_one(Project, UUID(payload["project_id"]))
    counts = {name: int(payload.get(name) or 0) for name in ("added", "changed", "cut")}
    words = ", ".join(f"{count} {name}" for name, count in counts.items() if count) or "nothing added, changed or cut"
    revision = payload["revision"]
    data = counts | {"revision": revision}
    return EventText(project, f"revision {revision} of the sound list: {words}.", "sound-list", data)


def _cut(session: Session, payload: Payload) -> EventText:
    cue = session.get_one(Cue, UUID(payload["cue_id"]))
    project = session.get_one(Project, cue.project_id)
    data = {"cue": {"id": str(cue.id), "label": cue_label(project, cue)}, "reason": cue.cut_reason}
    return EventText(project, f"{cue_label(project, cue)} was cut: {cue.cut_reason}", "sound-list", data)


def _pack(session: Session, payload: Payload) -> EventText:
    pack = session.get_one(SealedPack, UUID(payload["pack_id"]))
    project = session.get_one(Project, pack.project_id)
    data = {"pack_id": str(pack.id), "target": pack.target, "number": pack.number, "note": pack.note}
    return EventText(project, f"pack {pack.number} for {pack.target} is made.", "game-files", data)


def _build(session: Session, payload: Payload) -> EventText:
    build = session.get_one(Build, UUID(payload["build_id"]))
    data = {"build_id": str(build.id), "label": build.label, "files": build.files, "rejected": build.rejected}
    text = f"build {build.label}: {build.rejected} of {counted(build.files, 'file', 'files')} refused."
    return EventText(session.get_one(Project, build.project_id), text, "builds", data)


def _audit(session: Session, payload: Payload) -> EventText:
    audit = session.get_one(BuildAudit, UUID(payload["audit_id"]))
    data = {"audit_id": str(audit.id), "label": audit.label, "sounds": audit.sounds}
    data |= {"drifted": audit.drifted, "new_drifts": audit.new_drifts}
    text = f"audit of build {audit.label}: {audit.drifted} of {counted(audit.sounds, 'sound', 'sounds')} drifted."
    return EventText(session.get_one(Project, audit.project_id), text, "drift", data)


def _contract(session: Session, payload: Payload) -> EventText:
    contract = session.get_one(Contract, UUID(payload["contract_id"]))
    data = {"contract_id": str(contract.id), "title": contract.title}
    project = session.get_one(Project, contract.project_id)
    return EventText(project, f"{contract.title} is signed by both sides.", f"contracts/{contract.id}", data)


def _invoice(session: Session, payload: Payload) -> EventText:
    invoice = session.get_one(Invoice, UUID(payload["invoice_id"]))
    data = {"invoice_id": str(invoice.id), "number": invoice.full_number, "total": payload["total"]}
    data |= {"due_on": invoice.due_on.isoformat()}
    project = session.get_one(Project, invoice.project_id)
    return EventText(project, f"invoice {invoice.full_number} is issued: {payload['total']}.", "money", data)


def _payment(session: Session, payload: Payload) -> EventText:
    payment = session.get_one(Payment, UUID(payload["payment_id"]))
    invoice, contract = session.get_one(Invoice, payment.invoice_id), session.get_one(Contract, payment.contract_id)
    what = "a refund" if payment.amount_minor < 0 else "a payment"
    amount = money(abs(payment.amount_minor), contract.currency)
    data = {"payment_id": str(payment.id), "invoice": invoice.full_number, "amount_minor": payment.amount_minor}
    data |= {"currency": contract.currency, "paid_on": payment.paid_on.isoformat()}
    project = session.get_one(Project, payment.project_id)
    return EventText(project, f"{what} of {amount} is recorded for invoice {invoice.full_number}.", "money", data)


WORDS: Mapping[str, Callable[[Session, Payload], EventText]] = {
    **dict.fromkeys(("take.in_review", "take.returned", "take.approved"), _take),
    "changes.sent": _changes,
    "question.asked": _question,
    "list.revised": _list,
    "cue.cut": _cut,
    "pack.made": _pack,
    "build.posted": _build,
    "audit.posted": _audit,
    "contract.agreed": _contract,
    "invoice.issued": _invoice,
    "payment.recorded": _payment,
}
