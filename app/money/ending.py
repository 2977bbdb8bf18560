"""The total of a contract that ends early, stated without a database: each cue by the state of its work then."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from uuid import UUID, uuid4

from app.agreements.rules import WorkState
from app.core.money import BASIS_POINTS
from app.money.figures import Figures, figures_of
from app.money.ledger.book import CLAUSES, Entry, LedgerBook, Line, PayRules, PricedCue, reverse, settle_shares
from app.money.ledger.rules import LineKind

CLAUSE = "termination"  # its key in the library


@dataclass(frozen=True)
class StatedCue:
    """One line of the statement."""

    cue_id: UUID
    milestone_id: UUID
    state: WorkState
    was_cut: bool  # before the contract ended
    price_minor: int
    part_bp: int  # of the price
    owed_minor: int
    clause: str


@dataclass(frozen=True)
class Statement:
    """The sums owed where a contract ends; `figures` are those of the ledger once `entries` are written."""

    cues: Sequence[StatedCue]
    entries: Sequence[Entry]  # what the ledger lacks
    figures: Figures
    deposit_minor: int
    rounds_minor: int
    extra_minor: int  # work by change orders, interest, a bonus
    days_minor: int
    hours_minor: int
    retainer_minor: int

    @property
    def cues_minor(self) -> int:
        """Return the sum owed for cues."""
        return sum(cue.owed_minor for cue in self.cues)


def statement_of(
    book: LedgerBook,
    cues: Sequence[PricedCue],
    states: Mapping[UUID, WorkState],
    rules: PayRules,
    *,
    beside_cues_minor: int,
    deposit_is_set_off: bool = False,
    time: Sequence[Entry] = (),
) -> Statement:
    """Return the statement of a contract if it ends now; `states` has the work of each cue that is not settled.

    `time` is what hours and retainer owe by then and the ledger lacks.
    """
    cut = [cue if cue.is_settled else replace(cue, cut_in=states[cue.cue_id]) for cue in cues]
    entries = [*settle_shares(book, cut, rules), *time]
    if deposit_is_set_off:
        entries += [replace(reverse(line), clause=CLAUSE) for line in book.standing(LineKind.DEPOSIT)]
    after = _written(book, entries)
    return Statement(
        cues=[
            _stated(after, cue, rules, was_cut=before.cut_in is not None) for before, cue in zip(cues, cut, strict=True)
        ],
        entries=entries,
        figures=figures_of(after, cut, beside_cues_minor, is_ended=True),
        deposit_minor=sum(line.amount_minor for line in after.standing(LineKind.DEPOSIT)),
        rounds_minor=sum(line.amount_minor for line in after.standing(LineKind.EXTRA_ROUND)),
        extra_minor=sum(
            line.amount_minor
            for kind in (LineKind.EXTRA_WORK, LineKind.LATE_INTEREST, LineKind.BONUS)
            for line in after.standing(kind)
        ),
        days_minor=sum(line.amount_minor for line in after.standing(LineKind.WORKED_DAY)),
        hours_minor=sum(line.amount_minor for line in after.standing(LineKind.WORKED_HOURS)),
        retainer_minor=sum(line.amount_minor for line in after.standing(LineKind.RETAINER)),
    )


def _written(book: LedgerBook, entries: Sequence[Entry]) -> LedgerBook:
    """Return the ledger as it will be, with ids that are never kept."""
    nobody = UUID(int=0)
    return LedgerBook(
        [*book.lines, *(Line(**vars(entry), id=uuid4(), person_id=nobody) for entry in entries)], book.currency
    )


def _stated(after: LedgerBook, cue: PricedCue, rules: PayRules, *, was_cut: bool) -> StatedCue:
    state = cue.cut_in if cue.cut_in is not None else WorkState.ACCEPTED
    is_cut = state is not WorkState.ACCEPTED
    return StatedCue(
        cue_id=cue.cue_id,
        milestone_id=cue.milestone_id,
        state=state,
        was_cut=was_cut,
        price_minor=cue.amount_minor,
        part_bp=rules.kill_fees.of(state) if is_cut else BASIS_POINTS,
        owed_minor=after.share_minor(cue.cue_id),
        clause=CLAUSES[LineKind.CUT] if is_cut else cue.accepting_clause,
    )
