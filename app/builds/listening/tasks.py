"""Tasks by which a sound comes to play in the game as it should: made of notes and drift, seen and done."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.accounts.schemas import PersonBrief
from app.builds.audits.models import AuditedSound, GameTask, ListeningNote
from app.builds.audits.rules import TaskKind, TaskRole
from app.builds.audits.schemas import SoundCue
from app.builds.errors import GameTaskNotFound, ImplementerNeeded
from app.builds.listening import queries as listening_queries
from app.builds.listening.schemas import GameTaskRead, RecordedMoment
from app.core import clock
from app.core.events import publish
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_by_id
from app.sound_lists.rules import label


def cue_read(project: Project, cue: Cue) -> SoundCue:
    """Return a cue as it stands beside a sound."""
    return SoundCue(id=cue.id, label=label(project.cue_prefix, cue.number), name=cue.name)


def place_of(sound: AuditedSound | None) -> str:
    """Return the place of the change of a sound's level: object and property, else its file."""
    if sound is None:
        return ""
    if sound.moves:
        return f"{sound.moves[0]['object']}, {sound.moves[0]['property']}"
    return sound.path


def may_implement(access: ProjectAccess) -> bool:
    """Whether the caller puts sounds into the game, or acts for the team."""
    return Role.IMPLEMENTER in access.roles or access.is_producer or access.is_liaison or access.is_approver


def ensure_may_implement(access: ProjectAccess) -> None:
    """Raise TeamNeeded for designers, ImplementerNeeded for members who only review."""
    access.ensure_team()
    if not may_implement(access):
        raise ImplementerNeeded("only an implementer, an audio lead or a producer can do this")


def add_task(session: Session, task: GameTask) -> GameTask:
    """Keep a task, and have the people notified whose task it is."""
    session.add(task)
    session.flush()
    publish(session, "game_task.added", studio_id=task.studio_id, task_id=task.id)
    return task


def send_back(session: Session, access: ProjectAccess, audit_id: UUID, sound: AuditedSound, *, text: str) -> GameTask:
    """Ask the implementers to bring a sound back to what was approved; asked twice, it is one task."""
    open_task = listening_queries.open_drift_task(session, access.project.id, sound.path)
    if open_task is not None:
        return open_task
    task = add_task(
        session,
        GameTask(
            studio_id=access.project.studio_id,
            project_id=access.project.id,
            cue_id=sound.cue_id,
            path=sound.path,
            kind=TaskKind.DRIFT,
            role=TaskRole.IMPLEMENTER,
            gain_db=-sound.gain_db if sound.gain_db else None,
            where=place_of(sound),
            text=text or sound.message,
            audit_id=audit_id,
            asked_by=access.actor.person,
        ),
    )
    return listening_queries.task_by_id(session, task.id) or task


def tasks_in(
    session: Session, actor: Actor, project_id: UUID, *, done: bool, before: UUID | None, limit: int
) -> tuple[ProjectAccess, Sequence[GameTask]]:
    """Return tasks of a project: all of them to the team, to a designer their own and those they asked for."""
    access = project_access(session, actor, project_id)
    tasks = listening_queries.tasks_of(
        session, project_id, designer_id=access.only_designer_id, done=done, before=before, limit=limit
    )
    return access, tasks


def change_task(session: Session, actor: Actor, game_task_id: UUID, *, is_done: bool) -> tuple[ProjectAccess, GameTask]:
    """Mark a task as done, or as open again."""
    task = listening_queries.task_by_id(session, game_task_id)
    if task is None:
        raise GameTaskNotFound(f"no task {game_task_id}")
    try:
        access = project_access(session, actor, task.project_id)
    except ProjectNotFound:
        raise GameTaskNotFound(f"no task {game_task_id}") from None
    designer_id = access.only_designer_id
    if designer_id is not None and designer_id not in (task.assignee_id, task.asked_by):
        raise GameTaskNotFound(f"no task {game_task_id}")
    if not _may_do(access, task):
        raise ImplementerNeeded("only the person whose task it is, an audio lead or a producer can do this")
    if is_done != (task.done_at is not None):
        task.done_at, task.done_by = (clock.now(), actor.person) if is_done else (None, None)
        session.flush()
    return access, task


def moment_of(note: ListeningNote | None) -> RecordedMoment | None:
    """Return a note's moment in a recording."""
    if note is None or note.recording_id is None or note.at_s is None:
        return None
    return RecordedMoment(reference_version_id=note.recording_id, at_s=note.at_s)


def read_tasks(session: Session, access: ProjectAccess, tasks: Sequence[GameTask]) -> list[GameTaskRead]:
    """Return tasks as they are shown."""
    cues = cues_by_id(session, access.project.id, {task.cue_id for task in tasks if task.cue_id})
    notes = listening_queries.notes_by_id(session, [task.note_id for task in tasks if task.note_id])
    return [
        GameTaskRead(
            id=task.id,
            cue=cue_read(access.project, cues[task.cue_id]) if task.cue_id in cues else None,
            path=task.path,
            kind=task.kind,
            role=task.role,
            gain_db=task.gain_db,
            where=task.where,
            text=task.text,
            recording=moment_of(notes.get(task.note_id)) if task.note_id else None,
            asked_by=PersonBrief.model_validate(task.author),
            asked_at=task.asked_at,
            done_at=task.done_at,
            may_do=_may_do(access, task),
        )
        for task in tasks
    ]


def _may_do(access: ProjectAccess, task: GameTask) -> bool:
    return may_implement(access) or (access.actor.person_id is not None and task.assignee_id == access.actor.person_id)
