"""What is done about cues that wait under a clause on silence: reminders, and acceptance when the days are over."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import true
from sqlalchemy.orm import Session

from app.contracts.settlement import note_reminder
from app.deliveries.models import Take
from app.kit import clock
from app.kit.db import insert_unless_there, new_id
from app.kit.events import publish
from app.projects.queries import decider_of
from app.reviews import queries
from app.reviews.models import Reminder
from app.reviews.service import Decision
from app.reviews.silence import SilentCue, silent_cues


def not_minded_yet(session: Session, now: datetime) -> list[UUID]:
    """Return the cues whose days are over, and those of which a reminder is due that was not sent."""
    waiting = silent_cues(session, true())
    sent = {
        (one.cue_id, one.waiting_since, one.number)
        for one in queries.reminders_of(session, [w.cue.id for w in waiting])
    }
    return [
        one.cue.id
        for one in waiting
        if one.is_over(now) or ((number := one.reminders(now)) and (one.cue.id, one.since, number) not in sent)
    ]


def mind(session: Session, cue_id: UUID, now: datetime) -> None:
    """Accept a cue whose days are over, or remind its decider; do nothing where somebody decided meanwhile."""
    queries.lock_cue(session, cue_id)
    for one in silent_cues(session, Take.cue_id == cue_id):
        if one.is_over(now):
            _accept(session, one)
        elif number := one.reminders(now):
            _remind(session, one, number)


def _accept(session: Session, one: SilentCue) -> None:
    note = (
        f"Accepted by silence: no verdict within {one.silence.days} working days, until {one.last_day} "
        f"({one.contract.title})"
    )
    decision = Decision(session, decider_of(session, one.project), note, silence_contract_id=one.contract.id)
    for take in one.picks:
        decision.approve(take)
    decision.finish(one.cue)
    publish(
        session,
        "cue.accepted_by_silence",
        studio_id=one.cue.studio_id,
        cue_id=one.cue.id,
        contract_id=one.contract.id,
        days=one.silence.days,
    )


def _remind(session: Session, one: SilentCue, number: int) -> None:
    reminder = {
        "id": new_id(),
        "studio_id": one.cue.studio_id,
        "project_id": one.cue.project_id,
        "cue_id": one.cue.id,
        "waiting_since": one.since,
        "number": number,
        "created_at": clock.now(),
    }
    if not insert_unless_there(session, Reminder, reminder, unique=("cue_id", "waiting_since", "number")):
        return
    decider_id = decider_of(session, one.project)
    note_reminder(session, one.contract.id, one.cue.id, to_id=decider_id, last_day=one.last_day)
    publish(
        session,
        "decider.reminded",
        studio_id=one.cue.studio_id,
        cue_id=one.cue.id,
        decider_id=decider_id,
        last_day=one.last_day.isoformat(),
    )
