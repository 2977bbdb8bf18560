"""Warnings about a payment plan, with reasons.

Payments that rise keep both sides going, the largest for completing everything; but a last payment that is most of the
money makes the designer carry the project. The deposit is looked at by itself.
"""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import date

from app.core.money import BASIS_POINTS, money
from app.core.plural import day_in_words

HOLDBACK_BP = 5_000  # of what the milestones pay; more at the end is a loan from the designer
DEPOSIT_BP = (2_000, 5_000)  # what is usual, of the whole price


@dataclass(frozen=True)
class PlannedPayment:
    """One milestone of a plan; without cues it is the deposit."""

    name: str
    amount_minor: int
    due_on: date | None
    cues: int
    is_deposit: bool = False


@dataclass(frozen=True)
class Advice:
    """One warning about a plan; the plan may be agreed all the same.

    `subject` is the milestone that it is about, empty for the whole plan; `excess` says how far the limit is passed, in
    the unit of its rule. So two plans are compared by rule and subject, and not by their sentences.
    """

    code: str
    message: str
    why: str
    subject: str = ""
    excess: int = 0

    @property
    def key(self) -> tuple[str, str]:
        """Return the key that two equal warnings share: rule and subject."""
        return self.code, self.subject


def check_plan(payments: Sequence[PlannedPayment], currency: str, holdback_bp: int = HOLDBACK_BP) -> list[Advice]:
    """Return the warnings about a plan, in the order of its milestones."""
    milestones = [payment for payment in payments if not payment.is_deposit]
    return [
        *_deposit(payments, milestones, currency),
        *_dates(milestones),
        *_rising(milestones, currency),
        *_completion(milestones, holdback_bp),
        *_empty(milestones),
    ]


def _deposit(
    payments: Sequence[PlannedPayment], milestones: Sequence[PlannedPayment], currency: str
) -> Iterator[Advice]:
    deposit = sum(payment.amount_minor for payment in payments if payment.is_deposit)
    whole = deposit + sum(payment.amount_minor for payment in milestones)
    if not whole:
        return
    low_bp, high_bp = DEPOSIT_BP
    if deposit * BASIS_POINTS < low_bp * whole:
        yield Advice(
            "deposit-low",
            f"The deposit is {_percent(deposit, whole)} of the price; {low_bp // 100} to {high_bp // 100} % is usual. "
            f"It is a part of the price: take {money(-(-low_bp * whole // BASIS_POINTS) - deposit, currency)} "
            "from the milestones for it.",
            "Before the first acceptance the designer works for it alone.",
            excess=low_bp - deposit * BASIS_POINTS // whole,
        )
    elif deposit * BASIS_POINTS > high_bp * whole:
        yield Advice(
            "deposit-high",
            f"The deposit is {_percent(deposit, whole)} of the price; {low_bp // 100} to {high_bp // 100} % is usual.",
            "It is paid before any sound is heard.",
            excess=deposit * BASIS_POINTS // whole - high_bp,
        )


def _dates(milestones: Sequence[PlannedPayment]) -> Iterator[Advice]:
    dated = [payment for payment in milestones if payment.due_on is not None]
    for before, after in itertools.pairwise(dated):
        if before.due_on is not None and after.due_on is not None and after.due_on <= before.due_on:
            yield Advice(
                "dates-not-rising",
                f"{after.name} is due on {day_in_words(after.due_on)}, "
                f"not after {before.name} on {day_in_words(before.due_on)}.",
                "Milestones that fall together show no slip until it is late.",
                subject=after.name,
                excess=(before.due_on - after.due_on).days,
            )
    for payment in milestones:
        if payment.due_on is None:
            why = "Without a date, no delay can be seen."
            yield Advice("no-date", f"{payment.name} has no date.", why, subject=payment.name)


def _rising(milestones: Sequence[PlannedPayment], currency: str) -> Iterator[Advice]:
    for before, after in itertools.pairwise(milestones):
        if after.amount_minor < before.amount_minor:
            yield Advice(
                "not-rising",
                f"{after.name} pays {money(after.amount_minor, currency)}, "
                f"less than {before.name} with {money(before.amount_minor, currency)}.",
                "When less and less is left to earn, the work that remains is the first to wait.",
                subject=after.name,
                excess=before.amount_minor - after.amount_minor,
            )


def _completion(milestones: Sequence[PlannedPayment], holdback_bp: int) -> Iterator[Advice]:
    if len(milestones) < 2:
        if milestones and milestones[0].amount_minor and milestones[0].cues != 1:  # one cue cannot be parted
            yield Advice(
                "one-milestone",
                f"All is paid for {milestones[0].name} alone.",
                "Neither side sees early that the other drifts.",
            )
        return
    last, whole = milestones[-1], sum(payment.amount_minor for payment in milestones)
    largest = max(milestones, key=lambda payment: payment.amount_minor)
    if last.amount_minor < largest.amount_minor:
        yield Advice(
            "completion-not-largest",
            f"The largest payment is for {largest.name}, not for {last.name}, which completes everything.",
            "A list that is nearly done is worth little; the last sounds are what the game ships with.",
            excess=largest.amount_minor - last.amount_minor,
        )
    if last.amount_minor * BASIS_POINTS > holdback_bp * whole:
        yield Advice(
            "too-much-held-back",
            f"{last.name} holds {_percent(last.amount_minor, whole)} of the milestones back; "
            f"{holdback_bp / 100:g} % is the limit here.",
            "A designer who waits for most of the money takes other work meanwhile.",
            subject=last.name,
            excess=last.amount_minor * BASIS_POINTS // whole - holdback_bp,
        )


def _empty(milestones: Sequence[PlannedPayment]) -> Iterator[Advice]:
    for payment in milestones:
        if payment.amount_minor and not payment.cues:
            yield Advice(
                "no-cues",
                f"{payment.name} has an amount and no cues.",
                "Acceptance of cues makes money due, so nothing ever would here.",
                subject=payment.name,
            )


def worsened(before: Sequence[Advice], after: Sequence[Advice]) -> list[Advice]:
    """Return the warnings that a change adds to a plan or makes worse."""
    excess_before = {advice.key: advice.excess for advice in before}
    return [advice for advice in after if advice.key not in excess_before or advice.excess > excess_before[advice.key]]


def resolved(before: Sequence[Advice], after: Sequence[Advice]) -> list[Advice]:
    """Return the warnings that a change takes from a plan."""
    left = {advice.key for advice in after}
    return [advice for advice in before if advice.key not in left]


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / whole:.0f} %"
