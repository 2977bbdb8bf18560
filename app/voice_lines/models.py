"""The tables of this room."""

from datetime import date, datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.sound_lists.models import Cue
from app.voice_lines.rules import DEFAULT_TOLERANCE_PERCENT, SyntheticUse


class VoiceSettings(StudioOwned, Base):
    """Settings for all voice lines of a project; a project without it has the defaults."""

    __tablename__ = "voice_lines_settings"
    __table_args__ = (
        UniqueConstraint("project_id"),
        CheckConstraint("tolerance_percent between 1 and 100", name="tolerance_in_range"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    original_language: Mapped[str]
    tolerance_percent: Mapped[int] = mapped_column(default=DEFAULT_TOLERANCE_PERCENT)


class Character(StudioOwned, Base):
    """A speaking part of the script."""

    __tablename__ = "voice_lines_characters"
    __table_args__ = (UniqueConstraint("project_id", "folded"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    name: Mapped[str]
    folded: Mapped[str]  # two characters that differ in case only are one
    notes: Mapped[str] = mapped_column(default="")  # how the voice is meant


class Performer(StudioOwned, Base):
    """The person behind one or more voices, by the name on their releases."""

    __tablename__ = "voice_lines_performers"
    __table_args__ = (UniqueConstraint("project_id", "folded"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    name: Mapped[str]
    folded: Mapped[str]


class Casting(ProjectOwned, Base):
    """A character's performer in one language, the session director, and the person who casts."""

    __tablename__ = "voice_lines_castings"
    __table_args__ = (UniqueConstraint("character_id", "language"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    character_id: Mapped[UUID] = mapped_column(ForeignKey("voice_lines_characters.id"))
    language: Mapped[str]
    performer_id: Mapped[UUID | None] = mapped_column(ForeignKey("voice_lines_performers.id"), index=True)
    directed_by: Mapped[str] = mapped_column(default="")
    cast_by: Mapped[str] = mapped_column(default="")
    character: Mapped[Character] = relationship(lazy="raise")
    performer: Mapped[Performer | None] = relationship(lazy="raise")


class VoiceLine(StudioOwned, Dated, Base):
    """One line of the script, whatever its language."""

    __tablename__ = "voice_lines_lines"
    __table_args__ = (
        UniqueConstraint("project_id", "folded"),
        Index("ix_voice_lines_lines_order", "project_id", "position"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    character_id: Mapped[UUID] = mapped_column(ForeignKey("voice_lines_characters.id"), index=True)
    key: Mapped[str]  # its id in the script, by which a later script finds it
    folded: Mapped[str]
    file_name: Mapped[str]  # without an ending; the same in each language's folder
    scene: Mapped[str] = mapped_column(default="")
    direction: Mapped[str] = mapped_column(default="")
    position: Mapped[int]
    character: Mapped[Character] = relationship(lazy="raise")


class VoiceText(StudioOwned, Base):
    """A line in one language: the cue that its takes belong to, and its newest text."""

    __tablename__ = "voice_lines_texts"
    __table_args__ = (
        UniqueConstraint("line_id", "language"),
        Index("ix_voice_lines_texts_language", "project_id", "language"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    line_id: Mapped[UUID] = mapped_column(ForeignKey("voice_lines_lines.id"))
    language: Mapped[str]
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), unique=True)
    text: Mapped[str]
    newest_number: Mapped[int] = mapped_column(default=1)
    line: Mapped[VoiceLine] = relationship(lazy="raise")
    cue: Mapped[Cue] = relationship(lazy="raise")


class VoiceTextVersion(ProjectOwned, Base):
    """A text as it was from one moment on; what a take was recorded from is known by its time."""

    __tablename__ = "voice_lines_text_versions"
    __table_args__ = (
        UniqueConstraint("text_id", "number"),
        CheckConstraint("(takes_fit_at is null) = (takes_fit_by is null)", name="fit_said_by_a_person"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    text_id: Mapped[UUID] = mapped_column(ForeignKey("voice_lines_texts.id"))
    number: Mapped[int]
    text: Mapped[str]
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    written_at: Mapped[datetime] = mapped_column(default=clock.now)
    takes_fit_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    takes_fit_at: Mapped[datetime | None]  # earlier takes still fit this text: a comma moved
    author: Mapped[Person] = relationship(lazy="raise", foreign_keys=[written_by])


class Release(Base):
    """A performer's signed release, as a file with its dates, and what it says of synthetic use of the voice."""

    __tablename__ = "voice_lines_releases"
    __table_args__ = (
        CheckConstraint("valid_until is null or valid_until >= valid_from", name="ends_after_it_begins"),
        CheckConstraint("(removed_at is null) = (removed_by is null)", name="removed_by_a_person"),
        Index("ix_voice_lines_releases_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    performer_id: Mapped[UUID] = mapped_column(ForeignKey("voice_lines_performers.id"), index=True)
    file_name: Mapped[str]
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    valid_from: Mapped[date]
    valid_until: Mapped[date | None]  # None: without an end
    synthetic_use: Mapped[SyntheticUse]
    note: Mapped[str] = mapped_column(default="")
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
    removed_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    removed_at: Mapped[datetime | None]
    performer: Mapped[Performer] = relationship(lazy="raise")
    adder: Mapped[Person] = relationship(lazy="raise", foreign_keys=[added_by])
