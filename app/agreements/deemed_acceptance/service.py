"""What is due of cues under a deemed-acceptance clause: reminders, and acceptance when the days are over."""

from datetime import date, datetime
from uuid import UUID

from sqlalchemy import true
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.clauses.deemed_acceptance import CLAUSE
from app.agreements.deemed_acceptance import queries
from app.agreements.deemed_acceptance.cues import DeemedCue, deemed_cues
from app.agreements.models import Reminder
from app.agreements.plan import queries as plan_queries
from app.agreements.record import service as record
from app.core import clock
from app.core.db import insert_if_absent, new_id
from app.core.events import publish
from app.core.plural import counted
from app.deliveries.models import Take
from app.deliveries.rules import shown_name
from app.projects.approval.service import approval_rights
from app.projects.models import Project
from app.reviews.queries import lock_cue
from app.reviews.verdicts.decisions import Decision
from app.sound_lists.rules import label


def deemed_cues_due(session: Session, now: datetime) -> list[UUID]:
    """Return the cues whose days are over, and those of which a reminder is due that was not sent."""
    waiting = deemed_cues(session, true())
    sent = {
        (reminder.cue_id, reminder.waiting_since, reminder.number)
        for reminder in queries.reminders_of(session, [deemed.cue.id for deemed in waiting])
    }
    return [
        deemed.cue.id
        for deemed in waiting
        if deemed.is_over(now)
        or ((number := deemed.reminders(now)) and (deemed.cue.id, deemed.wait.since, number) not in sent)
    ]


def apply_deemed(session: Session, cue_id: UUID, now: datetime) -> None:
    """Accept a cue whose days are over, or remind those who may approve it; do nothing after a decision.

    A cue with two files of one delivery for one place is not accepted: the reminder names them.
    """
    lock_cue(session, cue_id)
    for deemed_cue in deemed_cues(session, Take.cue_id == cue_id):
        if deemed_cue.is_over(now):
            _accept(session, deemed_cue, now)
        elif number := deemed_cue.reminders(now):
            _remind(session, deemed_cue, number, now)


def _accept(session: Session, deemed: DeemedCue, now: datetime) -> None:
    note = (
        f"Auto-accepted: no response within {counted(deemed.wait.clause.days, 'working day')}, "
        f"until {deemed.wait.last_day(now)} ({deemed.contract.title})"
    )
    decision = Decision(session, None, note, deemed_by_contract_id=deemed.contract.id)
    for take in deemed.picks:
        decision.approve(take)
    decision.finish(deemed.cue)
    publish(
        session,
        "cue.deemed_accepted",
        studio_id=deemed.cue.studio_id,
        cue_id=deemed.cue.id,
        contract_id=deemed.contract.id,
        days=deemed.wait.clause.days,
    )


def _remind(session: Session, deemed: DeemedCue, number: int, now: datetime) -> None:
    reminder = {
        "id": new_id(),
        "studio_id": deemed.cue.studio_id,
        "project_id": deemed.cue.project_id,
        "cue_id": deemed.cue.id,
        "waiting_since": deemed.wait.since,
        "number": number,
        "created_at": clock.now(),
    }
    if not insert_if_absent(session, Reminder, reminder, unique=("cue_id", "waiting_since", "number")):
        return
    last_day = deemed.wait.last_day(now)
    for person_id in approval_rights(session, deemed.project).people_for(deemed.cue.category):
        _record_reminder(session, deemed.contract.id, deemed.cue.id, to_id=person_id, last_day=last_day)
        publish(
            session,
            "approver.reminded",
            studio_id=deemed.cue.studio_id,
            cue_id=deemed.cue.id,
            approver_id=person_id,
            last_day=last_day.isoformat(),
            undecided=[" and ".join(shown_name(take.file_name) for take in group) for group in deemed.undecided],
        )


def _record_reminder(session: Session, contract_id: UUID, cue_id: UUID, *, to_id: UUID, last_day: date) -> None:
    """Record that a person was reminded of a cue, and the last day for its verdict."""
    covered = plan_queries.cue_of(session, contract_id, cue_id)
    if covered is None:
        return
    prefix = session.get_one(Project, covered.project_id).cue_prefix
    cue = f"{label(prefix, covered.cue.number)} {covered.cue.name}"
    to = session.get_one(Person, to_id).name
    facts = {"cue": cue, "to": to, "clause": CLAUSE, "waits_until": last_day.isoformat()}
    record.append(session, contract_id, "reminded", facts, by=None)
