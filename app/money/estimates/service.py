"""Estimates of an agreed contract against the actual values; for its two parties only."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.agreements.access import visible_contract
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan import queries as plan_queries
from app.agreements.rules import AcceptedBy, ContractState
from app.core import clock
from app.money import queries, schemas
from app.money.errors import CueNotInContract, OtherPartyNeeded
from app.money.estimates.rules import ErrorRate, Habit, error_percent, error_rate, forecast, minor_per_hour
from app.money.ledger.service import not_agreed
from app.money.models import WorkLog
from app.money.own_time.queries import own_minutes
from app.projects.errors import ProducerNeeded

UNRELIABLE = (
    "Estimates and actuals differ by {:.0f} points from one to the next, so no date can be forecast. "
    "Talk before the next milestone."
)


def log_work(
    session: Session, actor: Actor, contract_id: UUID, *, cue_id: UUID, minutes: int, worked_on: date
) -> WorkLog:
    """Note time that went into a cue, as its designer."""
    contract = visible_contract(session, actor, contract_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("only the designer logs time", fix="ask the designer to log it")
    if contract.state is not ContractState.AGREED:
        raise not_agreed(contract, "time can be logged once both have signed the contract")
    if all(cue.cue_id != cue_id for cue in plan_queries.cues_of(session, contract.id)):
        raise CueNotInContract(
            f"this contract does not cover the cue {cue_id}",
            fix="name a cue of the contract; a change order adds one",
        )
    log = WorkLog(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        cue_id=cue_id,
        minutes=minutes,
        worked_on=worked_on,
        logged_by=actor.person,
    )
    session.add(log)
    session.flush()
    return log


def estimates(session: Session, actor: Actor, contract_id: UUID) -> schemas.EstimatesRead:
    """Return the estimates, the actual values, and the dates or the warning that follow.

    Raises ProducerNeeded for others of the team: a person's figures are seen by the two parties only.
    """
    contract = visible_contract(session, actor, contract_id)
    if contract.designer_id != actor.person and Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("a designer's estimates are seen by that designer and the studio's producers only")
    read = estimates_of(session, contract)
    if contract.designer_id == actor.person:
        read.pay = _pay(session, contract)
    return read


def _pay(session: Session, contract: Contract) -> schemas.PayPerHour | None:
    """Divide the fee of a contract's milestones by its hours; None where no milestone is paid."""
    fee_minor = sum(milestone.amount_minor for milestone in plan_queries.milestones_of(session, contract.id))
    if fee_minor <= 0:
        return None
    worked = queries.worked_minutes(session, [contract.id])
    cues = plan_queries.cues_of(session, contract.id)
    estimated_min = sum(cue.estimate_min or 0 for cue in cues)
    own_min = own_minutes(session, contract.designer_id, [cue.cue_id for cue in cues])
    logged_min = sum(worked.values()) + own_min
    return schemas.PayPerHour(
        currency=contract.currency,
        fee_minor=fee_minor,
        estimated_min=estimated_min,
        logged_min=logged_min,
        own_min=own_min,
        by_estimate_minor=minor_per_hour(fee_minor, estimated_min),
        by_log_minor=minor_per_hour(fee_minor, logged_min),
    )


def estimates_of(session: Session, contract: Contract) -> schemas.EstimatesRead:
    """Return estimates and actuals of a contract that the caller is a party to."""
    milestones = plan_queries.milestones_of(session, contract.id)
    cues = plan_queries.cues_of(session, contract.id)
    worked = queries.worked_minutes(session, [contract.id])
    of_cues = [_of_cue(cue, worked.get((contract.id, cue.cue_id))) for cue in cues if cue.estimate_min]
    of_milestones = [
        estimate
        for milestone in milestones
        if (estimate := _of_milestone(contract, milestone, [cue for cue in cues if cue.milestone_id == milestone.id]))
    ]
    cue_rate, milestone_rate = _rate(of_cues), _rate(of_milestones)
    wild = [
        rate for rate in (cue_rate, milestone_rate) if rate.habit is Habit.UNRELIABLE and rate.spread_points is not None
    ]
    return schemas.EstimatesRead(
        cues=of_cues,
        milestones=of_milestones,
        cue_habit=_habit(cue_rate),
        milestone_habit=_habit(milestone_rate),
        forecasts=_forecasts(contract, milestones, cues, milestone_rate, cue_rate),
        warning=UNRELIABLE.format(max(rate.spread_points or 0.0 for rate in wild)) if wild else None,
    )


def _of_cue(cue: ContractCue, worked_min: int | None) -> schemas.EstimateRead:
    is_done = cue.accepted_at is not None and worked_min is not None
    return _estimate(cue.cue_id, cue.cue.name, float(cue.estimate_min or 0), float(worked_min or 0), is_done=is_done)


def _of_milestone(contract: Contract, milestone: Milestone, cues: list[ContractCue]) -> schemas.EstimateRead | None:
    if milestone.is_deposit or milestone.due_on is None or contract.agreed_at is None:
        return None
    began_on = contract.agreed_at.date()
    estimate_days = (milestone.due_on - began_on).days
    if estimate_days <= 0:
        return None
    moments = [cue.accepted_at or cue.cut_at for cue in cues]
    done = [moment for moment in moments if moment is not None]
    if cues and all(cue.accepted_by is AcceptedBy.ADOPTION for cue in cues):
        return None
    is_done = bool(cues) and len(done) == len(cues) and any(cue.accepted_at for cue in cues)
    until = max(done) if is_done else clock.now()
    so_far_days = float((until.date() - began_on).days)
    return _estimate(milestone.id, milestone.name, float(estimate_days), so_far_days, is_done=is_done)


def _estimate(about_id: UUID, name: str, estimate: float, so_far: float, *, is_done: bool) -> schemas.EstimateRead:
    return schemas.EstimateRead(
        about_id=about_id,
        name=name,
        estimate=estimate,
        so_far=so_far,
        actual=so_far if is_done else None,
        error_percent=error_percent(estimate, so_far) if is_done else None,
    )


def _rate(pairs: list[schemas.EstimateRead]) -> ErrorRate:
    return error_rate([(pair.estimate, pair.actual) for pair in pairs if pair.actual is not None])


def _habit(rate: ErrorRate) -> schemas.HabitRead:
    return schemas.HabitRead(
        pairs=rate.pairs, mean_percent=rate.mean_percent, spread_points=rate.spread_points, habit=rate.habit
    )


def _forecasts(
    contract: Contract, milestones: Sequence[Milestone], cues: Sequence[ContractCue], *rates: ErrorRate
) -> list[schemas.ForecastRead]:
    """Forecast by the first rate that is steady: of milestones, else of cues."""
    rate = next((rate for rate in rates if rate.habit is Habit.STEADY), None)
    if rate is None or contract.agreed_at is None:
        return []
    began_on = contract.agreed_at.date()
    unfinished = {cue.milestone_id for cue in cues if cue.accepted_at is None and cue.cut_at is None}
    return [
        schemas.ForecastRead(
            milestone_id=milestone.id, milestone=milestone.name, due_on=milestone.due_on, forecast_on=forecast_on
        )
        for milestone in milestones
        if milestone.id in unfinished
        and milestone.due_on
        and (forecast_on := forecast(began_on, milestone.due_on, rate))
    ]
