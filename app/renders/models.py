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


class Picture(Base):
    """What the eye and ear need of one stored sound: its shape at two sizes, its spectrum, a preview to play."""

    __tablename__ = "renders_pictures"
    __table_args__ = (UniqueConstraint("studio_id", "sound_sha256"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    sound_sha256: Mapped[str]  # of a master or of a render
    duration_s: Mapped[float]
    thumb: Mapped[dict[str, Any]]  # points, min, max, rms as integers −127..127
    peaks_sha256: Mapped[str]
    spectrum_sha256: Mapped[str | None]
    preview_sha256: Mapped[str]
    preview_media_type: Mapped[str]
    created_at: Mapped[datetime] = mapped_column(default=clock.now)
