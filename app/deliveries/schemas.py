"""Bodies that this room reads and answers."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import BeforeValidator, Field, StringConstraints

from app.accounts.schemas import Line, PersonBrief, Prose
from app.core.web.http import Schema, Whole
from app.deliveries.rules import ArchiveState, SourceFileKind, TakeState, TrayActionKind, shown_name

GivenName = Annotated[
    str,
    StringConstraints(strip_whitespace=True, min_length=1, max_length=100_000),
    Field(description="Never used as a path."),
]
ShownName = Annotated[str, BeforeValidator(shown_name)]


class UploadRead(Schema):
    """A file on its way in, or arrived."""

    upload_id: UUID
    offset: int = Field(description="How many bytes are here.")
    length: int
    sha256: str | None = Field(description="Null until the last byte is here.")


class PartAsk(Schema):
    """A part that is to be sent next."""

    number: Whole = Field(description="Parts count from 1.")
    sha256: str = Field(
        pattern="^[0-9a-f]{64}$", description="Of the part's bytes, in hex; the store holds it to them."
    )


class PartsAsk(Schema):
    """The parts of a file to send next."""

    parts: list[PartAsk] = Field([], max_length=100)


class PartLinkRead(Schema):
    """The target of one part of a file: a PUT of exactly these bytes with exactly these headers."""

    number: int
    start: int = Field(description="The part's first byte in the file.")
    length: int
    url: str
    headers: dict[str, str]


class PartsRead(Schema):
    """The parts of a file, those in the store, and the targets of the requested ones."""

    part_bytes: int = Field(description="How long every part but the last is.")
    parts: int
    here: list[int] = Field(description="Parts that are in the store.")
    links: list[PartLinkRead]
    links_expire_at: datetime


class DeliveryAdd(Schema):
    """A new delivery."""

    note: Prose = ""


class DeliveryChange(Schema):
    """Changes of a delivery."""

    note: Prose


class DeliveryRead(Schema):
    """One upload of takes by a designer, with notes."""

    id: UUID
    project_id: UUID
    number: int
    note: str
    created_at: datetime
    closed_at: datetime | None
    designer: PersonBrief
    takes_count: int


class TakeAdd(Schema):
    """A finished upload that becomes a take; without a cue its name says which cue it is for."""

    upload_id: UUID
    file_name: GivenName
    cue_id: UUID | None = None
    variation: Whole | None = Field(None, description="Of a set; null: as the name says, else the first empty one.")
    note: Prose = ""


class CueBrief(Schema):
    """The cue that a take is for."""

    id: UUID
    label: str = Field(examples=["SW-014"])
    name: str


class CueGuess(Schema):
    """A cue that an unmatched file is for, or may be for."""

    cue_id: UUID
    label: str
    name: str
    variation: int | None = Field(description="Null where the name does not say which of the set.")
    variations: int = Field(description="How many the cue has.")
    reason: str
    becomes: str | None = Field(description="What the file would be called; null without a variation.")


class TakeAdded(Schema):
    """A delivered file as it came in."""

    id: UUID
    project_id: UUID
    delivery_id: UUID
    designer: PersonBrief
    cue: CueBrief | None = Field(description="Null while it waits in the unmatched tray.")
    variation: int
    number: int | None = Field(description="Shown as the version; null while unmatched.")
    alternate: int | None
    label: str | None = Field(description="What it is among alternates, in the words of its designer or the team.")
    state: TakeState
    verdict_reasons: list[str] = Field(description="Why it is approved or has to change, as the reviewer chose.")
    late: bool = Field(description="It came after its delivery was closed.")
    file_name: ShownName
    note: str
    fix_of_id: UUID | None = Field(description="The version that this one is a fix of.")
    master_sha256: str
    master_bytes: int
    received_at: datetime
    state_since: datetime
    already_here: bool = Field(False, description="The same file was here before; this is its take.")


class TakeRead(TakeAdded):
    """One delivered file; what an unmatched one is for is read from its name and the whole list."""

    discarded_at: datetime | None = Field(description="Out of the list and the tray since then; its master is kept.")
    sure: CueGuess | None = Field(description="The one cue that an unmatched file is for by its name, if that is sure.")
    guesses: list[CueGuess] = Field(description="Up to three cues that an unmatched file may be for otherwise.")


class TakeDetail(TakeRead):
    """One delivered file with the name that it had before it was renamed for its delivery."""

    received_name: ShownName | None = Field(description="Null where it was not renamed, or came in a ZIP.")


MAX_LABEL_CHARS = 40
Label = Annotated[
    str,
    StringConstraints(
        strip_whitespace=True,
        min_length=1,
        max_length=MAX_LABEL_CHARS,
        pattern=r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029]*$",
    ),
]


class TakeLabelSet(Schema):
    """The label of a take among alternates."""

    label: Label | None = Field(description="Of the studio's list or in other words; null takes it away.")


class TakeLabelRead(Schema):
    """The label of a take among alternates, and its author."""

    label: str | None
    labelled_by: PersonBrief | None
    labelled_at: datetime | None


class DryStemUpload(Schema):
    """A finished upload into a take's delivery that is the take's sound without its reverb."""

    upload_id: UUID


class DryStemRead(Schema):
    """A sound without its reverb; the takes of its name are compared with it."""

    id: UUID
    project_id: UUID
    delivery_id: UUID
    stem: str = Field(description="Of the takes that it is for: their file names without the ending.")
    take_ids: list[UUID] = Field(description="The takes that it is for; none while they have not come.")
    file_name: ShownName
    file_bytes: int
    sha256: str
    received_at: datetime


class TakeMatch(Schema):
    """The cue that a take is for."""

    cue_id: UUID
    variation: Whole | None = None


MANY = 2_000


class TakesNamed(Schema):
    """Takes that something is done to at once."""

    take_ids: list[UUID] = Field(min_length=1, max_length=MANY)


class SureAccept(Schema):
    """The files of the tray to match if their names are sure."""

    take_ids: list[UUID] | None = Field(None, max_length=MANY, description="Null: all of the tray.")


class TakeMove(Schema):
    """The place of a take."""

    take_id: UUID
    cue_id: UUID
    variation: Whole | None = Field(None, description="Of a set; null: as the name says, else the first empty one.")
    as_alternate: bool | None = Field(
        None, description="It is another idea for the same sound, and gets the next letter."
    )


class UndecidedTake(Schema):
    """One of the files between which nobody chose."""

    id: UUID
    file_name: ShownName
    number: int
    state: TakeState
    received_at: datetime


class UndecidedPlace(Schema):
    """Files of one delivery for the same sound: one counts, or they are alternates, or one is for another sound."""

    delivery_id: UUID
    cue: CueBrief
    variation: int
    alternate: int | None
    takes: list[UndecidedTake]


class TakesMove(Schema):
    """The places of takes."""

    moves: list[TakeMove] = Field(min_length=1, max_length=MANY)


class TakeRename(Schema):
    """The name of a file, and its proposed name."""

    take_id: UUID
    file_name: ShownName
    becomes: str


class TrayActionRead(Schema):
    """One action on many takes at once."""

    id: UUID
    kind: TrayActionKind
    done_at: datetime
    undone_at: datetime | None
    take_ids: list[UUID] = Field(description="The takes that changed.")


class TrayActionUndone(TrayActionRead):
    """The undone action."""

    moved_back: int = Field(description="Takes that are where they were before.")
    left: int = Field(description="Takes that were changed or decided since; they stay as they are.")


class ArchiveAdd(Schema):
    """A finished upload that is a ZIP of takes."""

    upload_id: UUID
    file_name: GivenName


class ArchiveEntry(Schema):
    """The result for one file in a ZIP."""

    path: str
    taken: bool
    take_id: UUID | None
    reason: str | None = Field(description="Why it was left out, or that it was here before.")


class ArchiveRead(Schema):
    """A delivered ZIP and what happened to it."""

    id: UUID
    delivery_id: UUID
    file_name: ShownName
    archive_bytes: int
    state: ArchiveState
    message: str
    entries: list[ArchiveEntry]
    received_at: datetime


class DeliveryDetail(DeliveryRead):
    """A delivery with everything that came in it."""

    takes: list[TakeRead]
    dry_stems: list[DryStemRead]
    archives: list[ArchiveRead]


# One line that may be empty, without control characters or marks that turn the direction of writing.
Words = Annotated[
    str,
    StringConstraints(
        strip_whitespace=True,
        max_length=200,
        pattern="^[^\\x00-\\x1f\\x7f-\\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069]*$",
    ),
]
MANY_SOURCES = 50


class LibrarySource(Schema):
    """A sound library that a sound has layers from."""

    name: Line
    licence: Words = Field("", description="Its name, or where it is kept; empty: not known yet.")
    file: Words = Field("", description="The recording of the library.")


class GeneratedSource(Schema):
    """A part of a sound that a machine generated."""

    tool: Line = Field(description="Name and version.")
    part: Line = Field(description="The part of the sound that it made.")


class PerformerSource(Schema):
    """A person who is heard in a sound."""

    name: Line
    release: Words = Field("", description="The signed release: its date, or where it is kept; empty: none yet.")


class Sources(Schema):
    """The sources of a sound."""

    from_scratch: bool = Field(False, description="Synthesized or designed without any recording of others.")
    own_recordings: bool = Field(False, description="Recorded by its designer.")
    libraries: list[LibrarySource] = Field([], max_length=MANY_SOURCES)
    generated: list[GeneratedSource] = Field([], max_length=MANY_SOURCES)
    performers: list[PerformerSource] = Field([], max_length=MANY_SOURCES)
    note: Words = ""


class SourcesRead(Schema):
    """The stated sources of a sound, or of a delivery."""

    sources: Sources
    stated_at: datetime
    stated_by: PersonBrief
    words: str = Field(description="The same as one line of text.")


class TakeSources(Schema):
    """The sources of one take."""

    take_id: UUID
    stated: SourcesRead | None = Field(description="Its own statement, else that of its delivery; null: none.")
    is_own: bool = Field(description="Whether the take has a statement of its own.")
    is_fixed: bool = Field(description="Whether they are on record: the take is approved, and nothing is open.")
    open_points: list[str] = Field(description="What a clearance asks for and is not stated.")


class DeliverySources(Schema):
    """The sources of a delivery."""

    delivery_id: UUID
    stated: SourcesRead | None = Field(description="Holds for every take without a statement of its own.")
    remembered: Sources | None = Field(description="What its designer stated last in this studio.")
    takes: list[TakeSources]


class RecipeSet(Schema):
    """The plug-ins of a take, and how it was made."""

    plug_ins: list[Line] = Field([], max_length=MANY_SOURCES, description="Names with versions.")
    recipe: Prose = ""


class SourceFileAdd(Schema):
    """A finished upload into a take's delivery that the take was made from."""

    upload_id: UUID


class SourceFileRead(Schema):
    """A file that a take was made from."""

    id: UUID
    kind: SourceFileKind
    file_name: ShownName
    file_bytes: int
    sha256: str
    received_at: datetime


class SourceBankRead(Schema):
    """The source bank of a take: session, layers, plug-ins and recipe; in no pack."""

    take_id: UUID
    is_shown: bool = Field(
        description="Whether the caller sees it: its designer, or the studio once it is handed over."
    )
    is_handed_over: bool = Field(description="Whether it goes to the studio once the take is approved.")
    plug_ins: list[str]
    recipe: str
    files: list[SourceFileRead]


class HandoffAdd(Schema):
    """What a maker did of a cue, and what is missing."""

    done_percent: int = Field(ge=0, le=100)
    missing: Annotated[Prose, StringConstraints(min_length=1)]
    from_id: UUID | None = Field(None, description="The maker, where a producer writes it; null: the caller.")


class NextMaker(Schema):
    """The designer who continues a cue."""

    designer_id: UUID


class HandoffTake(Schema):
    """A version in a hand-off, with as much of its source bank as the caller sees."""

    id: UUID
    file_name: ShownName
    variation: int
    number: int | None
    state: TakeState
    received_at: datetime
    plug_ins: list[str]
    recipe: str
    source_files: list[SourceFileRead]


class HandoffRead(Schema):
    """A cue that its maker leaves unfinished."""

    id: UUID
    cue_id: UUID
    done_percent: int
    missing: str
    created_at: datetime
    written_by: PersonBrief
    maker: PersonBrief
    next_maker: PersonBrief | None = Field(description="Who continues it; null: nobody yet.")
    closed: str | None = Field(description="Why its files cannot be downloaded now; null: they can.")
    takes: list[HandoffTake]
