"""Bodies of audits of game builds: what CI posts, read within bounds, and what the builds page shows."""

from datetime import datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import BaseModel, ConfigDict, Field

from app.accounts.schemas import PersonBrief
from app.builds.audits.rules import AuditStatus, CueMark
from app.builds.schemas import ReportTool
from app.core.web.http import Schema
from app.renders.schemas import TakeSound

MAX_AUDITED_SOUNDS = 20_000
MAX_PATH_CHARS = 1_000
MAX_WORD_CHARS = 500
MAX_MESSAGE_CHARS = 2_000
MAX_REASON_CHARS = 1_000
Level = Annotated[float, Field(ge=-1_000, le=1_000, allow_inf_nan=False)]
Path = Annotated[str, Field(max_length=MAX_PATH_CHARS)]
Word = Annotated[str, Field(max_length=MAX_WORD_CHARS)]
Text = Annotated[str, Field(max_length=MAX_REASON_CHARS, pattern="^[^\\x00]*$")]


class _Posted(BaseModel):
    """A part of a report: keys that are not read are left out, not refused, for newer versions add some."""

    model_config = ConfigDict(extra="ignore")


class PostedChangelist(_Posted):
    """The change that set a value; no person is named."""

    id: Word
    on: Word
    subject: Word


class PostedMove(_Posted):
    """A gain that is another than when the sound was approved."""

    object: Path
    property: Word
    file: Path
    approved_db: Level
    gain_db: Level
    changelist: PostedChangelist | None = None


class PostedDepends(_Posted):
    """Another influence on a level."""

    on: Word
    what: Word


class PostedPlay(_Posted):
    """One way in which the game plays a sound."""

    drift_db: Level | None
    used: bool | None = None
    events: list[Word] = Field(max_length=1_000)
    moved: list[PostedMove] = Field(max_length=200)
    depends: list[PostedDepends] = Field(max_length=200)


class PostedMatch(_Posted):
    """An approved sound that a file holds."""

    cue: Word | None
    take: Word | None
    path: Path


class PostedSound(_Posted):
    """The audit's result on one sound."""

    path: Path = Field(min_length=1)
    status: AuditStatus
    gain_db: Level | None
    approved: Path | None
    message: str = Field(max_length=20_000)
    matches: list[PostedMatch] = Field(max_length=1_000)
    played_status: AuditStatus = AuditStatus.SAME
    plays: list[PostedPlay] = Field([], max_length=200)


class PostedUnread(_Posted):
    """A file of the game's project that could not be read."""

    file: Path
    line: int = Field(0, ge=0, le=2**31 - 1)
    message: Word


class PostedProject(_Posted):
    """The project that the levels were read from."""

    engine: Word
    unread: list[PostedUnread] = Field(max_length=1_000)


class PostedReport(_Posted):
    """A report of `audio-checks audit`, as its JSON format has it."""

    schema_version: Literal[1]
    tool: ReportTool
    files: list[PostedSound] = Field(max_length=MAX_AUDITED_SOUNDS)
    project: PostedProject | None = None


class AuditAdd(Schema):
    """The audit of one build by the game's CI."""

    label: str = Field(min_length=1, max_length=200)
    commit: str = Field("", max_length=200)
    target: str = Field("", max_length=100)
    report: PostedReport


class AuditSummary(Schema):
    """One audit of a build, counted."""

    id: UUID
    label: str
    commit: str
    target: str
    engine: str = Field(description="Whose project the levels were read from; empty where files alone were compared.")
    sounds: int
    drifted: int = Field(description="Sounds that are not as approved, accepted ones included.")
    new_drifts: int = Field(description="Those that the audit before did not have, and that were not accepted.")
    created_at: datetime


class Unread(Schema):
    """A file of the game's project that could not be read; the rest was compared."""

    file: str
    line: int
    message: str


class AuditRead(AuditSummary):
    """One audit, and how much of its drift is accepted now."""

    before: str | None = Field(description="The label of the audit before it, against which new drift is counted.")
    accepted: int
    depends: int = Field(description="Sounds whose level depends on the game's state: no drift, and never the same.")
    unread: list[Unread]


class SoundCue(Schema):
    """The cue that a sound belongs to."""

    id: UUID
    label: str
    name: str


class Changelist(Schema):
    """The change that set a value; its person is not named."""

    id: str
    on: str
    subject: str


class Move(Schema):
    """A gain that is another than when the sound was approved."""

    object: str
    property: str
    file: str
    approved_db: float
    gain_db: float
    changelist: Changelist | None


class AcceptedDriftRead(Schema):
    """An accepted drift: why, by whom, and when."""

    id: UUID
    path: str
    status: AuditStatus
    played_status: AuditStatus
    gain_db: float | None
    reason: str
    accepted_by: PersonBrief
    accepted_at: datetime


class AuditedSoundRead(Schema):
    """An audit's result on one sound."""

    place: int
    path: str
    cue: SoundCue | None
    status: AuditStatus
    played_status: AuditStatus
    has_drifted: bool
    is_new: bool = Field(description="Whether the audit before did not have this drift.")
    gain_db: float | None = Field(description="File and properties together, against what was approved.")
    file_db: float | None
    property_db: float | None
    message: str
    moves: list[Move]
    depends: list[str]
    events: list[str]
    accepted: AcceptedDriftRead | None
    task_id: UUID | None = Field(description="The open task that it was sent back by.")
    sound: TakeSound | None = Field(description="The approved sound; the build's own file is not on the server.")


class SoundInBuild(Schema):
    """One build's result on a sound, for its history."""

    audit_id: UUID
    label: str
    created_at: datetime
    status: AuditStatus
    played_status: AuditStatus
    gain_db: float | None
    changelist: Changelist | None


class DriftAccept(Schema):
    """The reason to accept a drift as it is."""

    path: Path
    reason: Annotated[Text, Field(min_length=1)]


class SoundSendBack(Schema):
    """An implementer's task about a drift."""

    path: Path
    text: Text = ""


class CueInGame(Schema):
    """Whether a cue is in the build, and was heard in the game; and who says so."""

    cue: SoundCue
    category: str
    in_build: Literal["audit", "hand"] | None
    heard: Literal["pass", "hand"] | None


class CategoryInGame(Schema):
    """The counts of one category."""

    category: str
    cues: int
    heard: int


class GameStates(Schema):
    """The part of a list in the build, and the part never heard in the game."""

    cues: int = Field(description="Cues of the list that are not cut.")
    in_build: int
    heard: int
    never_heard: int
    build: str | None = Field(description="The label of the newest audited build.")
    categories: list[CategoryInGame]
    unheard: list[CueInGame] = Field(description="The first 200 that were never heard, in list order.")
    may_mark: bool = Field(description="Whether the caller may set a state by hand.")


class CueMarking(Schema):
    """A state set by hand, or taken back."""

    mark: CueMark
    is_set: bool
