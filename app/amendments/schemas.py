"""Requests and answers of amendment endpoints; every amount is in whole minor units of the contract's currency."""

from datetime import date, datetime
from typing import Annotated, Literal, Self
from uuid import UUID

from pydantic import Field, StringConstraints, TypeAdapter, model_validator

from app.accounts.schemas import PersonBrief
from app.agreements.clauses.terms import DepositAtEnd
from app.agreements.rules import Party, WorkState
from app.agreements.schemas import BlockRead, Reason, Stroke
from app.amendments.offer_rules import OfferKind
from app.amendments.rules import ChangeOrderState
from app.core.web.http import Schema
from app.money.schemas import LARGEST_MINOR, AdviceRead, ContractedCue, FiguresRead, Minor

ShortProse = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=200)]


class OrderMilestone(Schema):
    """A milestone that a change order may name."""

    id: UUID
    name: str
    due_on: date | None


class OrderCue(Schema):
    """A cue under the contract that a change order may name."""

    cue: ContractedCue
    price_minor: int
    round_minor: int = Field(description="What a further round of it costs; 0: the contract names no price.")


class OrderCaps(Schema):
    """The caps of days and hours that a change order may set; null: the contract pays nothing by it."""

    hours_cap: int | None
    hours_month_cap: int | None
    days_cap: int | None


class NoticeAdd(Schema):
    """The reason to end a contract, and its last day: the earliest that the contract allows where none is given."""

    reason: Reason
    ends_on: date | None = None


class NoticeRead(Schema):
    """A party's notice."""

    number: int
    party: Party
    given_by: str
    given_at: datetime
    reason: str
    ends_on: date | None = Field(description="Last day; null: it ends only when both agree to the statement.")


class StatedCueRead(Schema):
    """A cue in the statement: how far its work is, which part of its price that makes, and by which clause."""

    cue: ContractedCue
    milestone: str
    state: WorkState
    was_cut: bool = Field(description="It was cut before the contract ended.")
    price_minor: int
    part_bp: int
    owed_minor: int
    clause: str


class OpenPointRead(Schema):
    """Work that the studio has not agreed to yet, so the statement does not count it."""

    kind: Literal["round", "day"]
    text: str
    amount_minor: int


class SignedRead(Schema):
    """A party's yes to a text."""

    party: Party
    name: str
    drawing: list[Stroke] | None = Field(description="The name as it was drawn; null: it was not.")
    accepted_at: datetime


class AddCue(Schema):
    """A cue that the contract covers from now on."""

    kind: Literal["add_cue"]
    cue_id: UUID
    milestone_id: UUID
    price_minor: Minor
    estimate_min: Annotated[int, Field(ge=1, le=1_000_000)] | None = None


class CutCue(Schema):
    """A cue that the contract no longer covers: it is owed by the state of its work when both have agreed."""

    kind: Literal["cut_cue"]
    cue_id: UUID


class RepriceCue(Schema):
    """Another price of a cue."""

    kind: Literal["reprice_cue"]
    cue_id: UUID
    price_minor: Minor


class AddRound(Schema):
    """A round beyond those included, by the part of the cue's price that the contract names."""

    kind: Literal["add_round"]
    cue_id: UUID


class MoveDate(Schema):
    """Another date of a milestone."""

    kind: Literal["move_date"]
    milestone_id: UUID
    due_on: date


class AddWork(Schema):
    """Work beside the cues at a price, due when both have agreed: rush, a voice session, a new target."""

    kind: Literal["add_work"]
    milestone_id: UUID
    text: ShortProse
    amount_minor: Annotated[int, Field(ge=1, le=LARGEST_MINOR)]


class SetCaps(Schema):
    """Other caps of what is paid by the hour or by the day; what is null stays."""

    kind: Literal["set_caps"]
    hours_cap: Annotated[int, Field(ge=1, le=10_000)] | None = Field(None, description="Hours at most in all.")
    hours_month_cap: Annotated[int, Field(ge=1, le=744)] | None = Field(None, description="Hours at most in a month.")
    days_cap: Annotated[int, Field(ge=1, le=1_000)] | None = Field(None, description="Days at most in all.")

    @model_validator(mode="after")
    def _names_a_cap(self) -> Self:
        if not self.terms:
            raise ValueError("name the cap that changes: hours_cap, hours_month_cap or days_cap")
        return self

    @property
    def terms(self) -> dict[str, int]:
        """The terms of the contract that it sets."""
        caps = {"hours_cap": self.hours_cap, "hours_month_cap": self.hours_month_cap, "days_cap": self.days_cap}
        return {name: cap for name, cap in caps.items() if cap is not None}


Change = Annotated[AddCue | CutCue | RepriceCue | AddRound | MoveDate | AddWork | SetCaps, Field(discriminator="kind")]
CHANGES: TypeAdapter[list[Change]] = TypeAdapter(list[Change])

OfferKey = Annotated[str, StringConstraints(min_length=1, max_length=120, pattern="^[a-z0-9:-]+$")]


class OfferedChange(Schema):
    """The form's first content where a change order is offered; a null is for the party to say."""

    kind: Literal["add_cue", "reprice_cue", "add_round", "move_date", "add_work"]
    cue_id: UUID | None = None
    milestone_id: UUID | None = None
    text: str = ""
    due_on: date | None = None


class OfferDismissed(Schema):
    """That the other party wants no change order for it."""

    party: Party
    by: str
    at: datetime
    reason: str


class ChangeOfferRead(Schema):
    """Something that changed since both signed, and that no change order says yet."""

    offer: str = Field(description="Names it for good, in a proposal or when it is dismissed.")
    kind: OfferKind
    text: str
    who: str = Field(description="Whose act it was; empty where that is not known.")
    at: datetime
    change: OfferedChange
    dismissed: OfferDismissed | None = Field(description="The other party dismissed it.")


class OfferDismiss(Schema):
    """A change that a party wants no order for, and the reason."""

    offer: OfferKey
    reason: Reason


class ChangeOrderAdd(Schema):
    """A party's proposal, and its reason."""

    reason: Reason
    begins_at_once: bool = Field(
        default=False, description="Work begins before both have agreed, at the risk of the party that proposes."
    )
    changes: Annotated[list[Change], Field(min_length=1, max_length=200)]
    offers: Annotated[list[OfferKey], Field(max_length=200)] = Field(
        default=[], description="The offers that it takes up; one that is settled already is left out."
    )


class ChangedMilestone(Schema):
    """A milestone before and after."""

    name: str
    is_deposit: bool
    amount_before_minor: int
    amount_after_minor: int
    due_before: date | None
    due_after: date | None


class ChangesSet(Schema):
    """Changes to look at before one proposes them."""

    changes: Annotated[list[Change], Field(min_length=1, max_length=200)]


class DifferenceRead(Schema):
    """The effects of a change order on scope, price and dates, and on the check of the plan."""

    changes: list[str] = Field(description="Each change as a sentence.")
    cues_before: int
    cues_after: int
    price_before_minor: int
    price_after_minor: int
    milestones: list[ChangedMilestone]
    warnings: list[AdviceRead] = Field(description="What the change order itself makes harder.")
    advice: list[AdviceRead] = Field(description="Warnings about the plan that the change adds or makes worse.")
    advice_gone: list[AdviceRead] = Field(description="Warnings that the change resolves.")


class ChangeOrderMay(Schema):
    """The caller's permitted actions on a change order now."""

    agree: bool
    refuse: bool
    withdraw: bool


class ChangeOrderRead(Schema):
    """A change order."""

    number: int
    state: ChangeOrderState
    party: Party
    proposed_by: str
    proposed_at: datetime
    reason: str
    begins_at_once: bool
    closed_at: datetime | None
    close_reason: str
    text_sha256: str
    blocks: list[BlockRead]
    difference: DifferenceRead | None = Field(description="Null once it is closed: the text says what it was.")
    problems: list[str] = Field(description="Why it could not be agreed to as it stands.")
    signed: list[SignedRead]
    signatures_needed: int = Field(description="The designer's, and those of the studio's signers.")
    may: ChangeOrderMay


class ChangeOrdersRead(Schema):
    """The change orders of a contract, and what one may name."""

    project_id: UUID
    contract_id: UUID
    title: str
    currency: str
    my_party: Party | None
    may_propose: bool
    extra_round_bp: int
    orders: list[ChangeOrderRead]
    offers: list[ChangeOfferRead] = Field(
        description="What changed since both signed, the newest first; for the two parties only."
    )
    milestones: list[OrderMilestone] = Field(description="Open milestones, whose dates can move.")
    cues: list[OrderCue] = Field(description="Cues under the contract that are not settled.")
    caps: OrderCaps | None = Field(description="What it may set; null: nothing is paid by the day or hour.")
    cues_to_add: list[ContractedCue] = Field(description="Cues of the list that no running contract covers.")


class ChangePreview(Schema):
    """The effects of a change order, and its faults; nothing is saved."""

    difference: DifferenceRead | None
    problems: list[str]


class ReasonGiven(Schema):
    """The reason to refuse or withdraw a change order."""

    reason: Reason


class EndingMay(Schema):
    """The caller's permitted actions on an early end now."""

    give_notice: bool
    withdraw: bool
    agree: bool


class EndingRead(Schema):
    """The outcome of a contract's early end: a forecast, then a statement, then the settlement."""

    project_id: UUID
    contract_id: UUID
    title: str
    designer: PersonBrief
    currency: str
    my_party: Party | None
    state: Literal["forecast", "notice", "settled"]
    notice: NoticeRead | None
    notice_days: int | None = Field(description="Null: no clause lets one party end it alone.")
    earliest_ends_on: date | None
    deposit_at_end: DepositAtEnd
    cues: list[StatedCueRead]
    cues_minor: int
    deposit_minor: int
    rounds_minor: int
    extra_minor: int
    days_minor: int
    hours_minor: int = Field(description="Hours that wait for the studio and were not refused included.")
    retainer_minor: int = Field(description="Of the months that have begun.")
    due_now_minor: int = Field(description="What is due without the settlement.")
    figures: FiguresRead
    open_points: list[OpenPointRead]
    statement_sha256: str | None = Field(description="Null while it is a forecast.")
    settled_at: datetime | None
    signed: list[SignedRead]
    signatures_needed: int = Field(description="The designer's, and those of the studio's signers.")
    may: EndingMay
