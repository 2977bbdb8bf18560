"""What people are told by mail, and the sending."""

from uuid import UUID

import aiosmtplib
from sqlalchemy.orm import Session

from app.builds.models import Build
from app.conformance.queries import current_run
from app.deliveries.models import Take
from app.kit import clock, mail
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.notifications import queries, service
from app.notifications.models import Mail
from app.notifications.rules import counted, finding_line, text_of
from app.projects.models import Project
from app.reviews.models import ChangeRequest, Sending
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import label


def _page(runtime: Runtime, project: Project, page: str) -> str:
    return f"{runtime.settings.base_url}/projects/{project.id}/{page}"


def _label(project: Project, cue: Cue | None) -> str:
    return f"{label(project.cue_prefix, cue.number)} {cue.name}" if cue else "a file without a cue"


def _take_with_place(session: Session, take_id: str) -> tuple[Take, Project, Cue | None]:
    take = session.get_one(Take, UUID(take_id))
    project = session.get_one(Project, take.project_id)
    return take, project, session.get(Cue, take.cue_id) if take.cue_id else None


@job("notifications.mail_link")
def mail_link(runtime: Runtime, payload: Payload) -> None:
    """Mail a link that only its recipient should have: an invitation, or a new password."""
    subject, line = {
        "designer.invited": (
            "{from_name} invites you to make sounds for {subject_name}",
            "{from_name} invites you to make sounds for {subject_name}. The link shows the sound list at once; "
            "an account is asked for only before your first upload.",
        ),
        "member.invited": (
            "{from_name} invites you to {subject_name}",
            "{from_name} invites you to join {subject_name} on Soundlist.",
        ),
        "password.reset_asked": (
            "A new password for Soundlist",
            "Somebody asked for a new password for this address. The link sets one, within an hour and once. "
            "If it was not you, leave this mail alone: nothing has changed.",
        ),
    }[payload["event"]]
    names = {"from_name": payload.get("from_name") or "", "subject_name": payload.get("subject_name") or ""}
    note = str(payload.get("note") or "")
    with runtime.database.writing() as session:
        service.write_mail(
            session,
            event_id=payload["event_id"],
            studio_id=UUID(payload["studio_id"]) if payload.get("studio_id") else None,
            topic=f"link:{payload['event_id']}",
            recipient=payload["recipient"],
            subject=subject.format(**names),
            line=line.format(**names) + (f"\n\n{note}" if note else ""),
            link=payload["link"],
        )


@job("notifications.tell_check")
def tell_check(runtime: Runtime, payload: Payload) -> None:
    """Tell the designer what came back and why, and the decider what waits to be heard."""
    with runtime.database.writing() as session:
        take, project, cue = _take_with_place(session, payload["take_id"])
        run = current_run(session, take.id)
        if run is None:
            return
        name = _label(project, cue)
        if run.verdict == "conforming":
            if cue is None:
                return
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"to-review:{project.id}",
                recipient=queries.decider_address(session, project),
                subject=f"{project.name}: sounds to review",
                line=f"{name}: {take.file_name} conforms and waits for you.",
                link=_page(runtime, project, "review"),
                delay_s=runtime.settings.digest_delay_s,
            )
            return
        findings = [finding_line(finding) for finding in run.report["findings"] if finding["severity"] == "error"]
        if run.verdict == "unjudged":
            findings = [
                "The check itself broke. That is our fault; nothing is wrong with your file, and no round counts."
            ]
        service.write_mail(
            session,
            event_id=payload["event_id"],
            studio_id=project.studio_id,
            topic=f"returned:{project.id}",
            recipient=queries.address_of(session, take.designer_id),
            subject=f"{project.name}: files came back from the check",
            line="\n".join([f"{name}: {take.file_name}", *(f"  {line}" for line in findings)]),
            link=f"{runtime.settings.base_url}/desk",
            delay_s=runtime.settings.digest_delay_s,
        )


@job("notifications.tell_changes")
def tell_changes(runtime: Runtime, payload: Payload) -> None:
    """Tell each designer the changes that were sent together."""
    with runtime.database.writing() as session:
        sending = session.get_one(Sending, UUID(payload["sending_id"]))
        project = session.get_one(Project, sending.project_id)
        rows = queries.changes_of(session, sending.id)
        by_designer: dict[UUID, list[tuple[ChangeRequest, Take, Cue]]] = {}
        for change, take, cue in rows:
            by_designer.setdefault(take.designer_id, []).append((change, take, cue))
        for designer_id, changes in by_designer.items():
            lines = [sending.note] if sending.note else []
            for change, take, cue in changes:
                at = f" at {change.start_s:.3f} s" if change.start_s is not None else ""
                lines.append(f"{_label(project, cue)}, version {take.number}{at}: {change.text}")
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"changes:{sending.id}",
                recipient=queries.address_of(session, designer_id),
                subject=f"{project.name}: {counted(len(changes), 'change', 'changes')} requested",
                line="\n\n".join(lines),
                link=f"{runtime.settings.base_url}/desk",
            )


@job("notifications.tell_approval")
def tell_approval(runtime: Runtime, payload: Payload) -> None:
    """Tell the designer that a take was approved."""
    with runtime.database.writing() as session:
        take, project, cue = _take_with_place(session, payload["take_id"])
        service.write_mail(
            session,
            event_id=payload["event_id"],
            studio_id=project.studio_id,
            topic=f"approved:{project.id}",
            recipient=queries.address_of(session, take.designer_id),
            subject=f"{project.name}: sounds approved",
            line=f"{_label(project, cue)}, version {take.number}: approved ({take.file_name}).",
            link=_page(runtime, project, "sound-list"),
            delay_s=runtime.settings.digest_delay_s,
        )


@job("notifications.tell_question")
def tell_question(runtime: Runtime, payload: Payload) -> None:
    """Tell those who speak for the team what is asked on a cue."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        project = session.get_one(Project, question.project_id)
        cue = session.get_one(Cue, question.cue_id)
        asker = queries.address_of(session, question.asked_by)
        for recipient in queries.speaker_addresses(session, project) - {asker}:
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"questions:{project.id}",
                recipient=recipient,
                subject=f"{project.name}: a question on the sound list",
                line=f"{_label(project, cue)}: {question.text}",
                link=_page(runtime, project, f"sound-list/cues/{cue.id}"),
                delay_s=runtime.settings.digest_delay_s,
            )


@job("notifications.tell_answer")
def tell_answer(runtime: Runtime, payload: Payload) -> None:
    """Tell who asked what the answer is."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        project = session.get_one(Project, question.project_id)
        cue = session.get_one(Cue, question.cue_id)
        if question.asked_by == question.answered_by:
            return
        service.write_mail(
            session,
            event_id=payload["event_id"],
            studio_id=project.studio_id,
            topic=f"answers:{project.id}",
            recipient=queries.address_of(session, question.asked_by),
            subject=f"{project.name}: your question is answered",
            line=f"{_label(project, cue)}\n  {question.text}\n  {question.answer}",
            link=_page(runtime, project, f"sound-list/cues/{cue.id}"),
            delay_s=runtime.settings.digest_delay_s,
        )


@job("notifications.tell_list_revised")
def tell_list_revised(runtime: Runtime, payload: Payload) -> None:
    """Tell the engaged designers that the list changed."""
    with runtime.database.writing() as session:
        project = session.get_one(Project, UUID(payload["project_id"]))
        counts = (("added", "cue added", "cues added"), ("changed", "cue changed", "cues changed"))
        told = [counted(int(payload[key]), one, many) for key, one, many in counts if int(payload.get(key) or 0)]
        if not told:
            return
        for recipient in queries.designer_addresses(session, project.id):
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"list:{project.id}",
                recipient=recipient,
                subject=f"{project.name}: the sound list changed",
                line=f"Revision {payload['revision']}: {', '.join(told)}.",
                link=_page(runtime, project, "sound-list"),
                delay_s=runtime.settings.digest_delay_s,
            )


@job("notifications.tell_cut")
def tell_cut(runtime: Runtime, payload: Payload) -> None:
    """Tell the engaged designers that a cue was cut, and why."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        for recipient in queries.designer_addresses(session, project.id):
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"cut:{project.id}",
                recipient=recipient,
                subject=f"{project.name}: cues were cut",
                line=f"{_label(project, cue)} was cut: {cue.cut_reason}. What you delivered for it is kept.",
                link=_page(runtime, project, "sound-list"),
                delay_s=runtime.settings.digest_delay_s,
            )


@job("notifications.tell_build")
def tell_build(runtime: Runtime, payload: Payload) -> None:
    """Tell producers and decider that the game's CI refused audio."""
    with runtime.database.writing() as session:
        build = session.get_one(Build, UUID(payload["build_id"]))
        if not build.rejected:
            return
        project = session.get_one(Project, build.project_id)
        people = queries.producer_addresses(session, project.studio_id) | {queries.decider_address(session, project)}
        for recipient in people:
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=project.studio_id,
                topic=f"builds:{project.id}",
                recipient=recipient,
                subject=f"{project.name}: a build was refused",
                line=f"Build {build.label}: {build.rejected} of {counted(build.files, 'file', 'files')} refused.",
                link=f"{runtime.settings.base_url}/projects/{project.id}",
                delay_s=runtime.settings.digest_delay_s,
            )


@job("notifications.send_mail")
def send_mail(runtime: Runtime, payload: Payload) -> None:
    """Hand one mail to the SMTP server; without one it waits in the outbox."""
    if runtime.settings.smtp_url:
        _send(runtime, UUID(payload["mail_id"]))


def send_waiting(runtime: Runtime) -> None:
    """Send what waits, oldest first, now that a server is set or back."""
    if not runtime.settings.smtp_url:
        return
    with runtime.database.reading() as session:
        waiting = queries.overdue_ids(session, clock.now(), runtime.settings.digest_delay_s)
    for mail_id in waiting:
        try:
            _send(runtime, mail_id)
        except (aiosmtplib.SMTPException, OSError):
            return  # noted on the mail; the next round tries again


def _send(runtime: Runtime, mail_id: UUID) -> None:
    with runtime.database.writing() as session:
        sealed = service.seal(session, mail_id)
    if sealed is None:
        return
    message = mail.plain_mail(
        sender=runtime.settings.mail_from,
        recipient=sealed.recipient,
        subject=sealed.subject,
        text=text_of(sealed.lines, sealed.link),
    )
    try:
        mail.send(runtime.settings.smtp_url, message)
    except (aiosmtplib.SMTPException, OSError) as error:
        with runtime.database.writing() as session:
            session.get_one(Mail, mail_id).failure = f"{type(error).__name__}: {error}"
        raise
    with runtime.database.writing() as session:
        sent = session.get_one(Mail, mail_id)
        sent.sent_at, sent.failure = clock.now(), None
