"""The pace of a project, seen by both sides: the work's beside the studio's own."""

from collections import defaultdict
from collections.abc import Sequence
from datetime import date, datetime
from uuid import UUID

from sqlalchemy import Row
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.dashboards import money
from app.dashboards.schemas import ProjectMoney
from app.dashboards.velocity import queries as pace_queries
from app.dashboards.velocity.costs import costs
from app.dashboards.velocity.rules import (
    LATELY,
    MANY_ROUNDS,
    CuePace,
    days_late,
    decided_before_and_since,
    finish_on,
    first_pass_share,
    longest_wait_hours,
    mean_rounds,
    median_hours,
    median_so_far,
)
from app.dashboards.velocity.schemas import Pace, StudioPace, WornCue
from app.projects.service import project_access
from app.sound_lists.rules import label

WORN_SHOWN = 20


def pace(session: Session, actor: Actor, project_id: UUID) -> Pace:
    """Return a project's pace: the whole of it for those who act for the studio, a designer's own work for them.

    Raises TeamNeeded for the rest of the team.
    """
    access = project_access(session, actor, project_id)
    access.ensure_party()
    designer_id = access.only_designer_id
    listed = pace_queries.cues(session, project_id, designer_id)
    by_cue = _cue_paces(session, project_id, designer_id, listed)
    every, now = list(by_cue.values()), clock.now()
    worn = [
        WornCue(cue_id=cue_id, label=label(access.project.cue_prefix, number), name=name, rounds=by_cue[cue_id].rounds)
        for cue_id, number, name, _, _ in listed
        if by_cue[cue_id].rounds >= MANY_ROUNDS and by_cue[cue_id].accepted_at is None
    ]
    still_due = [cue.due_on for cue in every if cue.accepted_at is None and cue.due_on is not None]
    accepted = sum(cue.accepted_at is not None for cue in every)
    before, lately = decided_before_and_since(every, now - LATELY)
    paid = money.project_money(session, actor, project_id)
    spent, estimates, over_estimate = costs(session, access, paid)
    return Pace(
        cues=len(every),
        accepted=accepted,
        first_pass=first_pass_share(every),
        first_pass_lately=first_pass_share(lately),
        first_pass_before=first_pass_share(before),
        rounds_per_cue=mean_rounds(every),
        days_late=days_late(every, now.date()),
        overdue=sum(due_on < now.date() for due_on in still_due),
        finish_on=finish_on(every, now),
        needed_on=max(still_due, default=None),
        worn=sorted(worn, key=lambda cue: -cue.rounds)[:WORN_SHOWN],
        studio=_studio_pace(session, project_id, designer_id, paid),
        costs=spent,
        estimates=estimates,
        over_estimate=over_estimate,
    )


def cue_paces(session: Session, project_id: UUID, designer_id: UUID | None) -> dict[UUID, CuePace]:
    """Return the decisions on each cue of a project; of a designer, on those that she sent something for."""
    return _cue_paces(session, project_id, designer_id, pace_queries.cues(session, project_id, designer_id))


def _cue_paces(
    session: Session,
    project_id: UUID,
    designer_id: UUID | None,
    listed: Sequence[Row[UUID, int, str, int, date | None]],
) -> dict[UUID, CuePace]:
    decided = _decided(session, project_id, designer_id)
    nothing: Decided = (0, None, {})
    return {
        cue_id: _cue_pace(decided.get(cue_id, nothing), variations, due_on)
        for cue_id, _, _, variations, due_on in listed
    }


Approval = tuple[datetime, bool]  # since when, and whether it was adopted without a review
Decided = tuple[int, datetime | None, dict[int, Approval]]  # rounds, the first of them, approvals by variation


def _decided(session: Session, project_id: UUID, designer_id: UUID | None) -> dict[UUID, Decided]:
    counted = {cue_id: (count, first) for cue_id, count, first in pace_queries.rounds(session, project_id)}
    approved: dict[UUID, dict[int, Approval]] = defaultdict(dict)
    for cue_id, variation, at, is_adopted in pace_queries.approvals(session, project_id, designer_id):
        approved[cue_id][variation] = (at, is_adopted)
    return {
        cue_id: (*counted.get(cue_id, (0, None)), approved.get(cue_id, {}))
        for cue_id in counted.keys() | approved.keys()
    }


def _cue_pace(decided: Decided, variations: int, due_on: date | None) -> CuePace:
    rounds, first_round_at, approved = decided
    first = [at for at in (first_round_at, *(at for at, _ in approved.values())) if at is not None]
    approved_at = [approved[variation] for variation in range(1, variations + 1) if variation in approved]
    is_accepted = len(approved_at) == variations
    return CuePace(
        rounds=rounds,
        first_decided_at=min(first, default=None),
        accepted_at=max(at for at, _ in approved_at) if is_accepted else None,
        due_on=due_on,
        is_adopted=rounds == 0 and is_accepted and all(is_adopted for _, is_adopted in approved_at),
    )


def _studio_pace(session: Session, project_id: UUID, designer_id: UUID | None, paid: ProjectMoney) -> StudioPace:
    now = clock.now()
    asked = [(began, ended) for began, ended in pace_queries.answer_times(session, project_id, designer_id)]
    reviewed = [(began, ended) for began, ended in pace_queries.review_times(session, project_id, designer_id)]
    waits = pace_queries.review_waits(session, project_id, designer_id)
    paid_after = [contract.last_days_to_pay for contract in paid.contracts if contract.last_days_to_pay is not None]
    unpaid = [invoice for contract in paid.contracts for invoice in contract.open_invoices]
    return StudioPace(
        review_hours=median_hours([*reviewed, *((began, None) for began in waits)], now),
        waiting_reviews=len(waits),
        longest_review_wait_hours=longest_wait_hours(waits, now),
        answer_hours=median_hours(asked, now),
        open_questions=sum(ended is None for _, ended in asked),
        longest_answer_wait_hours=longest_wait_hours([began for began, ended in asked if ended is None], now),
        days_to_pay=median_so_far(paid_after, [(now.date() - invoice.issued_on).days for invoice in unpaid]),
        late_invoices=sum(invoice.state == "late" for invoice in unpaid),
    )
