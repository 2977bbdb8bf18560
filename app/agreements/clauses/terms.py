"""The figures that a contract's clauses leave open, as money is calculated by them."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from enum import StrEnum
from typing import Any

from app.agreements.clauses.rules import BY_DAY
from app.agreements.rules import WorkState


class DepositAtEnd(StrEnum):
    """The fate of the deposit where a contract ends early."""

    STAYS = "stays"  # with the designer
    SET_OFF = "set_off"  # against what the cues are owed


class SourcesNeeded(StrEnum):
    """The time by which a sound's sources are stated."""

    ASKED = "asked"  # nothing waits for them
    BEFORE_ACCEPTANCE = "before_acceptance"
    BEFORE_INVOICE = "before_invoice"


class SourceFiles(StrEnum):
    """The owner of session, layers and recipe of an approved file."""

    KEPT = "kept"  # by the designer
    HANDED_OVER = "handed_over"  # to the studio


class DownloadsOpen(StrEnum):
    """The time from which the studio downloads masters and game files."""

    AT_ONCE = "at_once"
    WHEN_PAID = "when_paid"  # what is due for an accepted cue


class BonusWhen(StrEnum):
    """The trigger of a bonus."""

    OTHER = "other"  # in the parties' own words, and theirs to see to
    ON_TIME = "on_time"  # every cue is accepted by the date of its milestone
    NO_REJECTED_TAKE = "no_rejected_take"  # every cue is accepted without a round of changes
    SHIPPED = "shipped"  # the studio says that the game has shipped


class PriceMode(StrEnum):
    """The way a contract's price comes about."""

    FLAT = "flat"  # a milestone's amount, shared by its cues
    PER_CUE = "per_cue"  # a price for each cue, which its milestone adds up
    DAY_RATE = BY_DAY  # days worked, up to a number of them


@dataclass(frozen=True)
class KillFees:
    """The fees for a cut cue, in basis points of its price, by the state of work; an accepted one is owed whole."""

    not_begun_bp: int = 0
    in_work_bp: int = 5_000
    delivered_bp: int = 7_500

    def of(self, state: WorkState) -> int:
        """Return the basis points owed for a cue that was cut in this state."""
        return {
            WorkState.NOT_BEGUN: self.not_begun_bp,
            WorkState.IN_WORK: self.in_work_bp,
            WorkState.DELIVERED: self.delivered_bp,
            WorkState.ACCEPTED: 10_000,
        }[state]


@dataclass(frozen=True)
class MoneyTerms:
    """The terms that decide over amounts; where a text does not say it, nothing is owed by it."""

    price_mode: PriceMode = PriceMode.FLAT
    rounds_included: int = 2
    extra_round_bp: int = 0  # of the cue's price
    kill_fee_not_begun_bp: int = 0
    kill_fee_in_work_bp: int = 0
    kill_fee_delivered_bp: int = 0
    payment_days: int = 14
    tax_bp: int = 0
    reverse_charge: bool = False  # the studio owes the tax where it is; none is invoiced
    day_rate_minor: int = 0
    days_cap: int = 0
    hour_rate_minor: int = 0
    hours_cap: int = 0  # paid by the hour, in all
    hours_month_cap: int = 0  # paid by the hour, in a month of the contract
    retainer_minor: int = 0  # a month
    retainer_hours: int = 0  # included in a month
    retainer_months: int = 0
    po_number: str = ""  # what invoices begin with
    notice_days: int | None = None  # None: it ends early only where both agree
    deposit_at_end: DepositAtEnd = DepositAtEnd.STAYS
    sources_needed: SourcesNeeded = SourcesNeeded.ASKED
    source_files: SourceFiles = SourceFiles.KEPT
    downloads_open: DownloadsOpen = DownloadsOpen.AT_ONCE
    late_interest_monthly_bp: int = 0  # of what is open of an invoice after its day
    bonus_minor: int = 0
    bonus_when: BonusWhen = BonusWhen.OTHER

    @classmethod
    def of(cls, terms: Mapping[str, Any]) -> "MoneyTerms":
        """Read the terms of a version; what it does not say is the default, and what is no matter of money is left."""
        given_terms = {field.name: terms[field.name] for field in fields(cls) if terms.get(field.name) is not None}
        if "price_mode" in given_terms:
            given_terms["price_mode"] = PriceMode(given_terms["price_mode"])
        if given_terms.get("notice_days") == "":
            del given_terms["notice_days"]  # its clause is struck
        if "deposit_at_end" in given_terms:
            given_terms["deposit_at_end"] = DepositAtEnd(given_terms["deposit_at_end"])
        if "sources_needed" in given_terms:
            given_terms["sources_needed"] = SourcesNeeded(given_terms["sources_needed"])
        if "source_files" in given_terms:
            given_terms["source_files"] = SourceFiles(given_terms["source_files"])
        if "downloads_open" in given_terms:
            given_terms["downloads_open"] = DownloadsOpen(given_terms["downloads_open"])
        if "bonus_when" in given_terms:
            given_terms["bonus_when"] = BonusWhen(given_terms["bonus_when"])
        if "reverse_charge" in given_terms:
            given_terms["reverse_charge"] = bool(
                given_terms["reverse_charge"]
            )  # 0 or 1 where only numbers and text are kept
        return cls(**given_terms)

    def to_dict(self) -> dict[str, Any]:
        """Return the terms as a version keeps them."""
        return asdict(self) | {"price_mode": self.price_mode.value}

    @property
    def kill_fees(self) -> KillFees:
        """Return the fees for a cut cue by the state of its work."""
        return KillFees(self.kill_fee_not_begun_bp, self.kill_fee_in_work_bp, self.kill_fee_delivered_bp)

    @property
    def days_cap_minor(self) -> int:
        """Return the cost cap of all days together."""
        return self.day_rate_minor * self.days_cap if self.price_mode is PriceMode.DAY_RATE else 0

    @property
    def has_hours(self) -> bool:
        """Whether work is counted in hours."""
        return self.hours_cap_minor > 0 or self.retainer_total_minor > 0

    @property
    def hours_cap_minor(self) -> int:
        """Return the cost cap of all hours beyond those that a retainer includes."""
        return self.hour_rate_minor * self.hours_cap

    @property
    def retainer_total_minor(self) -> int:
        """Return the cost of the retainer of all months."""
        return self.retainer_minor * self.retainer_months

    @property
    def time_cap_minor(self) -> int:
        """Return the cost cap of all days, hours and months of a retainer together."""
        return self.days_cap_minor + self.hours_cap_minor + self.retainer_total_minor

    @property
    def invoiced_tax_bp(self) -> int:
        """The rate that invoices carry."""
        return 0 if self.reverse_charge else self.tax_bp
