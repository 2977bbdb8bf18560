"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import CheckConstraint, ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.kit import clock
from app.kit.db import Base, new_id
from app.renders.rules import RenderState


class Render(Base):
    """One game file made from a take's master for one target, or the reason why not; never replaced."""

    __tablename__ = "renders_renders"
    __table_args__ = (
        UniqueConstraint("take_id", "target", "key"),
        CheckConstraint("(state = 'made') = (sha256 is not null)", name="made_has_file"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    target: Mapped[str]
    key: Mapped[str]  # hash of master, resolved target, peak limits, loop and renderer version
    state: Mapped[RenderState]
    refusal: Mapped[str | None]  # in words, with the mend
    sha256: Mapped[str | None]
    pcm_sha256: Mapped[str | None]
    file_bytes: Mapped[int | None]
    facts: Mapped[dict[str, Any]] = mapped_column(default=dict)
    measurements: Mapped[dict[str, Any]] = mapped_column(default=dict)
    attenuation_db: Mapped[float | None]
    created_at: Mapped[datetime] = mapped_column(default=clock.now)


class RenderSet(Base):
    """Every target's render of a take is made or refused, for one version of the spec and one edition of the take."""

    __tablename__ = "renders_sets"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    spec_id: Mapped[UUID] = mapped_column(ForeignKey("projects_specs.id"))
    edition: Mapped[int]
    completed_at: Mapped[datetime] = mapped_column(default=clock.now)


class Picture(Base):
    """What the eye and ear need of one stored sound: its shape at two sizes, its spectrum, a preview to play."""

    __tablename__ = "renders_pictures"
    __table_args__ = (UniqueConstraint("studio_id", "sound_sha256"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    sound_sha256: Mapped[str] = mapped_column(index=True)  # of a master or of a render
    duration_s: Mapped[float | None]  # None, like the hashes below, when the sound cannot be drawn
    facts: Mapped[dict[str, Any]] = mapped_column(default=dict)  # rate, depth, channels and frames
    thumb: Mapped[dict[str, Any]] = mapped_column(default=dict)  # points, min, max, rms as integers −127..127
    peaks_sha256: Mapped[str | None]
    spectrum_sha256: Mapped[str | None]
    preview_sha256: Mapped[str | None]
    preview_media_type: Mapped[str | None]
    created_at: Mapped[datetime] = mapped_column(default=clock.now)
