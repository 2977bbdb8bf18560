"""Jobs of cues under a deemed-acceptance clause: reminders, and acceptance when the days are over."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import true
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.kit import clock
from app.kit.db import insert_if_absent, new_id
from app.kit.events import publish
from app.money.settlement import record_reminder
from app.projects.queries import approver_of
from app.reviews import queries
from app.reviews.deemed_cues import DeemedCue, deemed_cues
from app.reviews.models import Reminder
from app.reviews.service import Decision


def deemed_cues_due(session: Session, now: datetime) -> list[UUID]:
    """Return the cues whose days are over, and those of which a reminder is due that was not sent."""
    waiting = deemed_cues(session, true())
    sent = {
        (one.cue_id, one.waiting_since, one.number)
        for one in queries.reminders_of(session, [w.cue.id for w in waiting])
    }
    return [
        one.cue.id
        for one in waiting
        if one.is_over(now) or ((number := one.reminders(now)) and (one.cue.id, one.since, number) not in sent)
    ]


def apply_deemed(session: Session, cue_id: UUID, now: datetime) -> None:
    """Accept a cue whose days are over, or remind its approver; do nothing if there is a decision meanwhile."""
    queries.lock_cue(session, cue_id)
    for one in deemed_cues(session, Take.cue_id == cue_id):
        if one.is_over(now):
            _accept(session, one)
        elif number := one.reminders(now):
            _remind(session, one, number)


def _accept(session: Session, one: DeemedCue) -> None:
    note = (
        f"Auto-accepted: no response within {one.silence.days} working days, until {one.last_day} "
        f"({one.contract.title})"
    )
    decision = Decision(session, approver_of(session, one.project), note, deemed_by_contract_id=one.contract.id)
    for take in one.picks:
        decision.approve(take)
    decision.finish(one.cue)
    publish(
        session,
        "cue.deemed_accepted",
        studio_id=one.cue.studio_id,
        cue_id=one.cue.id,
        contract_id=one.contract.id,
        days=one.silence.days,
    )


def _remind(session: Session, one: DeemedCue, number: int) -> None:
    reminder = {
        "id": new_id(),
        "studio_id": one.cue.studio_id,
        "project_id": one.cue.project_id,
        "cue_id": one.cue.id,
        "waiting_since": one.since,
        "number": number,
        "created_at": clock.now(),
    }
    if not insert_if_absent(session, Reminder, reminder, unique=("cue_id", "waiting_since", "number")):
        return
    approver_id = approver_of(session, one.project)
    record_reminder(session, one.contract.id, one.cue.id, to_id=approver_id, last_day=one.last_day)
    publish(
        session,
        "approver.reminded",
        studio_id=one.cue.studio_id,
        cue_id=one.cue.id,
        approver_id=approver_id,
        last_day=one.last_day.isoformat(),
    )
