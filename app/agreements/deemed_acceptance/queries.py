"""What waits for a verdict under an agreed contract, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, Row, and_, select
from sqlalchemy.orm import Session, joinedload

from app.agreements.models import ClockPause, Contract, ContractCue, Reminder
from app.agreements.rules import ContractState
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.projects.models import Project
from app.reviews.queue.queries import waits


def cues_under_contract(session: Session, cue_ids: Collection[UUID]) -> Sequence[UUID]:
    """Return the cues that an agreed contract covers and has not settled."""
    return session.scalars(
        select(ContractCue.cue_id)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(in_array(ContractCue.cue_id, cue_ids), *_is_open())
    ).all()


def _is_open() -> tuple[ColumnElement[bool], ...]:
    return Contract.state == ContractState.AGREED, ContractCue.accepted_at.is_(None), ContractCue.cut_at.is_(None)


def waiting_under_contract(session: Session, reach: ColumnElement[bool]) -> Sequence[Row[Take, Contract, Project]]:
    """Return the takes that wait of cues that an agreed contract with their designer covers, the newest first."""
    return session.execute(
        select(Take, Contract, Project)
        .join(ContractCue, ContractCue.cue_id == Take.cue_id)
        .join(Contract, and_(Contract.id == ContractCue.contract_id, Contract.designer_id == Take.designer_id))
        .join(Project, Project.id == Take.project_id)
        .where(reach, waits(), *_is_open())
        .options(joinedload(Take.cue))
        .order_by(Take.cue_id, Take.variation, Take.number.desc())
    ).all()


def reminders_of(session: Session, cue_ids: Collection[UUID]) -> Sequence[Reminder]:
    """Return the reminders that were sent of cues."""
    return session.scalars(select(Reminder).where(in_array(Reminder.cue_id, cue_ids))).all()


def clock_pauses(session: Session, contract_ids: Collection[UUID]) -> Sequence[ClockPause]:
    """Return the times in which change orders of contracts were open."""
    return session.scalars(
        select(ClockPause).where(in_array(ClockPause.contract_id, contract_ids)).order_by(ClockPause.id)
    ).all()
