"""Logged days and hours as both parties read them."""

from collections import Counter
from collections.abc import Sequence
from typing import Literal
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import visible_contract
from app.agreements.models import Contract
from app.agreements.plan.queries import terms_of
from app.money import queries
from app.money.ledger.service import load_ledger_book
from app.money.models import WorkedDay
from app.money.overview import brief
from app.money.work.schemas import WorkedDayRead
from app.money.work.service import price_of
from app.money.work.worked_hours import HourBook
from app.projects.models import Project


def worked_days(session: Session, actor: Actor, contract_id: UUID) -> list[WorkedDayRead]:
    """Return the days and hours that were logged, with their prices."""
    return _read(session, visible_contract(session, actor, contract_id))


def worked_day(session: Session, day: WorkedDay) -> WorkedDayRead:
    """Return one entry of logged work with its price."""
    contract = session.get_one(Contract, day.contract_id)
    return next(other for other in _read(session, contract) if other.id == day.id)


def _read(session: Session, contract: Contract) -> list[WorkedDayRead]:
    logged = queries.worked_days_of(session, contract.id)
    rate_minor = terms_of(session, contract).day_rate_minor
    of_hours = _prices_of_hours(session, contract, logged)
    prefix = session.get_one(Project, contract.project_id).cue_prefix
    return [
        WorkedDayRead(
            id=day.id,
            worked_on=day.worked_on,
            quarters=day.quarters,
            minutes=day.minutes,
            cue=brief(day.cue, prefix) if day.cue else None,
            note=day.note,
            state=_state(day),
            amount_minor=price_of(day.quarters, rate_minor) if day.quarters else of_hours[day.id],
            agreed_at=day.agreed_at,
            refused_at=day.refused_at,
            refusal=day.refusal,
        )
        for day in logged
    ]


def _state(day: WorkedDay) -> Literal["waiting", "agreed", "refused"]:
    if day.agreed_at is not None:
        return "agreed"
    return "waiting" if day.refused_at is None else "refused"


def _prices_of_hours(session: Session, contract: Contract, logged: Sequence[WorkedDay]) -> dict[UUID, int]:
    """Return the ledger's prices of approved hours, and the costs of waiting ones if they are approved in order."""
    prices = {worked.id: 0 for worked in logged}
    hours = HourBook(session, contract)
    if hours.entries:
        for line in load_ledger_book(session, contract).lines:
            if line.worked_day_id is not None:
                prices[line.worked_day_id] = line.amount_minor
        approved = Counter(hours.approved)
        for day in hours.waiting:
            prices[day.id] = hours.charge(day, approved)
            approved[hours.month_of(day.worked_on)] += day.minutes or 0
    return prices
