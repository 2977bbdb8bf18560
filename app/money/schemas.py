"""Inputs and answers of the money endpoints; every amount is in whole minor units of the contract's currency."""

from collections.abc import Sequence
from datetime import date, datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import Field, StringConstraints

from app.agreements.clauses.terms import BonusWhen
from app.agreements.rules import ContractState, WorkState
from app.core.web.http import Schema
from app.money.bonuses.rules import BonusState
from app.money.estimates.rules import Habit
from app.money.ledger.rules import LineKind

LARGEST_MINOR = 10**12
Minor = Annotated[int, Field(ge=0, le=LARGEST_MINOR)]
Words = Annotated[str, Field(max_length=2_000)]
ShortWords = Annotated[str, Field(max_length=200)]
InvoiceNumber = Annotated[str, StringConstraints(strip_whitespace=True, max_length=40, pattern=r"^[^\x00-\x1f\x7f]*$")]


class ContractedCue(Schema):
    """A cue of the list as contracts name it."""

    id: UUID
    label: str
    name: str


class PlannedCueSet(Schema):
    """A cue of a planned milestone; prices, where given, are the weights of its shares."""

    cue_id: UUID
    price_minor: Minor | None = None
    estimate_min: Annotated[int, Field(ge=1, le=1_000_000)] | None = None


class MilestoneSet(Schema):
    """A planned milestone; without an amount, the prices of its cues add up to it."""

    name: Annotated[str, Field(min_length=1, max_length=200)]
    amount_minor: Minor | None = None
    due_on: date | None = None
    is_deposit: bool = False
    tax_bp: Annotated[int, Field(ge=0, le=10_000)] | None = None
    cues: Annotated[list[PlannedCueSet], Field(max_length=2_000, default_factory=list)]


class PlanSet(Schema):
    """The whole plan of a draft."""

    milestones: Annotated[list[MilestoneSet], Field(max_length=100)]


class ProposedMilestoneRead(Schema):
    """A milestone to begin from."""

    name: str
    due_on: date | None
    is_deposit: bool
    amount_minor: int | None
    cue_ids: Sequence[UUID]


class PlanProposal(Schema):
    """Milestones over the cues that no agreed contract covers, in order."""

    milestones: Sequence[ProposedMilestoneRead]


class MilestoneCueRead(Schema):
    """A cue under contract: what was agreed for it and what happened to it."""

    cue: ContractedCue
    price_minor: int | None
    amount_minor: int | None
    estimate_min: int | None
    accepted_at: datetime | None
    cut_in: WorkState | None
    owed_minor: int
    paid_minor: int


class MilestoneRead(Schema):
    """A milestone; `left_minor` is its amount without what cuts saved."""

    id: UUID
    name: str
    is_deposit: bool
    amount_minor: int
    left_minor: int
    owed_minor: int
    paid_minor: int
    due_on: date | None
    tax_bp: int | None
    accepted: int
    wanted: int
    done_at: datetime | None
    cues: Sequence[MilestoneCueRead]


class AdviceRead(Schema):
    """One warning about a plan."""

    code: str
    message: str
    why: str
    subject: str = Field(description="The name of the milestone that it is about; empty: the whole plan.")


class PlanFault(Schema):
    """A fault of a plan: `milestones.0` is its first one, `milestones` all of it."""

    where: str
    message: str


class PriceRead(Schema):
    """The total of a plan, with its deposit in it, beside the bid that its contract began from."""

    total_minor: int
    deposit_minor: int = Field(description="A part of the total.")
    bid_minor: int | None = Field(description="Null: the contract began from no bid.")
    bid_currency: str | None
    above_bid_minor: int | None = Field(description="Negative below the bid; null where it is in another currency.")


class ConceptsRead(Schema):
    """The cues of a plan that are an idea still: what is ordered for them may change or go."""

    count: int
    cues: int = Field(description="Of how many cues in the plan.")
    amount_minor: int = Field(description="What the plan pays for them.")


class PlanChecked(Schema):
    """The errors and warnings of a plan that is not saved."""

    faults: Sequence[PlanFault]
    advice: Sequence[AdviceRead]
    price: PriceRead
    concepts: ConceptsRead


class PlanRead(Schema):
    """The milestones of a contract, and the warnings about them."""

    contract_id: UUID
    state: ContractState
    currency: str
    milestones: Sequence[MilestoneRead]
    advice: Sequence[AdviceRead]
    price: PriceRead
    concepts: ConceptsRead


class FiguresRead(Schema):
    """The figures of a contract without tax; paid, due, open and saved add up to agreed."""

    agreed_minor: int
    accepted_minor: int
    paid_minor: int
    due_minor: int
    open_minor: int
    saved_minor: int


class LedgerLineRead(Schema):
    """One line of a ledger: why, how much, by which clause, for which cue, and whose act it follows."""

    id: UUID
    at: datetime
    kind: LineKind
    amount_minor: int
    clause: str
    cue: ContractedCue | None
    milestone_id: UUID | None
    milestone: str | None
    round_number: int | None
    tax_bp: int | None
    by: str
    about_id: UUID | None
    invoice_id: UUID | None
    invoice_number: str | None
    reference: str | None


class BonusRead(Schema):
    """The bonus of a contract, and what happened to it."""

    amount_minor: int
    when: BonusWhen
    state: BonusState | None = Field(description="Null for a trigger in the parties' own words, which they see to.")
    because: str = Field(description="Why it is so; of a trigger in the parties' own words, these.")


class Shipped(Schema):
    """The day on which the game shipped."""

    shipped_on: date


class LedgerRead(Schema):
    """A contract's ledger in the order of its writing, and what it comes to."""

    contract_id: UUID
    currency: str
    figures: FiguresRead
    tax_minor: int
    open_tax_minor: int
    bonus: BonusRead | None
    lines: Sequence[LedgerLineRead]


class InvoiceLineRead(Schema):
    """One line of an invoice."""

    text: str
    amount_minor: int
    tax_bp: int | None


class TaxRead(Schema):
    """The tax of one rate on an invoice."""

    tax_bp: int
    amount_minor: int


class InvoiceDraft(Schema):
    """The content of an invoice if it were issued now."""

    contract_id: UUID
    currency: str
    number: int
    full_number: str
    number_advice: str
    is_number_taken: bool
    seller: str
    buyer: str
    po_number: str
    reverse_charge: bool
    payment_days: int
    lines: Sequence[InvoiceLineRead]
    taxes: Sequence[TaxRead]
    net_minor: int
    total_minor: int


class InvoiceIssue(Schema):
    """Number, sender and recipient; the lines are everything that is due and on no invoice yet.

    Without a number the invoice gets the one after the designer's last.
    """

    full_number: InvoiceNumber = ""
    seller: Words
    buyer: Words = ""
    po_number: ShortWords = ""
    note: Words = ""


class PaymentRead(Schema):
    """A payment or, below zero, a refund."""

    id: UUID
    amount_minor: int
    reference: str
    paid_on: date
    refund_of_id: UUID | None
    left_minor: int


class InvoiceRead(Schema):
    """An invoice with its lines and what was paid on it."""

    id: UUID
    contract_id: UUID
    number: int
    full_number: str
    currency: str
    issued_on: date
    due_on: date
    seller: str
    buyer: str
    po_number: str
    note: str
    reverse_charge: bool
    lines: Sequence[InvoiceLineRead]
    taxes: Sequence[TaxRead]
    net_minor: int
    total_minor: int
    paid_minor: int
    open_minor: int
    state: Literal["open", "partly_paid", "paid", "late"]
    days_to_pay: int | None
    late_interest_minor: int = Field(description="What it bears by today, by the contract's clause on late payment.")
    late_interest_charged_minor: int = Field(description="What of it is charged already.")
    payments: Sequence[PaymentRead]


class PaymentAdd(Schema):
    """Money that changed hands; below zero on a credit note."""

    amount_minor: Annotated[int, Field(ge=-LARGEST_MINOR, le=LARGEST_MINOR)]
    reference: Annotated[str, Field(min_length=1, max_length=200)]
    paid_on: date


class ExtraRoundRead(Schema):
    """A round beyond the included ones, and its price."""

    id: UUID
    contract_id: UUID
    cue: ContractedCue
    number: int
    included: int
    amount_minor: int
    currency: str
    state: Literal["proposed", "agreed", "dropped"]
    proposed_at: datetime


class WorkLogAdd(Schema):
    """Time that went into a cue."""

    cue_id: UUID
    minutes: Annotated[int, Field(ge=1, le=24 * 60)]
    worked_on: date


class EstimateRead(Schema):
    """An estimate of a cue in minutes, or of a milestone in days; the actual is None until it is done."""

    about_id: UUID
    name: str
    estimate: float
    so_far: float
    actual: float | None
    error_percent: float | None


class HabitRead(Schema):
    """The outcome of estimates: mean error in percent, its spread in points, and the usefulness of that."""

    pairs: int
    mean_percent: float | None
    spread_points: float | None
    habit: Habit


class ForecastRead(Schema):
    """The day that a steady habit makes of a milestone's date."""

    milestone_id: UUID
    milestone: str
    due_on: date
    forecast_on: date


class PayPerHour(Schema):
    """The fee of a contract divided by hours; a figure is null without hours."""

    currency: str
    fee_minor: int = Field(description="Of all milestones as agreed.")
    estimated_min: int
    logged_min: int = Field(description="For the cues of the contract, before and under it.")
    own_min: int = Field(description="Of these, logged without a contract, which nobody else sees.")
    by_estimate_minor: int | None
    by_log_minor: int | None


class EstimatesRead(Schema):
    """Estimates of cues in minutes and of milestones in days, against actual values."""

    cues: Sequence[EstimateRead]
    milestones: Sequence[EstimateRead]
    cue_habit: HabitRead
    milestone_habit: HabitRead
    forecasts: Sequence[ForecastRead]
    warning: str | None
    pay: PayPerHour | None = Field(default=None, description="What an hour earns; for the designer alone.")


class CalendarLinkMade(Schema):
    """The address of a calendar; its secret is shown this once."""

    url: str


class CueMoneyRead(Schema):
    """A contract's terms for one cue, and the effect of accepting it now."""

    contract_id: UUID
    currency: str
    milestone: str
    amount_minor: int
    would_owe_minor: int
    would_take_back_minor: int = Field(
        description="What is no longer due once a change of an approved version is sent; 0 until the cue is accepted."
    )
    accepted: int
    accepted_then: int
    wanted: int
    rounds_included: int
    extra_round_minor: int
    extra_rounds: Sequence[ExtraRoundRead]
