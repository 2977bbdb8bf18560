"""Jobs that write emails on what the game plays: drift that an audit found, and tasks."""

from uuid import UUID

from app.builds.audits.models import BuildAudit, GameTask
from app.builds.audits.rules import TaskKind, TaskRole
from app.core.jobs.queue import Payload
from app.core.plural import counted
from app.core.runtime import Runtime
from app.notifications import queries
from app.notifications.kinds import notice
from app.notifications.notifier import Notifier, cue_label
from app.notifications.preferences.rules import News
from app.projects.models import Project
from app.sound_lists.models import Cue

KIND_WORDS = {
    TaskKind.TOO_LOUD: "too loud",
    TaskKind.TOO_SOFT: "too soft",
    TaskKind.TOO_LONG: "too long",
    TaskKind.TOO_SHORT: "too short",
    TaskKind.WRONG: "wrong in the game",
    TaskKind.MISSING: "missing in the game",
    TaskKind.DRIFT: "not as approved",
}


@notice("audit.posted", topics={"drift": News.LIST})
def notify_audit(runtime: Runtime, payload: Payload) -> None:
    """Notify producers and approvers of sounds that play otherwise than approved since the audit before."""
    with runtime.database.writing() as session:
        audit = session.get_one(BuildAudit, UUID(payload["audit_id"]))
        if not audit.new_drifts:
            return
        project = session.get_one(Project, audit.project_id)
        notifier = Notifier(runtime, session, project, payload["event_id"])
        verb = "plays" if audit.new_drifts == 1 else "play"
        line = f"Build {audit.label}: {counted(audit.new_drifts, 'sound', 'sounds')} {verb} otherwise than approved."
        approvers = queries.approver_addresses(session, project)
        for recipient in queries.producer_addresses(session, project.studio_id) | {*approvers}:
            notifier.notify(recipient, "drift", "sounds drifted in a build", line, page="drift")


@notice("game_task.added", topics={"tasks": News.SOUNDS})
def notify_game_task(runtime: Runtime, payload: Payload) -> None:
    """Notify the implementers, or the designer, of a task; one that was taken back meanwhile is left out."""
    with runtime.database.writing() as session:
        task = session.get(GameTask, UUID(payload["task_id"]))
        if task is None or task.done_at is not None:
            return
        project = session.get_one(Project, task.project_id)
        cue = session.get(Cue, task.cue_id) if task.cue_id else None
        name = cue_label(project, cue) if cue else task.path
        gain = f", suggested {task.gain_db:+.1f} dB".replace("-", "−") if task.gain_db else ""
        where = f" ({task.where})" if task.where else ""
        line = f"{name}: {KIND_WORDS[task.kind]}{gain}{where}" + (f": {task.text}" if task.text else ".")
        notifier = Notifier(runtime, session, project, payload["event_id"])
        if task.role is TaskRole.IMPLEMENTER:
            people = queries.implementer_addresses(session, project)
        else:
            people = {queries.address_of(session, task.assignee_id)} if task.assignee_id else set()
        for recipient in people:
            notifier.notify(recipient, "tasks", "sounds to correct in the game", line, page="game-tasks")
