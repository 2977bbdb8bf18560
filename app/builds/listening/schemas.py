"""Bodies of listening passes and of the tasks that come from notes and drift."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.builds.audits.rules import MAX_AMOUNT_DB, HeardAs, TaskKind, TaskRole
from app.builds.audits.schemas import AuditSummary, Move, SoundCue
from app.core.web.http import Schema
from app.references.rules import MAX_RANGE_S
from app.renders.schemas import TakeSound

MAX_NOTE_CHARS = 1_000


class CueToHear(Schema):
    """One cue of a listening pass, with how the build plays it."""

    cue: SoundCue
    category: str
    description: str
    events: list[str] = Field(description="What begins it in the game.")
    files: int
    gain_db: float | None = Field(description="Against what was approved, of the file that is furthest off.")
    message: str
    depends: list[str]
    move: Move | None = Field(description="The gain that is furthest from the approved one.")
    suggested_db: float | None = Field(description="The change that would bring the approved level back.")
    sound: TakeSound | None = Field(description="The approved sound.")
    heard: bool = Field(description="Whether it was heard in this pass.")


class RecordedMoment(Schema):
    """A moment of a screen recording: a clip or a sound among the references of the project."""

    reference_version_id: UUID
    at_s: Annotated[float, Field(ge=0, le=MAX_RANGE_S, allow_inf_nan=False)]


class ListeningNoteRead(Schema):
    """A note of a listening pass."""

    id: UUID
    cue: SoundCue
    said: HeardAs
    amount_db: float | None
    text: str
    written_by: PersonBrief
    written_at: datetime
    is_mine: bool
    recording: RecordedMoment | None = Field(description="Where it was heard, in a recording.")
    task_id: UUID | None
    role: TaskRole | None = Field(description="Whose task it became.")
    is_done: bool


class ListeningPassRead(Schema):
    """A listening pass as the caller sees it: designers their own cues."""

    id: UUID
    audit: AuditSummary
    started_at: datetime
    is_newest: bool = Field(description="Whether no newer build was audited.")
    people: int = Field(description="How many people wrote notes in it.")
    heard: int
    cues: list[CueToHear]
    notes: list[ListeningNoteRead] = Field(description="The newest first; what was taken back is left out.")
    may_close: bool


class ListeningNow(Schema):
    """The open listening pass, and the build that a new one would begin with."""

    listening_pass: ListeningPassRead | None
    newest_audit: AuditSummary | None


class ListeningNoteAdd(Schema):
    """A person's note on a cue; sent again with the same id it counts once."""

    note_id: UUID = Field(description="Made where the note is written.")
    cue_id: UUID
    said: HeardAs
    amount_db: Annotated[float, Field(ge=-MAX_AMOUNT_DB, le=MAX_AMOUNT_DB, allow_inf_nan=False)] | None = None
    text: Annotated[str, Field(max_length=MAX_NOTE_CHARS, pattern="^[^\\x00]*$")] = ""
    written_at: datetime | None = Field(None, description="When the key was pressed, where it is sent later.")
    recording: RecordedMoment | None = Field(
        None, description="Where it was heard, in a recording. Such a note replaces no other one of its cue."
    )


class GameTaskRead(Schema):
    """Something to do so that the game plays a sound as it should."""

    id: UUID
    cue: SoundCue | None
    path: str
    kind: TaskKind
    role: TaskRole
    gain_db: float | None = Field(description="The change that is suggested.")
    where: str = Field(description="The object and property, or the file.")
    text: str
    recording: RecordedMoment | None = Field(description="Where it was heard, in a recording.")
    asked_by: PersonBrief
    asked_at: datetime
    done_at: datetime | None
    may_do: bool = Field(description="Whether the caller may mark it as done.")


class GameTaskChange(Schema):
    """Whether a task is done."""

    is_done: bool
