"""The record of the studio behind a posting: what bidders learn of it before they bid."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy import Row
from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.accounts.rules import Actor
from app.agreements.plan.queries import terms_of
from app.core import clock
from app.core.db import bypass_row_policies
from app.dashboards.studio_record import queries
from app.dashboards.studio_record.schemas import StudioRecord
from app.dashboards.velocity import queries as pace_queries
from app.dashboards.velocity.rules import FEW, CuePace, mean_rounds, median_hours, median_so_far
from app.dashboards.velocity.service import cue_paces
from app.hiring.postings.service import posting_seen
from app.money.ledger.rules import LineKind
from app.money.ledger.service import load_ledger_book


def studio_record(session: Session, actor: Actor, posting_id: UUID) -> StudioRecord:
    """Return the record of the studio that posted a job, to whoever sees the posting."""
    studio_id = posting_seen(session, actor, posting_id).posting.studio_id
    with bypass_row_policies(session):  # sums of projects that a candidate does not see
        return _record(session, studio_id)


def _record(session: Session, studio_id: UUID) -> StudioRecord:
    now = clock.now()
    reviewed, asked = [], []
    paces: list[CuePace] = []
    for project_id in queries.projects_of(session, studio_id):
        reviewed += [(since, at) for since, at in pace_queries.review_times(session, project_id, None)]
        asked += [(asked_at, at) for asked_at, at in pace_queries.answer_times(session, project_id, None)]
        paces += cue_paces(session, project_id, None).values()
    promised, earned, paid = _bonuses(session, studio_id)
    return StudioRecord(
        studio_name=session.get_one(Studio, studio_id).name,
        review_hours=median_hours(reviewed, now),
        answer_hours=median_hours(asked, now),
        days_to_pay=_days_to_pay(queries.payment_days(session, studio_id), now.date()),
        rounds_per_cue=mean_rounds(paces),
        bonuses_promised=promised,
        bonuses_earned=earned,
        bonuses_paid=paid,
    )


def _days_to_pay(invoices: Sequence[Row[date, date | None]], today: date) -> float | None:
    paid = [(paid_on - issued_on).days for issued_on, paid_on in invoices if paid_on is not None]
    open_days = [(today - issued_on).days for issued_on, paid_on in invoices if paid_on is None]
    return median_so_far(paid, open_days) if len(paid) >= FEW else None


def _bonuses(session: Session, studio_id: UUID) -> tuple[int, int, int]:
    """Return the numbers of contracts with a bonus, with an earned one, and with a paid one."""
    promised = earned = paid = 0
    for contract in queries.agreed_contracts(session, studio_id):
        if not terms_of(session, contract).bonus_minor:
            continue
        promised += 1
        book = load_ledger_book(session, contract)
        lines = list(book.standing(LineKind.BONUS))
        earned += bool(lines)
        paid += bool(lines) and all(book.paid_minor(line.id) >= line.amount_minor for line in lines)
    return promised, earned, paid
