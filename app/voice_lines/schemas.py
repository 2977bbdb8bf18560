"""The bodies of this room."""

from datetime import date, datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.deliveries.rules import TakeState
from app.sound_lists.schemas import CellGuess, ImportEncoding, ImportTab, RefusedNames, SkippedRow
from app.voice_lines.rules import (
    DEFAULT_LANGUAGE,
    MAX_DIRECTION_CHARS,
    MAX_NAME_CHARS,
    MAX_SCENE_CHARS,
    MAX_TEXT_CHARS,
    LineState,
    SyntheticUse,
)

MAX_NOTE_CHARS = 2_000
Language = Annotated[str, Field(min_length=2, max_length=40, pattern="^[^\\x00]*$")]
Name = Annotated[str, Field(max_length=MAX_NAME_CHARS, pattern="^[^\\x00]*$")]
Note = Annotated[str, Field(max_length=MAX_NOTE_CHARS, pattern="^[^\\x00]*$")]
Spoken = Annotated[str, Field(min_length=1, max_length=MAX_TEXT_CHARS, pattern="^[^\\x00]*$")]
Direction = Annotated[str, Field(max_length=MAX_DIRECTION_CHARS, pattern="^[^\\x00]*$")]
Scene = Annotated[str, Field(max_length=MAX_SCENE_CHARS, pattern="^[^\\x00]*$")]
Percent = Annotated[int, Field(ge=1, le=100)]


class ScriptAsk(Schema):
    """A script, and how to read it."""

    format: Literal["csv", "xlsx", "paste", "script"] = Field(
        description="`script`: text in which a name in capitals stands above what is spoken."
    )
    content_base64: str | None = Field(None, max_length=7_100_000, description="The file's bytes.")
    text: str | None = Field(None, max_length=5_300_000, description="The text, or what was pasted.")
    language: Language = Field(DEFAULT_LANGUAGE, description="Of the text, where no column names its language.")
    mapping: dict[Annotated[str, Field(max_length=200)], Annotated[str, Field(max_length=40)]] | None = Field(
        None,
        description="Column → `key`, `character`, `scene`, `direction`, `file_name`, `variations`, `text`, `ignore` "
        "or a language.",
    )
    speaker: str = Field("", max_length=100, description="Who speaks the lines that name no one.")
    speaker_in_key: bool = Field(
        False, description="The ids of lines that name no one begin with the character, as in `anna_010`."
    )
    dry_run: bool = Field(description="Only say what would happen.")
    atomic: bool = Field(
        False, description="Import nothing while any row has an error. Without it such rows are left out and named."
    )
    tab: str | None = Field(
        None, max_length=200, description="The tab of a workbook; otherwise the visible one with the most known heads."
    )
    encoding: str | None = Field(
        None, max_length=40, description="The encoding of a text, such as shift-jis; otherwise it is recognized."
    )
    keep_hidden: bool = Field(False, description="Read the rows and columns that the spreadsheet hides.")


class ScriptColumn(Schema):
    """A column of the sheet, and what it is read as: a field, a language, or `ignore`."""

    name: str
    samples: list[str]
    meaning: str


class LineChange(Schema):
    """An import's changes to a line."""

    field: str = Field(description="`character`, `scene`, `direction`, or the language of the text.")
    before: str
    after: str
    makes_stale: bool = Field(description="Takes were delivered of the text before.")


class ScriptRow(Schema):
    """The result for one row."""

    row: int = Field(description="Its number in the sheet, or of its line in the text.")
    action: Literal["add", "change", "same"]
    key: str
    character: str
    scene: str
    text: str
    files: int = Field(description="In each language; 1 where the script does not say.")
    languages: list[str]
    changes: list[LineChange]


class ScriptFault(Schema):
    """The error in one row."""

    row: int
    column: str | None
    message: str


class ScriptRead(Schema):
    """The content of a script, what was not read of it, its errors, and whether it was imported."""

    header_row: int | None
    tabs: list[ImportTab] = Field(description="Of a workbook; none for a text.")
    encoding: ImportEncoding | None = Field(description="Of a file of text.")
    columns: list[ScriptColumn]
    skipped: list[SkippedRow]
    guesses: list[CellGuess] = Field(description="Cells that took their value from a merged one above.")
    rows: list[ScriptRow]
    errors: list[ScriptFault]
    left_out: list[int] = Field(description="The rows that have an error, and are not imported.")
    refused_names: RefusedNames
    added: int
    changed: int
    same: int
    cues_added: int = Field(description="One for each line and language that is new.")
    stale: int = Field(description="Texts with takes that were made from another text.")
    not_in_script: list[str] = Field(description="Lines of the project that the script does not have. They stay.")
    imported: bool


class CharacterBrief(Schema):
    """A character by name."""

    id: UUID
    name: str


class SpokenBeside(Schema):
    """The line before or after, in the same scene."""

    character: str
    text: str


class LineCue(Schema):
    """The cue that takes of a line belong to."""

    id: UUID
    number: int
    label: str
    name: str


class LineTake(Schema):
    """The take that a line is judged by."""

    id: UUID
    number: int
    state: TakeState
    duration_s: float | None


class LineFile(Schema):
    """One file of a line and its state."""

    path: str
    state: LineState


class VoiceLineRead(Schema):
    """A line of the script in one language."""

    id: UUID
    key: str
    character: CharacterBrief
    scene: str
    direction: str
    language: str
    text: str | None = Field(description="Null: not translated yet.")
    text_version: int | None
    original_text: str | None
    before: SpokenBeside | None
    after: SpokenBeside | None
    path: str = Field(description="Where its file is expected: one name, in a folder per language.")
    files: list[LineFile] = Field(description="Each of its files: one, or the variations of its cue.")
    cue: LineCue | None
    state: LineState = Field(description="Of the file that is furthest from approved.")
    reason: str = Field(description="Why it must be recorded, or recorded again; empty where it need not.")
    take: LineTake | None
    recorded_text: str | None = Field(description="What a stale take says.")
    original_duration_s: float | None = Field(description="Of the newest approved take in the original language.")
    length_percent: float | None = Field(description="How much longer the take is than the original's.")
    length_is_off: bool
    performer: str | None
    directed_by: str


class StateCount(Schema):
    """The number of lines in a state."""

    state: LineState
    lines: int


class VoiceLines(Schema):
    """The script in one language."""

    language: str
    lines: list[VoiceLineRead]
    next: int | None = Field(description="Of the next page; null on the last.")
    total: int
    counts: list[StateCount] = Field(description="Of the whole script in this language, whatever is filtered.")
    may_change: bool


class PickUpsRead(Schema):
    """The pick-ups of the next session, by language and character."""

    lines: list[VoiceLineRead]
    languages: list[str] = Field(description="With something to record.")


class CastingRead(Schema):
    """A character's performer in one language."""

    language: str
    performer: str | None
    directed_by: str
    cast_by: str


class CharacterRead(Schema):
    """A character and its castings."""

    id: UUID
    name: str
    notes: str
    lines: int
    castings: list[CastingRead]


class VoiceScriptRead(Schema):
    """Facts of the whole script."""

    original_language: str
    length_tolerance_percent: int
    languages: list[str]
    characters: list[CharacterRead]
    lines: int
    may_change: bool


class VoiceSettingsChange(Schema):
    """The original language, and how far a length may be from the original's before it is marked."""

    original_language: Language
    length_tolerance_percent: Percent


class CharacterChange(Schema):
    """Notes on the intended voice."""

    notes: Note


class CastingChange(Schema):
    """Performer, session director and the person who casts; an empty name is nobody."""

    performer: Name = ""
    directed_by: Name = ""
    cast_by: Name = ""


class VoiceLineChange(Schema):
    """Changes to a line; fields that are left out stay."""

    scene: Scene = ""
    direction: Direction = ""


class VoiceTextChange(Schema):
    """A new text; the version that was read must still be the newest."""

    text: Spoken
    text_version: int = Field(ge=1, le=2**31 - 1)
    takes_fit: bool = Field(False, description="Takes that exist still fit the new text: they do not become stale.")


class ReleaseAdd(Schema):
    """A signed release: a finished upload, its dates, and what it says of synthetic use."""

    performer: Annotated[str, Field(min_length=1, max_length=MAX_NAME_CHARS, pattern="^[^\\x00]*$")]
    upload_id: UUID = Field(description="Of an upload into this project, `project_id` in its metadata.")
    valid_from: date
    valid_until: date | None = Field(None, description="Its last day; null: without an end.")
    synthetic_use: SyntheticUse
    note: Note = ""


class ReleaseRead(Schema):
    """A release of a performer."""

    id: UUID
    file_name: str
    file_bytes: int
    valid_from: date
    valid_until: date | None
    is_valid: bool = Field(description="Today.")
    synthetic_use: SyntheticUse
    note: str
    added_at: datetime
    added_by: PersonBrief


class PerformerRead(Schema):
    """A performer, what they speak, and their releases."""

    name: str
    parts: list[str] = Field(description="Characters with the language.")
    approved_lines: int
    releases: list[ReleaseRead]
    warning: str = Field(description="Empty where every approved line has a release that is valid today.")


class ReleasesRead(Schema):
    """The releases of a project by performer."""

    performers: list[PerformerRead]
    lines_without_performer: int = Field(description="Approved lines of characters for whom no performer is named.")
    may_change: bool
