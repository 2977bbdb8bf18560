"""Conditions of a contract's early end, and effects of a change order on a plan, stated without a database."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from datetime import date, timedelta
from enum import StrEnum
from uuid import UUID

from app.agreements.clauses.deemed_acceptance import working_days
from app.agreements.plan.validation import Advice, PlannedPayment
from app.amendments.errors import NoticeTooShort
from app.core.money import percent
from app.core.plural import counted, day_in_words


class ChangeOrderState(StrEnum):
    """The parties' progress with a change order."""

    PROPOSED = "proposed"
    AGREED = "agreed"
    REFUSED = "refused"  # by the other party
    WITHDRAWN = "withdrawn"  # by the party that proposed it
    LAPSED = "lapsed"  # the contract ended


def end_of_notice(today: date, notice_days: int | None, requested_on: date | None) -> date | None:
    """Return the last day of a contract whose notice is given today; None where it ends only if both agree.

    Raises NoticeTooShort for a day before the one that the contract allows.
    """
    if notice_days is None:
        if requested_on is not None:
            raise NoticeTooShort(
                "no clause of this contract lets one party end it on a day of their own",
                fix="give notice without a day; it ends when both agree to the statement",
            )
        return None
    earliest = today + timedelta(days=notice_days)
    if requested_on is not None and requested_on < earliest:
        raise NoticeTooShort(
            f"{requested_on} is before {earliest}; the contract wants {counted(notice_days, 'day')} of notice",
            errors=[{"where": "ends_on", "message": f"wanted {earliest} or later"}],
            fix=f"give notice for {earliest}; it ends at once when both agree to the statement",
        )
    return requested_on or earliest


def is_over(ends_on: date | None, today: date) -> bool:
    """Return whether the last day of a notice has passed, in UTC as every day of a contract."""
    return ends_on is not None and ends_on < today


@dataclass(frozen=True)
class Planned:
    """A milestone as a plan has it, for a change order to change."""

    milestone_id: UUID
    name: str
    amount_minor: int
    due_on: date | None
    cues: int
    is_deposit: bool = False

    @property
    def payment(self) -> PlannedPayment:
        """The milestone as the plan check reads it."""
        return PlannedPayment(self.name, self.amount_minor, self.due_on, self.cues, is_deposit=self.is_deposit)


@dataclass(frozen=True)
class Difference:
    """The effect of one change on a milestone."""

    milestone_id: UUID
    amount_minor: int = 0
    cues: int = 0
    due_on: date | None = None  # None: as it was


def changed_plan(plan: Sequence[Planned], differences: Sequence[Difference]) -> list[Planned]:
    """Return a plan with its changes."""
    after = {planned.milestone_id: planned for planned in plan}
    for difference in differences:
        now = after[difference.milestone_id]
        after[difference.milestone_id] = replace(
            now,
            amount_minor=now.amount_minor + difference.amount_minor,
            cues=now.cues + difference.cues,
            due_on=difference.due_on or now.due_on,
        )
    return list(after.values())


def warnings_of(
    before: Sequence[Planned],
    after: Sequence[Planned],
    today: date,
    *,
    rush_days: int,
    rush_bp: int,
    more_work: Collection[UUID] = (),
) -> list[Advice]:
    """Return a change order's effects that should not go unsaid: less time for more work, and work at a rush.

    `more_work` are the milestones to which it adds work beside their cues.
    """
    warnings: list[Advice] = []
    for old, new in zip(before, after, strict=True):
        is_earlier = old.due_on is not None and new.due_on is not None and new.due_on < old.due_on
        has_more = new.cues > old.cues or new.milestone_id in more_work
        is_more = has_more or new.amount_minor > old.amount_minor
        if old.due_on and new.due_on and is_earlier and is_more:
            warnings.append(
                Advice(
                    "earlier-and-more",
                    f"{new.name} moves from {day_in_words(old.due_on)} up to {day_in_words(new.due_on)} "
                    "while work is added to it.",
                    "Less time for more work is how dates are missed; move the date back, or take a cue out.",
                )
            )
        if (has_more or is_earlier) and rush_bp and new.due_on and working_days(today, new.due_on) < rush_days:
            warnings.append(
                Advice(
                    "rush",
                    f"{new.name} is due on {day_in_words(new.due_on)}, "
                    f"in less than {counted(rush_days, 'working day')}.",
                    f"By the clause on rates such work costs {percent(rush_bp)} more; say so in its price.",
                )
            )
    return warnings
