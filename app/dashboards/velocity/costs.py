"""A project's costs by currency: budget, committed, spent, a kept sound, churn; and the accuracy of estimates."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import Row
from sqlalchemy.orm import Session

from app.agreements.models import ContractCue
from app.agreements.rules import WorkState
from app.dashboards.schemas import ProjectMoney
from app.dashboards.velocity import cost_queries as pace_cost_queries
from app.dashboards.velocity.cost_rules import (
    OrderedCue,
    churn,
    churned_since,
    estimate_error,
    kept_sounds,
    over_estimate,
    per_kept_minor,
    wants_another_sound,
)
from app.dashboards.velocity.schemas import CostsRead, EstimateErrorRead, OverEstimateRead
from app.money.queries import worked_minutes
from app.projects.budgets.queries import budgets_of
from app.projects.service import ProjectAccess
from app.sound_lists.rules import CueState

Ordered = Sequence[Row[ContractCue, str, CueState]]


def costs(
    session: Session, access: ProjectAccess, paid: ProjectMoney
) -> tuple[list[CostsRead], EstimateErrorRead | None, OverEstimateRead | None]:
    """Return the costs of the contracts in `paid`, by currency, the error of their estimates, and what exceeds them.

    Budgets are for those who act for the studio; estimates for its producers and for the designer who made them.
    """
    contract_ids = [contract.contract_id for contract in paid.contracts]
    rows = pace_cost_queries.ordered(session, contract_ids)
    by_currency: dict[str, list[OrderedCue]] = defaultdict(list)
    for cue in _ordered_cues(session, rows):
        by_currency[cue.currency].append(cue)
    figures = {total.currency: total.figures for total in paid.totals}
    budgets = (
        {budget.currency: budget.amount_minor for budget in budgets_of(session, access.project.id)}
        if access.is_team
        else {}
    )
    read = []
    for currency in sorted(figures.keys() | budgets.keys()):
        of, total = by_currency[currency], figures.get(currency)
        spent_minor, kept, churned = total.accepted_minor if total else 0, kept_sounds(of), churn(of)
        read.append(
            CostsRead(
                currency=currency,
                budget_minor=budgets.get(currency),
                committed_minor=total.agreed_minor - total.saved_minor if total else 0,
                spent_minor=spent_minor,
                paid_minor=total.paid_minor if total else 0,
                due_minor=total.due_minor if total else 0,
                kept=kept,
                per_kept_minor=per_kept_minor(spent_minor, kept),
                to_finish_minor=total.open_minor if total else 0,
                ordered=churned.ordered,
                churned=churned.churned,
                churn=churned.share,
                churned_minor=churned.churned_minor,
            )
        )
    sees_estimates = access.is_producer or access.only_designer_id is not None
    if not sees_estimates:
        return read, None, None
    return read, *_estimate_errors(session, contract_ids, rows)


def _ordered_cues(session: Session, rows: Ordered) -> list[OrderedCue]:
    cue_ids = {cue.cue_id for cue, _, _ in rows}
    began, rewritten = _began(session, cue_ids), _rewritten(session, cue_ids)
    return [
        OrderedCue(
            cue_id=cue.cue_id,
            currency=currency,
            amount_minor=cue.amount_minor or 0,
            is_kept=cue.accepted_at is not None and cue.cut_at is None and state is not CueState.CUT,
            is_churned=cue.cut_in not in (None, WorkState.NOT_BEGUN)
            or churned_since(began.get(cue.cue_id), rewritten.get(cue.cue_id, ())),
        )
        for cue, currency, state in rows
    ]


def _began(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, datetime]:
    began = pace_cost_queries.first_takes(session, cue_ids)
    for cue_id, at in pace_cost_queries.first_logs(session, cue_ids).items():
        began[cue_id] = min(at, began.get(cue_id, at))
    return began


def _rewritten(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, list[datetime]]:
    rewritten: dict[UUID, list[datetime]] = defaultdict(list)
    for cue_id, at, before, after in pace_cost_queries.changes(session, cue_ids):
        if wants_another_sound(before, after):
            rewritten[cue_id].append(at)
    return rewritten


def _estimate_errors(
    session: Session, contract_ids: Collection[UUID], rows: Ordered
) -> tuple[EstimateErrorRead | None, OverEstimateRead | None]:
    logged = worked_minutes(session, contract_ids)
    accepted: list[tuple[int, int]] = []
    open_ones: list[tuple[int, int]] = []
    for cue, _, state in rows:
        minutes = logged.get((cue.contract_id, cue.cue_id))
        if cue.estimate_min and minutes and cue.accepted_at:
            accepted.append((cue.estimate_min, minutes))
        elif cue.estimate_min and minutes and cue.cut_at is None and state is not CueState.CUT:
            open_ones.append((cue.estimate_min, minutes))
    error, over = estimate_error(accepted), over_estimate(open_ones)
    return (
        EstimateErrorRead(
            cues=error.cues,
            estimated_min=error.estimated_min,
            logged_min=error.logged_min,
            error_percent=error.percent,
        )
        if error
        else None,
        OverEstimateRead(cues=over.cues, over_min=over.over_min) if over else None,
    )
