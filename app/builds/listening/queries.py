"""Listening passes, their notes, and tasks, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import or_, select
from sqlalchemy.orm import Session, joinedload

from app.builds.audits.models import AuditedSound, GameTask, ListeningNote, ListeningPass
from app.builds.audits.rules import TaskRole
from app.core.in_array import in_array


def open_pass(session: Session, project_id: UUID) -> ListeningPass | None:
    """Return the open listening pass of a project with its build."""
    return session.scalar(
        select(ListeningPass)
        .where(ListeningPass.project_id == project_id, ListeningPass.closed_at.is_(None))
        .options(joinedload(ListeningPass.audit))
    )


def pass_by_id(session: Session, pass_id: UUID) -> ListeningPass | None:
    """Return a listening pass, locked, so that its notes come one after the other."""
    query = select(ListeningPass).where(ListeningPass.id == pass_id)
    return session.scalar(query.with_for_update().execution_options(populate_existing=True))


def sounds_with_cues(session: Session, audit_id: UUID) -> Sequence[AuditedSound]:
    """Return the sounds of an audit that belong to cues, in its order."""
    return session.scalars(
        select(AuditedSound)
        .where(AuditedSound.audit_id == audit_id, AuditedSound.cue_id.is_not(None))
        .order_by(AuditedSound.place)
    ).all()


def sounds_of_cue(session: Session, audit_id: UUID, cue_id: UUID) -> Sequence[AuditedSound]:
    """Return the sounds of an audit that belong to one cue, in its order."""
    return session.scalars(
        select(AuditedSound)
        .where(AuditedSound.audit_id == audit_id, AuditedSound.cue_id == cue_id)
        .order_by(AuditedSound.place)
    ).all()


def notes_of(session: Session, pass_id: UUID) -> Sequence[ListeningNote]:
    """Return the notes of a pass that stand, with their authors, the newest first."""
    return session.scalars(
        select(ListeningNote)
        .where(ListeningNote.pass_id == pass_id, ListeningNote.undone_at.is_(None))
        .options(joinedload(ListeningNote.author))
        .order_by(ListeningNote.written_at.desc(), ListeningNote.id.desc())
    ).all()


def note_by_id(session: Session, note_id: UUID) -> ListeningNote | None:
    """Return a note with its author, taken back or not."""
    return session.scalar(
        select(ListeningNote).where(ListeningNote.id == note_id).options(joinedload(ListeningNote.author))
    )


def standing_notes(session: Session, pass_id: UUID, cue_id: UUID, person_id: UUID) -> Sequence[ListeningNote]:
    """Return a person's notes on a cue in a pass, away from any recording."""
    return session.scalars(
        select(ListeningNote).where(
            ListeningNote.pass_id == pass_id,
            ListeningNote.cue_id == cue_id,
            ListeningNote.written_by == person_id,
            ListeningNote.undone_at.is_(None),
            ListeningNote.recording_id.is_(None),
        )
    ).all()


def tasks_of_notes(session: Session, note_ids: Collection[UUID]) -> dict[UUID, GameTask]:
    """Return the tasks that notes became, by note."""
    tasks = session.scalars(select(GameTask).where(in_array(GameTask.note_id, note_ids)))
    return {task.note_id: task for task in tasks if task.note_id is not None}


def notes_by_id(session: Session, note_ids: Collection[UUID]) -> dict[UUID, ListeningNote]:
    """Return notes by id."""
    notes = session.scalars(select(ListeningNote).where(in_array(ListeningNote.id, note_ids)))
    return {note.id: note for note in notes}


def tasks_of(
    session: Session, project_id: UUID, *, designer_id: UUID | None, done: bool, before: UUID | None, limit: int
) -> Sequence[GameTask]:
    """Return tasks of a project with their authors, the newest first; of a designer those that are theirs."""
    query = select(GameTask).where(
        GameTask.project_id == project_id, GameTask.done_at.is_not(None) if done else GameTask.done_at.is_(None)
    )
    if designer_id is not None:
        query = query.where(or_(GameTask.assignee_id == designer_id, GameTask.asked_by == designer_id))
    if before is not None:
        query = query.where(GameTask.id < before)
    return session.scalars(query.options(joinedload(GameTask.author)).order_by(GameTask.id.desc()).limit(limit)).all()


def task_by_id(session: Session, task_id: UUID) -> GameTask | None:
    """Return a task with its author, locked."""
    query = select(GameTask).where(GameTask.id == task_id).options(joinedload(GameTask.author))
    return session.scalar(query.with_for_update(of=GameTask))


def open_drift_task(session: Session, project_id: UUID, path: str) -> GameTask | None:
    """Return the open task by which the drift of a sound was sent back."""
    query = select(GameTask).where(
        GameTask.project_id == project_id,
        GameTask.path == path,
        GameTask.audit_id.is_not(None),
        GameTask.role == TaskRole.IMPLEMENTER,
        GameTask.done_at.is_(None),
    )
    return session.scalar(query.options(joinedload(GameTask.author)).limit(1))
