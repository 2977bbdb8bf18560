"""Bodies that this room reads and answers."""

from datetime import date, datetime
from typing import Any, Literal
from uuid import UUID

from pydantic import BaseModel, ConfigDict, Field

from app.builds.engine_export.cues import Handoff
from app.builds.rules import PackState
from app.core.web.http import Schema


class MissingFile(Schema):
    """An accepted sound that a target has no game file of, and why."""

    cue_id: UUID
    label: str
    name: str
    file_name: str
    reason: str


class ChangedPath(Schema):
    """A game file that is not as it was in an earlier pack."""

    path: str
    kind: Literal["new", "changed", "gone"]


class PackChanges(Schema):
    """Changes of the game files since an earlier pack of the target; same: the same sound and loop."""

    since: int | None = Field(description="The number of that pack; null where there was none.")
    new: int
    changed: int
    gone: int
    same: int
    paths: list[ChangedPath] = Field(description="The first of each kind.")


class PackRead(Schema):
    """The content of the approved pack of a target."""

    target: str
    targets: list[str]
    files: int
    bytes: int
    masters_bytes: int
    cues_accepted: int
    cues_wanted: int = Field(description="Cues of the list that are not cut.")
    handoff: Handoff = Field(description="That of the target's newest sealed pack.")
    changes: PackChanges
    missing: list[MissingFile]


class PackAdd(Schema):
    """The pack to seal."""

    target: str = Field(min_length=1, max_length=100)
    note: str = Field("", max_length=2_000)
    masters: bool = False
    allow_missing: bool = Field(False, description="Leave out accepted sounds that have no game file.")
    placeholders: bool = Field(
        False, description="Put marked placeholder files in for the sounds that are not accepted."
    )
    handoff: Handoff = Field(Handoff.NONE, description="The engine whose import files go with the sounds.")


class SealedPackSummary(Schema):
    """A pack that was handed out, or is being put together."""

    id: UUID
    target: str
    number: int
    note: str
    with_masters: bool
    placeholders: bool
    handoff: Handoff
    state: PackState
    refusal: str = Field(description="Why it could not be put together.")
    sealed_by: str
    created_at: datetime
    sealed_at: datetime | None
    files: int = Field(description="Game files.")
    placeholder_files: int = Field(description="Placeholder files in addition.")
    bytes: int


class SealedPackRead(SealedPackSummary):
    """A pack, and what is not as it was in the one before."""

    changes: PackChanges


class ReportTool(BaseModel):
    """The tool that wrote the report."""

    model_config = ConfigDict(extra="allow")

    name: str = Field(max_length=100)
    version: str = Field(max_length=100)


class ReportSpec(BaseModel):
    """The spec that the files were judged by."""

    model_config = ConfigDict(extra="allow")

    name: str = Field(max_length=500)
    sha256: str = Field(max_length=64)


class ReportFinding(BaseModel):
    """One rule that a file breaks."""

    model_config = ConfigDict(extra="allow")

    code: str = Field(max_length=200)
    severity: Literal["error", "warning", "information"]
    message: str = Field(max_length=10_000)
    waived: bool = False


class ReportFile(BaseModel):
    """The report on one file."""

    model_config = ConfigDict(extra="allow")

    path: str = Field(max_length=10_000)
    verdict: Literal["conforming", "rejected", "unreadable", "unjudged"]
    findings: list[ReportFinding] = Field(max_length=1000)


class CheckReport(BaseModel):
    """A report of audio-checks, as its JSON format has it."""

    model_config = ConfigDict(extra="allow")

    schema_version: Literal[1]
    tool: ReportTool
    spec: ReportSpec | None
    files: list[ReportFile] = Field(max_length=20_000)
    summary: dict[str, int]


class BuildAdd(Schema):
    """The report of a game's CI on one build."""

    label: str = Field(min_length=1, max_length=200)
    commit: str = Field("", max_length=200)
    target: str = Field("", max_length=100)
    report: CheckReport


class BuildSummary(Schema):
    """One build, without its report."""

    id: UUID
    label: str
    commit: str
    target: str
    files: int
    rejected: int = Field(description="Files that are refused: rejected without a waiver, unreadable or unjudged.")
    warnings: int
    created_at: datetime


class BuildRead(BuildSummary):
    """One build with its whole report."""

    report: dict[str, Any]


class WaivedSound(Schema):
    """Codes that the approver let through for one sound, found by the hash of its samples."""

    pcm_sha256: str
    codes: list[str]
    reason: str
    cue: str | None
    file_name: str


class AcceptedSound(Schema):
    """A drift that was accepted for one sound, with its reason and day."""

    path: str
    status: str
    played_status: str
    gain_db: float | None
    reason: str
    on: date


class Baseline(Schema):
    """The baseline for `audio-checks check --baseline` and `audio-checks audit --baseline`."""

    format: Literal[1] = 1
    waived: list[WaivedSound]
    accepted: list[AcceptedSound] = Field(description="For audits; `check` leaves it alone.")


class ManifestTool(Schema):
    """The tool that made the manifest."""

    name: Literal["audio-checks"]
    version: str


class ManifestPart(Schema):
    """One gain on the way of a sound to the output."""

    object: str
    property: str
    gain_db: float


class ManifestPlay(Schema):
    """One way in which the game played a sound when its level was approved."""

    object: str = Field(description="In the project's tree.")
    gain_db: float | None = Field(description="Null where a script set it.")
    parts: list[ManifestPart]


class ManifestSound(Schema):
    """One approved game file, and what it is known by."""

    path: str = Field(description="In the pack, and so in the game.")
    pcm_sha256: str | None
    sample_rate_hz: int
    bit_depth: int | None
    channels: int
    frames: int
    sample_peak_dbfs: float | None = Field(description="Null for silence, like the next.")
    rms_dbfs: float | None
    fingerprint: str | None = Field(description="Base64; null where there is nothing to know it by.")
    cue: str | None = Field(description="The number of its cue.")
    take: str | None = Field(description="The id of its take.")
    plays: list[ManifestPlay] | None = Field(
        default=None, description="Null where no level was approved: then its file counts as it is."
    )


class Manifest(Schema):
    """The manifest for `audio-checks audit --manifest`."""

    schema_version: Literal[1]
    tool: ManifestTool
    fingerprint_version: int
    files: list[ManifestSound]


class CiLines(Schema):
    """Shell lines for the game's CI; the token goes into its secrets as SOUNDLIST_TOKEN."""

    command: str = Field(description="One line that does everything, by `soundlist ci`.")
    lines: list[str] = Field(description="The same with curl and audio-checks, for a CI that changes a step of it.")


class PlaceholderRead(Schema):
    """One file that the game has no accepted sound for yet."""

    cue_id: UUID
    cue: str
    name: str
    trigger: str = Field(description="The event that plays it, as the list says.")
    variation: int
    path: str
    category: str
    state: Literal["missing", "made", "outdated", "refused"] = Field(
        description="Whether a placeholder file is there; outdated: cue or spec changed since it was made."
    )
    spoken: bool
    refusal: str | None


class PlaceholderRegister(Schema):
    """The remaining placeholders, counted down as sounds are accepted."""

    target: str
    targets: list[str]
    files: int = Field(description="Files that the list asks for.")
    replaced: int = Field(description="Those with an accepted sound.")
    left: int
    made: int = Field(description="Those left that have a placeholder file to spec.")
    items: list[PlaceholderRead]


class CategoryCountdown(Schema):
    """The number of files of one category that are still placeholders."""

    category: str
    files: int
    left: int


class PlaceholderCountdown(Schema):
    """The number of remaining placeholders, without their names."""

    target: str
    cues: int = Field(description="Cues of the list that are not cut.")
    cues_left: int = Field(description="Those of which a file has no accepted sound.")
    files: int
    left: int
    categories: list[CategoryCountdown] = Field(description="By name; one without a category first.")
    next: PlaceholderRead | None = Field(
        description="The next to record: the most settled, in list order, of which no version is under way."
    )


class PlaceholdersAdd(Schema):
    """The target for which placeholder files are to be made."""

    target: str = Field(min_length=1, max_length=100)


class MemoryRead(Schema):
    """The memory of some of a target's files."""

    category: str | None
    files: int
    unknown_files: int = Field(description="Left out, because their cues have no length yet.")
    pcm_bytes: int
    disk_bytes: int
    memory_bytes: int
    budget_bytes: int | None
    over_bytes: int | None


class MemoryByCategory(Schema):
    """The memory of a target, in total and by category."""

    total: MemoryRead
    categories: list[MemoryRead]


class TargetMemory(Schema):
    """The format of a target's game files, and their memory in the game."""

    name: str
    engine: str | None = Field(description="Whose preset bears this name.")
    accepts: str | None = Field(description="What that engine imports.")
    why: str | None
    sample_rate_hz: int
    bit_depth: int
    encoding: str
    quality: float | None = Field(description="Of what a lossy codec keeps, 0 to 1.")
    channels: Literal["master", 1, 2]
    dither: str
    folder: str
    codec_ratio: float
    streamed: bool
    used: MemoryByCategory = Field(description="Of the accepted sounds, as their files are.")
    forecast: MemoryByCategory = Field(description="Those, and the rest of the list by the lengths that it asks for.")


class PresetRead(Schema):
    """A target for one engine, to be added to the spec."""

    name: str
    engine: str
    accepts: str
    why: str
    toml: str


class TargetsRead(Schema):
    """The targets of the newest spec, and what there is to start from."""

    targets: list[TargetMemory]
    presets: list[PresetRead]


class OpenCue(Schema):
    """A cue of a contract that has ended, which no contract covers now."""

    id: UUID
    label: str
    name: str


class OpenHandover(Schema):
    """A contract that has ended with cues that wait for another designer."""

    contract_id: UUID
    title: str
    designer: str
    ended_at: datetime
    cues: list[OpenCue]
