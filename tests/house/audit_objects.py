"""An audit with an accepted drift, and a listening pass with a note and a task, as part of one of everything."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.builds.audits.models import (
    AcceptedDrift,
    AuditedSound,
    BuildAudit,
    GameTask,
    ListeningNote,
    ListeningPass,
)
from app.builds.audits.rules import AuditStatus, HeardAs, TaskKind, TaskRole
from app.core import clock
from app.core.db import new_id


def add_audit(
    session: Session, of: dict[str, UUID], *, cue_id: UUID, producer_id: UUID, designer_id: UUID
) -> dict[str, UUID]:
    """Add what a designer heard in a build; return its ids by the names in paths."""
    audit = BuildAudit(**of, label="1.0", target="game", sounds=1, drifted=1, new_drifts=1, unread=[])
    session.add(audit)
    session.flush()
    drift = {"path": "shield_hit.wav", "status": AuditStatus.GAIN, "played_status": AuditStatus.GAIN, "gain_db": 6.0}
    sound = AuditedSound(
        **of, **drift, audit_id=audit.id, place=0, cue_id=cue_id, has_drifted=True, file_db=0.0, property_db=6.0,
        message="6.0 dB louder", moves=[], depends=[], events=[],
    )  # fmt: skip
    accepted = AcceptedDrift(**of, **drift, target="game", reason="Quiet under the music", accepted_by=producer_id)
    listening = ListeningPass(**of, audit_id=audit.id, started_by=designer_id)
    session.add_all([sound, accepted, listening])
    session.flush()
    note = ListeningNote(
        **of, id=new_id(), pass_id=listening.id, cue_id=cue_id, said=HeardAs.TOO_LONG, text="", written_by=designer_id,
        written_at=clock.now(),
    )  # fmt: skip
    session.add(note)
    session.flush()
    task = GameTask(
        **of, cue_id=cue_id, path="shield_hit.wav", kind=TaskKind.TOO_LONG, role=TaskRole.DESIGNER,
        assignee_id=designer_id, where="shield_hit.wav", text="", note_id=note.id, asked_by=designer_id,
    )  # fmt: skip
    session.add(task)
    session.flush()
    return {
        "audit_id": audit.id,
        "accepted_drift_id": accepted.id,
        "listening_pass_id": listening.id,
        "listening_note_id": note.id,
        "game_task_id": task.id,
    }
