"""The tables of this room."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import StudioOwned
from app.core.db import Base, new_id
from app.references.rules import PreviewState, ReferenceKind


class Reference(StudioOwned, Base):
    """A thing that shows or says how something is meant: pinned to a cue, to a category, or to the whole project."""

    __tablename__ = "references_references"
    __table_args__ = (
        Index("ix_references_references_board", "project_id", "id"),
        CheckConstraint("cue_id is null or category is null", name="pinned_once"),
        CheckConstraint("(removed_at is null) = (removed_by is null)", name="removed_by_a_person"),
        CheckConstraint("end_s is null or end_s > start_s", name="range_ends_later"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    category: Mapped[str | None]
    caption: Mapped[str]
    terms: Mapped[str]  # under which a licensed original may be used
    words: Mapped[str] = mapped_column(default="")  # that it shows: "warm, crunchy"
    start_s: Mapped[float | None]
    end_s: Mapped[float | None]
    newest_number: Mapped[int]
    spotted_from_id: Mapped[UUID | None] = mapped_column(  # the clip of which it is a part; follows its new versions
        ForeignKey("references_references.id"), index=True
    )
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
    removed_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    removed_at: Mapped[datetime | None]  # off the board; its versions stay


class ReferenceVersion(Base):
    """One file or link of a reference; the newest is shown, and none is ever altered."""

    __tablename__ = "references_versions"
    __table_args__ = (
        UniqueConstraint("reference_id", "number"),
        CheckConstraint("(url is null) <> (sha256 is null)", name="file_or_link"),
        CheckConstraint("(sha256 is null) = (file_bytes is null)", name="file_has_a_size"),
        Index("ix_references_versions_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    reference_id: Mapped[UUID] = mapped_column(ForeignKey("references_references.id"))
    number: Mapped[int]
    kind: Mapped[ReferenceKind]
    media_type: Mapped[str]
    file_name: Mapped[str]  # of a link: its host
    url: Mapped[str | None]
    sha256: Mapped[str | None]
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    excerpt: Mapped[str]  # the beginning of a text
    preview: Mapped[PreviewState]
    problem: Mapped[str] = mapped_column(default="")  # why no preview could be drawn
    width_px: Mapped[int | None]
    height_px: Mapped[int | None]
    thumb_sha256: Mapped[str | None]
    thumb_bytes: Mapped[int | None]
    view_sha256: Mapped[str | None]
    view_bytes: Mapped[int | None]
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
    reference: Mapped[Reference] = relationship(lazy="raise")
    author: Mapped[Person] = relationship(lazy="raise")


class ReferenceOpening(StudioOwned, Base):
    """One time that a person opened a version; what is opened again within minutes is one opening."""

    __tablename__ = "references_openings"
    __table_args__ = (
        Index("ix_references_openings_of_person", "version_id", "person_id", "opened_at"),
        Index("ix_references_openings_log", "project_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    version_id: Mapped[UUID] = mapped_column(ForeignKey("references_versions.id"))
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    opened_at: Mapped[datetime] = mapped_column(default=clock.now)
    version: Mapped[ReferenceVersion] = relationship(lazy="raise")
    person: Mapped[Person] = relationship(lazy="raise")
