"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.renders.rules import BatchState, ItemState, RenderState


class Render(Dated, Base):
    """One game file made from a take's master for one target, or the reason why not; never replaced."""

    __tablename__ = "renders_renders"
    __table_args__ = (
        UniqueConstraint("take_id", "target", "key"),
        CheckConstraint("(state = 'made') = (sha256 is not null)", name="made_has_file"),
        Index("ix_renders_renders_kept", "studio_id", "sha256", "file_bytes"),  # what a studio keeps is summed up of it
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    target: Mapped[str]
    key: Mapped[str]  # hash of master, resolved target, peak limits, loop and renderer version
    state: Mapped[RenderState]
    refusal: Mapped[str | None]  # in words, with the fix
    sha256: Mapped[str | None]
    pcm_sha256: Mapped[str | None]
    file_bytes: Mapped[int | None]
    facts: Mapped[dict[str, Any]] = mapped_column(default=dict)
    measurements: Mapped[dict[str, Any]] = mapped_column(default=dict)
    attenuation_db: Mapped[float | None]
    # What was lost, with both spectra; read alone. None: refused, or made before losses were measured.
    loss: Mapped[dict[str, Any] | None] = mapped_column(deferred=True)


class RenderSet(StudioOwned, Base):
    """Every target's render of a take is made or refused, for one version of the spec and one edition of the take."""

    __tablename__ = "renders_sets"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    spec_id: Mapped[UUID] = mapped_column(ForeignKey("projects_specs.id"))
    edition: Mapped[int]
    completed_at: Mapped[datetime] = mapped_column(default=clock.now)


class Batch(StudioOwned, Dated, Base):
    """A re-render of a project's game files in one action: at a changed spec, or for a new target."""

    __tablename__ = "renders_batches"
    __table_args__ = (
        UniqueConstraint("project_id", "number"),
        CheckConstraint("(ended_at is null) = (state in ('planning', 'running'))", name="ended_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    number: Mapped[int]
    state: Mapped[BatchState] = mapped_column(default=BatchState.PLANNING)
    spec_id: Mapped[UUID | None] = mapped_column(ForeignKey("projects_specs.id"))  # None until it is planned
    targets: Mapped[list[str]] = mapped_column(default=list)  # empty: all of the spec's
    asked_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: the spec was changed
    note: Mapped[str] = mapped_column(default="")  # why it ended early
    ended_at: Mapped[datetime | None]


class BatchItem(StudioOwned, Base):
    """One game file of a batch: what it replaces in the game, and what happened to it."""

    __tablename__ = "renders_batch_items"
    __table_args__ = (
        UniqueConstraint("batch_id", "take_id", "target"),
        Index("ix_renders_batch_items_waiting", "batch_id", "state", "place"),
    )

    batch_id: Mapped[UUID] = mapped_column(ForeignKey("renders_batches.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    target: Mapped[str]
    category: Mapped[str] = mapped_column(default="")
    state: Mapped[ItemState] = mapped_column(default=ItemState.WAITING)
    before_bytes: Mapped[int | None] = mapped_column(BigInteger)  # None: the target had no file of this take
    after_bytes: Mapped[int | None] = mapped_column(BigInteger)  # None: there is none, or none yet
    reason: Mapped[str] = mapped_column(default="")  # why there is none, in words


class Picture(Dated, Base):
    """The pictures and preview of one stored sound: its waveform at two sizes, its spectrum, a preview to play."""

    __tablename__ = "renders_pictures"
    __table_args__ = (
        UniqueConstraint("studio_id", "sound_sha256"),
        Index("ix_renders_pictures_kept", "studio_id", "drawn_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    sound_sha256: Mapped[str] = mapped_column(index=True)  # of a master or of a render
    duration_s: Mapped[float | None]  # None, like the hashes below, when the sound cannot be drawn
    facts: Mapped[dict[str, Any]] = mapped_column(default=dict)  # rate, depth, channels and frames
    thumb: Mapped[dict[str, Any]] = mapped_column(default=dict)  # points, min, max, rms as integers −127..127
    peaks_sha256: Mapped[str | None]
    spectrum_sha256: Mapped[str | None]
    preview_sha256: Mapped[str | None]
    preview_media_type: Mapped[str | None]
    light_sha256: Mapped[str | None]  # of the preview in Ogg Vorbis; None: small, of a game file, or drawn before
    drawn_bytes: Mapped[int | None] = mapped_column(BigInteger)  # of all together; None: drawn before it was noted


class Timbre(StudioOwned, Dated, Base):
    """Features of a stored sound for comparison with others: its timbre and its spectrum."""

    __tablename__ = "renders_timbres"
    __table_args__ = (UniqueConstraint("studio_id", "sound_sha256"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    sound_sha256: Mapped[str]  # of a master
    timbre: Mapped[list[float]] = mapped_column(default=list)  # empty, like the bands, for silence
    bands_db: Mapped[list[float]] = mapped_column(default=list)  # from 20 Hz on, under the loudest


class Reel(ProjectOwned, Dated, Base):
    """All takes of a cue that a person may see, joined into one file for listening; it never ships."""

    __tablename__ = "renders_reels"
    __table_args__ = (
        UniqueConstraint("cue_id", "key"),
        CheckConstraint("sha256 is null or refusal is null", name="made_or_refused"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    key: Mapped[str]  # hash of the takes and of how they follow one another
    gap_ms: Mapped[int]
    crossfade_ms: Mapped[int]
    with_slates: Mapped[bool]
    takes: Mapped[list[dict[str, Any]]] = mapped_column(default=list)  # in order: take, preview, where it begins
    file_name: Mapped[str]
    is_spoken: Mapped[bool] = mapped_column(default=False)
    duration_s: Mapped[float | None]  # None, like the hash below, until it is made
    sha256: Mapped[str | None]
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    refusal: Mapped[str | None]  # in words


class MasterExport(ProjectOwned, Dated, Base):
    """A copy of a take's master with its provenance, as known when it was requested."""

    __tablename__ = "renders_master_exports"
    __table_args__ = (
        UniqueConstraint("take_id", "key"),
        CheckConstraint("sha256 is null or refusal is null", name="made_or_refused"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    key: Mapped[str]  # hash of the master and of what was known of it
    provenance: Mapped[dict[str, Any]]  # as audio_checks names it
    left: Mapped[list[str]] = mapped_column(default=list)  # what could not be written, in words
    file_name: Mapped[str]
    sha256: Mapped[str | None]  # None until it is made
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    refusal: Mapped[str | None]  # in words
