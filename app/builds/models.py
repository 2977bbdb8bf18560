"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.builds.engine_export.cues import Handoff
from app.builds.rules import FileKind, PackState
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id


class Build(ProjectOwned, Dated, Base):
    """One run of audio-checks in the game's CI, with its whole report."""

    __tablename__ = "builds_builds"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    label: Mapped[str]
    commit: Mapped[str] = mapped_column(default="")
    target: Mapped[str] = mapped_column(default="")
    files: Mapped[int]
    rejected: Mapped[int]  # rejected, unreadable and unjudged files
    warnings: Mapped[int]
    report: Mapped[dict[str, Any]]
    token_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_tokens.id"))


class SealedPack(StudioOwned, Dated, Base):
    """A pack as it was handed out: numbered for its target, and never changed."""

    __tablename__ = "builds_packs"
    __table_args__ = (
        UniqueConstraint("project_id", "target", "number"),
        CheckConstraint("(state = 'sealed') = (sealed_at is not null)", name="sealed_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    target: Mapped[str]
    number: Mapped[int]
    note: Mapped[str] = mapped_column(default="")
    with_masters: Mapped[bool] = mapped_column(default=False)
    allow_missing: Mapped[bool] = mapped_column(default=False)
    placeholders: Mapped[bool] = mapped_column(
        default=False
    )  # placeholder files are in it, because the request asked for them
    handoff: Mapped[Handoff] = mapped_column(default=Handoff.NONE)
    state: Mapped[PackState] = mapped_column(default=PackState.SEALING)
    refusal: Mapped[str] = mapped_column(default="")
    sealed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    sealed_at: Mapped[datetime | None]
    sealer: Mapped[Person] = relationship(lazy="raise")


class PackedFile(StudioOwned, Base):
    """One file of a sealed pack."""

    __tablename__ = "builds_packed_files"
    __table_args__ = (
        UniqueConstraint("pack_id", "path"),
        Index(  # what a studio keeps is summed up of it
            "ix_builds_packed_files_keys",
            *("studio_id", "sha256", "size_bytes"),
            sqlite_where=text("kind = 'key'"),
            postgresql_where=text("kind = 'key'"),
        ),
    )

    pack_id: Mapped[UUID] = mapped_column(ForeignKey("builds_packs.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)
    path: Mapped[str]
    kind: Mapped[FileKind]
    sha256: Mapped[str]
    size_bytes: Mapped[int] = mapped_column(BigInteger)
    pcm_sha256: Mapped[str | None]  # None: it is not a game file
    render_id: Mapped[UUID | None] = mapped_column(ForeignKey("renders_renders.id"))


class Fingerprint(Base):
    """The fingerprint by which audits of game builds recognise a stored game file."""

    __tablename__ = "builds_fingerprints"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    sound_sha256: Mapped[str] = mapped_column(primary_key=True)
    fingerprint_version: Mapped[int]  # of audio_checks: fingerprints of earlier versions are not used
    entry: Mapped[dict[str, Any]]  # of a manifest, but for path, cue and take
    fingerprinted_at: Mapped[datetime] = mapped_column(default=clock.now)


class PlaceholderFile(ProjectOwned, Base):
    """A placeholder that was made for one variation of a cue and one target, marked as such in the file."""

    __tablename__ = "builds_placeholder_files"
    __table_args__ = (
        UniqueConstraint("cue_id", "variation", "target"),
        CheckConstraint("(refusal is null) = (sha256 is not null)", name="made_or_refused"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    variation: Mapped[int]
    target: Mapped[str]
    key: Mapped[str]  # of the cue's facts and the spec: another key wants another placeholder file
    sha256: Mapped[str | None]
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    is_spoken: Mapped[bool] = mapped_column(default=False)
    refusal: Mapped[str | None]
    made_at: Mapped[datetime] = mapped_column(default=clock.now)
