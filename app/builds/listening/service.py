"""Listening passes: people hear the cues of a build in the running game, and their notes become tasks."""

from collections.abc import Mapping, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.builds.audits import queries as audit_queries
from app.builds.audits.models import AuditedSound, BuildAudit, GameTask, ListeningNote, ListeningPass
from app.builds.audits.rules import (
    MAX_AMOUNT_DB,
    TaskRole,
    ensure_amount,
    is_heard,
    role_of,
    task_of,
)
from app.builds.audits.schemas import AuditSummary
from app.builds.audits.service import approved_sounds
from app.builds.errors import (
    ListeningNoteInvalid,
    ListeningNoteNotFound,
    ListeningNoteTaken,
    ListeningPassClosed,
    ListeningPassNotFound,
    NothingToHear,
)
from app.builds.listening import queries as listening_queries
from app.builds.listening.schemas import (
    CueToHear,
    ListeningNoteAdd,
    ListeningNoteRead,
    ListeningNow,
    ListeningPassRead,
    RecordedMoment,
)
from app.builds.listening.tasks import add_task, cue_read, moment_of, place_of
from app.core import clock
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.references.errors import ReferenceNotFound
from app.references.rules import ReferenceKind
from app.references.service import version_seen
from app.renders.schemas import TakeSound
from app.sound_lists.errors import CueNotFound
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_by_id


def listening_now(session: Session, actor: Actor, project_id: UUID) -> ListeningNow:
    """Return the open listening pass, and the build that a new one would begin with."""
    access = project_access(session, actor, project_id)
    current = listening_queries.open_pass(session, project_id)
    newest = audit_queries.newest_audit(session, project_id)
    return ListeningNow(
        listening_pass=_read_pass(session, access, current, newest) if current else None,
        newest_audit=AuditSummary.model_validate(newest) if newest else None,
    )


def start(session: Session, actor: Actor, project_id: UUID) -> ListeningNow:
    """Begin a listening pass over the newest audited build; the one that is open is continued."""
    access = project_access(session, actor, project_id)
    current = listening_queries.open_pass(session, project_id)
    if current is None:
        newest = audit_queries.newest_audit(session, project_id)
        if newest is None:
            raise NothingToHear(
                "no build was audited yet, so there is no list of sounds to hear",
                fix="have the game's CI post an audit; the commands are on the builds page",
            )
        session.add(
            ListeningPass(
                studio_id=access.project.studio_id, project_id=project_id, audit_id=newest.id, started_by=actor.person
            )
        )
        session.flush()
    return listening_now(session, actor, project_id)


def close(session: Session, actor: Actor, listening_pass_id: UUID) -> None:
    """Close a pass; its notes and tasks stay, and the next one begins with the newest build."""
    access, current = _visible_pass(session, actor, listening_pass_id)
    access.ensure_may_speak()
    if current.closed_at is None:
        current.closed_at, current.closed_by = clock.now(), actor.person
        session.flush()


def add_note(session: Session, actor: Actor, listening_pass_id: UUID, body: ListeningNoteAdd) -> ListeningNoteRead:
    """Keep the caller's note on a cue, in place of their earlier one, and make a task of it.

    A note that came already is answered as it stands, so that a phone may send it again.
    """
    access, current = _visible_pass(session, actor, listening_pass_id)
    same_note = listening_queries.note_by_id(session, body.note_id)
    if same_note is not None:
        if same_note.written_by != actor.person_id or same_note.pass_id != current.id:
            raise ListeningNoteTaken("another note has this id; make a new one")
        return _read_note(session, access, same_note)
    if current.closed_at is not None:
        raise ListeningPassClosed("this listening pass is closed", fix="begin a new one, and write the note there")
    ensure_amount(body.said, body.amount_db)
    sounds = listening_queries.sounds_of_cue(session, current.audit_id, body.cue_id)
    if not sounds or not _sees(session, access, body.cue_id):
        raise CueNotFound(f"no cue {body.cue_id} in this listening pass")
    if body.recording is not None:
        _ensure_recording(session, actor, current, body.recording)
    else:
        for earlier in listening_queries.standing_notes(session, current.id, body.cue_id, actor.person):
            _take_back(session, earlier)
    now = clock.now()
    note = ListeningNote(
        id=body.note_id,
        studio_id=current.studio_id,
        project_id=current.project_id,
        pass_id=current.id,
        cue_id=body.cue_id,
        said=body.said,
        amount_db=body.amount_db,
        text=body.text,
        recording_id=body.recording.reference_version_id if body.recording else None,
        at_s=body.recording.at_s if body.recording else None,
        written_by=actor.person,
        written_at=max(current.started_at, min(now, body.written_at)) if body.written_at else now,
        received_at=now,
    )
    session.add(note)
    session.flush()
    _add_task_of(session, note, sounds)
    return _read_note(session, access, listening_queries.note_by_id(session, note.id) or note)


def _ensure_recording(session: Session, actor: Actor, current: ListeningPass, moment: RecordedMoment) -> None:
    """Raise unless a moment is of a clip or a sound among the references of the project of a pass."""
    version = version_seen(session, actor, moment.reference_version_id)
    if version.project_id != current.project_id:
        raise ReferenceNotFound(f"no version {moment.reference_version_id} of a reference")
    if version.kind not in (ReferenceKind.VIDEO, ReferenceKind.AUDIO):
        raise ListeningNoteInvalid(f"{version.file_name} is not a recording; name a clip or a sound")


def undo_note(session: Session, actor: Actor, listening_note_id: UUID) -> None:
    """Take a note of the caller back, and its task unless that is done; done twice, it is one."""
    note = listening_queries.note_by_id(session, listening_note_id)
    if note is None or note.written_by != actor.person_id:
        raise ListeningNoteNotFound(f"no note {listening_note_id} of yours")
    try:
        project_access(session, actor, note.project_id)
    except ProjectNotFound:
        raise ListeningNoteNotFound(f"no note {listening_note_id} of yours") from None
    if note.undone_at is None:
        _take_back(session, note)


def _take_back(session: Session, note: ListeningNote) -> None:
    note.undone_at = clock.now()
    task = listening_queries.tasks_of_notes(session, [note.id]).get(note.id)
    if task is not None and task.done_at is None:
        session.delete(task)
    session.flush()


def _add_task_of(session: Session, note: ListeningNote, sounds: Sequence[AuditedSound]) -> None:
    kind = task_of(note.said)
    if kind is None:
        return
    role = role_of(kind)
    takes = audit_queries.approved_takes_of(session, note.project_id, [note.cue_id])
    designer = takes[note.cue_id].designer_id if note.cue_id in takes else None
    furthest = _furthest(sounds)
    add_task(
        session,
        GameTask(
            studio_id=note.studio_id,
            project_id=note.project_id,
            cue_id=note.cue_id,
            path=furthest.path,
            kind=kind,
            role=role,
            assignee_id=designer if role is TaskRole.DESIGNER else None,
            gain_db=note.amount_db,
            where=place_of(furthest) if role is TaskRole.IMPLEMENTER else furthest.path,
            text=note.text,
            note_id=note.id,
            asked_by=note.written_by,
        ),
    )


def _visible_pass(session: Session, actor: Actor, listening_pass_id: UUID) -> tuple[ProjectAccess, ListeningPass]:
    listening_pass = listening_queries.pass_by_id(session, listening_pass_id)
    if listening_pass is None:
        raise ListeningPassNotFound(f"no listening pass {listening_pass_id}")
    try:
        return project_access(session, actor, listening_pass.project_id), listening_pass
    except ProjectNotFound:
        raise ListeningPassNotFound(f"no listening pass {listening_pass_id}") from None


def _sees(session: Session, access: ProjectAccess, cue_id: UUID) -> bool:
    own_cues = _own_cues(session, access)
    return own_cues is None or cue_id in own_cues


def _own_cues(session: Session, access: ProjectAccess) -> set[UUID] | None:
    """Return the cues that a designer hears: those they delivered for; None: the team hears all."""
    designer_id = access.only_designer_id
    return None if designer_id is None else audit_queries.cues_of_designer(session, access.project.id, designer_id)


def _furthest(sounds: Sequence[AuditedSound]) -> AuditedSound:
    return max(sounds, key=lambda sound: abs(sound.gain_db or 0.0))


def _read_pass(
    session: Session, access: ProjectAccess, current: ListeningPass, newest: BuildAudit | None
) -> ListeningPassRead:
    own_cues = _own_cues(session, access)
    by_cue: dict[UUID, list[AuditedSound]] = {}
    for sound in listening_queries.sounds_with_cues(session, current.audit_id):
        if sound.cue_id is not None and (own_cues is None or sound.cue_id in own_cues):
            by_cue.setdefault(sound.cue_id, []).append(sound)
    cues = cues_by_id(session, access.project.id, by_cue)
    notes = [note for note in listening_queries.notes_of(session, current.id) if note.cue_id in cues]
    heard = {note.cue_id for note in notes if is_heard(note.said)}
    shown = [_furthest(sounds) for sounds in by_cue.values()]
    sounds = approved_sounds(session, access.project, shown)
    in_order = sorted(cues.values(), key=lambda cue: (cue.position, cue.number))
    return ListeningPassRead(
        id=current.id,
        audit=AuditSummary.model_validate(current.audit),
        started_at=current.started_at,
        is_newest=newest is None or newest.id == current.audit_id,
        people=len({note.written_by for note in notes}),
        heard=len(heard),
        cues=[_cue_to_hear(access, cue, by_cue[cue.id], sounds, is_heard=cue.id in heard) for cue in in_order],
        notes=_read_notes(session, access, notes, cues),
        may_close=access.is_producer or access.is_liaison or access.is_approver,
    )


def _cue_to_hear(
    access: ProjectAccess,
    cue: Cue,
    sounds: Sequence[AuditedSound],
    approved: Mapping[int, TakeSound],
    *,
    is_heard: bool,
) -> CueToHear:
    furthest = _furthest(sounds)
    gain_db = furthest.gain_db
    return CueToHear(
        cue=cue_read(access.project, cue),
        category=cue.category,
        description=cue.description,
        events=list(dict.fromkeys(event for sound in sounds for event in sound.events)),
        files=len(sounds),
        gain_db=gain_db,
        message=furthest.message,
        depends=furthest.depends,
        move=furthest.moves[0] if furthest.moves else None,
        suggested_db=-gain_db if gain_db and 0.1 <= abs(gain_db) <= MAX_AMOUNT_DB else None,
        sound=approved.get(furthest.place),
        heard=is_heard,
    )


def _read_note(session: Session, access: ProjectAccess, note: ListeningNote) -> ListeningNoteRead:
    (read,) = _read_notes(session, access, [note], cues_by_id(session, note.project_id, [note.cue_id]))
    return read


def _read_notes(
    session: Session, access: ProjectAccess, notes: Sequence[ListeningNote], cues: Mapping[UUID, Cue]
) -> list[ListeningNoteRead]:
    tasks = listening_queries.tasks_of_notes(session, [note.id for note in notes])
    return [
        ListeningNoteRead(
            id=note.id,
            cue=cue_read(access.project, cues[note.cue_id]),
            said=note.said,
            amount_db=note.amount_db,
            text=note.text,
            written_by=PersonBrief.model_validate(note.author),
            written_at=note.written_at,
            is_mine=note.written_by == access.actor.person_id,
            recording=moment_of(note),
            task_id=task.id if task else None,
            role=task.role if task else None,
            is_done=task is not None and task.done_at is not None,
        )
        for note in notes
        for task in (tasks.get(note.id),)
    ]
