"""Bodies that this room reads and answers."""

from datetime import date, datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import Email, Line, PersonBrief, Prose
from app.core.web.http import LARGEST_NUMBER, Schema
from app.hiring.roster.rules import BusyKind, Exclusivity
from app.hiring.rules import (
    DEFAULT_HEADINGS,
    AskedScope,
    BidLineKind,
    BidNoteKind,
    BidState,
    BidUnit,
    PostingPhase,
    PostingState,
    SampleState,
)

Currency = Annotated[str, StringConstraints(strip_whitespace=True, pattern="^[A-Z]{3}$")]
Minor = Annotated[int, Field(ge=0, le=10**10)]  # of one line; its amount stays a whole number in every reader
Hundredths = Annotated[int, Field(ge=0, le=10**6)]
Revision = Annotated[int, Field(ge=0, le=LARGEST_NUMBER)]
Key = Annotated[str, StringConstraints(strip_whitespace=False, max_length=200, pattern="^[^\\x00]*$")]
Asked = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=2000, pattern="^[^\\x00]*$")]
Heading = Annotated[Line, Field(max_length=60)]
Note = Annotated[str, StringConstraints(strip_whitespace=True, max_length=200, pattern="^[^\\x00]*$")]
MAX_SAMPLE_BASE64 = 8_000_000  # characters: 6 MB of sound, about 20 s of stereo at 48 kHz and 24 bit
Day = Annotated[date, Field(ge=date(2000, 1, 1), le=date(2999, 12, 31))]


class BusyRangeWrite(Schema):
    """Days that are taken."""

    from_on: Day
    to_on: Day = Field(description="The last day.")
    kind: BusyKind = BusyKind.BOOKED
    note: Note = ""


class PostingAdd(Schema):
    """A posting to write."""

    title: Line
    text: Prose = ""
    equipment: Prose = Field(default="", description="That the work needs; bidders say what of it they have.")
    phase: PostingPhase = PostingPhase.PRODUCTION
    currency: Currency | None = Field(
        default=None, description="Null: as it is; for a new posting that of the project's budget, else the last used."
    )
    price_minor: Minor | None = Field(default=None, description="Of an advisory phase: what the studio pays for it.")
    budget_minor: Minor | None = None
    is_budget_shown: bool = Field(default=False, description="Whether candidates see the budget.")
    rate_floor_minor: Minor | None = Field(
        default=None, description="An effective hourly rate below it is pointed out to the team."
    )
    scope: AskedScope = AskedScope.ALL
    categories: Annotated[list[Key], Field(max_length=200)] = Field(default_factory=list)
    cue_ids: Annotated[list[UUID], Field(max_length=5000)] = Field(default_factory=list)
    headings: Annotated[list[Heading], Field(min_length=1, max_length=12)] = Field(
        default_factory=lambda: list(DEFAULT_HEADINGS), description="What the team scores, 1 to 5 each."
    )
    bids_until_on: date | None = Field(default=None, description="The last day on which bids are taken.")
    work_from_on: date | None = None
    work_to_on: date | None = None


class PostingChange(PostingAdd):
    """A posting as it should be."""

    revision: Revision = Field(description="The revision that was read.")


class AskedLine(Schema):
    """One line that every bid is made on, counted from the sound list."""

    key: str = Field(description="The category; empty for cues without one.")
    label: str
    cues: int
    files: int
    concepts: int = Field(0, description="Cues that are an idea still: what is ordered for them may change or go.")


class AskedCue(Schema):
    """One cue that a line of a posting counts, as the sound list has it now."""

    id: UUID
    line: str = Field(description="The key of its line.")
    name: str
    variations: int
    duration_s: float | None = Field(description="How long one file is, as far as it is known.")
    duration_min_s: float | None
    duration_max_s: float | None
    loop: bool
    is_concept: bool = Field(description="An idea still: what is ordered for it may change or go.")


class CandidateRead(Schema):
    """A person who may bid."""

    id: UUID
    email: str
    person: PersonBrief | None = Field(description="Null until the link was opened with an account.")
    is_invited: bool = Field(description="False where the person came by the posting's link.")
    joined_at: datetime | None
    created_at: datetime


class PostingQuestionRead(Schema):
    """A candidate's question about a posting, and the answer."""

    id: UUID
    text: str
    asked_by: PersonBrief | None = Field(description="Null where another candidate asked.")
    asked_at: datetime
    answer: str | None
    is_for_all: bool
    answered_at: datetime | None


class BidLine(Schema):
    """One line of a bid."""

    key: Key = Field(description="The asked line's key; for an extra, what it is for.")
    kind: BidLineKind
    unit: BidUnit
    quantity_hundredths: Hundredths = Field(description="300 for three cues, 750 for seven and a half hours.")
    price_minor: Minor = Field(description="For one cue, one hour, or the whole.")
    note: Annotated[str, StringConstraints(strip_whitespace=True, max_length=500, pattern="^[^\\x00]*$")] = ""


class BidContent(Schema):
    """A designer's offer."""

    lines: Annotated[list[BidLine], Field(max_length=100)]
    hours_hundredths: Hundredths | None = Field(default=None, description="The whole work in hours: 16000 for 160.")
    from_on: date | None = None
    to_on: date | None = None
    exclusivity: Exclusivity = Field(
        default=Exclusivity.UNKNOWN, description="Whether the designer works on this project alone while it lasts."
    )
    other_work: Prose = Field(default="", description="The designer's other work in these days.")
    equipment: Prose = Field(default="", description="What the designer has of the equipment that the posting names.")
    note: Prose = ""


class BidWrite(BidContent):
    """A designer's own bid, to keep as a draft."""

    revision: Revision = Field(description="The revision that was read; 0 for a bid that begins.")


class BidSend(Schema):
    """A bid to send."""

    revision: Revision = Field(description="The revision that was read: what is sent is what was seen.")


class Clash(Schema):
    """An offer or award elsewhere, in the days of this posting."""

    title: str
    is_awarded: bool
    from_on: date
    to_on: date


class SampleAdd(Schema):
    """A sound for a bid."""

    line_key: Key = Field(description="Of the line that it is for.")
    file_name: Annotated[str, Field(min_length=1, max_length=200, pattern="^[^\\x00]*$")]
    content_base64: Annotated[str, Field(min_length=1, max_length=MAX_SAMPLE_BASE64)]


class SampleFinding(Schema):
    """A finding of the check in a sample."""

    code: str
    severity: str
    message: str
    fix: str


class SampleRead(Schema):
    """A sound of a bid; play it from /v1/bid-samples/{id}/file while it is open."""

    id: UUID
    line_key: str
    file_name: str
    file_bytes: int
    state: SampleState
    spec_version: int | None = Field(description="The version of the delivery spec that it was checked by.")
    findings: list[SampleFinding]
    problem: str = Field(description="Why it could not be checked.")
    is_open: bool = Field(description="False once a refused bid's samples are no longer kept.")


class OwnBidRead(Schema):
    """The caller's own bid."""

    id: UUID
    state: BidState
    revision: int
    content: BidContent
    total_minor: int
    concept_minor: int = Field(description="The part of it that is for cues that are concepts still.")
    missing: list[str] = Field(description="Asked lines that it does not offer.")
    sent_at: datetime | None
    resent_at: datetime | None
    differs: bool = Field(description="Whether the draft differs from what was sent.")
    is_awarded: bool
    samples: list[SampleRead]


class PostingSummary(Schema):
    """A posting in a list."""

    id: UUID
    project_id: UUID
    project_name: str
    studio_name: str
    title: str
    phase: PostingPhase
    state: PostingState
    takes_bids: bool
    bids_until_on: date | None
    work_from_on: date | None
    work_to_on: date | None
    bids: int | None = Field(description="How many were sent; null for candidates.")
    own_bid: BidState | None


class PostingRead(Schema):
    """A posting as the caller may see it."""

    id: UUID
    project_id: UUID
    project_name: str
    studio_name: str
    title: str
    state: PostingState
    takes_bids: bool
    bids_until_on: date | None
    work_from_on: date | None
    work_to_on: date | None
    phase: PostingPhase
    revision: int
    currency: str
    nda_open: bool = Field(description="An NDA comes first: until it is signed only title, dates and studio are shown.")
    is_team: bool
    text: str
    equipment: str = Field(description="That the work needs.")
    price_minor: int | None
    budget_minor: int | None = Field(description="Null where it is not shown to the caller, or not named.")
    is_budget_shown: bool
    rate_floor_minor: int | None = Field(description="For the team only.")
    scope: AskedScope
    categories: list[str]
    cue_ids: list[UUID] = Field(description="For the team only.")
    lines: list[AskedLine]
    headings: list[str] = Field(description="For the team only.")
    has_link: bool = Field(description="For the team: whether a link without an invitation is open.")
    candidates: list[CandidateRead] = Field(description="For the team only.")
    questions: list[PostingQuestionRead]
    bids: int | None = Field(description="For the team: how many were sent.")
    own_bid: OwnBidRead | None
    clashes: list[Clash] = Field(description="For the candidate: offers and awards elsewhere in these days.")
    opened_at: datetime | None
    closed_at: datetime | None
    awarded_at: datetime | None
    contract_id: UUID | None = Field(description="For the team: the draft that the award opened.")


class CandidateAdd(Schema):
    """An address to invite."""

    email: Email


class PostingLink(Schema):
    """The link of a posting; shown this once."""

    url: str


class PostingPreview(Schema):
    """The page of a posting's link, before any account."""

    email: str | None = Field(description="Whose personal link it is; null for the link for everyone.")
    has_account: bool = Field(description="Whether this address has an account.")
    sends_mail: bool = Field(description="Whether personal links are mailed; if not, the studio hands them over.")
    studio_name: str
    project_name: str = Field(description="Empty while an NDA comes first.")
    title: str
    state: PostingState
    takes_bids: bool
    phase: PostingPhase
    nda_needed: bool
    bids_until_on: date | None
    work_from_on: date | None
    work_to_on: date | None
    text: str
    currency: str
    price_minor: int | None
    budget_minor: int | None
    lines: list[AskedLine]


class PostingJoined(Schema):
    """The posting that the caller may bid on from now on."""

    posting_id: UUID


class PostingQuestionAdd(Schema):
    """A question about a posting."""

    text: Asked


class PostingQuestionAnswer(Schema):
    """The answer to a question, for all candidates or for the one who asked."""

    text: Asked
    is_for_all: bool


class ShortlistWrite(Schema):
    """Whether a bid is on the shortlist."""

    is_shortlisted: bool


ScoreValue = Annotated[int, Field(ge=1, le=5)]


class ScoresWrite(Schema):
    """The caller's scores for a bid under each heading."""

    scores: Annotated[dict[str, ScoreValue], Field(max_length=12)]
    note: Prose = ""


class PersonScores(Schema):
    """The scores of one person of the team for a bid."""

    person: PersonBrief
    scores: dict[str, int]
    note: str


class BidNoteWrite(Schema):
    """A note of the team on a bid; the bidder never sees it."""

    kind: BidNoteKind = BidNoteKind.CALL
    held_on: Day
    text: Annotated[Prose, StringConstraints(min_length=1)]


class BidNoteRead(BidNoteWrite):
    """A note of the team on a bid, with its author."""

    id: UUID
    author: PersonBrief
    created_at: datetime


class ComparedBid(Schema):
    """One bid beside the others."""

    id: UUID
    designer: PersonBrief
    is_shortlisted: bool
    sent_at: datetime
    resent_at: datetime | None
    content: BidContent
    amounts_minor: list[int] = Field(description="Of each line, in the order of the lines.")
    total_minor: int
    concept_minor: int = Field(description="The part of it that is for cues that are concepts still.")
    missing: list[str] = Field(description="Asked lines without an offer: the total is not comparable.")
    hourly_rate_minor: int | None = Field(description="The total divided by the hours; null without hours.")
    is_below_floor: bool
    over_budget_minor: int | None = Field(description="Below zero: under it. Null where no budget is named.")
    days_late: int | None = Field(description="How many days after the posting's last day the work ends.")
    roster_entry_id: UUID | None = Field(description="The designer on the studio's roster; null where they are not.")
    busy: list[BusyRangeWrite] = Field(
        description="By the roster: what is taken in the days of the bid, or of the posting where the bid names none."
    )
    samples: list[SampleRead] = Field(description="In the order of the posting's lines, then as they were added.")
    notes: list[BidNoteRead] = Field(description="Of calls, interviews and otherwise, the newest day first.")
    own_scores: PersonScores | None
    others: list[PersonScores] | None = Field(description="Null until the caller has given every score of their own.")
    scored_by: int = Field(description="How many people have scored it.")


class BidComparison(Schema):
    """The bids of a posting on the same lines; those shortlisted first, then the first sent first."""

    posting_id: UUID
    title: str
    state: PostingState
    currency: str
    budget_minor: int | None
    rate_floor_minor: int | None
    work_from_on: date | None
    work_to_on: date | None
    headings: list[str]
    lines: list[AskedLine]
    bids: list[ComparedBid]
    awarded_bid_id: UUID | None
    contract_id: UUID | None
    may_award: bool
    is_roster_full: bool = Field(description="Whether an award cannot put its designer on the studio's roster.")
    pending: list[str] = Field(description="Who was invited and has not sent a bid: names, or addresses.")


class PostingAwarded(Schema):
    """The draft contract that an award opened."""

    project_id: UUID
    contract_id: UUID
    is_on_roster: bool = Field(description="False where the studio's roster was full: the designer is not on it.")
