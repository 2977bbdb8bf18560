"""Milestones and priced cues of contracts, read from the database; callers have checked who looks."""

from collections.abc import Collection, Sequence
from datetime import date
from typing import Any
from uuid import UUID
from zoneinfo import ZoneInfo

from sqlalchemy import Row, exists, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership
from app.accounts.queries import time_zones_of
from app.agreements.clauses.rules import Clause, terms_in_force
from app.agreements.clauses.terms import MoneyTerms
from app.agreements.models import Contract, ContractCue, ContractVersion, Milestone
from app.agreements.rules import ContractState
from app.core import clock
from app.sound_lists.models import Cue, CueChange, Question, Revision
from app.sound_lists.rules import CueState


def milestones_of(session: Session, contract_id: UUID) -> Sequence[Milestone]:
    """Return the milestones of a contract, in order."""
    return session.scalars(
        select(Milestone).where(Milestone.contract_id == contract_id).order_by(Milestone.position)
    ).all()


def milestone_by_id(session: Session, milestone_id: UUID) -> Milestone | None:
    """Return a milestone without asking who looks."""
    return session.get(Milestone, milestone_id)


def cues_of(session: Session, contract_id: UUID) -> Sequence[ContractCue]:
    """Return the cues of a contract with those of the list, in order."""
    return session.scalars(
        select(ContractCue)
        .where(ContractCue.contract_id == contract_id)
        .options(joinedload(ContractCue.cue))
        .order_by(ContractCue.position)
    ).all()


def cues_in_project(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> Sequence[Cue]:
    """Return those of these cues that are in the project."""
    return session.scalars(select(Cue).where(Cue.id.in_(cue_ids), Cue.project_id == project_id)).all()


def running_cue(session: Session, cue_id: UUID, designer_ids: Collection[UUID] | None) -> ContractCue | None:
    """Return a cue as an agreed contract covers it; of one of these designers where some are given."""
    query = (
        select(ContractCue)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(ContractCue.cue_id == cue_id, Contract.state == ContractState.AGREED)
        .options(joinedload(ContractCue.cue))
        .order_by(Contract.number)
    )
    if designer_ids is not None:
        query = query.where(Contract.designer_id.in_(designer_ids))
    return session.scalars(query).first()


def contracts_for_question(session: Session, question: Question) -> Sequence[ContractCue]:
    """Return the cue of a question as each running contract covers it whose designer asked it, or its team did."""
    of_team = exists().where(Membership.studio_id == question.studio_id, Membership.person_id == question.asked_by)
    return session.scalars(
        select(ContractCue)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(
            ContractCue.cue_id == question.cue_id,
            Contract.state == ContractState.AGREED,
            or_(Contract.designer_id == question.asked_by, of_team),
        )
        .options(joinedload(ContractCue.cue))
        .order_by(ContractCue.contract_id)
    ).all()


def cue_of(session: Session, contract_id: UUID, cue_id: UUID) -> ContractCue | None:
    """Return a cue as one contract covers it, as it stands now."""
    return session.scalar(
        select(ContractCue)
        .where(ContractCue.contract_id == contract_id, ContractCue.cue_id == cue_id)
        .options(joinedload(ContractCue.cue))
        .execution_options(populate_existing=True)
    )


def is_accepted_elsewhere(session: Session, contract_id: UUID, cue_id: UUID) -> bool:
    """Return whether a cue was accepted under another contract, which may have ended since."""
    accepted = select(ContractCue.id).where(
        ContractCue.cue_id == cue_id, ContractCue.contract_id != contract_id, ContractCue.accepted_at.is_not(None)
    )
    return session.scalars(accepted.limit(1)).first() is not None


def covered_elsewhere(session: Session, contract_id: UUID, cue_ids: Collection[UUID]) -> Sequence[Row[str, str]]:
    """Return the cues that another agreed contract covers and that are not settled there, with its title."""
    return session.execute(
        select(Cue.name, Contract.title)
        .join(ContractCue, ContractCue.cue_id == Cue.id)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(
            Cue.id.in_(cue_ids),
            Contract.id != contract_id,
            Contract.state == ContractState.AGREED,
            ContractCue.cut_at.is_(None),
            ContractCue.accepted_at.is_(None),
        )
        .order_by(Cue.number)
    ).all()


def wanted_cues(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return the cues of a project that are not cut, and that no agreed contract covers, in list order."""
    covered = select(ContractCue.id).join(Contract, Contract.id == ContractCue.contract_id)
    is_covered = covered.where(
        ContractCue.cue_id == Cue.id, Contract.state == ContractState.AGREED, ContractCue.cut_at.is_(None)
    ).exists()
    return session.scalars(
        select(Cue)
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT, ~is_covered)
        .order_by(Cue.position, Cue.number)
    ).all()


def agreed_terms(session: Session, contract: Contract) -> dict[str, object]:
    """Return the open terms of a contract's newest version that its standing clauses name, over its framework's.

    What change orders have set since stands over both.
    """
    terms: dict[str, object] = {}
    for contract_id in (contract.framework_id, contract.id):
        if contract_id is not None:
            newest = session.execute(
                select(ContractVersion.clauses, ContractVersion.terms)
                .where(ContractVersion.contract_id == contract_id)
                .order_by(ContractVersion.number.desc())
                .limit(1)
            ).first()
            if newest is not None:
                terms |= terms_in_force([Clause.of(row) for row in newest.clauses], newest.terms)
    return terms | contract.changed_terms


def today_of(session: Session, contract: Contract) -> date:
    """Return today by the calendar of the time zone of a contract's studio."""
    (time_zone,) = time_zones_of(session, {contract.studio_id}).values()
    return clock.now().astimezone(ZoneInfo(time_zone)).date()


def terms_of(session: Session, contract: Contract) -> MoneyTerms:
    """Return the terms of a contract's money."""
    return MoneyTerms.of(agreed_terms(session, contract))


def running_contracts(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the agreed contracts of a project that cover cues."""
    return session.scalars(
        select(Contract.id)
        .where(
            Contract.project_id == project_id,
            Contract.state == ContractState.AGREED,
            exists().where(ContractCue.contract_id == Contract.id),
        )
        .order_by(Contract.id)
    ).all()


def covered_changes(
    session: Session, project_id: UUID, revision: int
) -> Sequence[Row[UUID, UUID, int, str, dict[str, Any]]]:
    """Return the changes of a revision of the list to cues under running contracts, contract by contract."""
    return session.execute(
        select(ContractCue.contract_id, Cue.id.label("cue_id"), Cue.number, Cue.name, CueChange.after)
        .join(Cue, Cue.id == ContractCue.cue_id)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .join(CueChange, CueChange.cue_id == Cue.id)
        .join(Revision, Revision.id == CueChange.revision_id)
        .where(Revision.project_id == project_id, Revision.number == revision, Contract.state == ContractState.AGREED)
        .order_by(ContractCue.contract_id, ContractCue.position)
    ).all()
