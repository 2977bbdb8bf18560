"""The bodies of this room."""

from typing import Any, Literal
from uuid import UUID

from pydantic import Field

from app.kit.http import Schema
from app.renders.rules import RenderState


class ThumbRead(Schema):
    """The shape of a sound in a row of a list: integers, ±127 is full scale."""

    points: int
    min: list[int]
    max: list[int]
    rms: list[int]


class BandsRead(Schema):
    """How the energy of a sound is spread over frequency, in sixths of an octave."""

    hz: list[float] = Field(description="The middle of each band.")
    dbfs: list[float | None] = Field(description="RMS of what lies in it, over the whole sound; null for nothing.")


class PeaksRead(Schema):
    """The shape of a sound across a screen: ±1.0 is full scale."""

    points: int
    frames: int
    sample_rate_hz: int
    duration_s: float
    min: list[float]
    max: list[float]
    rms: list[float]
    bands: BandsRead | None = Field(None, description="Null for a sound that was drawn by an earlier version.")


class SoundBrief(Schema):
    """Where the preview, peaks and spectrum of one stored sound are; null where drawing it failed."""

    picture_id: UUID | None
    duration_s: float | None
    thumb: ThumbRead | None
    preview_url: str | None
    peaks_url: str | None
    spectrum_url: str | None


class MasterSoundRead(SoundBrief):
    """A take's master, to see and to hear; its measurements are in its check."""

    state: Literal["drawn", "drawing", "undrawable"]
    facts: dict[str, Any]
    file_bytes: int


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
    mend: SoundBrief | None = Field(description="Its newest mended copy, once it is drawn.")
    renders: list[RenderSoundRead]
