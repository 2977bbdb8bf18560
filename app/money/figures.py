"""The figures of a contract: every one is summed from its lines, and together they are the agreed total."""

from collections.abc import Sequence
from dataclasses import dataclass

from app.money.ledger.book import LedgerBook, PricedCue
from app.money.ledger.rules import LineKind

EXTRAS = frozenset(  # due since, and in no plan
    {LineKind.EXTRA_ROUND, LineKind.EXTRA_WORK, LineKind.LATE_INTEREST, LineKind.BONUS}
)


@dataclass(frozen=True)
class Figures:
    """A contract's money without tax; `paid + due + open + saved` is `agreed`."""

    agreed_minor: int  # the plan, the extra rounds and work that were agreed to since, a bonus, interest
    accepted_minor: int  # what became due by acceptance and cuts, deposit and extras included
    paid_minor: int
    due_minor: int  # owed and not paid; below zero: paid for what was taken back since
    open_minor: int  # agreed and not due yet
    saved_minor: int  # what cuts and an early end left over


def figures_of(
    book: LedgerBook, cues: Sequence[PricedCue], beside_cues_minor: int, *, is_ended: bool = False
) -> Figures:
    """Sum a contract up; `beside_cues_minor` is what no cue carries: deposit, caps of days and hours, retainer.

    `is_ended`: it was settled early, so nothing more can become due and all that is not owed is saved.
    """
    owed_lines = [line for line in book.owed if line.kind is not LineKind.TAX]
    owed_minor = sum(line.amount_minor for line in owed_lines)
    paid_minor = sum(book.paid_minor(line.id) for line in owed_lines)
    extras = {line.id for line in owed_lines if line.kind in EXTRAS}
    extras_minor = sum(line.amount_minor for line in owed_lines if line.id in extras or line.about_id in extras)
    agreed_minor = beside_cues_minor + sum(cue.amount_minor for cue in cues) + extras_minor
    saved_minor = sum(cue.amount_minor - book.share_minor(cue.cue_id) for cue in cues if cue.cut_in is not None)
    if is_ended:
        saved_minor = agreed_minor - owed_minor
    return Figures(
        agreed_minor=agreed_minor,
        accepted_minor=owed_minor,
        paid_minor=paid_minor,
        due_minor=owed_minor - paid_minor,
        open_minor=agreed_minor - saved_minor - owed_minor,
        saved_minor=saved_minor,
    )


def tax_minor(book: LedgerBook) -> int:
    """Return the tax that was invoiced."""
    return sum(line.amount_minor for line in book.lines if line.kind is LineKind.TAX)


def open_tax_minor(book: LedgerBook) -> int:
    """Return the tax that was invoiced and is not paid."""
    return sum(line.amount_minor - book.paid_minor(line.id) for line in book.lines if line.kind is LineKind.TAX)
