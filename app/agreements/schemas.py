"""Requests and answers of contracts."""

from datetime import date, datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import ConfigDict, Field, StringConstraints

from app.accounts.rules import AddressProof
from app.accounts.schemas import Line, PersonBrief, Prose
from app.agreements.rules import ContractKind, ContractState, Party, ReleaseClause
from app.agreements.signing.drawn_signatures import DRAWING, WIDTH
from app.core.web.http import LARGEST_NUMBER, Schema

Coordinate = Annotated[int, Field(strict=True, ge=0, le=WIDTH)]
Stroke = list[Annotated[list[Coordinate], Field(min_length=2, max_length=2)]]
Currency = Annotated[str, StringConstraints(strip_whitespace=True, pattern="^[A-Z]{3}$")]
BasisPoints = Annotated[int, Field(ge=0, le=10_000)]
Reason = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=2000, pattern="^[^\\x00]*$")]
Sha256 = Annotated[str, StringConstraints(max_length=64)]


class ClauseRow(Schema):
    """One clause: Markdown with variables in braces; what does not stand is kept, and not in the text."""

    model_config = ConfigDict(str_strip_whitespace=False)

    key: str = Field(max_length=61)
    title: str = Field(max_length=200)
    text: str = Field(max_length=25_000, pattern="^[^\\x00]*$")
    stands: bool = True


class ChoiceRead(Schema):
    """One of the values that a term may have, and what the text says then."""

    value: int | str
    label: str
    words: str


class TermRead(Schema):
    """A term that a clause leaves open: `_bp` ends a part in basis points, `_minor` an amount in minor units."""

    name: str
    default: int | str
    label: str
    min: int | None
    max: int | None
    choices: list[ChoiceRead] = Field(description="Empty where any value does.")


class LibraryClauseRead(Schema):
    """A clause of the library, and why one would want it."""

    key: str
    title: str
    text: str
    stands: bool
    why: str
    music: bool
    instead_of: str | None
    terms: list[TermRead]


class LibraryRead(Schema):
    """The library's content for a kind of contract, and the variables that the server fills in."""

    kind: ContractKind
    notice: str
    clauses: list[LibraryClauseRead]
    variables: dict[str, str]


class TemplateBrief(Schema):
    """A template that the studio keeps."""

    id: UUID
    name: str
    kind: ContractKind
    created_at: datetime
    changed_at: datetime


class TemplateRead(TemplateBrief):
    """A template with its clauses and terms."""

    clauses: list[ClauseRow]
    terms: dict[str, int | str]


class TemplateAdd(Schema):
    """A template to keep."""

    name: Line
    kind: ContractKind
    clauses: list[ClauseRow] = Field(min_length=1, max_length=200)
    terms: dict[str, int | str]


class TemplateChange(Schema):
    """The new content of a template."""

    name: Line
    clauses: list[ClauseRow] = Field(min_length=1, max_length=200)
    terms: dict[str, int | str]


class TemplateImport(Schema):
    """A template as TOML; under another name if one is given."""

    toml: str = Field(max_length=1_000_000)
    name: Line | None = None


class ContractTemplateAdd(Schema):
    """The name under which to keep a contract's clauses."""

    name: Line


class ContractAdd(Schema):
    """A contract to begin with one designer."""

    engagement_id: UUID
    kind: ContractKind
    title: Line
    currency: Currency = "USD"
    template_id: UUID | None = None
    framework_id: UUID | None = None
    same_as_id: UUID | None = Field(
        None, description="A contract of the studio, whose clauses and terms it begins with."
    )
    with_music: bool = False


class DraftChange(Schema):
    """The whole draft as it is to be."""

    title: Line
    clauses: list[ClauseRow] = Field(min_length=1, max_length=200)
    terms: dict[str, int | str]
    currency: Currency
    release_clause: ReleaseClause = ReleaseClause.PER_CUE
    holdback_bp: BasisPoints = 0


class MilestoneAmount(Schema):
    """A milestone's payment."""

    milestone_id: UUID
    amount_minor: int = Field(ge=0, le=10**12)


class DraftSave(DraftChange):
    """The draft to save, and the version that it was made from."""

    note: Prose = ""
    based_on_version: int = Field(ge=1, le=LARGEST_NUMBER)
    amounts: list[MilestoneAmount] | None = Field(
        None,
        max_length=100,
        description="Needed where the currency changes: what each milestone of the plan pays in the new one. "
        "With it the amounts among the terms are in the new currency too.",
    )


class SpanRead(Schema):
    """A run of letters of one weight."""

    model_config = ConfigDict(str_strip_whitespace=False)

    text: str
    strong: bool
    emphatic: bool
    field: str = Field(
        description="In a draft's preview, the figure that these letters are: a term, `total`, `deposit`, or "
        "`milestone.N` for what the Nth milestone pays; empty for other letters."
    )


class BlockRead(Schema):
    """A head, a paragraph, one item of a list, or a table whose first row is its head."""

    kind: Literal["head", "text", "item", "table"]
    level: int
    spans: list[SpanRead]
    rows: list[list[list[SpanRead]]]


class DraftProblem(Schema):
    """A fault of a draft, and its place: `clauses.KEY` or `terms.NAME`."""

    where: str
    message: str


class PreviewedClauseRead(Schema):
    """A clause that stands in a draft, and where its text is among the blocks of the whole."""

    key: str
    number: int
    title: str
    first_block: int
    block_count: int


class DraftPreview(Schema):
    """The text that a draft would have, and what is wrong with it."""

    blocks: list[BlockRead]
    clauses: list[PreviewedClauseRead] = Field(description="The clauses that stand, in order.")
    problems: list[DraftProblem]


class VersionBrief(Schema):
    """One version of a contract's text."""

    number: int
    note: str
    author: PersonBrief
    created_at: datetime
    sent_at: datetime | None
    text_sha256: str
    pdf_sha256: str | None


class VersionRead(VersionBrief):
    """One version with its text; what it was written from is the studio's alone."""

    blocks: list[BlockRead]
    clauses: list[ClauseRow]
    terms: dict[str, int | str]


class AcceptanceRead(Schema):
    """One person's yes, for a party."""

    party: Party
    name: str
    email: str
    email_proof: AddressProof | None = Field(
        description="How it was shown that they read the mail of that address; null: it was not."
    )
    agent: str = Field(description="Browser and system, as the browser names them; empty if unknown.")
    code_entered_at: datetime | None = Field(description="When the code mailed to that address was typed; null: never.")
    drawing: list[Stroke] | None = Field(description="The name as it was drawn; null: it was not.")
    accepted_at: datetime


class MayRead(Schema):
    """The caller's permitted actions on the contract now."""

    change: bool
    send: bool
    recall: bool
    request_change: bool
    accept: bool
    end: bool
    amend: bool = Field(description="Whether they may propose a change order, or give notice.")


class LastContractRead(Schema):
    """The contract that another one can begin like; null where the studio has sent none of its kind."""

    contract: "LastContract | None"


class LastContract(Schema):
    """A contract to begin like."""

    id: UUID
    title: str
    designer: PersonBrief
    currency: str
    created_at: datetime


class NoticeBrief(Schema):
    """A notice in effect: since when, and the last day of the contract."""

    given_at: datetime
    ends_on: date | None = Field(description="Null: it ends when both agree to the statement.")


class ContractBrief(Schema):
    """A contract as lists show it."""

    id: UUID
    project_id: UUID
    number: int
    title: str
    kind: ContractKind
    state: ContractState
    designer: PersonBrief
    engagement_id: UUID
    framework_id: UUID | None
    currency: str
    release_clause: ReleaseClause
    deposit_bp: int
    holdback_bp: int
    created_at: datetime
    agreed_at: datetime | None
    ended_at: datetime | None
    end_reason: str | None
    my_party: Party | None
    waits_for: list[Party] = Field(description="Whose step is next.")
    notice: NoticeBrief | None = Field(description="While the contract runs and a party has given notice.")


class ContractRead(ContractBrief):
    """A contract with the text that the caller sees, and who said yes to it."""

    studio_name: str
    version: VersionRead
    acceptances: list[AcceptanceRead]
    signers: list[PersonBrief] = Field(
        description="Who signs for the studio, in this order; empty: any one of its producers."
    )
    signs_first: Party | None = Field(description="Which party signs first; null: either.")
    change_requested: "ContractChangeRead | None" = Field(
        description="The changes that the designer requests, until it is sent again."
    )
    redlines: "ContractRedlines | None" = Field(
        description="The last round of changes that the designer proposed clause by clause; null: none yet."
    )
    joint: "list[JointPart]" = Field(
        description="Both parts of joint work, which two designers make; empty for a contract that stands alone."
    )
    signature_time: "SignatureTime | None" = Field(description="Null before it is first sent.")
    may: MayRead


class JointPart(Schema):
    """One designer's part of joint work."""

    contract_id: UUID | None = Field(description="Null for the contract of the other designer, which only they see.")
    designer: PersonBrief
    is_own: bool = Field(description="Whether it is this contract's part.")
    cues: int
    amount_minor: int
    currency: str
    share: str = Field(description="Of the price of both, in percent; empty where there is none.")


class ShareSet(Schema):
    """A designer's share of the price of joint work: a part of it, or an amount."""

    share_bp: BasisPoints | None = None
    share_minor: int | None = Field(None, ge=0, le=10**12)


class JointAdd(ShareSet):
    """The second designer of a draft, and their cues; without a share, the amounts follow the cues."""

    engagement_id: UUID
    cue_ids: list[UUID] = Field(min_length=1, max_length=5000)


class ContractRedlines(Schema):
    """The last round of redlines in figures."""

    rounds: int
    count: int
    unanswered: int
    is_open: bool = Field(description="Whether the next version is still to be sent.")
    by: str
    at: datetime


class SignatureTime(Schema):
    """The time of a contract from first being sent to the last signature."""

    first_sent_at: datetime
    waits_since: datetime | None = Field(description="Since when its next step is open; null: it waits for nobody.")


class ContractChangeRead(Schema):
    """The change that the designer wants."""

    text: str
    clause: str
    by: str
    at: datetime


class SendAdd(Schema):
    """The note sent with the text."""

    note: Prose = ""


class RecallAdd(Schema):
    """The reason to take back a text."""

    reason: Reason


class ContractChangeAdd(Schema):
    """The change that the designer wants, of one clause or of the whole."""

    text: Reason
    clause_key: str | None = Field(default=None, max_length=61)


class AcceptAdd(Schema):
    """A yes: under which name, and to which text."""

    name: Line
    text_sha256: Sha256
    code: str | None = Field(
        None, max_length=20, description="The digits mailed to the caller; needed where the server sends mail."
    )
    drawing: list[Stroke] | None = Field(None, description=DRAWING)


class SigningCodeAdd(Schema):
    """The text that a code is for."""

    text_sha256: Sha256


class SigningCodeRead(Schema):
    """The address of a mailed code, and the number of tries."""

    email: str
    expires_at: datetime
    tries: int


class SignersSet(Schema):
    """The studio's signers, in this order, and the party that signs first."""

    person_ids: list[UUID] = Field(max_length=20)
    first: Party | None = None


class EndAdd(Schema):
    """The reason to end a contract."""

    reason: Reason


class RecordEntryRead(Schema):
    """One entry of the record."""

    seq: int
    at: str
    kind: str
    payload: dict[str, Any]
    previous_sha256: str
    sha256: str


class RecordRead(Schema):
    """The record of a contract, and whether it is the one that was written."""

    contract_id: UUID
    title: str
    length: int
    sha256: str
    faults: list[str]
    entries: list[RecordEntryRead]
