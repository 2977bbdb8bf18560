"""The worked example of docs/explanation/contracts-and-money.md, walked through row by row."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from uuid import UUID, uuid4

from app.agreements.plan.amounts import split
from app.agreements.rules import WorkState
from app.money.figures import figures_of
from app.money.ledger.book import (
    Entry,
    LedgerBook,
    Line,
    PayRules,
    PricedCue,
    allocate,
    price_of_round,
    refund,
    settle_shares,
    tax_entries,
)
from app.money.ledger.rules import LineKind

DOCUMENT = Path(__file__).resolve().parents[3] / "docs/explanation/contracts-and-money.md"
DEPOSIT_MINOR, TAX_BP, ROUND_BP = 25_000, 1_900, 1_250


def rows() -> list[list[str]]:
    """Return the rows of the example's table."""
    text = DOCUMENT.read_text().partition("| what happens |")[2]
    return [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines()[2:] if line]


def minor(written: str) -> int:
    """Return an amount as it is written, in cents."""
    return int(written.replace(",", "").replace(".", "").replace("−", "-"))


class Example:
    """A contract with three cues, by the functions that the server uses."""

    def __init__(self) -> None:
        milestone_id = uuid4()
        self.cues = [PricedCue(uuid4(), milestone_id, share) for share in split(100_000, [0, 0, 0])]
        self.lines: list[Line] = []
        self.invoices: list[UUID] = []
        self.payments: list[UUID] = []

    @property
    def book(self) -> LedgerBook:
        return LedgerBook(self.lines, "EUR")

    def write(self, entries: list[Entry], **more: UUID) -> None:
        self.lines += [Line(**vars(entry), id=uuid4(), person_id=uuid4(), **more) for entry in entries]

    def agree(self) -> None:
        self.write([Entry(LineKind.DEPOSIT, DEPOSIT_MINOR, "payment_plan", milestone_id=uuid4())])

    def invoice(self) -> None:
        billed, invoice_id = {line.id for line in self.book.billable}, uuid4()
        taxes = tax_entries(self.book.billable, {}, default_bp=TAX_BP)
        self.lines = [replace(line, invoice_id=invoice_id) if line.id in billed else line for line in self.lines]
        self.write(taxes, invoice_id=invoice_id)
        self.invoices.append(invoice_id)

    def pay(self, amount_minor: int) -> None:
        self.payments.append(uuid4())
        self.write(allocate(self.book, self.invoices[-1], amount_minor), payment_id=self.payments[-1])

    def give_back(self, amount_minor: int) -> None:
        self.write(refund(self.book, self.payments[-1], amount_minor), payment_id=uuid4())

    def change(self, place: int, **facts: object) -> None:
        self.cues[place] = replace(self.cues[place], **facts)
        self.write(settle_shares(self.book, self.cues, PayRules()))

    def agree_round(self, place: int) -> None:
        cue = self.cues[place]
        price = price_of_round(cue, ROUND_BP)
        self.write([Entry(LineKind.EXTRA_ROUND, price, "rates", cue.cue_id, cue.milestone_id, None, 3)])


def test_the_worked_example_is_right_to_the_cent() -> None:
    example = Example()
    assert [cue.amount_minor for cue in example.cues] == [33_334, 33_333, 33_333]
    steps: list[Callable[[], None]] = [
        example.agree,
        example.invoice,
        lambda: example.pay(29_750),
        lambda: example.change(0, is_accepted=True),
        lambda: example.agree_round(1),
        lambda: example.change(2, cut_in=WorkState.IN_WORK),
        lambda: example.change(0, is_accepted=False),
        lambda: example.change(0, is_accepted=True),
        example.invoice,
        lambda: example.pay(40_000),
        lambda: example.give_back(10_000),
        lambda: example.change(1, is_accepted=True),
    ]
    for step, row in zip(steps, rows(), strict=True):
        before = len(example.lines)
        step()
        what, lines, *figures = row
        assert [line.amount_minor for line in example.lines[before:]] == [minor(one) for one in lines.split("+")], what
        now = figures_of(example.book, example.cues, DEPOSIT_MINOR)
        shown = [now.agreed_minor, now.paid_minor, now.due_minor, now.open_minor, now.saved_minor]
        assert shown == [minor(figure) for figure in figures], what
        assert sum(shown[1:]) == shown[0], what
