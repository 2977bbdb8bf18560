"""The caps of days and hours that a contract pays for, as a change order may set them."""

from collections.abc import Iterator
from dataclasses import dataclass

from sqlalchemy.orm import Session

from app.agreements.clauses.terms import MoneyTerms, PriceMode
from app.agreements.models import Contract
from app.agreements.plan.queries import milestones_of
from app.amendments.schemas import OrderCaps, SetCaps
from app.core.money import money
from app.money.ledger.rules import hours_in_words
from app.money.ledger.service import load_ledger_book
from app.money.work.rules import MINUTES
from app.money.work.service import day_rate_read
from app.money.work.worked_hours import HourBook

UNITS = {"hours_cap": "hour", "hours_month_cap": "hour", "days_cap": "day"}


@dataclass(frozen=True)
class Caps:
    """A contract whose caps of days and hours a change order may set."""

    session: Session
    contract: Contract
    terms: MoneyTerms

    def read(self) -> OrderCaps | None:
        """Return the caps as they stand; None where nothing is paid by the day or hour."""
        caps = OrderCaps(**{name: getattr(self.terms, name) if self._pays_by(name) else None for name in UNITS})
        return None if all(cap is None for cap in caps.model_dump().values()) else caps

    def problems(self, change: SetCaps) -> list[str]:
        """Return the faults of a change, each with a way on."""
        terms = change.terms
        for name in terms:
            if not self._pays_by(name):
                return [f"the contract does not pay by the {UNITS[name]}; {self._instead()}"]
        if all(cap == getattr(self.terms, name) for name, cap in terms.items()):
            return ["these caps hold already; give another number"]
        return [
            f"{used}; the cap can be {_many(name, least)} or more"
            for name, least, used in self._used()
            if terms.get(name, least) < least
        ]

    def sentence(self, change: SetCaps) -> str:
        """Return a change in words."""
        terms, parts = change.terms, []
        for name, tail in (("hours_cap", "in all"), ("hours_month_cap", "in a month"), ("days_cap", "in all")):
            was, cap = getattr(self.terms, name), terms.get(name)
            if cap is not None and cap != was:
                parts.append(f"{_many(name, cap)} {tail} instead of {was}")
        rate_minor = self.terms.day_rate_minor if "days_cap" in terms else self.terms.hour_rate_minor
        unit = "a day" if "days_cap" in terms else "an hour"
        return f"At most {' and '.join(parts)} are paid, at {money(rate_minor, self.contract.currency)} {unit}."

    def added_minor(self, change: SetCaps) -> int:
        """Return the growth of the contract's highest possible cost."""
        return MoneyTerms.of(self.terms.to_dict() | change.terms).time_cap_minor - self.terms.time_cap_minor

    def _pays_by(self, name: str) -> bool:
        if name == "days_cap":
            return self.terms.price_mode is PriceMode.DAY_RATE
        return self.terms.hour_rate_minor > 0

    def _instead(self) -> str:
        milestones = milestones_of(self.session, self.contract.id)
        has_milestone = any(not milestone.is_deposit for milestone in milestones)
        return "add work to a milestone instead" if has_milestone else "sign another contract for it"

    def _used(self) -> Iterator[tuple[str, int, str]]:
        """Yield each cap with the least that it can be, and what counts towards it already."""
        if self._pays_by("hours_cap"):
            counted, in_one_month = HourBook(self.session, self.contract).counted()
            in_all = f"{hours_in_words(counted)} count towards the cap already"
            in_month = f"{hours_in_words(in_one_month)} of one month count towards the cap already"
            yield "hours_cap", -(-counted // MINUTES), in_all
            yield "hours_month_cap", -(-in_one_month // MINUTES), in_month
        by_day = day_rate_read(self.terms, load_ledger_book(self.session, self.contract))
        if by_day is not None and by_day.day_rate_minor:
            agreed = f"days for {money(by_day.agreed_minor, self.contract.currency)} are agreed to"
            yield "days_cap", -(-by_day.agreed_minor // by_day.day_rate_minor), agreed


def _many(name: str, number: int) -> str:
    return f"{number} {UNITS[name]}{'' if number == 1 else 's'}"
