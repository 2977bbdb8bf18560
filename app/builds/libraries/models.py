"""The tables by which files of sound libraries are found again in delivered takes."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import StudioOwned
from app.core.db import Base, new_id


class SoundLibrary(Base):
    """A sound library that a person registered in a studio, by the fingerprints of its files."""

    __tablename__ = "builds_sound_libraries"
    __table_args__ = (UniqueConstraint("studio_id", "person_id", "name"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))  # who registered it
    name: Mapped[str]
    licence: Mapped[str] = mapped_column(default="")
    sounds: Mapped[int] = mapped_column(default=0)
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
    person: Mapped[Person] = relationship(lazy="raise")


class LibrarySound(StudioOwned, Base):
    """A file of a sound library: its fingerprint, and never its sound."""

    __tablename__ = "builds_library_sounds"

    library_id: Mapped[UUID] = mapped_column(
        ForeignKey("builds_sound_libraries.id", ondelete="CASCADE"), primary_key=True
    )
    path: Mapped[str] = mapped_column(primary_key=True)  # below the folder that was fingerprinted
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    fingerprint_version: Mapped[int]
    pcm_sha256: Mapped[str]
    sample_rate_hz: Mapped[int]
    fingerprint: Mapped[bytes]
    moments: Mapped[bytes]  # of the fingerprint: its loudest, for finding it quickly


class LibraryMatch(Base):
    """A take that holds the same sound as a file of a library; name and licence are those of when it was found."""

    __tablename__ = "builds_library_matches"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    library_id: Mapped[UUID] = mapped_column(
        ForeignKey("builds_sound_libraries.id", ondelete="CASCADE"), primary_key=True, index=True
    )
    path: Mapped[str] = mapped_column(primary_key=True)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    name: Mapped[str]  # of the library
    licence: Mapped[str]
    score: Mapped[float]
    gain_db: Mapped[float]  # by how much the take is louder than the file
    has_same_samples: Mapped[bool]
    is_trimmed: Mapped[bool]
    is_resampled: Mapped[bool]
    found_at: Mapped[datetime] = mapped_column(default=clock.now)
