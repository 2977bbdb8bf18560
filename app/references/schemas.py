"""The bodies of this room."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import AfterValidator, Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.references.rules import MAX_RANGE_S, MAX_URL_CHARS, PreviewState, ReferenceKind, tidy_words

MAX_CAPTION_CHARS = 500
MAX_TERMS_CHARS = 1_000
MAX_WORDS_CHARS = 200
MAX_MARKS = 500  # of a clip, which become cues at once
Caption = Annotated[str, Field(max_length=MAX_CAPTION_CHARS, pattern="^[^\\x00]*$")]
Words = Annotated[str, Field(max_length=MAX_WORDS_CHARS, pattern="^[^\\x00]*$"), AfterValidator(tidy_words)]
Terms = Annotated[str, Field(max_length=MAX_TERMS_CHARS, pattern="^[^\\x00]*$")]
Address = Annotated[str, Field(max_length=MAX_URL_CHARS, pattern="^[^\\x00]*$")]
Category = Annotated[str, Field(min_length=1, max_length=200, pattern="^[^\\x00]*$")]
Seconds = Annotated[float, Field(ge=0, le=MAX_RANGE_S, allow_inf_nan=False)]


class ReferenceContent(Schema):
    """The content of a version: a finished upload, or a link."""

    upload_id: UUID | None = Field(None, description="Of an upload into this project, `project_id` in its metadata.")
    url: Address | None = Field(None, description="An https address. The server never fetches it.")


class ReferenceAdd(ReferenceContent):
    """A reference to add: pinned to a cue, or to a category, or else to the whole project."""

    cue_id: UUID | None = None
    category: Category | None = None
    caption: Caption = ""
    terms: Terms = Field("", description="Under which it may be used, as in: licensed original, may not be shipped.")
    words: Words = Field("", description="That it shows, separated by commas, as in: warm, crunchy.")
    start_s: Seconds | None = Field(None, description="Where the meant part of a sound or clip begins.")
    end_s: Seconds | None = None


class ReferenceChange(Schema):
    """The changes of a reference; fields that are left out stay."""

    cue_id: UUID | None = None
    category: Category | None = None
    caption: Caption = ""
    terms: Terms = ""
    words: Words = ""
    start_s: Seconds | None = None
    end_s: Seconds | None = None


class SpottedMark(Schema):
    """A place in a clip where a sound is needed, which becomes a cue."""

    name: str = Field(min_length=1, max_length=200, pattern="^[^\\x00]*$")
    category: str = Field("", max_length=60, pattern="^[^\\x00]*$")
    start_s: Seconds
    duration_s: Annotated[float, Field(gt=0, le=MAX_RANGE_S, allow_inf_nan=False)] | None = Field(
        None, description="How long the sound is; null where only its beginning was marked."
    )


class SpottedMarks(Schema):
    """The marks of a clip, in the order in which their cues join the list."""

    marks: list[SpottedMark] = Field(min_length=1, max_length=MAX_MARKS)


class PinnedCue(Schema):
    """The cue that a reference is pinned to."""

    id: UUID
    number: int
    name: str


class ReferenceVersionRead(Schema):
    """One file or link of a reference."""

    id: UUID
    number: int
    kind: ReferenceKind = Field(description="By the bytes of the file, whatever its name says.")
    media_type: str
    file_name: str = Field(description="Of a link: its host.")
    url: str | None
    file_bytes: int | None
    excerpt: str = Field(description="The beginning of a text.")
    preview: PreviewState
    problem: str = Field(description="Why no preview could be drawn.")
    width_px: int | None
    height_px: int | None
    added_at: datetime
    added_by: PersonBrief


class ReferenceRead(Schema):
    """A reference with its newest version."""

    id: UUID
    project_id: UUID
    cue: PinnedCue | None
    category: str | None
    caption: str
    terms: str
    words: str = Field(description="That it shows, separated by commas.")
    start_s: float | None
    end_s: float | None
    added_at: datetime
    version: ReferenceVersionRead
    parts: int = Field(0, description="Cues spotted from it, whose parts follow to a new version.")
    may_change: bool


class ReferenceOpeningRead(Schema):
    """One time that a person opened a version."""

    reference_id: UUID
    caption: str
    file_name: str
    version: int
    person: PersonBrief
    opened_at: datetime
    is_removed: bool = Field(description="Whether the reference is off the board since.")
