"""Bodies that this room reads and answers."""

from datetime import date, datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema, Whole
from app.projects.rules import EngagementKind
from app.projects.schemas import ResolvedSpec, SpecRead
from app.sound_lists.clarity.rules import Fact
from app.sound_lists.rules import CueChannels, CueState, Need, Phase, Reverb

OpenState = Literal["concept", "prototype", "locked"]
Text = Annotated[str, Field(max_length=20_000)]
Figure = Annotated[float, Field(allow_inf_nan=False)]


class NameRefusalRead(Schema):
    """The delivery spec's objection to the file name of a cue."""

    stem: str = Field(description="The file name without its ending; that of the first variation.")
    rule: Literal["pattern", "tokens", "ucs", "not-portable", "reserved"]
    message: str
    proposed: str | None = Field(description="A file name for the cue that the spec accepts.")


class CueRead(Schema):
    """One line of the list."""

    id: UUID
    number: int
    label: str = Field(examples=["SW-014"])
    position: int
    name: str
    file_name: str
    stems: list[str] = Field(description="The file names, without ending, that its variations own; none once cut.")
    category: str
    description: str
    use: str
    trigger: str
    duration_s: float | None = Field(description="Asked for, within a quarter; with bounds, the length to plan with.")
    duration_min_s: float | None = Field(description="The sound is at least this long; null: no bound.")
    duration_max_s: float | None = Field(description="The sound is at most this long; null: no bound.")
    length_locked: bool
    frame_rate_fps: float | None
    loop: bool
    reverb: Reverb | None
    channels: CueChannels | None = Field(description="Null: as the delivery spec says.")
    variations: int
    state: CueState
    phase: Phase | None = Field(description="The phase by whose end its sound is accepted.")
    need: Need = Field(description="How much the game needs it: without a must it cannot ship.")
    playback_priority: int | None
    due_on: date | None = Field(description="The day on which the sound is needed.")
    placeholder: bool
    palette: bool
    implementer_id: UUID | None = Field(description="Who puts it into the game; a designer sees only themselves.")
    recorder_id: UUID | None = Field(description="Who records it; a designer sees only themselves.")
    extra: dict[str, str] = Field(description="Imported columns without a field.")
    edition: int = Field(description="Send it back with a change, so that two editors notice each other.")
    cut_reason: str | None
    cut_at: datetime | None
    open_questions: int
    refused_name: NameRefusalRead | None = Field(
        None, description="Set where the delivery spec refuses the file name; see refused-names."
    )


class CategoryCount(Schema):
    """One category of the sound list."""

    category: str = Field(description="Empty for cues without a category.")
    cues: int = Field(description="Cut ones are not counted.")


class SoundListRead(Schema):
    """One page of the list as it stands."""

    revision: int = Field(description="0 while the list is empty and untouched.")
    cues: list[CueRead]
    next: str | None = Field(description="The cursor of the following page, null at the end.")


class CueFields(Schema):
    """The fields of a cue that people type."""

    name: Text = ""
    file_name: Text = ""
    category: Text = ""
    description: Text = ""
    use: Text = ""
    trigger: Text = ""
    duration_s: Figure | None = None
    duration_min_s: Figure | None = None
    duration_max_s: Figure | None = None
    length_locked: bool = False
    frame_rate_fps: Figure | None = None
    loop: bool = False
    reverb: Reverb | None = None
    channels: CueChannels | None = None
    variations: Whole = 1
    state: OpenState = "prototype"
    need: Need = Need.MUST
    phase: Phase | None = None
    playback_priority: Whole | None = None
    due_on: date | None = None
    placeholder: bool = False
    palette: bool = False
    implementer_id: UUID | None = None
    recorder_id: UUID | None = None
    extra: dict[Text, Text] = Field(default_factory=dict)


class CueAdd(CueFields):
    """A typed row; only a name or a file name is needed. It is a concept until the team says otherwise."""

    state: OpenState = "concept"


class CuesAdd(Schema):
    """Typed or pasted rows, in list order."""

    cues: list[CueAdd] = Field(min_length=1, max_length=1000)


class CuePatch(CueFields):
    """Changes of a cue; omitted fields stay."""

    edition: Whole = Field(description="The edition that was read.")


class CueOrder(Schema):
    """Cues in their new order: they share out among themselves the places that they hold now."""

    cue_ids: list[UUID] = Field(min_length=1, max_length=20_000)


class PlaceholderSet(Schema):
    """Whether the game plays a placeholder file for now."""

    placeholder: bool


class PaletteSet(Schema):
    """Whether the cue belongs to the palette that new sounds are compared with."""

    palette: bool


class QuestionAdd(Schema):
    """A question that a designer needs answered to make the sound."""

    text: str = Field(min_length=1, max_length=2000)
    due_on: date | None = Field(default=None, description="The day by which the answer is needed.")
    blocks: bool = Field(default=False, description="Work on the cue waits for the answer, and its milestone with it.")


class QuestionPatch(Schema):
    """Changes to an open question; what is left out stays."""

    owner_id: UUID | None = Field(default=None, description="The member of the team who is to answer; null: anybody.")
    due_on: date | None = None
    blocks: bool | None = None


class AnswerAdd(Schema):
    """The answer, which joins the cue's description unless the request says otherwise."""

    text: str = Field(min_length=1, max_length=4000)
    joins: bool = True


class QuestionRead(Schema):
    """A question on a cue, and its answer."""

    id: UUID
    cue_id: UUID
    cue_label: str
    cue_name: str
    text: str
    asked_by: PersonBrief | None = Field(description="Null where a designer looks at another designer's question.")
    asked_at: datetime
    answer: str | None
    answered_by: PersonBrief | None
    answered_at: datetime | None
    owner: PersonBrief | None = Field(description="The member of the team who is to answer; null: anybody.")
    due_on: date | None
    blocks: bool = Field(description="Work on the cue waits for the answer, and its milestone with it.")


class CueDetail(CueRead):
    """One cue with what was asked about it."""

    project_id: UUID
    questions: list[QuestionRead]


class RevisionRead(Schema):
    """One saved change of the list."""

    number: int
    summary: str
    author: PersonBrief
    created_at: datetime


class FieldChange(Schema):
    """One fact before and after."""

    field: str
    before: Any
    after: Any


class CueDifference(Schema):
    """A cue that differs between two revisions."""

    id: UUID
    number: int
    label: str
    name: str
    changes: list[FieldChange]
    cut_reason: str | None


class ListComparison(Schema):
    """The changes of the list between two revisions."""

    from_revision: int
    to_revision: int
    added: list[CueDifference]
    changed: list[CueDifference]
    cut: list[CueDifference]


ImportField = Literal[
    "number",
    "name",
    "file_name",
    "category",
    "description",
    "use",
    "trigger",
    "duration_s",
    "duration_min_s",
    "duration_max_s",
    "length_locked",
    "frame_rate_fps",
    "loop",
    "reverb",
    "channels",
    "variations",
    "state",
    "need",
    "phase",
    "playback_priority",
    "due_on",
    "placeholder",
    "palette",
    "implementer",
    "recorder",
    "extra",
    "ignore",
]


OwnField = Annotated[str, Field(pattern=r"^own:.", max_length=80, description="A column of the list's own, by name.")]
RowNumber = Annotated[int, Field(ge=1, le=1_048_576)]  # as many rows as a workbook can have


class CellEdit(Schema):
    """The text that a cell of a sheet has in place of its own."""

    row: RowNumber
    column: str = Field(max_length=1000)
    text: str = Field(max_length=10_000)


class ImportAsk(Schema):
    """A spreadsheet, and how to read it."""

    format: Literal["csv", "xlsx", "paste"]
    content_base64: str | None = Field(None, max_length=7_100_000, description="The file's bytes; for csv and xlsx.")
    text: str | None = Field(None, max_length=5_300_000, description="What was pasted, or a CSV as text.")
    mapping: dict[str, ImportField | OwnField] | None = Field(
        None,
        description="Column → field; `own:Mood` is the list's own column Mood, `extra` keeps a column as it is, "
        "`ignore` leaves it out. Columns not named here are read as guessed.",
    )
    dry_run: bool = Field(description="Only say what would happen.")
    atomic: bool = Field(
        False, description="Import nothing while any row has an error. Without it such rows are left out and named."
    )
    tab: str | None = Field(
        None,
        max_length=200,
        description="The tab of a workbook; otherwise the visible one with the most known heads.",
    )
    encoding: str | None = Field(
        None, max_length=40, description="The encoding of a CSV file, such as shift-jis; without it, it is recognized."
    )
    fill_down: bool = Field(True, description="Fill the cells below the first one of a merged block.")
    fill_down_columns: list[str] = Field(
        default_factory=list, max_length=200, description="Columns whose empty cells take the value of the cell above."
    )
    edits: list[CellEdit] = Field(
        default_factory=list, max_length=20_000, description="Cells that were repaired after the sheet was read."
    )
    keep_hidden: bool = Field(False, description="Read the rows and columns that the spreadsheet hides.")
    skip_rows: list[RowNumber] = Field(
        default_factory=list, max_length=20_000, description="Rows to leave out, by their numbers in the sheet."
    )
    keep_rows: list[RowNumber] = Field(
        default_factory=list, max_length=20_000, description="Rows to read as cues although they look like none."
    )
    frame_rate_fps: float | None = Field(None, gt=0, le=1000, description="For lengths in frames.")
    sample_rate_hz: float = Field(48_000, gt=0, le=1_000_000, description="For lengths in samples.")
    day_first: bool | None = Field(
        None,
        description="Whether 4/5/2026 is in May; otherwise other days of its column show it, or it is an error.",
    )
    use_proposed_names: bool = Field(
        False, description="Give cues whose file names the spec refuses the names that it would accept."
    )
    match: Literal["number", "name", "add"] = Field(
        "number", description="How a row finds its cue: by number, by name, or never, so that every row is added."
    )


class ImportColumn(Schema):
    """A column of the sheet, and what it is read as."""

    name: str
    samples: list[str]
    guess: ImportField | OwnField | None = Field(
        description="What its head and cells look like; null: nothing we know."
    )
    field: ImportField | OwnField
    why: str = Field(description="What was guessed beyond its head; empty where nothing was.")


class ImportTab(Schema):
    """A tab of the workbook."""

    name: str
    rows: int = Field(description="Rows with something in them, the head too.")
    heads: list[str]
    is_hidden: bool
    is_read: bool


class ImportEncoding(Schema):
    """The encoding that a file was read in."""

    name: str
    is_guess: bool = Field(description="It is neither UTF-8 nor UTF-16, and was chosen by how likely its text is.")
    others: list[str] = Field(description="Other encodings in which the file is text, the likeliest first.")


class SheetRow(Schema):
    """A row of the sheet, as it is read: repaired and filled down."""

    row: int
    cells: list[str] = Field(description="In the order of the columns; of a long cell, its beginning.")


class SkippedRow(Schema):
    """A row that is not read as a cue; `keep_rows` reads it."""

    row: int
    kind: Literal["section", "total", "head", "note", "hidden", "asked"]
    text: str
    why: str


class CellGuess(Schema):
    """A cell whose reading is a guess, or that took its value from elsewhere."""

    row: int
    column: str
    kind: Literal["filled_down", "reading", "name", "broken_formula"]
    text: str = Field(description="What the cell says.")
    value: str = Field(description="What it is read as.")
    why: str


class UnreadColumn(Schema):
    """A column that no field is read from."""

    name: str
    is_kept: bool = Field(description="Its cells are kept with the cues as they are; otherwise they are left out.")
    cells: int = Field(description="Cells with something in them.")
    why: str


class RefusedName(NameRefusalRead):
    """A file name of the list, or of a sheet, that the delivery spec refuses."""

    row: int | None = Field(description="Of the sheet; null for a cue of the list.")
    cue_id: UUID | None = Field(description="Null for a cue that is not in the list yet.")
    label: str | None
    name: str
    category: str


class PatternOffer(Schema):
    """A naming pattern that admits every name of the list that it is for."""

    category: str | None = Field(description="The category whose pattern it is; null for the pattern of the spec.")
    pattern: str = Field(description="The pattern that refuses names now.")
    proposed: str
    names: int = Field(description="How many refused names it admits.")


class RefusedNames(Schema):
    """Contradictions between the list and the delivery spec, and possible solutions on either side."""

    names: list[RefusedName]
    patterns: list[PatternOffer]


class SpecSaved(SpecRead):
    """The spec as it was saved, and the file names of the list that it refuses."""

    refused_names: RefusedNames


class RefusedRename(Schema):
    """The cues that get the proposed file names."""

    cue_ids: list[UUID] | None = Field(None, max_length=20_000, description="Null for all that have a proposal.")


class PatternAdmit(Schema):
    """The pattern of the spec that is to admit the names of the list."""

    category: str | None = Field(None, max_length=60, description="As in the offer.")


class SpecDraft(Schema):
    """A spec that is not saved."""

    toml: str = Field(max_length=400_000)


class ImportRow(Schema):
    """The result for one row."""

    row: int = Field(description="Its number in the sheet, as the spreadsheet shows it.")
    action: Literal["add", "change", "same"]
    label: str | None = Field(description="The cue it changes, or the number it will get; null when we number it.")
    name: str
    file_name: str
    category: str
    description: str
    duration_s: float | None
    duration_min_s: float | None
    duration_max_s: float | None
    loop: bool
    channels: CueChannels | None = Field(description="Null: as the delivery spec says.")
    variations: int
    state: CueState
    due_on: date | None
    changes: list[FieldChange]


class ImportFault(Schema):
    """The error in one cell."""

    row: int
    name: str = Field(description="The cue's name as the row has it; empty where it has none.")
    column: str | None
    message: str
    text: str = Field("", description="The cell as it stands; empty where the error is not of one cell.")


class ImportRead(Schema):
    """The content of a sheet, what was guessed, skipped and not read, its errors, and whether it was imported."""

    header_row: int | None
    tabs: list[ImportTab] = Field(description="Of a workbook; none for a text.")
    encoding: ImportEncoding | None = Field(description="Of a file of text.")
    columns: list[ImportColumn]
    unread: list[UnreadColumn]
    skipped: list[SkippedRow]
    guesses: list[CellGuess]
    cells: list[SheetRow] = Field(description="The sheet itself, for a dry run; otherwise none.")
    rows: list[ImportRow]
    errors: list[ImportFault]
    left_out: list[int] = Field(description="The rows that have an error, and are not imported.")
    refused_names: RefusedNames
    added: int
    changed: int
    same: int
    imported: bool
    revision: int


class PreviewCue(Schema):
    """A cue as an invited designer sees it before having an account."""

    number: int
    label: str
    name: str
    file_name: str
    category: str
    description: str
    use: str
    duration_s: float | None
    duration_min_s: float | None
    duration_max_s: float | None
    loop: bool
    channels: CueChannels | None
    variations: int
    state: CueState


class PreviewProject(Schema):
    """The project that an invitation is for."""

    name: str
    description: str
    cue_prefix: str


class InvitationPreview(Schema):
    """The page of a mailed link: the project, its list, and the required format of sounds."""

    project: PreviewProject
    studio_name: str
    kind: EngagementKind
    note: str
    email: str
    invited_by_name: str
    has_account: bool
    expires_at: datetime
    nda_needed: bool = Field(description="An NDA comes first: cues and spec open once it is accepted.")
    cues: list[PreviewCue]
    accepted: bool
    spec: ResolvedSpec | None


class FactQuestion(Schema):
    """A fact that a cue's words leave open."""

    fact: Fact
    question: str = Field(description="In words: How big?")
    answers: list[str] = Field(description="Likely answers to choose from; any other is as good.")


class UnclearCue(Schema):
    """A cue that a designer could not make from its words, with what they leave open."""

    cue_id: UUID
    questions: list[FactQuestion]


class ClarityRead(Schema):
    """The clarity check's result for a list."""

    unclear: list[UnclearCue]


class FactAnswer(Schema):
    """An answer, which is written into the cue's description or category."""

    text: str = Field(min_length=1, max_length=200)


class FactDismissal(Schema):
    """Whether a fact is asked for no more."""

    dismissed: bool
