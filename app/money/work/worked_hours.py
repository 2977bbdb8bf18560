"""The hours of one contract by its months: what was logged and approved, and what the contract pays for."""

from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.terms import PriceMode
from app.agreements.models import Contract
from app.agreements.plan.queries import milestones_of, terms_of
from app.core import clock
from app.core.plural import day_in_words
from app.money import queries
from app.money.bonuses.service import studio_days
from app.money.errors import CapExceeded, NotHourly
from app.money.ledger.book import CLAUSES, Entry, LedgerBook
from app.money.ledger.rules import LineKind, hours_in_words
from app.money.models import WorkedDay
from app.money.work.rules import HourTerms, Minutes, month_begins_on, month_of
from app.money.work.schemas import HoursMonthRead, HoursRead


class HourBook:
    """The hours of an agreed contract against its terms; callers that write hold the contract's lock."""

    def __init__(self, session: Session, contract: Contract) -> None:
        self._session, self.contract = session, contract
        self.money_terms = terms_of(session, contract)
        self.terms = HourTerms.of(self.money_terms)
        days = studio_days(session, contract)
        self.today = days.of(clock.now())
        self.agreed_on = days.of(contract.agreed_at) if contract.agreed_at else self.today
        logged = queries.worked_days_of(session, contract.id) if self.money_terms.has_hours else ()
        self.entries: Sequence[WorkedDay] = [day for day in logged if day.minutes is not None]

    def month_of(self, day: date) -> int:
        """Return the month of the contract in which a day is."""
        return month_of(day, self.agreed_on)

    @property
    def approved(self) -> Minutes:
        """The approved minutes by month."""
        return self._by_month(entry for entry in self.entries if entry.agreed_at is not None)

    @property
    def waiting(self) -> list[WorkedDay]:
        """Return work neither approved nor refused by the studio, in the order of its days."""
        return [entry for entry in self.entries if entry.agreed_at is None and entry.refused_at is None]

    def counted(self) -> tuple[int, int]:
        """Return the minutes that count towards the cap of all hours, and the most of one month."""
        minutes = self._by_month(entry for entry in self.entries if entry.refused_at is None)
        months = [self.terms.paid_in(month, of_it) for month, of_it in minutes.items()]
        return self.terms.paid(minutes), max(months, default=0)

    def _by_month(self, entries: Iterator[WorkedDay]) -> Minutes:
        minutes: Counter[int] = Counter()
        for entry in entries:
            minutes[self.month_of(entry.worked_on)] += entry.minutes or 0
        return minutes

    def ensure_paid(self, worked_on: date, minutes: int, *, instead_of: UUID | None = None) -> None:
        """Raise NotHourly for a contract without hours, CapExceeded beyond what is included and the caps."""
        if not self.money_terms.has_hours:
            by_day = self.money_terms.price_mode is PriceMode.DAY_RATE
            instead = "log days instead" if by_day else more_work(self._session, self.contract)
            raise NotHourly("this contract does not pay by the hour", fix=instead)
        others = self._by_month(entry for entry in self.entries if entry.refused_at is None and entry.id != instead_of)
        month = self.month_of(worked_on)
        left = self.terms.left(month, others)
        if minutes > left:
            raise CapExceeded(
                f"{hours_in_words(minutes)} on {day_in_words(worked_on)} is more than the contract pays for: "
                f"{self._limits()}; "
                f"{hours_in_words(left)} left in this month",
                fix=(f"log up to {hours_in_words(left)}, and " if left else "") + self._more_hours(),
            )

    def _more_hours(self) -> str:
        if self.terms.cap_min:
            return "propose a change order that raises the caps of hours"
        return more_work(self._session, self.contract)

    def _limits(self) -> str:
        terms, limits = self.terms, []
        if terms.included_min and terms.months:
            limits.append(f"{hours_in_words(terms.included_min)} a month are included")
        if terms.cap_min:
            caps = f"{hours_in_words(terms.month_cap_min)} a month and {hours_in_words(terms.cap_min)} in all"
            limits.append(f"at most {caps} are paid by the hour")
        return ", ".join(limits)

    def charge(self, day: WorkedDay, approved: Minutes) -> int:
        """Return the cost of an entry once it is approved after others."""
        return self.terms.charge(self.month_of(day.worked_on), day.minutes or 0, approved)

    def entries_at_end(self, book: LedgerBook) -> list[Entry]:
        """Return the entries due at an early end: hours that nobody has refused, and the months that have begun."""
        approved, entries = Counter(self.approved), self.retainer_entries(book)
        for day in self.waiting:
            amount_minor = self.charge(day, approved)
            approved[self.month_of(day.worked_on)] += day.minutes or 0
            entries += hour_entries(day, amount_minor)
        return entries

    def retainer_entries(self, book: LedgerBook) -> list[Entry]:
        """Return the months of the retainer that have begun and are not in the ledger."""
        charged = {line.month_number for line in book.lines if line.kind is LineKind.RETAINER}
        months = self.terms.months_due(self.agreed_on, self.today, {month for month in charged if month is not None})
        kind = LineKind.RETAINER
        return [Entry(kind, self.terms.retainer_minor, CLAUSES[kind], month_number=month) for month in months]

    def read(self) -> HoursRead | None:
        """Return hours and retainer as both parties see them; None where the contract has none."""
        if not self.money_terms.has_hours:
            return None
        approved, waiting = self.approved, self._by_month(iter(self.waiting))
        last = max([self.month_of(self.today), *approved, *waiting])
        return HoursRead(
            rate_minor=self.terms.rate_minor,
            cap_min=self.terms.cap_min,
            month_cap_min=self.terms.month_cap_min,
            paid_min=self.terms.paid(approved),
            retainer_minor=self.terms.retainer_minor if self.money_terms.retainer_total_minor else 0,
            included_min=self.terms.included_min,
            retainer_months=self.terms.months if self.money_terms.retainer_total_minor else 0,
            months=[
                HoursMonthRead(
                    number=month,
                    begins_on=month_begins_on(month, self.agreed_on),
                    is_retained=month <= self.terms.months and self.terms.retainer_minor > 0,
                    approved_min=approved.get(month, 0),
                    waiting_min=waiting.get(month, 0),
                    left_min=self.terms.left(month, Counter(approved) + Counter(waiting)),
                )
                for month in range(max(1, last - 11), last + 1)
            ],
        )


def more_work(session: Session, contract: Contract) -> str:
    """Return the way to agree on work that a contract does not pay for."""
    if any(not milestone.is_deposit for milestone in milestones_of(session, contract.id)):
        return "propose a change order that adds the work at its price"
    return "sign another contract for it"


def hour_entries(day: WorkedDay, amount_minor: int) -> list[Entry]:
    """Return the entry for an approved entry of hours; none where the retainer includes it."""
    kind = LineKind.WORKED_HOURS
    if not amount_minor:
        return []
    return [Entry(kind, amount_minor, CLAUSES[kind], cue_id=day.cue_id, worked_day_id=day.id)]
