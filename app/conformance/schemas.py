"""Bodies that this room reads and answers."""

from datetime import datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import Field, StringConstraints

import audio_checks
from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.deliveries.rules import TakeState
from app.deliveries.schemas import CueBrief, GivenName, ShownName
from app.projects.schemas import AcceptRead, LimitsRead
from app.sound_lists.rules import MAX_VARIATIONS, CueChannels

Reason = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=5000, pattern="^[^\\x00]*$")]


class FindingRead(Schema):
    """One rule that a file breaks, with its proof."""

    check: str
    code: str
    severity: Literal["error", "warning", "information"]
    message: str
    fix: str
    measured: float | None
    limit: float | None
    unit: str | None
    start_s: float | None
    end_s: float | None
    waived: bool
    auto_fix: str | None = Field(None, description="What a fix does about it; null where none can.")
    no_auto_fix: str | None = Field(None, description="Why no fix can, and who can put it right.")


class WaiverAdd(Schema):
    """The reason to let through a returned take."""

    reason: Reason


class WaiverRead(Schema):
    """That the approver let a returned take through, and why."""

    id: UUID
    codes: list[str]
    reason: str
    waived_by: PersonBrief
    created_at: datetime


class ComparedStemRead(Schema):
    """The dry stem that a take has now; `judgements.reverb.stem` has what was found with it."""

    file_name: ShownName
    file_bytes: int
    sha256: str
    received_at: datetime


class CheckRead(Schema):
    """The newest check of a take."""

    take_id: UUID
    state: TakeState
    verdict: Literal["conforming", "rejected", "unreadable", "unjudged"]
    spec_version: int
    is_newest_spec: bool = Field(description="The newest spec asks nothing else of this take.")
    tool_version: str
    created_at: datetime
    facts: dict[str, Any] | None
    measurements: dict[str, Any]
    judgements: dict[str, Any]
    dry_stem: ComparedStemRead | None
    is_newest_stem: bool = Field(description="This check used the current dry stem, or there is none.")
    findings: list[FindingRead]
    waiver: WaiverRead | None


class RepairRead(Schema):
    """One thing that a fix put right."""

    kind: Literal["gain", "head", "tail", "name", "header", "depth", "offset"]
    codes: list[str] = Field(description="The findings that it answers.")
    words: str = Field(examples=["level lowered by 1.70 dB"])
    start_s: float | None = Field(description="Where in the take: what was cut, or the spot of the level.")
    end_s: float | None


class ShapeRead(Schema):
    """The shape of a stretch of sound: ±1.0 is full scale."""

    frames: int
    sample_rate_hz: int
    min: list[float]
    max: list[float]
    rms: list[float]


class SpotRead(Schema):
    """The sound around a repair, before and after, by the time of the take."""

    kind: Literal["gain", "head", "tail", "offset"]
    start_s: float
    end_s: float
    after_start_s: float
    after_end_s: float
    before: ShapeRead
    after: ShapeRead


class LeftRead(Schema):
    """A finding that remains in a fixed copy, and why no fix answers it."""

    code: str
    severity: Literal["error", "warning", "information"]
    message: str
    why: str


class FixedFrom(Schema):
    """The take that this one is a fix of."""

    take_id: UUID
    number: int | None
    repairs: list[RepairRead]
    used_by: PersonBrief
    used_at: datetime


class CheckLimitDescription(Schema):
    """A limit that a check holds files to."""

    key: str = Field(description="In the table `limits` of a spec.", examples=["true_peak_dbtp"])
    label: str
    unit: str
    least: float
    greatest: float
    is_range: bool = Field(description="Whether a spec states `min` and `max`.")
    usual: float | None = Field(description="What holds where the spec says nothing; null for no limit.")


class CheckDescription(Schema):
    """A check: what it is called, why it is there, and what a spec may state of it."""

    name: str = Field(examples=["true-peak"])
    label: str
    summary: str = Field(description="What holds of a sound when it finds nothing.")
    why: str
    how_to_fix: str
    severity: Literal["error", "warning"] = Field(description="Where the spec says nothing.")
    may_return: bool = Field(description="Whether a spec may make it an error, so that takes are returned for it.")
    is_in_categories: bool = Field(description="Whether the form of a category offers its severity.")
    limits: list[CheckLimitDescription]


MAX_PREVIEWED_FILES = 200
MAX_PROPOSED_NAMES = 1_000


class FileNamed(Schema):
    """A file that is about to be sent."""

    file_name: GivenName
    cue_id: UUID | None = Field(None, description="The cue that it was dropped on; null: as its name says.")


class CheckPreview(Schema):
    """The files of a delivery before they are sent."""

    files: list[FileNamed] = Field(min_length=1, max_length=MAX_PREVIEWED_FILES)
    proposed: list[GivenName] = Field(
        default_factory=list,
        max_length=MAX_PROPOSED_NAMES,
        description="The list's names that other files are about to get: their variations are not free.",
    )


class PreviewedCheck(Schema):
    """A check that a page can make of a file before it is sent."""

    name: str
    label: str


class SpecView(Schema):
    """The spec's demands on files of one category."""

    category: str | None
    accept: AcceptRead
    limits: LimitsRead
    levels: dict[str, Literal["error", "warning", "off"]] = Field(
        description="Where the spec itself says how serious a check is, by its name."
    )


class CueLength(Schema):
    """The length that a cue asks for, and its channels."""

    channels: CueChannels | None = Field(description="Null: as the delivery spec says.")
    duration_s: float | None
    duration_min_s: float | None
    duration_max_s: float | None
    length_locked: bool
    frame_rate_fps: float | None


class FilePreview(Schema):
    """The rules for a file, and the faults of its name."""

    cue: CueBrief | None = Field(description="Null where its name does not say surely which.")
    variation: int | None
    length: CueLength | None
    spec: int = Field(description="Its place in `specs`.")
    is_dry_stem: bool = Field(description="It would be the dry stem of a version, which is not checked.")
    list_name: str | None = Field(
        description="The list's name for a file of the likeliest cue; null where its name is right or none is likely."
    )
    findings: list[FindingRead] = Field(description="Of its name alone.")


class CheckPreviewed(Schema):
    """The rules for files, in the order in which they were named."""

    checks: list[PreviewedCheck]
    specs: list[SpecView]
    files: list[FilePreview]


class FixRead(Schema):
    """The possible or finished fix of a take."""

    take_id: UUID
    state: Literal["none", "offered", "making", "made", "refused", "used"]
    says: str = Field(description="What the fix does, or did; else why there is none.")
    repairs: list[RepairRead]
    left: list[LeftRead]
    is_our_fault: bool = Field(description="It failed because of an error in our code; asking again may help.")
    before: dict[str, Any] = Field(description="Figures of the take, by name.")
    after: dict[str, Any] = Field(description="The same figures of the fixed copy.")
    cut_head_s: float = Field(description="Removed from the start.")
    cut_tail_s: float = Field(description="Removed from the end.")
    duration_s: float | None = Field(description="Of the fixed copy.")
    file_name: str | None
    spots: list[SpotRead]
    becomes: int | None = Field(description="The version that it would be now, or is.")
    new_take_id: UUID | None
    used_by: PersonBrief | None
    used_at: datetime | None
    fixed_from: FixedFrom | None


class FixOffer(Schema):
    """A take of which a fix would be enough."""

    take_id: UUID
    cue: CueBrief
    variation: int
    number: int
    take_state: TakeState
    state: Literal["offered", "making", "made"]
    says: str = Field(examples=["Trims 45.0 ms from the start."])


SHORTEST_PAUSES_S = (0.05, 10.0)
MAX_PARTS = 100


class SplitAsk(Schema):
    """How the parts of a file are to be found; markers and regions come before silence."""

    shortest_pause_s: float = Field(
        audio_checks.SHORTEST_PAUSE_S,
        ge=SHORTEST_PAUSES_S[0],
        le=SHORTEST_PAUSES_S[1],
        description="Shorter silence is part of a sound.",
    )


class PartPlace(Schema):
    """The variation that a part becomes."""

    part: int = Field(ge=1, le=MAX_PARTS)
    variation: int = Field(ge=1, le=MAX_VARIATIONS)


class SplitUse(Schema):
    """The cue that the parts are for; parts that are not named are left out."""

    cue_id: UUID | None = Field(None, description="Null: the cue of the file.")
    places: list[PartPlace] | None = Field(
        None, min_length=1, max_length=MAX_PARTS, description="Null: part 1 becomes variation 1, and so on."
    )


class SplitPartRead(Schema):
    """One part of a file."""

    number: int
    start_s: float
    duration_s: float
    label: str = Field(description="Of its marker or region; empty for none.")


class SplitFrom(Schema):
    """The file that a take was cut from, and which range of it."""

    take_id: UUID
    file_name: ShownName
    first_frame: int
    end_frame: int = Field(description="The first frame after the range.")
    start_s: float | None = Field(description="Null where the rate is not known any more.")
    end_s: float | None


class SplitRead(Schema):
    """The parts that a file holds, and what became of them."""

    take_id: UUID
    state: Literal["none", "offered", "making", "made", "refused", "used"]
    says: str = Field(description="Why it is offered, how the parts were found, or why there are none.")
    may_split: bool = Field(description="It is not reviewed yet and not discarded.")
    is_our_fault: bool = Field(description="It failed because of an error in our code; asking again may help.")
    shortest_pause_s: float
    found_by: Literal["regions", "markers", "silence"] | None
    parts: list[SplitPartRead]
    tray_action_id: UUID | None = Field(description="The action that made the parts variations, until it is undone.")
    split_from: SplitFrom | None


class SplitOffer(Schema):
    """A file that holds several sounds."""

    take_id: UUID
    file_name: ShownName
    cue: CueBrief | None
    variations: int | None = Field(description="Of its cue.")
    says: str = Field(examples=["3 sounds with silence between them (0.20 s, 1.40 s), 1.00 s long."])
