"""Audits of builds, what they say of sounds, accepted drift and states of cues, read; callers have checked access."""

from collections.abc import Collection, Sequence
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session, joinedload

from app.builds.audits.models import AcceptedDrift, AuditedSound, BuildAudit, GameTask, ListeningNote, MarkedCue
from app.builds.audits.rules import UNHEARD, AuditStatus, TaskKind
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.sound_lists.models import Cue, Stem
from app.sound_lists.rules import CueState

HISTORY = 40


def audits_of(session: Session, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[BuildAudit]:
    """Return audits of a project, the newest first."""
    query = select(BuildAudit).where(BuildAudit.project_id == project_id)
    if before is not None:
        query = query.where(BuildAudit.id < before)
    return session.scalars(query.order_by(BuildAudit.id.desc()).limit(limit)).all()


def audit_by_id(session: Session, audit_id: UUID) -> BuildAudit | None:
    """Return an audit."""
    return session.scalar(select(BuildAudit).where(BuildAudit.id == audit_id))


def newest_audit(session: Session, project_id: UUID) -> BuildAudit | None:
    """Return the newest audit of a project, whatever its target."""
    query = select(BuildAudit).where(BuildAudit.project_id == project_id)
    return session.scalar(query.order_by(BuildAudit.id.desc()).limit(1))


def audit_before(session: Session, project_id: UUID, target: str, audit_id: UUID | None) -> BuildAudit | None:
    """Return the audit of a target before another; its newest where none is given."""
    query = select(BuildAudit).where(BuildAudit.project_id == project_id, BuildAudit.target == target)
    if audit_id is not None:
        query = query.where(BuildAudit.id < audit_id)
    return session.scalar(query.order_by(BuildAudit.id.desc()).limit(1))


def drifted_sounds(session: Session, audit_id: UUID) -> Sequence[AuditedSound]:
    """Return the sounds of an audit that drifted, in its order."""
    return session.scalars(
        select(AuditedSound)
        .where(AuditedSound.audit_id == audit_id, AuditedSound.has_drifted.is_(True))
        .order_by(AuditedSound.place)
    ).all()


def depending_sounds(session: Session, audit_id: UUID) -> int:
    """Return the number of sounds of an audit that have a level that the game's state changes, and no drift."""
    places = session.scalars(
        select(AuditedSound.place).where(
            AuditedSound.audit_id == audit_id,
            AuditedSound.has_drifted.is_(False),
            AuditedSound.played_status == AuditStatus.DEPENDS,
        )
    )
    return len(places.all())


def sounds_of(
    session: Session, audit_id: UUID, *, drifted_only: bool, after: int | None, limit: int
) -> Sequence[AuditedSound]:
    """Return the sounds of an audit in its order."""
    query = select(AuditedSound).where(AuditedSound.audit_id == audit_id)
    if drifted_only:
        query = query.where(AuditedSound.has_drifted.is_(True))
    if after is not None:
        query = query.where(AuditedSound.place > after)
    return session.scalars(query.order_by(AuditedSound.place).limit(limit)).all()


def sound_at(session: Session, audit_id: UUID, path: str) -> AuditedSound | None:
    """Return an audit's result on a path."""
    query = select(AuditedSound).where(AuditedSound.audit_id == audit_id, AuditedSound.path == path)
    return session.scalar(query.order_by(AuditedSound.place).limit(1))


def history_of(session: Session, project_id: UUID, path: str) -> list[tuple[AuditedSound, BuildAudit]]:
    """Return the last audits' results on a path, the newest first."""
    rows = session.execute(
        select(AuditedSound, BuildAudit)
        .join(BuildAudit, BuildAudit.id == AuditedSound.audit_id)
        .where(AuditedSound.project_id == project_id, AuditedSound.path == path)
        .order_by(AuditedSound.audit_id.desc())
        .limit(HISTORY)
    )
    return [(sound, audit) for sound, audit in rows]


def accepted_drifts(session: Session, project_id: UUID) -> Sequence[AcceptedDrift]:
    """Return the accepted drifts that were not withdrawn, the newest first, with the people who accepted them."""
    return session.scalars(
        select(AcceptedDrift)
        .where(AcceptedDrift.project_id == project_id, AcceptedDrift.withdrawn_at.is_(None))
        .options(joinedload(AcceptedDrift.author))
        .order_by(AcceptedDrift.id.desc())
    ).all()


def accepted_drift_by_id(session: Session, accepted_drift_id: UUID) -> AcceptedDrift | None:
    """Return an accepted drift, withdrawn or not."""
    return session.scalar(select(AcceptedDrift).where(AcceptedDrift.id == accepted_drift_id))


def open_drift_tasks(session: Session, project_id: UUID) -> dict[str, UUID]:
    """Return the tasks by which drift was sent back and that are not done, by path."""
    rows = session.execute(
        select(GameTask.path, GameTask.id).where(
            GameTask.project_id == project_id, GameTask.kind == TaskKind.DRIFT, GameTask.done_at.is_(None)
        )
    )
    return dict(rows.all())


def takes_named(session: Session, project_id: UUID, take_ids: Collection[UUID]) -> dict[UUID, Take]:
    """Return takes of a project by id, without what belongs to them."""
    query = select(Take).where(Take.project_id == project_id, in_array(Take.id, take_ids))
    return {take.id: take for take in session.scalars(query)}


def cues_by_stem(session: Session, project_id: UUID) -> dict[str, UUID]:
    """Return the cue that owns each stem, in small letters."""
    rows = session.execute(select(Stem.stem, Stem.cue_id).where(Stem.project_id == project_id))
    return {PurePosixPath(stem).name.lower(): cue_id for stem, cue_id in rows}


def wanted_cues(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return the cues of a list that are not cut, in list order."""
    query = select(Cue).where(Cue.project_id == project_id, Cue.state != CueState.CUT)
    return session.scalars(query.order_by(Cue.position, Cue.number)).all()


def statuses_by_cue(session: Session, audit_id: UUID) -> dict[UUID, list[tuple[AuditStatus, AuditStatus]]]:
    """Return an audit's statuses for the files of each cue: file and level."""
    rows = session.execute(
        select(AuditedSound.cue_id, AuditedSound.status, AuditedSound.played_status).where(
            AuditedSound.audit_id == audit_id, AuditedSound.cue_id.is_not(None)
        )
    )
    by_cue: dict[UUID, list[tuple[AuditStatus, AuditStatus]]] = {}
    for cue_id, status, played_status in rows:
        if cue_id is None:
            continue
        by_cue.setdefault(cue_id, []).append((status, played_status))
    return by_cue


def heard_cues(session: Session, project_id: UUID) -> set[UUID]:
    """Return the cues that were heard in the game, in any listening pass."""
    query = select(ListeningNote.cue_id).where(
        ListeningNote.project_id == project_id,
        ListeningNote.said.not_in(UNHEARD),
        ListeningNote.undone_at.is_(None),
    )
    return set(session.scalars(query.distinct()))


def marks_of(session: Session, project_id: UUID) -> Sequence[MarkedCue]:
    """Return the states of cues that were set by hand."""
    return session.scalars(select(MarkedCue).where(MarkedCue.project_id == project_id)).all()


def approved_takes_of(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, Take]:
    """Return an approved take of each cue, that of its first variation."""
    query = select(Take).where(
        Take.project_id == project_id, Take.state == TakeState.APPROVED, in_array(Take.cue_id, cue_ids)
    )
    takes = session.scalars(query.order_by(Take.variation.desc(), Take.id))
    return {take.cue_id: take for take in takes if take.cue_id is not None}


def cues_of_designer(session: Session, project_id: UUID, designer_id: UUID) -> set[UUID]:
    """Return the cues that a designer delivered for."""
    query = select(Take.cue_id).where(
        Take.project_id == project_id, Take.designer_id == designer_id, Take.cue_id.is_not(None)
    )
    return {cue_id for cue_id in session.scalars(query.distinct()) if cue_id is not None}
