"""Cues that wait for the person whom they name; each function is one SELECT."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import exists, func, select
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def accepted_for_implementer(session: Session, project_id: UUID, person_id: UUID) -> dict[UUID, datetime]:
    """Return the accepted cues that a person puts into the game, each with the time of its last approval."""
    of_person = (Cue.project_id == project_id, Cue.implementer_id == person_id, Cue.state != CueState.CUT)
    approved = (Take.state == TakeState.APPROVED, Take.variation <= Cue.variations)
    rows = session.execute(
        select(Cue.id, func.max(Take.state_since))
        .join(Take, Take.cue_id == Cue.id)
        .where(*of_person, *approved)
        .group_by(Cue.id, Cue.variations)
        .having(func.count(Take.variation.distinct()) >= Cue.variations)
    )
    return dict(rows.all())


def cues_to_record(session: Session, project_id: UUID, person_id: UUID) -> int:
    """Return the number of cues that a person records and of which no take has come."""
    of_person = (Cue.project_id == project_id, Cue.recorder_id == person_id, Cue.state != CueState.CUT)
    has_takes = exists().where(Take.cue_id == Cue.id, Take.discarded_at.is_(None))
    return session.scalar(select(func.count()).where(*of_person, ~has_takes)) or 0
