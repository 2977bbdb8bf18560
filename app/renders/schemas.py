"""The bodies of this room."""

from datetime import datetime
from typing import Any, Literal
from uuid import UUID

from pydantic import BaseModel, ConfigDict, Field

from app.core.web.http import Schema
from app.deliveries.schemas import CueBrief
from app.renders.rules import BatchState, RenderState


class ThumbRead(Schema):
    """The shape of a sound in a row of a list: integers, ±127 is full scale."""

    points: int
    min: list[int]
    max: list[int]
    rms: list[int]


class BandsRead(Schema):
    """The spectrum of a sound, in sixths of an octave."""

    hz: list[float] = Field(description="The centre of each band.")
    dbfs: list[float | None] = Field(description="RMS within it, over the whole sound; null for silence.")


class PeaksRead(Schema):
    """The shape of a sound across a screen."""

    points: int
    frames: int
    sample_rate_hz: int
    duration_s: float
    full_scale: int = Field(1, description="The value of full scale; sounds drawn by an earlier version have 1.")
    min: list[float]
    max: list[float]
    rms: list[float]
    bands: BandsRead | None = Field(None, description="Null for a sound that was drawn by an earlier version.")


class SoundBrief(Schema):
    """The addresses of preview, peaks and spectrum of one stored sound; null if drawing it failed."""

    picture_id: UUID | None
    duration_s: float | None
    thumb: ThumbRead | None
    preview_url: str | None
    peaks_url: str | None
    spectrum_url: str | None


class TakeSound(SoundBrief):
    """A take's master, to play."""

    take_id: UUID


class MasterSoundRead(SoundBrief):
    """A take's master, to show and play; its measurements are in its check."""

    state: Literal["drawn", "drawing", "undrawable"]
    facts: dict[str, Any]
    file_bytes: int


class OtherSound(SoundBrief):
    """A sound of another designer that the project lets its designers hear."""

    id: UUID
    cue: CueBrief
    category: str
    variation: int
    variations: int
    is_palette: bool
    is_approved: bool = Field(description="False while it waits for approval.")


class RenderSoundRead(SoundBrief):
    """One game file of a take at the current spec, or the reason why there is none."""

    id: UUID | None
    target: str
    state: RenderState | Literal["waiting"]
    refusal: str | None
    facts: dict[str, Any]
    measurements: dict[str, Any]
    attenuation_db: float | None
    file_bytes: int | None
    file_url: str | None


class TakeSoundsRead(Schema):
    """Everything of a take that can be played."""

    take_id: UUID
    master: MasterSoundRead
    fix: SoundBrief | None = Field(description="Its newest fixed copy, once it is drawn.")
    renders: list[RenderSoundRead]
    closed: str | None = Field(
        description="Why masters and game files cannot be downloaded now, where the contract opens them by payment."
    )


class BatchAdd(Schema):
    """The renders to make again."""

    targets: list[str] = Field(default_factory=list, max_length=100, description="Empty: all of the spec's.")


class BatchSummary(Schema):
    """One batch and how far it is."""

    id: UUID
    number: int
    state: BatchState
    targets: list[str] = Field(description="Empty: all that the spec has.")
    by_spec: bool = Field(description="A change of the spec asked for it, and no person.")
    note: str = Field(description="Why it ended early.")
    created_at: datetime
    ended_at: datetime | None
    files: int
    waiting: int
    made: int
    kept: int = Field(description="Game files that are what is wanted already.")
    refused: int
    left: int = Field(description="Game files whose version may not ship at the moment, or whose master is lost.")


class BatchSizes(Schema):
    """The bytes of a target's game files of one category, before and after."""

    target: str
    category: str
    files: int
    before_bytes: int
    after_bytes: int


class BatchTrouble(Schema):
    """A game file that a batch could not make, and why."""

    cue: str
    name: str
    target: str
    reason: str


class BatchRead(BatchSummary):
    """One batch with what it did to the sizes, and the first game files that it could not make."""

    sizes: list[BatchSizes]
    trouble: list[BatchTrouble]


class LossSpectra(Schema):
    """Master and game file in the same bands, RMS over the whole sound; null where there is nothing."""

    hz: list[float]
    master_dbfs: list[float | None]
    render_dbfs: list[float | None]


class LossLevels(BaseModel):
    """Levels of one sound, named as in the report; null is silence."""

    model_config = ConfigDict(extra="allow")

    sample_peak_dbfs: float | None = None
    true_peak_dbtp: float | None = None
    short_loudness_lufs: float | None = None
    integrated_lufs: float | None = None


class SeamRead(Schema):
    """A loop's seam against the sound around it."""

    step_db: float | None
    slope_db: float | None


class LossRead(BaseModel):
    """The loss of a game file against its master; null in dB means silence."""

    before: LossLevels
    after: LossLevels
    above_nyquist_db: float | None = Field(
        description="Energy above half the new rate against all of the master's, in dB."
    )
    shelf_db: float
    attenuation_db: float
    requantisation_dbfs: float | None = Field(
        description="RMS of what rounding and dither added; null: every sample is exact."
    )
    trimmed_s: list[float] = Field(description="At the start, and at the end.")
    loop_fit_frames: float
    seam_before: SeamRead | None
    seam_after: SeamRead | None
    mono_loss_db: float | None
    spectra: LossSpectra


Slates = Literal["spoken", "beeped", "none"]


class ReelAdd(Schema):
    """The order and gaps of a cue's takes in a reel."""

    gap_ms: int = Field(500, ge=0, le=5_000, description="Silence between takes.")
    crossfade_ms: int = Field(0, ge=0, le=5_000, description="In place of the gap; 0: none.")
    slates: Slates = Field(
        "spoken", description="How each take is announced; by beeps too if the server has no speech."
    )
    order: Literal["oldest", "newest"] = Field("oldest", description="Which take comes first, of each variation.")


class ReelTake(Schema):
    """One take of a reel."""

    take_id: UUID
    variation: int
    number: int
    start_s: float | None = Field(description="Where it begins; null until the reel is made.")


class ReelRead(Schema):
    """All takes of a cue in a row, to be listened to; never for what ships."""

    id: UUID
    cue_id: UUID
    state: Literal["making", "made", "refused"]
    refusal: str | None
    gap_ms: int
    crossfade_ms: int
    slates: Slates
    takes: list[ReelTake]
    duration_s: float | None
    file_bytes: int | None
    file_name: str
    file_url: str | None


class MasterExportRead(Schema):
    """A take's master with what is known of it written into bext and iXML; its sound is the master's, byte for byte."""

    id: UUID
    take_id: UUID
    state: Literal["making", "made", "refused"]
    refusal: str | None
    fields: dict[str, str] = Field(description="Its metadata, by the field names of ASWG-G006.")
    left: list[str] = Field(description="What could not be written, as sentences.")
    file_bytes: int | None
    file_name: str
    file_url: str | None
