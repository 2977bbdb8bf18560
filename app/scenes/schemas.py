"""The bodies of this room."""

from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.renders.schemas import ThumbRead
from app.scenes.rules import HIGHEST_DB, LOWEST_DB, BedRole, LevelFrom

LevelDb = Annotated[float, Field(ge=LOWEST_DB, le=HIGHEST_DB, allow_inf_nan=False)]
Category = Annotated[str, Field(max_length=200, pattern="^[^\\x00]*$")]


class BedSet(Schema):
    """A bed of a project or of one category: an approved sound, or a sound of the references."""

    role: BedRole
    category: Category = Field("", description="Empty: under the sounds of the whole project.")
    take_id: UUID | None = Field(None, description="Of an approved version.")
    reference_id: UUID | None = Field(None, description="Of a sound on the references board; its part plays.")
    level_db: LevelDb = -12.0
    is_on: bool = True


class BedChange(Schema):
    """The changes of a bed; fields that are left out stay."""

    level_db: LevelDb | None = None
    is_on: bool | None = None


class BedRead(Schema):
    """A bed as it is set."""

    id: UUID
    role: BedRole
    category: str
    take_id: UUID | None
    reference_id: UUID | None
    level_db: float
    is_on: bool


class BedSource(Schema):
    """A sound that can be a bed."""

    take_id: UUID | None
    reference_id: UUID | None
    name: str
    loops: bool


class SceneLaneRead(Schema):
    """One sound of a scene: when it plays, how loud, and what plays it."""

    id: str = Field(description="`sound`, or the id of the neighbour's cue, or the bed's role.")
    name: str
    cue_id: UUID | None
    take_id: UUID | None
    bed: BedRead | None
    reference_version_id: UUID | None = Field(
        description="Of a bed from the references. Its opening is recorded before it is sent."
    )
    preview_url: str | None = Field(description="Null while it is prepared, or where it cannot be played.")
    thumb: ThumbRead | None
    duration_s: float | None
    loops: bool
    starts_s: list[float]
    level_db: float
    level_from: LevelFrom
    is_on: bool
    is_measured: bool
    problem: str


class ClipRead(Schema):
    """A clip of the game that shows where a sound plays."""

    reference_id: UUID
    reference_version_id: UUID
    caption: str
    file_name: str
    media_type: str
    start_s: float
    end_s: float | None


class SceneRead(Schema):
    """A version among what sounds with it: the first lane is the version itself."""

    take_id: UUID
    cue_id: UUID
    category: str
    length_s: float
    has_spots: bool = Field(description="Whether the list says when the sound plays; else it plays once.")
    audit_label: str | None = Field(description="Of the newest audit of a build, which the levels come from.")
    lanes: list[SceneLaneRead]
    clips: list[ClipRead]
    is_ready: bool = Field(description="Whether all that can be prepared is.")
    may_change: bool


class MaskedBand(Schema):
    """One band of hearing: how far the sound stands above what covers it there."""

    hz: float = Field(description="The centre of the band.")
    is_part: bool = Field(description="Whether the sound has anything here, within 40 dB of its loudest.")
    is_heard: bool
    sound_db: float | None
    cover_db: float | None = Field(description="The level from which the sound would be heard; null for none.")
    margin_db: float | None = Field(description="Between the two; null where one of them is missing.")
    covered_by: str | None = Field(description="The lane that is strongest here.")


class MaskingRead(Schema):
    """The bands of a sound that are heard in its scene. A person decides whether that is enough."""

    is_measured: bool = Field(description="False while a sound of the scene is still being measured.")
    is_compared: bool = Field(description="False where nothing else sounds: then there are no bands and no figures.")
    missing: str = Field(description="What the scene lacks, in words; empty where it has a bed and neighbours.")
    bands: list[MaskedBand]
    part_bands: int
    heard_bands: int
    energy_share: float
    time_share: float
    in_words: str


class SoundComparisonAdd(Schema):
    """The sound to compare a version with: another version, or one of its own game files. Exactly one of the two."""

    against_take_id: UUID | None = None
    target: Annotated[str, Field(max_length=100, pattern="^[^\\x00]*$")] | None = None


class SpectraRead(Schema):
    """Three long-term spectra in the same bands, in dBFS; null for silence."""

    hz: list[float]
    sound_dbfs: list[float | None]
    against_dbfs: list[float | None]
    difference_dbfs: list[float | None]


class SoundComparisonRead(Schema):
    """The difference of a version from another sound, both aligned to the sample and brought to one level."""

    id: UUID
    is_made: bool
    lag_s: float | None = Field(description="How much later the other sound had to begin.")
    gain_db: float | None = Field(description="How much louder the other sound had to be.")
    residue_db: float | None = Field(description="The level of the difference against that of the version.")
    spectra: SpectraRead | None
    file_url: str | None
    refusal: str | None
