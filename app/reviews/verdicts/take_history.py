"""The events of a take, oldest first."""

from collections.abc import Iterable
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.conformance.queries import fix_that_made
from app.deliveries.labels import label_of
from app.deliveries.models import Delivery, Take
from app.deliveries.service import take_for
from app.reviews import queries
from app.reviews.models import ChangeRequest, Comment, Verdict
from app.reviews.rules import HistoryKind, VerdictKind
from app.reviews.schemas import HistoryEntry


def take_history(session: Session, actor: Actor, take_id: UUID) -> list[HistoryEntry]:
    """Return the events of a take, oldest first; without unsent drafts."""
    take, _ = take_for(session, actor, take_id)
    entries = [_receipt(session, take), *_checks(session, take), *_said(session, take), *_labelling(session, take)]
    return sorted(entries, key=lambda entry: entry.at)


def _receipt(session: Session, take: Take) -> HistoryEntry:
    designer = PersonBrief.model_validate(people_by_id(session, {take.designer_id})[take.designer_id])
    delivery = session.get_one(Delivery, take.delivery_id)
    text = f"{take.file_name}, delivery {delivery.number}"
    fix = fix_that_made(session, take.id)
    if fix is not None:
        master = session.get_one(Take, fix.take_id)
        words = ", ".join(repair["words"] for repair in fix.made.get("repairs", []))
        text = f"{text}: a fix of version {master.number}, with its designer's consent; {words}"
    if take.split_of_id is not None:
        whole = session.get_one(Take, take.split_of_id)
        text = f"{text}: frames {take.split_first_frame} to {take.split_end_frame} of {whole.file_name}"
    return HistoryEntry(at=take.received_at, kind=HistoryKind.RECEIVED, by=designer, text=text)


def _checks(session: Session, take: Take) -> Iterable[HistoryEntry]:
    for run in queries.check_runs_of(session, take.id):
        messages = "; ".join(str(finding["message"]) for finding in run.report.get("findings") or [])
        text = f"{run.verdict}: {messages}" if messages else run.verdict
        yield HistoryEntry(at=run.created_at, kind=HistoryKind.CHECKED, by=None, text=text)
    for waiver, person in queries.waivers_of(session, take.id):
        yield HistoryEntry(
            at=waiver.created_at, kind=HistoryKind.WAIVED, by=PersonBrief.model_validate(person), text=waiver.reason
        )


def _said(session: Session, take: Take) -> Iterable[HistoryEntry]:
    for verdict in queries.verdicts_on(session, Verdict.take_id == take.id):
        if verdict.kind is not VerdictKind.REQUEST_CHANGE:  # added below, with its time in the sound
            yield HistoryEntry(
                at=verdict.created_at,
                kind=HistoryKind(verdict.kind),
                by=PersonBrief.model_validate(verdict.author) if verdict.author else None,
                on_behalf_of=PersonBrief.model_validate(verdict.represented) if verdict.represented else None,
                by_deemed_acceptance=verdict.deemed_by_contract_id is not None,
                by_adoption=verdict.adoption_id is not None,
                without_listening=verdict.without_listening,
                text=verdict.note,
                reasons=verdict.reasons,
            )
    sent = (ChangeRequest.take_id == take.id, ChangeRequest.feedback_id.is_not(None))
    for request in queries.change_requests_of(session, *sent):
        if request.sending is not None:
            yield HistoryEntry(
                at=request.sending.created_at,
                kind=HistoryKind.REQUEST_CHANGE,
                by=PersonBrief.model_validate(request.author),
                text=request.text,
                start_s=request.start_s,
                end_s=request.end_s,
            )
    for comment in queries.comments_on(session, Comment.take_id == take.id):
        yield HistoryEntry(
            at=comment.created_at,
            kind=HistoryKind.COMMENT,
            by=PersonBrief.model_validate(comment.author) if comment.author else None,
            text=comment.text if comment.author else f"{comment.byline['name']}: {comment.text}",
            start_s=comment.start_s,
            end_s=comment.end_s,
        )


def _labelling(session: Session, take: Take) -> Iterable[HistoryEntry]:
    take_label = label_of(session, take)
    if take_label.labelled_at is not None:
        yield HistoryEntry(
            at=take_label.labelled_at, kind=HistoryKind.LABELLED, by=take_label.labelled_by, text=take_label.label or ""
        )
