"""The ledger of one contract, stated without a database: what is owed by whose act and which clause, and what was paid.

Lines are only ever added. A correction is a line of the opposite amount that names the line it takes back; a payment
is laid out over the lines of its invoice, so that every cent of it names a cue.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from uuid import UUID

from app.agreements.clauses.terms import KillFees
from app.agreements.rules import ReleaseClause, WorkState
from app.core.money import money, part_of
from app.money.errors import NothingToInvoice, Overpayment, RefundTooLarge
from app.money.ledger.rules import LineKind

PAYMENTS = frozenset({LineKind.PAID, LineKind.REFUNDED})
SHARES = frozenset({LineKind.ACCEPTED, LineKind.HELD_BACK, LineKind.CUT})
CLAUSES = {
    LineKind.DEPOSIT: "payment_plan",
    LineKind.ACCEPTED: "acceptance",
    LineKind.HELD_BACK: "payment_plan",
    LineKind.CUT: "kill_fee",
    LineKind.EXTRA_ROUND: "rates",
    LineKind.WORKED_DAY: "rates",
    LineKind.WORKED_HOURS: "hours",
    LineKind.RETAINER: "retainer",
    LineKind.EXTRA_WORK: "changes",
    LineKind.LATE_INTEREST: "payment",
    LineKind.BONUS: "bonus",
    LineKind.TAX: "payment",
    LineKind.PAID: "payment",
}  # a line that takes another back names that one's clause


@dataclass(frozen=True)
class Entry:
    """A line before it is written; who caused it is added then."""

    kind: LineKind
    amount_minor: int
    clause: str
    cue_id: UUID | None = None
    milestone_id: UUID | None = None
    about_id: UUID | None = None  # the line that is taken back or paid
    round_number: int | None = None
    tax_bp: int | None = None
    late_invoice_id: UUID | None = None  # the invoice that bears interest
    late_until_on: date | None = None
    worked_day_id: UUID | None = None
    month_number: int | None = None  # of the contract


@dataclass(frozen=True)
class Line(Entry):
    """One line of the ledger."""

    id: UUID = field(kw_only=True)
    person_id: UUID | None = field(kw_only=True)
    invoice_id: UUID | None = field(default=None, kw_only=True)
    payment_id: UUID | None = field(default=None, kw_only=True)


@dataclass(frozen=True)
class PricedCue:
    """The agreed terms of a cue, and its state."""

    cue_id: UUID
    milestone_id: UUID
    amount_minor: int
    is_accepted: bool = False
    cut_in: WorkState | None = None
    accepting_clause: str = CLAUSES[LineKind.ACCEPTED]

    @property
    def is_settled(self) -> bool:
        """Whether a milestone waits for it no longer."""
        return self.is_accepted or self.cut_in is not None


class LedgerBook:
    """The lines of one contract, in the order of their writing."""

    def __init__(self, lines: Iterable[Line], currency: str) -> None:
        self.lines = list(lines)
        self.currency = currency
        self._taken_back = {line.about_id for line in self.lines if line.kind is LineKind.REVERSED}
        self._paid_minor: dict[UUID, int] = {}
        for line in self.lines:
            if line.kind in PAYMENTS:
                owed_id = self._owed_id(line)
                self._paid_minor[owed_id] = self._paid_minor.get(owed_id, 0) + line.amount_minor

    def _owed_id(self, line: Line) -> UUID:
        if line.about_id is None:
            raise AssertionError("a payment entry names what it pays")
        if line.kind is LineKind.PAID:
            return line.about_id
        return self._owed_id(next(candidate for candidate in self.lines if candidate.id == line.about_id))

    @property
    def owed(self) -> list[Line]:
        """Every line but those of payments."""
        return [line for line in self.lines if line.kind not in PAYMENTS]

    @property
    def billable(self) -> list[Line]:
        """Return the lines on no invoice yet; a line taken back before it was billed is not billed any more."""
        unbilled = {line.id: line for line in self.owed if line.invoice_id is None}
        undone = {
            line.about_id for line in unbilled.values() if line.kind is LineKind.REVERSED and line.about_id in unbilled
        }
        return [line for line in unbilled.values() if line.id not in undone and line.about_id not in undone]

    def standing(self, kind: LineKind) -> list[Line]:
        """Return the lines of a kind that were not taken back."""
        return [line for line in self.lines if line.kind is kind and line.id not in self._taken_back]

    def paid_minor(self, line_id: UUID) -> int:
        """Return the paid amount of a line."""
        return self._paid_minor.get(line_id, 0)

    def open_minor(self, invoice_id: UUID) -> int:
        """Return the amount of an invoice that is not paid yet."""
        return sum(line.amount_minor - self.paid_minor(line.id) for line in self.owed if line.invoice_id == invoice_id)

    def owed_by_kind(self, cue_id: UUID) -> dict[LineKind, Line]:
        """Return the lines by which a cue's price is owed, by their kind: at most one of each."""
        owed_by_kind: dict[LineKind, Line] = {}
        for line in self.lines:
            if line.cue_id == cue_id and line.kind in SHARES and line.id not in self._taken_back:
                if line.kind in owed_by_kind:
                    raise AssertionError(f"cue {cue_id} is owed twice as {line.kind}")
                owed_by_kind[line.kind] = line
        return owed_by_kind

    def share_minor(self, cue_id: UUID) -> int:
        """Return the owed part of a cue's price."""
        return sum(line.amount_minor for line in self.owed_by_kind(cue_id).values())


def reverse(line: Line) -> Entry:
    """Return the entry that takes a line back."""
    kind = LineKind.REFUNDED if line.kind is LineKind.PAID else LineKind.REVERSED
    return Entry(
        kind,
        -line.amount_minor,
        line.clause,
        cue_id=line.cue_id,
        milestone_id=line.milestone_id,
        about_id=line.id,
        tax_bp=line.tax_bp,
    )


@dataclass(frozen=True)
class PayRules:
    """The clauses by which a cue's price becomes due."""

    release: ReleaseClause = ReleaseClause.PER_CUE
    holdback_bp: int = 0  # of each share, until the last cue is accepted or cut
    kill_fees: KillFees = field(default_factory=KillFees)


def settle_shares(book: LedgerBook, cues: Sequence[PricedCue], rules: PayRules) -> list[Entry]:
    """Return the entries that bring the ledger to what acceptance and cuts make due; none if it is up to date.

    A share that is on an invoice stays there when other cues are opened again: only its own cue takes it back.
    """
    open_milestones = {cue.milestone_id for cue in cues if not cue.is_settled}
    entries: list[Entry] = []
    for cue in cues:
        owed_by_kind = book.owed_by_kind(cue.cue_id)
        waits = rules.release is ReleaseClause.ON_COMPLETION and cue.milestone_id in open_milestones
        shares = _wanted_shares(cue, owed_by_kind, rules, waits=waits, is_last=not open_milestones)
        kept = {kind for kind, line in owed_by_kind.items() if shares.get(kind) == line.amount_minor}
        entries += [reverse(line) for kind, line in owed_by_kind.items() if kind not in kept]
        entries += [
            Entry(kind, amount_minor, _clause(kind, cue), cue_id=cue.cue_id, milestone_id=cue.milestone_id)
            for kind, amount_minor in shares.items()
            if kind not in kept and amount_minor
        ]
    return entries


def settle_bonus(book: LedgerBook, bonus_minor: int, *, is_earned: bool) -> list[Entry]:
    """Return the entry that makes a bonus due, once, or takes it back where it is not earned any more."""
    owed = book.standing(LineKind.BONUS)
    if not is_earned:
        return [reverse(line) for line in owed]
    return [] if owed or not bonus_minor else [Entry(LineKind.BONUS, bonus_minor, CLAUSES[LineKind.BONUS])]


def _clause(kind: LineKind, cue: PricedCue) -> str:
    return cue.accepting_clause if kind is LineKind.ACCEPTED else CLAUSES[kind]


def _wanted_shares(
    cue: PricedCue, owed_by_kind: Mapping[LineKind, Line], rules: PayRules, *, waits: bool, is_last: bool
) -> dict[LineKind, int]:
    # Cutting what was accepted changes nothing that is owed.
    if cue.cut_in is not None and not (cue.cut_in is WorkState.ACCEPTED and LineKind.ACCEPTED in owed_by_kind):
        return {LineKind.CUT: part_of(cue.amount_minor, rules.kill_fees.of(cue.cut_in))}
    if not cue.is_accepted and cue.cut_in is None:
        return {}
    held_minor = part_of(cue.amount_minor, rules.holdback_bp)
    shares = {LineKind.ACCEPTED: (cue.amount_minor - held_minor, not waits), LineKind.HELD_BACK: (held_minor, is_last)}
    return {
        kind: amount_minor
        for kind, (amount_minor, is_due) in shares.items()
        if is_due or (kind in owed_by_kind and owed_by_kind[kind].invoice_id is not None)
    }


def paid_cues(book: LedgerBook, cues: Iterable[PricedCue]) -> set[UUID]:
    """Return the accepted cues whose price is due and paid to the last cent.

    A cue without a price of its own, as under a contract by the day, is paid once all that is due is.
    """
    unpaid_minor: dict[UUID | None, int] = {}
    for line in book.owed:
        left_minor = line.amount_minor - book.paid_minor(line.id)
        unpaid_minor[line.cue_id] = unpaid_minor.get(line.cue_id, 0) + left_minor
    all_paid = not any(unpaid_minor.values())
    return {
        cue.cue_id
        for cue in cues
        if cue.is_accepted
        and not unpaid_minor.get(cue.cue_id)
        and (book.share_minor(cue.cue_id) >= cue.amount_minor if cue.amount_minor else all_paid)
    }


def open_lines(book: LedgerBook, cue: PricedCue) -> list[Line] | None:
    """Return the lines of an accepted cue that are not paid; None where its acceptance has made nothing due yet.

    A cue without a price of its own, as under a contract by the day, has the open lines of the whole contract.
    """
    if not cue.is_accepted or (cue.amount_minor and not book.share_minor(cue.cue_id)):
        return None
    lines = [line for line in book.owed if line.cue_id == cue.cue_id or not cue.amount_minor]
    unpaid = [line for line in lines if line.amount_minor != book.paid_minor(line.id)]
    # A credit for a share that was taken back pays for the share that took its place.
    return unpaid if sum(line.amount_minor - book.paid_minor(line.id) for line in unpaid) > 0 else []


def price_of_round(cue: PricedCue, extra_round_bp: int) -> int:
    """Return the price of one round beyond the included ones."""
    return part_of(cue.amount_minor, extra_round_bp)


def tax_entries(lines: Sequence[Line], tax_bp_of: Mapping[UUID, int], *, default_bp: int) -> list[Entry]:
    """Return one entry of tax for each rate above zero; `tax_bp_of` has the rates of milestones with a separate rate.

    Raises NothingToInvoice where there is no line to tax.
    """
    if not lines:
        raise NothingToInvoice(
            "everything due is on an invoice already",
            fix="wait until a cue is accepted, or other work is due",
        )
    by_rate: dict[int, int] = {}
    for line in lines:
        if (rate := rate_of(line, tax_bp_of, default_bp=default_bp)) is not None:
            by_rate[rate] = by_rate.get(rate, 0) + line.amount_minor
    return [
        Entry(LineKind.TAX, part_of(net_minor, rate), CLAUSES[LineKind.TAX], tax_bp=rate)
        for rate, net_minor in sorted(by_rate.items())
        if part_of(net_minor, rate)
    ]


def rate_of(line: Line, tax_bp_of: Mapping[UUID, int], *, default_bp: int) -> int | None:
    """Return the rate of tax on a line; None for interest, which is not a price of work."""
    if line.kind is LineKind.LATE_INTEREST:
        return None
    return tax_bp_of.get(line.milestone_id, default_bp) if line.milestone_id else default_bp


def allocate(book: LedgerBook, invoice_id: UUID, amount_minor: int) -> list[Entry]:
    """Lay a payment out over the lines of its invoice, credits first, then in order; raise Overpayment beyond it.

    An invoice below zero is a credit note; what is paid back on it is a payment below zero.
    """
    lines = [line for line in book.owed if line.invoice_id == invoice_id]
    open_minor = {line.id: line.amount_minor - book.paid_minor(line.id) for line in lines}
    whole_minor = sum(open_minor.values())
    sign = 1 if amount_minor > 0 else -1
    if not 0 < sign * amount_minor <= sign * whole_minor:
        raise Overpayment(
            f"{money(whole_minor, book.currency)} of this invoice is open, "
            f"so a payment of {money(amount_minor, book.currency)} is too much",
            fix="record that amount here, and the rest on another invoice"
            if sign * whole_minor > 0 and amount_minor
            else "nothing of it is to pay: record the payment on another invoice"
            if not whole_minor
            else f"record up to {money(whole_minor, book.currency)}",
        )
    left_minor = sign * amount_minor
    entries: list[Entry] = []
    for line in sorted(lines, key=lambda candidate: sign * candidate.amount_minor > 0):
        step = sign * open_minor[line.id]
        if step > 0:
            step = min(step, left_minor)
        if step:
            left_minor -= step
            entries.append(
                Entry(
                    LineKind.PAID,
                    sign * step,
                    CLAUSES[LineKind.PAID],
                    cue_id=line.cue_id,
                    milestone_id=line.milestone_id,
                    about_id=line.id,
                    tax_bp=line.tax_bp,
                )
            )
    return entries


def refund(book: LedgerBook, payment_id: UUID, amount_minor: int) -> list[Entry]:
    """Take a payment back in part or whole, the line it paid last first; raise RefundTooLarge beyond what is left."""
    refunded_minor: dict[UUID, int] = {}
    for line in book.lines:
        if line.kind is LineKind.REFUNDED and line.about_id is not None:
            refunded_minor[line.about_id] = refunded_minor.get(line.about_id, 0) - line.amount_minor
    paid = [line for line in book.lines if line.kind is LineKind.PAID and line.payment_id == payment_id]
    left = {line.id: line.amount_minor - refunded_minor.get(line.id, 0) for line in paid}
    whole_minor = sum(left.values())
    sign = 1 if whole_minor > 0 else -1
    if not 0 < sign * amount_minor <= sign * whole_minor:
        raise RefundTooLarge(
            f"{money(whole_minor, book.currency)} of this payment is not refunded yet, "
            f"so {money(amount_minor, book.currency)} cannot be refunded",
            fix=f"record up to {money(whole_minor, book.currency)}"
            if whole_minor
            else "this is final: all of it is back",
        )
    if amount_minor == whole_minor:
        return [_part_back(line, left[line.id]) for line in reversed(paid) if left[line.id]]
    entries: list[Entry] = []
    remains = sign * amount_minor
    for line in reversed(paid):
        # Credits that the payment used up stay used up: they go back with its last cent only.
        if (step := min(sign * left[line.id], remains)) > 0:
            remains -= step
            entries.append(_part_back(line, sign * step))
    return entries


def _part_back(line: Line, amount_minor: int) -> Entry:
    return replace(reverse(line), amount_minor=-amount_minor)
