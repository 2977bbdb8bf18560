"""Random valid lives of a contract: the ledger stays balanced, and every line can be followed."""

from dataclasses import replace
from uuid import UUID, uuid4

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from app.agreements.clauses.terms import KillFees
from app.agreements.plan.amounts import split
from app.agreements.rules import ReleaseClause, WorkState
from app.core.money import part_of
from app.money.errors import NothingToInvoice, Overpayment, RefundTooLarge
from app.money.figures import figures_of, open_tax_minor
from app.money.ledger.book import (
    PAYMENTS,
    Entry,
    LedgerBook,
    Line,
    PayRules,
    PricedCue,
    allocate,
    open_lines,
    paid_cues,
    price_of_round,
    refund,
    settle_shares,
    tax_entries,
)
from app.money.ledger.rules import LineKind

KILL_FEES = KillFees(not_begun_bp=1_000, in_work_bp=5_000, delivered_bp=9_000)
DEPOSIT_MINOR = 1_440_01
PERSON = uuid4()


def written(entry: Entry, **more: UUID | None) -> Line:
    """Write an entry as the service does: with an id and the person who caused it."""
    return Line(**vars(entry), id=uuid4(), person_id=PERSON, **more)


class Contract(RuleBasedStateMachine):
    """Two parties, three milestones, and whatever they may do."""

    @initialize(
        release=st.sampled_from(ReleaseClause),
        holdback_bp=st.sampled_from([0, 1_000, 3_333]),
        amounts=st.lists(st.integers(0, 300_000), min_size=3, max_size=3),
        weights=st.lists(st.integers(0, 9), min_size=9, max_size=9),
        taxes=st.lists(st.sampled_from([0, 700, 1_900]), min_size=3, max_size=3),
    )
    def agree(self, release, holdback_bp, amounts, weights, taxes):
        """Fix the price of every cue, and make the deposit due."""
        self.rules, self.amounts = PayRules(release, holdback_bp, KILL_FEES), amounts
        self.milestones = [uuid4() for _ in amounts]
        self.tax_bp = dict(zip(self.milestones, taxes, strict=True))
        self.cues: dict[UUID, PricedCue] = {}
        for place, (milestone_id, amount) in enumerate(zip(self.milestones, amounts, strict=True)):
            for part in split(amount, weights[3 * place : 3 * place + 3]):
                cue = PricedCue(uuid4(), milestone_id, part)
                self.cues[cue.cue_id] = cue
        self.ids = list(self.cues)
        self.rounds = dict.fromkeys(self.ids, 0)
        self.invoices: list[UUID] = []
        self.payments: dict[UUID, int] = {}
        self.lines = [written(Entry(LineKind.DEPOSIT, DEPOSIT_MINOR, "payment-plan", milestone_id=self.milestones[0]))]

    @property
    def book(self) -> LedgerBook:
        return LedgerBook(self.lines, "EUR")

    def settle(self):
        entries = settle_shares(self.book, list(self.cues.values()), self.rules)
        self.lines += [written(entry) for entry in entries]

    def change(self, which: int, **facts):
        cue = self.cues[self.ids[which]]
        self.cues[cue.cue_id] = PricedCue(**{**vars(cue), **facts})
        self.settle()

    @rule(which=st.integers(0, 8), again=st.booleans())
    def accept(self, which, again):
        """Approve the last take of a cue; the same request may come twice."""
        if self.cues[self.ids[which]].cut_in is None:
            self.change(which, is_accepted=True)
            if again:
                before = len(self.lines)
                self.settle()
                assert len(self.lines) == before

    @rule(which=st.integers(0, 8))
    def reverse(self, which):
        """Take an approval back."""
        if self.cues[self.ids[which]].cut_in is None:
            self.change(which, is_accepted=False)

    @rule(which=st.integers(0, 8), state=st.sampled_from(WorkState))
    def cut(self, which, state):
        """Cut a cue in whatever state it is."""
        cue = self.cues[self.ids[which]]
        if cue.cut_in is None:
            self.change(which, cut_in=WorkState.ACCEPTED if cue.is_accepted else state)

    @rule(which=st.integers(0, 8), price_bp=st.integers(0, 5_000))
    def agree_extra_round(self, which, price_bp):
        """Ask for more than the included rounds."""
        cue = self.cues[self.ids[which]]
        self.rounds[cue.cue_id] += 1
        amount = price_of_round(cue, price_bp)
        if amount:
            entry = Entry(
                LineKind.EXTRA_ROUND, amount, "rounds", cue.cue_id, cue.milestone_id, None, self.rounds[cue.cue_id]
            )
            self.lines.append(written(entry))

    @rule()
    def invoice(self):
        """Bill everything that is due, with its tax."""
        billed = self.book.billable
        invoice_id = uuid4()
        try:
            taxes = tax_entries(billed, self.tax_bp, default_bp=0)
        except NothingToInvoice:
            assert not billed
            return
        ids = {line.id for line in billed}
        self.lines = [
            Line(**{**vars(line), "invoice_id": invoice_id}) if line.id in ids else line for line in self.lines
        ]
        self.lines += [written(entry, invoice_id=invoice_id) for entry in taxes]
        self.invoices.append(invoice_id)

    def open_minor(self, invoice_id: UUID) -> int:
        book = self.book
        return sum(line.amount_minor - book.paid_minor(line.id) for line in book.owed if line.invoice_id == invoice_id)

    @precondition(lambda self: self.invoices)
    @rule(data=st.data(), share=st.integers(1, 4))
    def pay(self, data, share):
        """Pay an invoice in part or whole; a credit note is paid the other way."""
        invoice_id = data.draw(st.sampled_from(self.invoices))
        whole = self.open_minor(invoice_id)
        amount = whole if share == 4 else part_of(whole, 2_500 * share)
        if not whole:
            with pytest.raises(Overpayment):
                allocate(self.book, invoice_id, 1)
        if not amount:
            return
        with pytest.raises(Overpayment):
            allocate(self.book, invoice_id, whole + (1 if whole > 0 else -1))
        payment_id = uuid4()
        entries = allocate(self.book, invoice_id, amount)
        assert sum(entry.amount_minor for entry in entries) == amount
        self.lines += [written(entry, payment_id=payment_id) for entry in entries]
        self.payments[payment_id] = amount

    @precondition(lambda self: self.payments)
    @rule(data=st.data(), share=st.integers(1, 4))
    def refund_some(self, data, share):
        """Give a payment back in part or whole."""
        payment_id = data.draw(st.sampled_from(list(self.payments)))
        left = self.payments[payment_id]
        amount = left if share == 4 else part_of(left, 2_500 * share)
        if not amount:
            return
        with pytest.raises(RefundTooLarge):
            refund(self.book, payment_id, left + (1 if left > 0 else -1))
        entries = refund(self.book, payment_id, amount)
        assert sum(entry.amount_minor for entry in entries) == -amount
        self.lines += [written(entry, payment_id=payment_id) for entry in entries]
        self.payments[payment_id] -= amount

    @invariant()
    def every_cent_is_somewhere(self):
        """What was agreed is paid, due, open or saved."""
        figures = figures_of(self.book, list(self.cues.values()), DEPOSIT_MINOR)
        together = figures.paid_minor + figures.due_minor + figures.open_minor + figures.saved_minor
        assert together == figures.agreed_minor
        rounds = sum(line.amount_minor for line in self.lines if line.kind is LineKind.EXTRA_ROUND)
        assert figures.agreed_minor == DEPOSIT_MINOR + sum(self.amounts) + rounds
        assert figures.open_minor >= 0
        assert figures.saved_minor >= 0

    @invariant()
    def payments_are_what_was_handed_over(self):
        """Lines of payments add up to the payments, and no line is paid beyond its amount."""
        book = self.book
        assert sum(line.amount_minor for line in self.lines if line.kind in PAYMENTS) == sum(self.payments.values())
        for line in book.owed:
            low, high = sorted((0, line.amount_minor))
            assert low <= book.paid_minor(line.id) <= high
            assert line.invoice_id is not None or not book.paid_minor(line.id)

    @invariant()
    def what_is_due_is_open_on_invoices_or_not_billed(self):
        """The sum due can be followed to invoices and to what waits for the next one."""
        book = self.book
        due = figures_of(book, list(self.cues.values()), DEPOSIT_MINOR).due_minor + open_tax_minor(book)
        waiting = sum(line.amount_minor for line in book.billable)
        assert due == waiting + sum(self.open_minor(invoice_id) for invoice_id in self.invoices)

    @invariant()
    def every_line_can_be_followed(self):
        """Each names a person, a clause, and a cue or milestone; a correction undoes exactly one line, once."""
        by_id = {line.id: line for line in self.lines}
        taken_back = [line.about_id for line in self.lines if line.kind is LineKind.REVERSED]
        assert len(taken_back) == len(set(taken_back))
        for line in self.lines:
            assert line.person_id
            assert line.clause
            assert line.amount_minor
            assert line.cue_id or line.milestone_id or line.tax_bp
            if line.kind is LineKind.REVERSED:
                assert by_id[line.about_id].amount_minor == -line.amount_minor
            if line.kind in PAYMENTS | {LineKind.REVERSED}:
                about = by_id[line.about_id]
                assert (about.cue_id, about.milestone_id) == (line.cue_id, line.milestone_id)

    @invariant()
    def cues_are_owed_by_their_state(self):
        """An accepted cue owes its price as its clauses release it, a cut one its kill fee, any other nothing."""
        book = self.book
        is_last = all(cue.is_settled for cue in self.cues.values())
        for cue in self.cues.values():
            standing = book.owed_by_kind(cue.cue_id)
            owed = {kind: line.amount_minor for kind, line in standing.items()}
            siblings = [one for one in self.cues.values() if one.milestone_id == cue.milestone_id]
            held = part_of(cue.amount_minor, self.rules.holdback_bp)
            if cue.cut_in is not None and LineKind.CUT in owed:
                assert owed == {LineKind.CUT: part_of(cue.amount_minor, KILL_FEES.of(cue.cut_in))}
            elif cue.cut_in not in (None, WorkState.ACCEPTED):
                assert not part_of(cue.amount_minor, KILL_FEES.of(cue.cut_in))
            elif not cue.is_accepted:
                assert owed == {}
            else:
                if is_last:
                    assert sum(owed.values()) == cue.amount_minor
                elif LineKind.HELD_BACK in owed:
                    assert standing[LineKind.HELD_BACK].invoice_id
                if self.rules.release is ReleaseClause.PER_CUE or all(sibling.is_settled for sibling in siblings):
                    assert owed.get(LineKind.ACCEPTED, 0) == cue.amount_minor - held
                elif LineKind.ACCEPTED in owed:
                    assert standing[LineKind.ACCEPTED].invoice_id


Contract.TestCase.settings = settings(max_examples=40, stateful_step_count=25)
TestContract = Contract.TestCase


def alpha() -> tuple[list[PricedCue], LedgerBook]:
    milestone_id = uuid4()
    return [PricedCue(uuid4(), milestone_id, 18_000) for _ in range(3)], LedgerBook([], "USD")


def test_with_release_on_completion_the_last_cue_makes_all_due():
    cues, book = alpha()
    two = [PricedCue(cue.cue_id, cue.milestone_id, 18_000, is_accepted=place < 2) for place, cue in enumerate(cues)]
    assert settle_shares(book, two, PayRules(ReleaseClause.ON_COMPLETION)) == []
    three = [PricedCue(cue.cue_id, cue.milestone_id, 18_000, is_accepted=True) for cue in cues]
    due = settle_shares(book, three, PayRules(ReleaseClause.ON_COMPLETION))
    assert [(entry.kind, entry.amount_minor) for entry in due] == [(LineKind.ACCEPTED, 18_000)] * 3


def test_a_cut_completes_a_milestone():
    cues, book = alpha()
    done = [PricedCue(cue.cue_id, cue.milestone_id, 18_000, is_accepted=True) for cue in cues[:2]]
    done.append(PricedCue(cues[2].cue_id, cues[2].milestone_id, 18_000, cut_in=WorkState.IN_WORK))
    due = settle_shares(book, done, PayRules(ReleaseClause.ON_COMPLETION))
    assert [entry.amount_minor for entry in due] == [18_000, 18_000, 9_000]


def test_what_was_taken_back_before_it_was_billed_is_not_billed():
    cues, book = alpha()
    accepted = [PricedCue(cues[0].cue_id, cues[0].milestone_id, 18_000, is_accepted=True), *cues[1:]]
    lines = [written(entry) for entry in settle_shares(book, accepted, PayRules())]
    lines += [written(entry) for entry in settle_shares(LedgerBook(lines, "USD"), cues, PayRules())]
    assert [line.amount_minor for line in lines] == [18_000, -18_000]
    assert LedgerBook(lines, "USD").billable == []


def test_what_is_held_back_comes_with_the_last_cue():
    cues, book = alpha()
    rules = PayRules(holdback_bp=1_000)
    one = [PricedCue(cues[0].cue_id, cues[0].milestone_id, 18_000, is_accepted=True), *cues[1:]]
    due = settle_shares(book, one, rules)
    assert [(entry.kind, entry.amount_minor) for entry in due] == [(LineKind.ACCEPTED, 16_200)]
    lines = [written(entry) for entry in due]
    every = [PricedCue(cue.cue_id, cue.milestone_id, 18_000, is_accepted=True) for cue in cues]
    due = settle_shares(LedgerBook(lines, "USD"), every, rules)
    assert sorted(entry.amount_minor for entry in due) == [1_800, 1_800, 1_800, 16_200, 16_200]


def paid(line: Line, amount_minor: int) -> Line:
    return written(Entry(LineKind.PAID, amount_minor, "payment", line.cue_id, line.milestone_id, line.id))


def test_a_cue_is_paid_with_its_last_cent():
    cues, book = alpha()
    accepted = [replace(cues[0], is_accepted=True), *cues[1:]]
    lines = [written(entry) for entry in settle_shares(book, accepted, PayRules())]

    def seen(*payments: Line) -> tuple[set[UUID], list[list[Line] | None]]:
        book = LedgerBook([*lines, *payments], "USD")
        return paid_cues(book, accepted), [open_lines(book, cue) for cue in accepted]

    assert seen() == (set(), [lines, None, None])
    assert seen(paid(lines[0], 17_999)) == (set(), [lines, None, None])
    assert seen(paid(lines[0], 18_000)) == ({cues[0].cue_id}, [[], None, None])


def test_a_cue_of_which_a_share_is_held_back_is_open_and_not_paid_in_full():
    cues, book = alpha()
    accepted = [replace(cues[0], is_accepted=True), *cues[1:]]
    lines = [written(entry) for entry in settle_shares(book, accepted, PayRules(holdback_bp=1_000))]
    book = LedgerBook([*lines, paid(lines[0], 16_200)], "USD")
    assert (paid_cues(book, accepted), open_lines(book, accepted[0])) == (set(), [])


def test_a_cue_without_a_price_is_paid_with_the_whole_contract():
    cue = PricedCue(uuid4(), uuid4(), 0, is_accepted=True)
    day = written(Entry(LineKind.WORKED_DAY, 50_000, "rates"))
    owed, settled = LedgerBook([day], "USD"), LedgerBook([day, paid(day, 50_000)], "USD")
    assert (paid_cues(owed, [cue]), open_lines(owed, cue)) == (set(), [day])
    assert (paid_cues(settled, [cue]), open_lines(settled, cue)) == ({cue.cue_id}, [])


def test_the_credit_for_a_share_taken_back_pays_for_the_one_in_its_place():
    cues, book = alpha()
    accepted = [replace(cues[0], is_accepted=True), *cues[1:]]
    lines = [written(entry, invoice_id=uuid4()) for entry in settle_shares(book, accepted, PayRules())]
    lines.append(paid(lines[0], 18_000))
    lines += [written(entry) for entry in settle_shares(LedgerBook(lines, "USD"), cues, PayRules())]
    assert [line.amount_minor for line in lines] == [18_000, 18_000, -18_000]
    lines += [written(entry) for entry in settle_shares(LedgerBook(lines, "USD"), accepted, PayRules())]
    assert [line.amount_minor for line in lines[3:]] == [18_000]
    assert open_lines(LedgerBook(lines, "USD"), accepted[0]) == []
