"""The bonus of a contract: what happened to it, read from what is recorded."""

from dataclasses import dataclass
from datetime import date, datetime
from zoneinfo import ZoneInfo

from sqlalchemy.orm import Session

from app.accounts.calendars.service import time_zones_of
from app.agreements.clauses.terms import BonusWhen, MoneyTerms
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import agreed_terms, terms_of
from app.agreements.rules import ContractState
from app.core import clock
from app.money.bonuses.rules import BonusCue, BonusState, BonusStatus, bonus_status_of
from app.money.ledger.book import LedgerBook
from app.money.ledger.rules import LineKind
from app.money.ledger.service import cue_label
from app.money.schemas import BonusRead
from app.projects.models import Project


@dataclass(frozen=True)
class StudioDays:
    """The days of a studio, by its time zone."""

    zone: ZoneInfo

    def of(self, at: datetime) -> date:
        """Return the day on which a moment was there."""
        return at.astimezone(self.zone).date()


def studio_days(session: Session, contract: Contract) -> StudioDays:
    """Return the days of a contract's studio."""
    return StudioDays(ZoneInfo(time_zones_of(session, {contract.studio_id})[contract.studio_id]))


def bonus_status(session: Session, contract: Contract, terms: MoneyTerms) -> BonusStatus | None:
    """Return the outcome of a bonus that the software calculates; None where there is none."""
    if not terms.bonus_minor or terms.bonus_when is BonusWhen.OTHER:
        return None
    days = studio_days(session, contract)
    due_on = {milestone.id: milestone.due_on for milestone in plan_queries.milestones_of(session, contract.id)}
    prefix = session.get_one(Project, contract.project_id).cue_prefix
    cues = [
        BonusCue(
            name=cue_label(cue.cue, prefix),
            due_on=due_on[cue.milestone_id],
            accepted_on=days.of(cue.accepted_at) if cue.accepted_at else None,
            has_round=cue.change_requested_at is not None,
        )
        for cue in plan_queries.cues_of(session, contract.id)
        if cue.cut_at is None
    ]
    return bonus_status_of(
        terms.bonus_when,
        cues,
        today=days.of(clock.now()),
        is_running=contract.state is ContractState.AGREED,
        shipped_on=contract.game_shipped_on,
    )


def bonus_of(session: Session, contract: Contract, book: LedgerBook) -> BonusRead | None:
    """Return the bonus of a contract that was agreed, and what happened to it; None where it has none."""
    terms = terms_of(session, contract)
    if contract.agreed_at is None or not terms.bonus_minor:
        return None
    status = bonus_status(session, contract, terms)
    if status is not None and book.standing(LineKind.BONUS) and status.state is not BonusState.EARNED:
        status = BonusStatus(BonusState.EARNED, "it was due before the contract ended")
    trigger = agreed_terms(session, contract).get("bonus_trigger", "")
    return BonusRead(
        amount_minor=terms.bonus_minor,
        when=terms.bonus_when,
        state=status.state if status else None,
        because=status.because if status else str(trigger),
    )
