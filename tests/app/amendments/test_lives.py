"""Random valid lives of several contracts: the ledger equals a plain model that is written apart from it.

The model keeps no lines. From the cues and what was agreed it calculates what must be owed, each sum rounded once.
"""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from fractions import Fraction
from uuid import UUID, uuid4

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from app.agreements.clauses.terms import KillFees, MoneyTerms
from app.agreements.rules import ReleaseClause, WorkState
from app.money.ending import statement_of
from app.money.figures import figures_of
from app.money.ledger.book import Entry, LedgerBook, Line, PayRules, PricedCue, settle_bonus, settle_shares
from app.money.ledger.rules import LineKind
from app.money.work.rules import HourTerms, month_begins_on

pytestmark = pytest.mark.slow

DEPOSIT_MINOR, ROUND_BP = 77_777, 1_250
PARTS = {"not_begun": 333, "in_work": 5_000, "delivered": 7_501}
FEES = KillFees(*PARTS.values())
CONTRACTS, CUES = 2, 5
AGREED_ON = date(2026, 1, 31)
TERMS = MoneyTerms(
    hour_rate_minor=6_007,
    hours_cap=20,
    hours_month_cap=12,
    retainer_minor=45_678,
    retainer_hours=5,
    retainer_months=4,
)


def rounded(amount_minor: int, part_bp: int) -> int:
    """Round half away from zero, by fractions: the model's own calculation."""
    exact = Fraction(amount_minor * part_bp, 10_000)
    return int(exact + Fraction(1, 2))


class Life:
    """One contract: what the server keeps of it, and what the model knows."""

    def __init__(self, release: ReleaseClause, holdback_bp: int, prices: list[int], *, is_set_off: bool) -> None:
        self.rules = PayRules(release, holdback_bp, FEES)
        self.is_set_off = is_set_off
        self.milestones = [uuid4(), uuid4()]
        self.cues = [PricedCue(uuid4(), self.milestones[place % 2], price) for place, price in enumerate(prices)]
        self.lines: list[Line] = []
        self.write([Entry(LineKind.DEPOSIT, DEPOSIT_MINOR, "payment_plan", milestone_id=uuid4())])
        self.extras: list[int] = []
        self.bonus_minor = 0
        self.had_bonus = False
        self.is_ended = False
        self.terms = TERMS
        self.month = 1  # of the contract
        self.approved: dict[int, int] = {}
        self.waiting: list[tuple[int, int]] = []  # month and minutes

    @property
    def book(self) -> LedgerBook:
        return LedgerBook(self.lines, "EUR")

    @property
    def hours(self) -> HourTerms:
        return HourTerms.of(self.terms)

    @property
    def beside_minor(self) -> int:
        return DEPOSIT_MINOR + self.terms.time_cap_minor

    def write(self, entries: list[Entry]) -> None:
        self.lines += [Line(**vars(entry), id=uuid4(), person_id=UUID(int=1)) for entry in entries]

    def change(self, place: int, **facts: object) -> None:
        self.cues[place] = replace(self.cues[place], **facts)
        self.settle()

    def settle(self) -> None:
        self.write(settle_shares(self.book, self.cues, self.rules))
        if not self.is_ended:
            self.write(settle_bonus(self.book, self.bonus_minor, is_earned=self.earns_the_bonus()))
            self.had_bonus = self.earns_the_bonus()

    def earns_the_bonus(self) -> bool:
        """Whether every cue that was not cut is accepted, and some are."""
        left = [cue for cue in self.cues if cue.cut_in is None]
        return bool(left) and all(cue.is_accepted for cue in left)

    def owed_bonus(self) -> int:
        """Return what an early end leaves of a bonus: what was due before it."""
        earned = self.had_bonus if self.is_ended else self.earns_the_bonus()
        return self.bonus_minor if earned else 0

    def owed_by_the_model(self) -> int:
        """Return what must be owed by what happened, without any line."""
        deposit = 0 if self.is_ended and self.is_set_off else DEPOSIT_MINOR
        return deposit + sum(self.extras) + self.owed_bonus() + self.owed_time() + sum(map(self._share, self.cues))

    def owed_time(self) -> int:
        """Return what hours and retainer cost by what happened: all hours beyond those included, rounded once."""
        months = min(self.month, self.hours.months)
        beyond = [
            max(0, minutes - (self.hours.included_min if month <= self.hours.months else 0))
            for month, minutes in self.approved.items()
        ]
        assert max(beyond, default=0) <= self.hours.month_cap_min
        assert sum(beyond) <= self.hours.cap_min
        return months * self.hours.retainer_minor + int(
            Fraction(sum(beyond) * self.hours.rate_minor, 60) + Fraction(1, 2)
        )

    def hours_needed(self, together: Callable[[list[int]], int]) -> int:
        """Return the whole hours that months with what waits in them need, summed or the most of one."""
        minutes = dict(self.approved)
        for month, waiting in self.waiting:
            minutes[month] = minutes.get(month, 0) + waiting
        included = self.terms.retainer_hours * 60
        beyond = [
            max(0, of - (included if month <= self.terms.retainer_months else 0)) for month, of in minutes.items()
        ]
        return -(-together([0, *beyond]) // 60)

    def charge_months(self) -> list[Entry]:
        charged = {line.month_number for line in self.lines if line.kind is LineKind.RETAINER}
        today = month_begins_on(self.month, AGREED_ON)
        return [
            Entry(LineKind.RETAINER, self.hours.retainer_minor, "retainer", month_number=month)
            for month in self.hours.months_due(AGREED_ON, today, charged)
        ]

    def approve_hours(self, month: int, minutes: int) -> list[Entry]:
        amount_minor = self.hours.charge(month, minutes, self.approved)
        self.approved[month] = self.approved.get(month, 0) + minutes
        kind = LineKind.WORKED_HOURS
        return [Entry(kind, amount_minor, "hours", worked_day_id=uuid4())] if amount_minor else []

    def _share(self, cue: PricedCue) -> int:
        if cue.cut_in is not None:
            return rounded(cue.amount_minor, PARTS[cue.cut_in.value])
        if not cue.is_accepted:
            return 0
        siblings = [one for one in self.cues if one.milestone_id == cue.milestone_id]
        held = rounded(cue.amount_minor, self.rules.holdback_bp)
        is_released = self.rules.release is ReleaseClause.PER_CUE or all(sibling.is_settled for sibling in siblings)
        return (cue.amount_minor - held if is_released else 0) + (
            held if all(one.is_settled for one in self.cues) else 0
        )


class Lives(RuleBasedStateMachine):
    """Whatever the parties of some contracts may do, in any order."""

    @initialize(
        releases=st.lists(st.sampled_from(ReleaseClause), min_size=CONTRACTS, max_size=CONTRACTS),
        holdbacks=st.lists(st.sampled_from([0, 999, 3_333]), min_size=CONTRACTS, max_size=CONTRACTS),
        prices=st.lists(st.lists(st.integers(0, 99_999), min_size=CUES, max_size=CUES), min_size=2, max_size=2),
        set_off=st.lists(st.booleans(), min_size=CONTRACTS, max_size=CONTRACTS),
        bonuses=st.lists(st.sampled_from([0, 31_337]), min_size=CONTRACTS, max_size=CONTRACTS),
    )
    def agree(self, releases, holdbacks, prices, set_off, bonuses):
        self.lives = [
            Life(*given, is_set_off=is_set_off)
            for *given, is_set_off in zip(releases, holdbacks, prices, set_off, strict=True)
        ]
        for life, bonus_minor in zip(self.lives, bonuses, strict=True):
            life.bonus_minor = bonus_minor
            life.write(life.charge_months())

    def running(self, which: int) -> Life | None:
        life = self.lives[which % CONTRACTS]
        return None if life.is_ended else life

    def open_cue(self, life: Life, place: int) -> int | None:
        place %= len(life.cues)
        return None if life.cues[place].is_settled else place

    @rule(which=st.integers(0, 1), place=st.integers(0, 20))
    def accept(self, which, place):
        if (life := self.running(which)) and (at := self.open_cue(life, place)) is not None:
            life.change(at, is_accepted=True)

    @rule(which=st.integers(0, 1), place=st.integers(0, 20))
    def reverse(self, which, place):
        life = self.running(which)
        if life and life.cues[place % len(life.cues)].cut_in is None:
            life.change(place % len(life.cues), is_accepted=False)

    @rule(which=st.integers(0, 1), place=st.integers(0, 20), state=st.sampled_from(list(PARTS)))
    def cut(self, which, place, state):
        """Cut a cue on the list, or take it out by a change order: the ledger gets the same line."""
        if (life := self.running(which)) and (at := self.open_cue(life, place)) is not None:
            life.change(at, cut_in=WorkState(state))

    @rule(which=st.integers(0, 1), price=st.integers(0, 99_999), milestone=st.integers(0, 1))
    def add_cue(self, which, price, milestone):
        """A change order adds a cue; a milestone that is complete takes none."""
        if life := self.running(which):
            milestone_id = life.milestones[milestone]
            if any(not cue.is_settled for cue in life.cues if cue.milestone_id == milestone_id):
                life.cues.append(PricedCue(uuid4(), milestone_id, price))
                life.settle()

    @rule(which=st.integers(0, 1), place=st.integers(0, 20), price=st.integers(0, 99_999))
    def reprice(self, which, place, price):
        if (life := self.running(which)) and (at := self.open_cue(life, place)) is not None:
            life.change(at, amount_minor=price)

    @rule(which=st.integers(0, 1), place=st.integers(0, 20))
    def add_round(self, which, place):
        life = self.running(which)
        if life and (at := self.open_cue(life, place)) is not None:
            cue, price = life.cues[at], rounded(life.cues[at].amount_minor, ROUND_BP)
            if price:
                life.extras.append(price)
                number = len(life.extras)
                life.write([Entry(LineKind.EXTRA_ROUND, price, "rates", cue.cue_id, cue.milestone_id, None, number)])

    @rule(which=st.integers(0, 1), price=st.integers(1, 50_000))
    def add_work(self, which, price):
        if life := self.running(which):
            life.extras.append(price)
            life.write([Entry(LineKind.EXTRA_WORK, price, "changes", milestone_id=life.milestones[0])])

    @rule(which=st.integers(0, 1), month=st.integers(1, 9), minutes=st.integers(1, 700))
    def log_hours(self, which, month, minutes):
        """Log as many minutes of a month that has begun as the contract pays for."""
        if life := self.running(which):
            month = min(month, life.month)
            logged = dict(life.approved)
            for waiting_month, waiting in life.waiting:
                logged[waiting_month] = logged.get(waiting_month, 0) + waiting
            minutes = min(minutes, life.hours.left(month, logged))
            if minutes:
                life.waiting.append((month, minutes))

    @rule(which=st.integers(0, 1), place=st.integers(0, 20), agrees=st.booleans())
    def judge_hours(self, which, place, agrees):
        """Approve or refuse one entry, in any order."""
        if (life := self.running(which)) and life.waiting:
            entry = life.waiting.pop(place % len(life.waiting))
            if agrees:
                life.write(life.approve_hours(*entry))

    @rule(which=st.integers(0, 1), in_all=st.integers(1, 60), in_month=st.integers(1, 60))
    def set_caps(self, which, in_all, in_month):
        """A change order raises or lowers the caps, no lower than what is approved or waits."""
        if life := self.running(which):
            in_all, in_month = max(in_all, life.hours_needed(sum)), max(in_month, life.hours_needed(max))
            life.terms = replace(life.terms, hours_cap=in_all, hours_month_cap=in_month)

    @rule(which=st.integers(0, 1), times=st.integers(1, 3))
    def begin_month(self, which, times):
        """Begin a month; the job that charges it may run often."""
        if life := self.running(which):
            life.month += 1
            for _ in range(times):
                life.write(life.charge_months())

    @rule(which=st.integers(0, 1))
    def accept_all(self, which):
        """Accept every open cue: with the last one a bonus is due."""
        if life := self.running(which):
            for place, cue in enumerate(life.cues):
                if not cue.is_settled:
                    life.change(place, is_accepted=True)

    @invariant()
    def a_bonus_stands_once(self):
        for life in self.lives:
            standing = [line.amount_minor for line in life.book.standing(LineKind.BONUS)]
            assert standing == [amount for amount in [life.owed_bonus()] if amount]

    @rule(which=st.integers(0, 1), states=st.lists(st.sampled_from(list(PARTS)), min_size=20, max_size=20))
    def end(self, which, states):
        """Settle: what the statement says, then exactly that in the ledger."""
        if not (life := self.running(which)):
            return
        of = {cue.cue_id: WorkState(states[place % 20]) for place, cue in enumerate(life.cues) if not cue.is_settled}
        time = life.charge_months() + [entry for one in life.waiting for entry in life.approve_hours(*one)]
        life.waiting = []
        statement = statement_of(
            *(life.book, life.cues, of, life.rules),
            beside_cues_minor=life.beside_minor,
            deposit_is_set_off=life.is_set_off,
            time=time,
        )
        before = len(life.lines)
        life.write(list(statement.entries))
        life.cues = [cue if cue.is_settled else replace(cue, cut_in=of[cue.cue_id]) for cue in life.cues]
        life.is_ended = True
        assert figures_of(life.book, life.cues, life.beside_minor, is_ended=True) == statement.figures
        parts = (statement.cues_minor, statement.deposit_minor, statement.rounds_minor, statement.extra_minor)
        assert statement.hours_minor + statement.retainer_minor == life.owed_time()
        assert sum(parts) + life.owed_time() == statement.figures.accepted_minor
        assert [cue.owed_minor for cue in statement.cues] == [life._share(cue) for cue in life.cues]
        life.settle()
        assert len(life.lines) == before + len(statement.entries), "settled once, there is nothing more to write"

    @invariant()
    def the_ledger_is_what_the_model_says(self):
        for life in self.lives:
            owed = sum(line.amount_minor for line in life.book.owed)
            assert owed == life.owed_by_the_model()
            assert owed >= 0

    @invariant()
    def every_cent_is_somewhere(self):
        for life in self.lives:
            figures = figures_of(life.book, life.cues, life.beside_minor, is_ended=life.is_ended)
            together = figures.paid_minor + figures.due_minor + figures.open_minor + figures.saved_minor
            whole = (
                life.beside_minor + sum(cue.amount_minor for cue in life.cues) + sum(life.extras) + life.owed_bonus()
            )
            assert together == figures.agreed_minor == whole
            assert figures.open_minor >= 0
            assert figures.saved_minor >= 0
            if life.is_ended:
                assert figures.open_minor == 0


Lives.TestCase.settings = settings(max_examples=60, stateful_step_count=30)
TestLives = Lives.TestCase
