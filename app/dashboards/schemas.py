"""Answers of the dashboards."""

from datetime import date, datetime
from typing import Any, Literal
from uuid import UUID

from pydantic import Field

from app.accounts.rules import Role
from app.accounts.schemas import PersonBrief
from app.agreements.rules import ContractState, ReleaseClause
from app.core.web.http import Schema
from app.dashboards.rules import CueStatus
from app.deliveries.schemas import CueBrief
from app.money.schemas import (
    EstimatesRead,
    ExtraRoundRead,
    FiguresRead,
    InvoiceRead,
    LedgerLineRead,
    MilestoneCueRead,
    MilestoneRead,
)
from app.money.work.schemas import DayRateRead, HoursRead
from app.projects.rules import EngagementKind
from app.reviews.rules import PausedBy
from app.reviews.schemas import CommentRead
from app.sound_lists.rules import Need


class MyStudio(Schema):
    """A studio that the caller is a member of."""

    id: UUID
    name: str
    roles: list[Role]


class MyProject(Schema):
    """A project that the caller sees, and what they are in it."""

    id: UUID
    name: str
    studio_id: UUID
    studio_name: str
    cue_prefix: str
    part: Literal["team", "designer"]
    is_producer: bool
    is_liaison: bool
    is_approver: bool
    approves_all: bool = Field(description="False for who approves some categories only, or none.")
    engagement_kind: EngagementKind | None
    nda_open: bool = Field(description="Brief, list and spec stay closed to the caller until the NDA is agreed.")
    is_sample: bool = Field(default=False, description="The sample project, which one request deletes.")


class Me(Schema):
    """The signed-in person, and everything they can open."""

    person: PersonBrief
    email: str
    email_verified_at: datetime | None = Field(description="Since when it is known that they read this address.")
    is_operator: bool = Field(description="Whether the caller runs this server.")
    has_contracts: bool = Field(True, description="Whether this server has contracts, money and hiring.")
    second_factor_required_by: list[str] = Field(
        default_factory=list,
        description="Names of studios that open once the caller has set up a second factor; empty once they have.",
    )
    studios: list[MyStudio]
    projects: list[MyProject]


class VariationProgress(Schema):
    """The status of one variation of a cue."""

    variation: int
    stem: str
    status: CueStatus


class NewestTake(Schema):
    """The take that a list row shows."""

    id: UUID
    number: int
    variation: int
    state: str
    file_name: str
    received_at: datetime
    duration_s: float | None
    thumb: dict[str, Any] | None
    preview_url: str | None


class CueProgress(Schema):
    """The progress of one cue."""

    cue_id: UUID
    status: CueStatus
    since: datetime | None
    accepted: int
    wanted: int
    alternates: int
    versions: int
    rounds: int
    variations: list[VariationProgress]
    newest_take: NewestTake | None
    worst_finding: dict[str, Any] | None
    open_question: str | None
    waived: bool
    not_to_spec: bool
    unheard_take_ids: list[UUID] = Field(
        description="Of its takes that wait or are approved, those that the caller has not heard; none for designers."
    )


class ListProgress(Schema):
    """The progress of the cues of one page of the list; `next` is the cursor of the following page, null at the end."""

    cues: list[CueProgress]
    next: str | None


class ListCounts(Schema):
    """The numbers of cues of the whole list by status."""

    counts: dict[CueStatus, int]
    files_to_review: int


class RecentVerdict(Schema):
    """A cue of which a take was approved, or a change requested, within a week."""

    cue: CueBrief
    status: Literal["accepted", "change_requested"]
    since: datetime


class AskedQuestion(Schema):
    """A question that waits for an answer."""

    id: UUID
    cue: CueBrief
    text: str
    asked_by: PersonBrief
    asked_at: datetime
    answer: str | None
    answered_at: datetime | None
    owner: PersonBrief | None = Field(description="The member of the team who is to answer; null: anybody.")
    due_on: date | None
    blocks: bool = Field(description="Work on the cue waits for the answer, and its milestone with it.")


class WithOthers(Schema):
    """A matter that waits for another person."""

    cue: CueBrief | None
    file_name: str
    status: Literal["returned", "unmatched", "change_requested", "unjudged"]
    who: str
    person_id: UUID
    picture: str | None = Field(None, description="The address of the person's picture.")
    since: datetime


class BuildBrief(Schema):
    """One run of the game's CI."""

    id: UUID
    label: str
    commit: str
    target: str
    files: int
    rejected: int
    warnings: int
    created_at: datetime


class Today(Schema):
    """Matters that wait for the team today, besides the review queue."""

    questions: list[AskedQuestion]
    with_others: list[WithOthers]
    builds: list[BuildBrief]
    counts: dict[CueStatus, int]
    draft_changes: int
    placeholders: int
    unsent_mails: int


class CameBack(Schema):
    """A take that is with the designer again."""

    take_id: UUID
    cue: CueBrief | None
    number: int | None
    variation: int
    file_name: str
    status: Literal["returned", "change_requested", "unjudged"]
    since: datetime
    duration_s: float | None
    thumb: dict[str, Any] | None
    preview_url: str | None
    peaks_url: str | None
    findings: list[dict[str, Any]]
    changes: list[dict[str, Any]]
    comments: list[CommentRead] = Field(description="What the team said of it, and replies to that and to changes.")
    round: int | None
    limit_dbfs: float | None


class ToMake(Schema):
    """A cue that waits for a file from the designer."""

    cue: CueBrief
    use: str
    category: str
    duration_s: float | None
    duration_min_s: float | None
    duration_max_s: float | None
    loop: bool
    variations: int
    missing: int
    state: str
    status: CueStatus


class WithApprover(CueBrief):
    """A cue that waits for its verdict."""

    accepted_after: date | None = Field(
        description="Day after which it counts as accepted without a verdict, by its contract's clause on silence."
    )
    silence_paused_by: PausedBy | None = Field(description="What is open, so that the days of the clause do not count.")


class Desk(Schema):
    """A designer's work in one project; of its lists the first page each, and the cursor of the following one."""

    came_back: list[CameBack]
    came_back_next: str | None
    came_back_cues: int
    to_make: list[ToMake]
    to_make_next: str | None
    to_make_cues: int
    with_approver: list[WithApprover]
    with_approver_next: str | None
    with_approver_cues: int
    with_approver_files: int
    accepted: int
    cues: int
    unmatched: int
    checking: int
    questions: list[AskedQuestion] = Field(description="The open ones, and the 20 that were answered last.")


class Step(Schema):
    """One cell of the project's steps."""

    cue: CueBrief
    palette: bool
    status: CueStatus


class NeedCompletion(Schema):
    """Progress of the cues of one need; cut ones are not counted."""

    need: Need
    accepted: int
    cues: int


class PaletteSound(Schema):
    """One sound of the palette."""

    cue: CueBrief
    take_id: UUID
    loop: bool
    thumb: dict[str, Any] | None
    preview_url: str | None
    loudness_lufs: float | None


class Activity(Schema):
    """Something that happened lately."""

    at: datetime
    kind: Literal["delivery", "build", "returned", "approved", "changes", "cut", "question", "answer"]
    who: str
    text: str


class Overview(Schema):
    """A project at one glance."""

    steps: list[Step] = Field(description="Of the first 500 cues of the list.")
    cues: int
    counts: dict[CueStatus, int]
    needs: list[NeedCompletion] = Field(description="The most needed first; a need without cues is left out.")
    builds: list[BuildBrief]
    palette: list[PaletteSound]
    lately: list[Activity]
    reviewers: int


class MilestoneSlip(Schema):
    """The delay of a milestone in whole days, split by the party that caused it."""

    milestone_id: UUID
    name: str
    due_on: date
    days: int
    designer_days: int
    studio_days: int


class ContractMoney(Schema):
    """The money of one agreed contract; amounts in whole minor units."""

    contract_id: UUID
    title: str
    designer: PersonBrief
    currency: str
    release: ReleaseClause
    kill_fee_in_work_bp: int
    by_day: DayRateRead | None
    by_hour: HoursRead | None
    figures: FiguresRead
    milestones: list[MilestoneRead]
    slips: list[MilestoneSlip]
    slip_growth_days: float | None
    proposed_rounds: list[ExtraRoundRead]
    billable_minor: int
    next_invoice: int
    open_invoices: list[InvoiceRead]
    last_days_to_pay: int | None


class MilestoneCue(MilestoneCueRead):
    """A cue of a milestone, and where it stands."""

    status: CueStatus


class MilestoneSheet(Schema):
    """A milestone with all that is known of it; slip and estimates are None but for the two parties."""

    project_id: UUID
    contract_id: UUID
    contract_title: str
    contract_state: ContractState
    designer: PersonBrief
    currency: str
    release: ReleaseClause
    milestone: MilestoneRead
    cues: list[MilestoneCue]
    blocked_by: list[AskedQuestion] = Field(description="Open questions for which work on its cues waits.")
    slip: MilestoneSlip | None
    slips: list[MilestoneSlip]
    slip_growth_days: float | None
    estimates: EstimatesRead | None
    lines: list[LedgerLineRead]
    invoices: list[InvoiceRead]


class CurrencyFigures(Schema):
    """The totals of all contracts of one currency."""

    currency: str
    figures: FiguresRead


class ProjectMoney(Schema):
    """The money of a project, as far as the caller sees its contracts."""

    contracts: list[ContractMoney]
    totals: list[CurrencyFigures]
