"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock
from app.core.columns import Dated, StudioOwned
from app.core.db import Base, new_id
from app.scenes.rules import BedRole


class Bed(StudioOwned, Base):
    """The sound under those of a project, or under those of one category, where it replaces the project's."""

    __tablename__ = "scenes_beds"
    __table_args__ = (
        UniqueConstraint("project_id", "category", "role"),
        CheckConstraint("(take_id is null) <> (reference_id is null)", name="take_or_reference"),
        CheckConstraint("level_db between -60 and 12", name="level_in_range"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    category: Mapped[str]  # empty: the whole project
    role: Mapped[BedRole]
    take_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"))
    reference_id: Mapped[UUID | None] = mapped_column(ForeignKey("references_references.id"))
    level_db: Mapped[float]
    is_on: Mapped[bool]
    changed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)


class SceneSound(Dated, Base):
    """A stored sound's excitation of the ear; of a reference also the part that plays, in a form for browsers."""

    __tablename__ = "scenes_sounds"
    __table_args__ = (
        UniqueConstraint("studio_id", "sound_sha256", "part"),
        Index("ix_scenes_sounds_kept", "studio_id", "preview_sha256", "preview_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    sound_sha256: Mapped[str]  # of the preview of a take, or of the file of a reference
    part: Mapped[str]  # of a reference, as in "1.5-9"; empty for a take
    duration_s: Mapped[float | None]  # None, like all below, while `problem` says why there is none
    excitation: Mapped[str | None] = mapped_column(deferred=True)  # base64, see app/scenes/excitations.py
    thumb: Mapped[dict[str, Any]] = mapped_column(default=dict)
    preview_sha256: Mapped[str | None]
    preview_bytes: Mapped[int | None] = mapped_column(BigInteger)
    problem: Mapped[str] = mapped_column(default="")


class Comparison(Dated, Base):
    """One sound against another: both spectra, and what is left of the one without the other, as a track to hear."""

    __tablename__ = "scenes_comparisons"
    __table_args__ = (
        UniqueConstraint("project_id", "sound_sha256", "against_sha256"),
        CheckConstraint("sha256 is null or refusal is null", name="made_or_refused"),
        Index("ix_scenes_comparisons_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    sound_sha256: Mapped[str]  # of what plays, like the one below
    against_sha256: Mapped[str]
    lag_s: Mapped[float | None]  # the other one was moved by so much; None, like all below, until it is made
    gain_db: Mapped[float | None]  # and by this, before it was taken away
    residue_db: Mapped[float | None]  # what is left, against the sound itself
    spectra: Mapped[dict[str, Any]] = mapped_column(default=dict)
    sha256: Mapped[str | None]
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    refusal: Mapped[str | None]  # in words
