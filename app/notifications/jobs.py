"""Jobs that write emails on events, and send them."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from uuid import UUID

import aiosmtplib
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.facts import in_words
from app.agreements.models import Contract
from app.agreements.rules import ContractState, Party
from app.builds.models import Build
from app.conformance.models import CheckRun
from app.conformance.queries import mark_notified, projects_to_notify, runs_of
from app.deliveries.rules import TakeState
from app.kit import clock, mail
from app.kit.db import new_id
from app.kit.money import money
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.money.models import Invoice
from app.notifications import links, queries, service
from app.notifications.errors import MailBusy
from app.notifications.models import Mail
from app.notifications.rules import counted, finding_line, text_of
from app.projects.models import Engagement, Project
from app.projects.visibility import nda_is_pending
from app.reviews.models import Comment, Feedback
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import label

NOTIFICATION_OVERDUE_AFTER = timedelta(minutes=1)  # by then the job scheduled by the check has run


@dataclass(frozen=True)
class Notifier:
    """Writes mails about one project for one event; news of a topic is gathered into one mail a person."""

    runtime: Runtime
    session: Session
    project: Project
    event_id: str

    def notify(self, recipient: str, topic: str, subject: str, *lines: str, page: str | None = None) -> None:
        """Add lines to the recipient's mail on the topic; without a page the link leads to the desk."""
        base_url = self.runtime.settings.base_url
        service.write_mail(
            self.session,
            event_id=self.event_id,
            studio_id=self.project.studio_id,
            topic=f"{topic}:{self.project.id}",
            recipient=recipient,
            subject=f"{self.project.name}: {subject}",
            lines=lines,
            link=f"{base_url}/desk" if page is None else f"{base_url}/projects/{self.project.id}/{page}".rstrip("/"),
            delay_s=self.runtime.settings.digest_delay_s,
        )


def _label(project: Project, cue: Cue | None) -> str:
    return f"{label(project.cue_prefix, cue.number)} {cue.name}" if cue else "a file without a cue"


@job("notifications.mail_link")
def mail_link(runtime: Runtime, payload: Payload) -> None:
    """Write the mail of a secret link: an invitation, a new password, an address to verify, a new account."""
    with runtime.database.writing() as session:
        links.write(session, payload, base_url=runtime.settings.base_url)


@job("notifications.notify_checks")
def notify_checks(runtime: Runtime, payload: Payload) -> None:
    """Notify designers of returned takes, and the approver of takes to review, since the last notification."""
    with runtime.database.writing() as session:
        _notify_runs(runtime, session, payload["event_id"], mark_notified(session, UUID(payload["project_id"])))


# An earlier version notified of each take by itself, and marked no check as unnotified.
@job("notifications.notify_check")
def notify_check(runtime: Runtime, payload: Payload) -> None:
    """Notify of one take that it was returned and why, or that it waits for review."""
    with runtime.database.writing() as session:
        _notify_runs(runtime, session, payload["event_id"], [UUID(payload["take_id"])])


@job("notifications.notify_overdue_checks")
def notify_overdue_checks(runtime: Runtime, _payload: Payload) -> None:
    """Notify of checks that were committed after the notification of their window."""
    with runtime.database.reading() as session:
        project_ids = projects_to_notify(session, clock.now() - NOTIFICATION_OVERDUE_AFTER)
    for project_id in project_ids:
        notify_checks(runtime, {"project_id": str(project_id), "event_id": str(new_id())})


def _notify_runs(runtime: Runtime, session: Session, event_id: str, take_ids: Sequence[UUID]) -> None:
    runs = runs_of(session, take_ids)
    if not runs:
        return
    project = session.get_one(Project, runs[0].CheckRun.project_id)
    notifier = Notifier(runtime, session, project, event_id)
    waiting: list[str] = []
    returned: dict[UUID, list[str]] = {}
    for run, take, cue in runs:
        name = _label(project, cue)
        if run.verdict != "conforming":
            returned.setdefault(take.designer_id, []).append(f"{name}: {take.file_name}{_why_returned(run)}")
        elif cue is not None:
            waiting.append(f"{name}: {take.file_name} passed the check and is ready for your review.")
    if waiting:
        notifier.notify(
            queries.approver_address(session, project), "to-review", "sounds to review", *waiting, page="review"
        )
    for designer_id, lines in returned.items():
        designer = queries.address_of(session, designer_id)
        notifier.notify(designer, "returned", "files returned by the check", *lines)


def _why_returned(run: CheckRun) -> str:
    found = [finding_line(finding) for finding in run.report["findings"] if finding["severity"] == "error"]
    if run.verdict == "unjudged":
        found = ["The check failed. That is our fault: your file is kept, and no round is counted."]
    return "".join(f"\n  {each}" for each in found)


@job("notifications.notify_changes")
def notify_changes(runtime: Runtime, payload: Payload) -> None:
    """Notify each designer of the change requests that were sent together."""
    with runtime.database.writing() as session:
        sending = session.get_one(Feedback, UUID(payload["feedback_id"]))
        project = session.get_one(Project, sending.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        by_designer: dict[UUID, list[str]] = {}
        for change, take, cue in queries.changes_of(session, sending.id):
            at = f" at {change.start_s:.3f} s" if change.start_s is not None else ""
            line = f"{_label(project, cue)}, version {take.number}{at}: {change.text}"
            by_designer.setdefault(take.designer_id, []).append(line)
        for designer_id, lines in by_designer.items():
            subject = f"{counted(len(lines), 'change', 'changes')} requested"
            text = "\n\n".join([sending.note, *lines] if sending.note else lines)
            notifier.notify(queries.address_of(session, designer_id), f"changes:{sending.id}", subject, text)


@job("notifications.notify_reply")
def notify_reply(runtime: Runtime, payload: Payload) -> None:
    """Notify who wrote a note that it was answered."""
    with runtime.database.writing() as session:
        comment = session.get_one(Comment, UUID(payload["comment_id"]))
        take, project, cue = queries.take_with_place(session, comment.take_id)
        author = session.get_one(Person, comment.written_by)
        line = f"{_label(project, cue)}, version {take.number}: {author.name} replied: {comment.text}"
        recipient = queries.address_of(session, UUID(payload["person_id"]))
        is_designers = UUID(payload["person_id"]) == take.designer_id
        page = None if is_designers or cue is None else f"review/{cue.id}"
        Notifier(runtime, session, project, payload["event_id"]).notify(
            recipient, "replies", "a reply to your note", line, page=page
        )


@job("notifications.notify_approval")
def notify_approval(runtime: Runtime, payload: Payload) -> None:
    """Notify the designer that a take was approved, unless the verdict was undone meanwhile."""
    with runtime.database.writing() as session:
        take, project, cue = queries.take_with_place(session, UUID(payload["take_id"]))
        if take.state is not TakeState.APPROVED:
            return
        line = f"{_label(project, cue)}, version {take.number}: approved ({take.file_name})."
        designer = queries.address_of(session, take.designer_id)
        Notifier(runtime, session, project, payload["event_id"]).notify(
            designer, "approved", "sounds approved", line, page="sound-list"
        )


@job("notifications.notify_question")
def notify_question(runtime: Runtime, payload: Payload) -> None:
    """Notify those who act for the team of a question on a cue."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        project = session.get_one(Project, question.project_id)
        cue = session.get_one(Cue, question.cue_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line, page = f"{_label(project, cue)}: {question.text}", f"sound-list/cues/{cue.id}"
        for recipient in queries.spokesperson_addresses(session, project) - {
            queries.address_of(session, question.asked_by)
        }:
            notifier.notify(recipient, "questions", "a question on the sound list", line, page=page)


@job("notifications.notify_answer")
def notify_answer(runtime: Runtime, payload: Payload) -> None:
    """Notify the asker of the answer."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        if question.asked_by == question.answered_by:
            return
        project = session.get_one(Project, question.project_id)
        cue = session.get_one(Cue, question.cue_id)
        line = f"{_label(project, cue)}\n  {question.text}\n  {question.answer}"
        asker = queries.address_of(session, question.asked_by)
        Notifier(runtime, session, project, payload["event_id"]).notify(
            asker, "answers", "your question is answered", line, page=f"sound-list/cues/{cue.id}"
        )


@job("notifications.notify_list_revised")
def notify_list_revised(runtime: Runtime, payload: Payload) -> None:
    """Notify the engaged designers that the list changed."""
    with runtime.database.writing() as session:
        project = session.get_one(Project, UUID(payload["project_id"]))
        counts = (("added", "cue added", "cues added"), ("changed", "cue changed", "cues changed"))
        changes = [counted(int(payload[key]), one, many) for key, one, many in counts if int(payload.get(key) or 0)]
        if not changes:
            return
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"Revision {payload['revision']}: {', '.join(changes)}."
        for recipient in queries.designer_addresses(session, project.id):
            notifier.notify(recipient, "list", "the sound list changed", line, page="sound-list")


@job("notifications.notify_cut")
def notify_cut(runtime: Runtime, payload: Payload) -> None:
    """Notify the engaged designers that a cue was cut, and why."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"{_label(project, cue)} was cut: {cue.cut_reason}. What you delivered for it is kept."
        for recipient in queries.designer_addresses(session, project.id):
            notifier.notify(recipient, "cut", "cues were cut", line, page="sound-list")


@job("notifications.notify_contract")
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
                {designer},
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
                f"{title}: notice was given. Its page Ending early says what each cue is owed.",
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
            due = f"The deposit of {money(deposit, contract.currency)} is due: issue the invoice for it."
            notifier.notify(designer, "deposit", "the deposit is due", due, page="money")
        for recipient in recipients:
            notifier.notify(recipient, f"contract:{payload['event']}", subject, line, page=f"contracts/{contract.id}")


@job("notifications.notify_signature")
def notify_signature(runtime: Runtime, payload: Payload) -> None:
    """Notify the other party that a contract needs its signature too."""
    with runtime.database.writing() as session:
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        if contract.state is not ContractState.SENT:
            return  # signed by both, or recalled meanwhile
        project = session.get_one(Project, contract.project_id)
        recipients = {queries.address_of(session, contract.designer_id)}
        if payload["party"] == Party.DESIGNER.value:
            recipients = queries.producer_addresses(session, project.studio_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"{contract.title} is signed by the other side and needs your signature."
        for recipient in recipients:
            notifier.notify(
                recipient, "contract:signed", "a contract needs your signature", line, page=f"contracts/{contract.id}"
            )


@job("notifications.notify_invoice")
def notify_invoice(runtime: Runtime, payload: Payload) -> None:
    """Notify the producers of an invoice: its sum, and the day until which it is to be paid."""
    with runtime.database.writing() as session:
        invoice = session.get_one(Invoice, UUID(payload["invoice_id"]))
        project = session.get_one(Project, invoice.project_id)
        contract = session.get_one(Contract, invoice.contract_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = (
            f"Invoice {invoice.number} for {contract.title}: {payload['total']}, to be paid by "
            f"{in_words(invoice.due_on)}. Record the payment once it is made."
        )
        for recipient in queries.producer_addresses(session, project.studio_id):
            notifier.notify(recipient, "invoices", "an invoice to pay", line, page="money")


@job("notifications.notify_joined")
def notify_joined(runtime: Runtime, payload: Payload) -> None:
    """Notify the producers that a designer joined, and of an NDA that is to be sent first."""
    with runtime.database.writing() as session:
        engagement = session.get_one(Engagement, UUID(payload["engagement_id"]))
        project = session.get_one(Project, engagement.project_id)
        name = session.get_one(Person, engagement.designer_id).name
        is_closed = nda_is_pending(project, engagement)
        next_step = f"Send {name} the NDA: the list stays closed until it is signed." if is_closed else ""
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = " ".join(filter(None, (f"{name} joined as sound designer.", next_step)))
        for recipient in queries.producer_addresses(session, project.studio_id):
            notifier.notify(recipient, "joined", "a designer joined", line, page="contracts" if is_closed else "people")


@job("notifications.notify_reminder")
def notify_reminder(runtime: Runtime, payload: Payload) -> None:
    """Remind the approver of the day after which a cue is deemed accepted."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        last_day = date.fromisoformat(payload["last_day"])
        line = (
            f"{_label(project, cue)} needs your review. "
            f"Without a response it is accepted automatically after {in_words(last_day)}, as agreed in its contract."
        )
        approver = queries.address_of(session, UUID(payload["approver_id"]))
        notifier = Notifier(runtime, session, project, payload["event_id"])
        notifier.notify(approver, "reminders", "sounds to review soon", line, page="review")


@job("notifications.notify_deemed_acceptance")
def notify_deemed_acceptance(runtime: Runtime, payload: Payload) -> None:
    """Notify designer, approver and producers that a cue was deemed accepted."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        contract = session.get_one(Contract, UUID(payload["contract_id"]))
        line = (
            f"{_label(project, cue)} was accepted automatically: no response within {payload['days']} working days, "
            f"as agreed in {contract.title}. It is paid like any other accepted cue."
        )
        people = {
            queries.address_of(session, contract.designer_id),
            queries.approver_address(session, project),
            *queries.producer_addresses(session, project.studio_id),
        }
        notifier = Notifier(runtime, session, project, payload["event_id"])
        for recipient in people:
            notifier.notify(recipient, "silence", "sounds auto-accepted", line, page="sound-list")


@job("notifications.notify_build")
def notify_build(runtime: Runtime, payload: Payload) -> None:
    """Notify producers and approver that the game's CI refused audio."""
    with runtime.database.writing() as session:
        build = session.get_one(Build, UUID(payload["build_id"]))
        if not build.rejected:
            return
        project = session.get_one(Project, build.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"Build {build.label}: {build.rejected} of {counted(build.files, 'file', 'files')} refused."
        people = queries.producer_addresses(session, project.studio_id) | {queries.approver_address(session, project)}
        for recipient in people:
            notifier.notify(recipient, "builds", "a build was refused", line, page="")


@job("notifications.send_mail")
def send_mail(runtime: Runtime, payload: Payload) -> None:
    """Hand one mail to the SMTP server; without one it waits in the outbox, its link to be copied."""
    if runtime.settings.smtp_url:
        _send(runtime, UUID(payload["mail_id"]))
    else:
        _show_link(runtime, UUID(payload["mail_id"]))


def send_pending(runtime: Runtime) -> None:
    """Send what waits, oldest first, now that a server is set or back; without one, show the links of what waits."""
    if not runtime.settings.smtp_url:
        with runtime.database.reading() as session:
            linkless = queries.ids_without_link(session)
        for mail_id in linkless:
            _show_link(runtime, mail_id)
        return
    with runtime.database.reading() as session:
        waiting = queries.overdue_ids(session, clock.now(), runtime.settings.digest_delay_s)
    for mail_id in waiting:
        try:
            _send(runtime, mail_id)
        except (MailBusy, aiosmtplib.SMTPResponseException):
            continue  # another worker sends it, or it was refused, which is noted on it: the next may pass
        except (aiosmtplib.SMTPException, OSError):
            return  # the server is away; the next round tries again


def _show_link(runtime: Runtime, mail_id: UUID) -> None:
    with runtime.database.writing() as session:
        waiting = queries.mail_locked(session, mail_id)
        if waiting is None or waiting.sent_at is not None or waiting.link is not None:
            return
        waiting.link = links.make(session, waiting, base_url=runtime.settings.base_url, is_sent_by_mail_only=False)


def _send(runtime: Runtime, mail_id: UUID) -> None:
    with runtime.database.writing() as session:
        claimed = service.claim(session, mail_id)
        if claimed is None:
            return
        link = links.make(session, claimed, base_url=runtime.settings.base_url, is_sent_by_mail_only=True)
        if claimed.secret_of is not None:
            claimed.link = None  # the link that the outbox showed is revoked
            if link is None:
                session.delete(claimed)  # it was used, revoked or grew old before a server took it
                return
    message = mail.plain_mail(
        sender=runtime.settings.mail_from,
        recipient=claimed.recipient,
        subject=claimed.subject,
        text=text_of(claimed.lines, link),
    )
    try:
        mail.send(runtime.settings.smtp_url, message)
    except (aiosmtplib.SMTPException, OSError) as error:
        with runtime.database.writing() as session:
            refused = session.get_one(Mail, mail_id)
            refused.failure, refused.claimed_until = f"{type(error).__name__}: {error}", None
        raise
    with runtime.database.writing() as session:
        sent = session.get_one(Mail, mail_id)
        sent.sent_at, sent.failure, sent.claimed_until, sent.link = clock.now(), None, None, None
