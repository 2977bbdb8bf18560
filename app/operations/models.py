"""The tables of this room: passes over all stored files, the files that they found damaged, and erasures to come."""

from datetime import date, datetime
from enum import StrEnum
from uuid import UUID

from sqlalchemy import BigInteger, ForeignKey, Index, text
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock
from app.core.columns import StudioOwned
from app.core.db import Base, new_id


class BlobState(StrEnum):
    """The fault of a blob that a row names."""

    MISSING = "missing"
    ALTERED = "altered"


class Scrub(Base):
    """One pass over all blobs that rows name, by studio and hash, and then over those that none names."""

    __tablename__ = "operations_scrubs"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    started_at: Mapped[datetime] = mapped_column(default=clock.now, index=True)
    finished_at: Mapped[datetime | None]
    last_studio_id: Mapped[UUID | None]  # of the blob that was verified last
    last_sha256: Mapped[str | None]
    blobs: Mapped[int] = mapped_column(default=0)
    size_bytes: Mapped[int] = mapped_column(BigInteger, default=0)
    missing: Mapped[int] = mapped_column(default=0)
    altered: Mapped[int] = mapped_column(default=0)
    orphaned: Mapped[int] = mapped_column(default=0)
    orphaned_bytes: Mapped[int] = mapped_column(BigInteger, default=0)


class DamagedBlob(Base):
    """A blob that was missing or altered when it was verified last."""

    __tablename__ = "operations_damaged_blobs"

    studio_id: Mapped[UUID] = mapped_column(primary_key=True)
    sha256: Mapped[str] = mapped_column(primary_key=True)
    kind: Mapped[str]
    state: Mapped[BlobState]
    found_at: Mapped[datetime] = mapped_column(default=clock.now)


class MasterRetention(StudioOwned, Base):
    """The announced deletion, or a producer's choice to keep, of the masters of a designer in a project."""

    __tablename__ = "operations_master_retentions"

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    ends_on: Mapped[date | None]  # as announced; None: not yet
    announced_at: Mapped[datetime | None]
    kept_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: by the contracts' years
    kept_at: Mapped[datetime | None]
    deleted_at: Mapped[datetime | None]  # what was delivered later is kept


class Erasure(Base):
    """A project, or a studio with all its projects, that is erased once its day comes."""

    __tablename__ = "operations_erasures"
    __table_args__ = (
        Index(
            "uq_operations_erasures_of_studio",
            "studio_id",
            unique=True,
            sqlite_where=text("project_id is null"),
            postgresql_where=text("project_id is null"),
        ),
        Index("uq_operations_erasures_of_project", "project_id", unique=True),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID | None] = mapped_column(ForeignKey("projects_projects.id"))  # None: the studio
    requested_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    requested_at: Mapped[datetime] = mapped_column(default=clock.now)
    due_at: Mapped[datetime] = mapped_column(index=True)
