"""Verdicts, comments and list changes under a contract, to hold its record against; callers check who looks."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import Row, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractCue, ContractEvent
from app.deliveries.models import Take
from app.reviews.models import ChangeRequest, Comment, Feedback, Verdict
from app.sound_lists.models import CueChange, Question, Revision


def verdicts_under(session: Session, contract: Contract) -> Sequence[Verdict]:
    """Return the verdicts on the designer's takes of cues that the contract covers."""
    return session.scalars(
        select(Verdict)
        .join(Take, Take.id == Verdict.take_id)
        .join(ContractCue, ContractCue.cue_id == Verdict.cue_id)
        .where(ContractCue.contract_id == contract.id, Take.designer_id == contract.designer_id)
        .order_by(Verdict.id)
    ).all()


def takes_under(session: Session, contract: Contract) -> Sequence[Take]:
    """Return the designer's takes of cues that the contract covers."""
    return session.scalars(
        select(Take)
        .join(ContractCue, ContractCue.cue_id == Take.cue_id)
        .where(ContractCue.contract_id == contract.id, Take.designer_id == contract.designer_id)
        .order_by(Take.id)
    ).all()


def comments_under(session: Session, contract: Contract) -> Sequence[Row[UUID, Comment]]:
    """Return the comments on the designer's takes of cues that the contract covers, each with its cue."""
    return session.execute(
        select(ContractCue.cue_id, Comment)
        .join(Take, Take.id == Comment.take_id)
        .join(ContractCue, ContractCue.cue_id == Take.cue_id)
        .where(ContractCue.contract_id == contract.id, Take.designer_id == contract.designer_id)
        .order_by(Comment.id)
    ).all()


def change_requests_under(session: Session, contract: Contract) -> Sequence[Row[UUID, ChangeRequest, datetime]]:
    """Return the change requests that were sent on the designer's takes, each with its cue and when it was sent."""
    return session.execute(
        select(ContractCue.cue_id, ChangeRequest, Feedback.created_at)
        .join(Feedback, Feedback.id == ChangeRequest.feedback_id)
        .join(Take, Take.id == ChangeRequest.take_id)
        .join(ContractCue, ContractCue.cue_id == ChangeRequest.cue_id)
        .where(ContractCue.contract_id == contract.id, Take.designer_id == contract.designer_id)
        .order_by(ChangeRequest.id)
    ).all()


def questions_under(session: Session, contract: Contract) -> Sequence[Question]:
    """Return the questions that the designer asked on cues that the contract covers."""
    return session.scalars(
        select(Question)
        .join(ContractCue, ContractCue.cue_id == Question.cue_id)
        .where(ContractCue.contract_id == contract.id, Question.asked_by == contract.designer_id)
        .order_by(Question.id)
    ).all()


def entries_with_this_designer(session: Session, contract: Contract, kinds: Collection[str]) -> Sequence[str]:
    """Return the contents of entries of some kinds in the records of the project's contracts with this designer.

    A cue that one contract has settled and another one covers is on record in the first.
    """
    return session.scalars(
        select(ContractEvent.payload)
        .join(Contract, Contract.id == ContractEvent.contract_id)
        .where(
            Contract.project_id == contract.project_id,
            Contract.designer_id == contract.designer_id,
            ContractEvent.kind.in_(kinds),
        )
    ).all()


def list_changes(session: Session, project_id: UUID, revisions: Collection[int]) -> dict[tuple[int, str], Any]:
    """Return the changes of revisions of the list, by revision and cue."""
    rows = session.execute(
        select(Revision.number, CueChange.cue_id, CueChange.after)
        .join(CueChange, CueChange.revision_id == Revision.id)
        .where(Revision.project_id == project_id, Revision.number.in_(revisions))
    )
    return {(number, str(cue_id)): after for number, cue_id, after in rows}
