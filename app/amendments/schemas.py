"""What the endpoints of amendments take and answer; every amount is in whole minor units of the contract's currency."""

from datetime import date, datetime
from typing import Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.agreements.rules import Party, WorkState
from app.agreements.schemas import Reason
from app.agreements.terms import DepositAtEnd
from app.kit.http import Schema
from app.money.schemas import ContractedCue, FiguresRead


class NoticeAdd(Schema):
    """Why a contract ends, and its last day: the earliest that the contract allows where none is given."""

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
    accepted_at: datetime


class EndingMay(Schema):
    """What the caller may do about an early end now."""

    give_notice: bool
    withdraw: bool
    agree: bool


class EndingRead(Schema):
    """What a contract comes to if it ends early: a forecast, then a statement, then what was settled."""

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
    days_minor: int
    due_now_minor: int = Field(description="What is due without the settlement.")
    figures: FiguresRead
    open_points: list[OpenPointRead]
    statement_sha256: str | None = Field(description="Null while it is a forecast.")
    settled_at: datetime | None
    signed: list[SignedRead]
    may: EndingMay
