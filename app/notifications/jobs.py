"""Jobs that write emails on events of sounds, lists, people and builds."""

from collections.abc import Mapping, Sequence
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.builds.models import Build
from app.conformance.models import CheckRun
from app.conformance.queries import mark_notified, projects_to_notify, runs_of
from app.core import clock
from app.core.db import new_id
from app.core.jobs.queue import Payload
from app.core.plural import counted
from app.core.runtime import Runtime
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.notifications import queries
from app.notifications.audio_excerpts.rules import SpotLine, spot_of
from app.notifications.kinds import notice
from app.notifications.notifier import Notifier, cue_label
from app.notifications.preferences.rules import News
from app.notifications.rules import finding_line
from app.projects.models import Engagement, Project
from app.projects.visibility import nda_is_pending
from app.reviews.models import Comment, Feedback
from app.sound_lists.models import Cue, Question

NOTIFICATION_OVERDUE_AFTER = timedelta(minutes=1)


@notice("takes.checked", topics={"to-review": News.SOUNDS, "returned": News.SOUNDS})
def notify_checks(runtime: Runtime, payload: Payload) -> None:
    """Notify designers of returned takes, and the approver of takes to review, since the last notification."""
    with runtime.database.writing() as session:
        _notify_runs(runtime, session, payload["event_id"], mark_notified(session, UUID(payload["project_id"])))


@notice()
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
    waiting: dict[str, list[str]] = {}  # by category: each may have an approver of its own
    returned: dict[UUID, list[str]] = {}
    for run, take, cue in runs:
        name = cue_label(project, cue)
        if run.verdict != "conforming":
            returned.setdefault(take.designer_id, []).append(f"{name}: {take.file_name}{_why_returned(run)}")
        elif cue is not None:
            line = f"{name}: {take.file_name} passed the check and is ready for your review."
            waiting.setdefault(cue.category, []).append(line)
    for approver, lines in _by_approver(session, project, waiting).items():
        subject = notifier.fold("sound to review", "sounds to review")
        notifier.notify(approver, "to-review", subject, *lines, page="review")
    for designer_id, lines in returned.items():
        designer = queries.address_of(session, designer_id)
        subject = notifier.fold("file returned by the check", "files returned by the check")
        notifier.notify(designer, "returned", subject, *lines)


def _by_approver(session: Session, project: Project, waiting: Mapping[str, Sequence[str]]) -> dict[str, list[str]]:
    """Return the lines for each address of those who may approve, given the lines of each category."""
    lines: dict[str, list[str]] = {}
    for category, of_category in waiting.items():
        for approver in queries.approver_addresses(session, project, category):
            lines.setdefault(approver, []).extend(of_category)
    return lines


def _why_returned(run: CheckRun) -> str:
    lines = [finding_line(finding) for finding in run.report["findings"] if finding["severity"] == "error"]
    if run.verdict == "unjudged":
        lines = ["The check failed. That is our fault: your file is kept, and no round is counted."]
    return "".join(f"\n  {line}" for line in lines)


@notice("changes.sent", topics={"changes": News.SOUNDS})
def notify_changes(runtime: Runtime, payload: Payload) -> None:
    """Notify each designer of the change requests that were sent together."""
    with runtime.database.writing() as session:
        sending = session.get_one(Feedback, UUID(payload["feedback_id"]))
        project = session.get_one(Project, sending.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        by_designer: dict[UUID, list[SpotLine]] = {}
        for change, take, cue in queries.changes_of(session, sending.id):
            spot = spot_of(take.id, _version(project, take, cue), change.start_s, project_id=project.id)
            line = SpotLine(f"{_version(project, take, cue)}{_at(change.start_s)}: {change.text}", spot)
            by_designer.setdefault(take.designer_id, []).append(line)
        for designer_id, lines in by_designer.items():
            subject = f"{counted(len(lines), 'change', 'changes')} requested"
            message_lines = [sending.note, *lines] if sending.note else lines
            notifier.notify(queries.address_of(session, designer_id), f"changes:{sending.id}", subject, *message_lines)


def _version(project: Project, take: Take, cue: Cue | None) -> str:
    return f"{cue_label(project, cue)}, version {take.number}"


def _at(start_s: float | None) -> str:
    return f" at {start_s:.3f} s" if start_s is not None else ""


@notice("note.answered", topics={"replies": News.TALK})
def notify_reply(runtime: Runtime, payload: Payload) -> None:
    """Notify the author of a note of its answer, while they work on the project."""
    with runtime.database.writing() as session:
        comment = session.get_one(Comment, UUID(payload["comment_id"]))
        take, project, cue = queries.take_with_place(session, comment.take_id)
        if not queries.works_on(session, project, UUID(payload["person_id"])):
            return
        author = session.get_one(Person, comment.written_by)
        version = _version(project, take, cue)
        recipient = queries.address_of(session, UUID(payload["person_id"]))
        is_designers = UUID(payload["person_id"]) == take.designer_id
        reviewed_id = None if is_designers or cue is None else cue.id
        page = f"review/{reviewed_id}" if reviewed_id else None
        spot = spot_of(take.id, version, comment.start_s, project_id=project.id, reviewed_cue_id=reviewed_id)
        line = SpotLine(f"{version}: {author.name} replied: {comment.text}", spot)
        Notifier(runtime, session, project, payload["event_id"]).notify(
            recipient, "replies", "a reply to your note", line, page=page
        )


@notice("person.mentioned", topics={"mentions": News.MENTIONS})
def notify_mention(runtime: Runtime, payload: Payload) -> None:
    """Notify a person who is mentioned in a comment, a reply or a change request, while they work on the project."""
    with runtime.database.writing() as session:
        note = queries.note_by_id(session, UUID(payload["said_id"]), is_comment=payload["kind"] == "comment")
        take, project, cue = queries.take_with_place(session, note.take_id)
        author = session.get_one(Person, note.written_by)
        person_id = UUID(payload["person_id"])
        if not queries.works_on(session, project, person_id):
            return
        version = _version(project, take, cue)
        reviewed_id = None if person_id == take.designer_id or cue is None else cue.id
        page = f"review/{reviewed_id}" if reviewed_id else None
        spot = spot_of(take.id, version, note.start_s, project_id=project.id, reviewed_cue_id=reviewed_id)
        line = SpotLine(f"{version}{_at(note.start_s)}: {author.name} wrote: {note.text}", spot)
        Notifier(runtime, session, project, payload["event_id"]).notify(
            queries.address_of(session, person_id), "mentions", f"{author.name} mentions you", line, page=page
        )


@notice("take.approved", topics={"approved": News.SOUNDS})
def notify_approval(runtime: Runtime, payload: Payload) -> None:
    """Notify the designer that a take was approved, unless the verdict was undone meanwhile."""
    with runtime.database.writing() as session:
        take, project, cue = queries.take_with_place(session, UUID(payload["take_id"]))
        if take.state is not TakeState.APPROVED:
            return
        line = f"{cue_label(project, cue)}, version {take.number}: approved ({take.file_name})."
        designer = queries.address_of(session, take.designer_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        subject = notifier.fold("version approved", "versions approved")
        notifier.notify(designer, "approved", subject, line, page="sound-list")


@notice("question.asked", topics={"questions": News.TALK})
def notify_question(runtime: Runtime, payload: Payload) -> None:
    """Notify those who act for the team of a question on a cue."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        project = session.get_one(Project, question.project_id)
        cue = session.get_one(Cue, question.cue_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line, page = f"{cue_label(project, cue)}: {question.text}", f"sound-list/cues/{cue.id}"
        for recipient in queries.spokesperson_addresses(session, project) - {
            queries.address_of(session, question.asked_by)
        }:
            notifier.notify(recipient, "questions", "a question on the sound list", line, page=page)


@notice("question.answered", topics={"answers": News.TALK})
def notify_answer(runtime: Runtime, payload: Payload) -> None:
    """Notify the asker of the answer, while they work on the project."""
    with runtime.database.writing() as session:
        question = session.get_one(Question, UUID(payload["question_id"]))
        if question.asked_by == question.answered_by:
            return
        project = session.get_one(Project, question.project_id)
        if not queries.works_on(session, project, question.asked_by):
            return
        cue = session.get_one(Cue, question.cue_id)
        line = f"{cue_label(project, cue)}\n  {question.text}\n  {question.answer}"
        asker = queries.address_of(session, question.asked_by)
        Notifier(runtime, session, project, payload["event_id"]).notify(
            asker, "answers", "your question is answered", line, page=f"sound-list/cues/{cue.id}"
        )


@notice("list.revised", topics={"list": News.LIST})
def notify_list_revised(runtime: Runtime, payload: Payload) -> None:
    """Notify the engaged designers that the list changed."""
    with runtime.database.writing() as session:
        project = session.get_one(Project, UUID(payload["project_id"]))
        counts = (("added", "cue added", "cues added"), ("changed", "cue changed", "cues changed"))
        changes = [
            counted(int(payload[key]), singular, many) for key, singular, many in counts if int(payload.get(key) or 0)
        ]
        if not changes:
            return
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"Revision {payload['revision']}: {', '.join(changes)}."
        for recipient in queries.designer_addresses(session, project.id):
            notifier.notify(recipient, "list", "the sound list changed", line, page="sound-list")


@notice("cue.cut", topics={"cut": News.LIST})
def notify_cut(runtime: Runtime, payload: Payload) -> None:
    """Notify the engaged designers that a cue was cut, and why."""
    with runtime.database.writing() as session:
        cue = session.get_one(Cue, UUID(payload["cue_id"]))
        project = session.get_one(Project, cue.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"{cue_label(project, cue)} was cut: {cue.cut_reason}. What you delivered for it is kept."
        for recipient in queries.designer_addresses(session, project.id):
            notifier.notify(recipient, "cut", notifier.fold("cue cut", "cues cut"), line, page="sound-list")


@notice("build.posted", topics={"builds": News.LIST})
def notify_build(runtime: Runtime, payload: Payload) -> None:
    """Notify producers and approver that the game's CI refused audio."""
    with runtime.database.writing() as session:
        build = session.get_one(Build, UUID(payload["build_id"]))
        if not build.rejected:
            return
        project = session.get_one(Project, build.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        line = f"Build {build.label}: {build.rejected} of {counted(build.files, 'file', 'files')} refused."
        approvers = queries.approver_addresses(session, project)
        people = queries.producer_addresses(session, project.studio_id) | {*approvers}
        for recipient in people:
            notifier.notify(recipient, "builds", "a build was refused", line, page="")


@notice("designer.joined", topics={"joined": News.LIST})
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
