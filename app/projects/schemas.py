"""Bodies and answers of projects."""

from datetime import date, datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import ConfigDict, Field, StringConstraints, model_validator

from app.accounts.rules import MAX_TOKEN_DAYS, Scope
from app.accounts.schemas import Email, Line, MaybeLine, PersonBrief, PersonRead, Prose, StudioBrief
from app.core.web.http import LARGEST_NUMBER, Schema
from app.projects.rules import DesignersHear, EngagementKind

CuePrefix = Annotated[str, StringConstraints(strip_whitespace=True, pattern="^[A-Z][A-Z0-9]{0,7}$")]
Reason = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=500, pattern="^[^\\x00]*$")]
Category = Annotated[
    str, StringConstraints(strip_whitespace=True, to_lower=True, max_length=60, pattern=r"^[^\W_][\w-]*$")
]
Toml = Annotated[str, StringConstraints(strip_whitespace=False, max_length=200_000)]


class ProjectAdd(Schema):
    """A new project."""

    studio_id: UUID
    name: Line
    description: Prose = ""
    cue_prefix: CuePrefix = Field(description="One to eight capitals and digits: SW numbers the cues SW-001, SW-002 …")
    preset: Literal["44k1", "48k"] = "44k1"


class ProjectChange(Schema):
    """Changes; omitted fields stay."""

    name: Line | None = None
    description: Prose | None = None
    cue_prefix: CuePrefix | None = None
    archived: bool | None = None
    nda_needed: bool | None = None
    designers_hear: DesignersHear | None = None


class EngagementRead(Schema):
    """A designer's tie to the project."""

    id: UUID
    designer: PersonBrief
    kind: EngagementKind
    created_at: datetime
    ended_at: datetime | None
    nda_accepted_at: datetime | None


class Mine(Schema):
    """The caller's roles in the project."""

    is_team: bool
    is_producer: bool
    is_liaison: bool
    is_approver: bool = Field(description="Whether the caller approves some sounds today, as approver or as deputy.")
    engagement_kind: EngagementKind | None
    nda_open: bool = Field(description="Brief, list and spec open once the caller has accepted the project's NDA.")


class CategoryApproverRead(Schema):
    """A category of the sound list with an approver of its own."""

    category: str
    approver: PersonBrief


class ProjectRead(Schema):
    """A project as its page's header shows it; a designer sees only their own engagement."""

    id: UUID
    name: str
    description: str
    cue_prefix: str
    created_at: datetime
    archived_at: datetime | None
    nda_needed: bool = Field(description="Designers see brief, list and spec once they accepted an NDA.")
    designers_hear: DesignersHear = Field(
        description="Which sounds of other designers a designer may hear: none, approved ones with the palette, "
        "or also those that wait for approval."
    )
    studio: StudioBrief
    approver: PersonBrief
    category_approvers: list[CategoryApproverRead] = Field(description="All other categories are the approver's.")
    liaisons: list[PersonBrief]
    audio_leads_warning: str | None = Field(description="For the team, where more than two audio leads are named.")
    engagements: list[EngagementRead]
    mine: Mine
    spec_version: int


class ApproverAdd(Schema):
    """The new approver, and why."""

    person_id: UUID
    reason: Reason


class CategoryApproverName(Schema):
    """The approver of one category."""

    category: Category
    person_id: UUID | None = Field(description="Null gives the category back to the project's approver.")


class DeputyAdd(Schema):
    """A deputy for a person's approvals, and the days."""

    person_id: UUID
    deputy_id: UUID
    from_on: date = Field(description="The first day, in the studio's time zone.")
    until_on: date = Field(description="The last day, which counts.")


class DeputyRead(Schema):
    """A deputy of today or of later days."""

    id: UUID
    person: PersonBrief
    deputy: PersonBrief
    from_on: date
    until_on: date


class DeputiesRead(Schema):
    """The deputies of today and of later days, and the studio's time zone that their days are counted in."""

    time_zone: str
    today: date
    deputies: list[DeputyRead]


class ApproverInvite(Schema):
    """The address of the person who becomes the approver."""

    email: Email


class ApproverInvited(Schema):
    """Whether the address is the approver now, or becomes it on joining."""

    email: str
    is_named: bool = Field(description="A member of the studio is named at once; others once they join.")


class ApproverChangeRead(Schema):
    """The new approver, the former one, and why."""

    person: PersonBrief
    reason: str
    changer: PersonBrief
    created_at: datetime


class RangeRead(Schema):
    """A lower and an upper bound; null does not limit."""

    min: float | None
    max: float | None


class AcceptRead(Schema):
    """The accepted formats of delivered files; null accepts anything that can be read."""

    containers: list[str] | None
    encodings: list[str] | None
    sample_rates_hz: list[int] | None
    bit_depths: list[int] | None
    channels: list[int] | None
    layouts: list[str] | None
    duration_s: RangeRead


class LimitsRead(Schema):
    """The levels and edges a file keeps to; null does not limit."""

    sample_peak_dbfs: float | None
    true_peak_dbtp: float | None
    dc_offset_percent: float | None
    silence_below_dbfs: float | None
    head_silence_ms: float | None
    tail_silence_ms: float | None
    edge_silence_below_dbfs: float
    tolerance_db: float
    loudness_lufs: RangeRead
    noise_floor_dbfs: float | None
    mono_loss_db: float | None
    others: dict[str, float] = Field(description="Limits of checks that are named by `/v1/checks` alone, by key.")


class NameTokenRead(Schema):
    """One part of a name."""

    name: str
    wanted: str = Field(description="What it may be, in words.")
    optional: bool
    repeats: bool


class NamingRead(Schema):
    """The naming of files: by a pattern, by tokens, or by the grammar of the Universal Category System."""

    pattern: str | None
    extension: str | None
    tokens: list[NameTokenRead]
    separator: str
    grammar: str | None
    portable: bool = Field(description="Whether names must be such that every system can hold them.")


class EngineRead(Schema):
    """Effects that the game adds, so files come without them."""

    adds: list[str]


class TargetRead(Schema):
    """The format of renders."""

    name: str
    sample_rate_hz: int
    bit_depth: int
    encoding: str
    quality: float | None = Field(description="Of what a lossy codec keeps, 0 to 1.")
    channels: Literal["master", 1, 2]
    dither: str
    over_peak: str


class ResolvedSpec(Schema):
    """The spec with its defaults filled in, for sounds of no category."""

    name: str
    accept: AcceptRead
    limits: LimitsRead
    naming: NamingRead
    required_metadata: list[str]
    engine: EngineRead
    targets: dict[str, TargetRead]
    checks: dict[str, str]
    categories: list[str]


class SpecBrief(Schema):
    """One version of the spec, without its text."""

    version: int
    sha256: str
    note: str
    created_at: datetime
    author: PersonBrief


class SpecRead(SpecBrief):
    """One version of the spec: its text, the tables that the text says, and what they come to."""

    model_config = ConfigDict(str_strip_whitespace=False)

    toml: str
    tables: dict[str, Any]
    resolved: ResolvedSpec
    warnings: list[str]


class SpecChange(Schema):
    """The whole text of the spec to be."""

    model_config = ConfigDict(str_strip_whitespace=False)

    toml: Toml
    note: Prose = ""
    based_on_version: int = Field(ge=1, le=LARGEST_NUMBER)


class SpecFormChange(Schema):
    """The tables of the spec to be, keyed as in its TOML; null leaves a key out."""

    tables: dict[str, Any]
    note: Prose = ""
    based_on_version: int = Field(ge=1, le=LARGEST_NUMBER)


class SpecDraftCheck(Schema):
    """A spec to look at before it is saved: its text, or its tables."""

    model_config = ConfigDict(str_strip_whitespace=False)

    toml: Toml | None = None
    tables: dict[str, Any] | None = None

    @model_validator(mode="after")
    def _is_one_of_both(self) -> "SpecDraftCheck":
        if (self.toml is None) == (self.tables is None):
            raise ValueError("send either toml or tables")
        return self


class SpecDraftChecked(Schema):
    """The text, the tables it says and what they come to, with what is probably not meant."""

    model_config = ConfigDict(str_strip_whitespace=False)

    toml: str
    sha256: str
    tables: dict[str, Any]
    resolved: ResolvedSpec
    warnings: list[str]


class InvitationAdd(Schema):
    """The person to invite, and their tie."""

    email: Email
    kind: EngagementKind = EngagementKind.CONTRACT
    note: Prose = ""


class InvitationRead(Schema):
    """An invitation of a designer, and whether it was accepted."""

    id: UUID
    email: str
    kind: EngagementKind
    note: str
    inviter: PersonBrief
    created_at: datetime
    expires_at: datetime
    accepted_at: datetime | None


class InvitationAccepted(Schema):
    """The tie that accepting made, and to what."""

    person: PersonRead
    project_id: UUID
    engagement: EngagementRead


class EngagementChange(Schema):
    """Changes; omitted fields stay."""

    kind: EngagementKind | None = None
    ended: bool | None = None


class TokenAdd(Schema):
    """The purpose and rights of a build's token."""

    name: Line
    scopes: list[Scope] = Field(min_length=1)
    days: int = Field(MAX_TOKEN_DAYS, ge=1, le=MAX_TOKEN_DAYS, description="How long it works.")


class TokenRead(Schema):
    """A build's key, without its secret."""

    id: UUID
    name: str
    scopes: list[Scope]
    creator: PersonBrief
    created_at: datetime
    last_used_at: datetime | None = Field(description="To within a minute; null: never used.")
    expires_at: datetime = Field(description="From then on its requests are refused.")
    revoked_at: datetime | None


class TokenMade(TokenRead):
    """A new key with its secret, which is shown this once."""

    secret: str


class CreditNameSave(Schema):
    """The caller's name in a project's credits."""

    name: MaybeLine = Field("", description="Empty: the name of the account.")
    is_left_out: bool = False


class CreditLineAdd(Schema):
    """A name that is added to a project's credits by hand."""

    role: Line = Field(examples=["Voice"])
    name: Line
