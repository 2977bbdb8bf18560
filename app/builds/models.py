"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import ForeignKey
from sqlalchemy.orm import Mapped, mapped_column

from app.kit import clock
from app.kit.db import Base, new_id


class Build(Base):
    """One run of audio-checks in the game's CI, with its whole report."""

    __tablename__ = "builds_builds"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    label: Mapped[str]
    commit: Mapped[str] = mapped_column(default="")
    target: Mapped[str] = mapped_column(default="")
    files: Mapped[int]
    rejected: Mapped[int]  # rejected, unreadable and unjudged files
    warnings: Mapped[int]
    report: Mapped[dict[str, Any]]
    token_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_tokens.id"))
    created_at: Mapped[datetime] = mapped_column(default=clock.now)
