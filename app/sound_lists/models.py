"""The tables of this room."""

from datetime import date, datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ColumnElement, ForeignKey, Index, UniqueConstraint, func, text
from sqlalchemy.engine.default import DefaultExecutionContext
from sqlalchemy.ext.hybrid import hybrid_property
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.core.recorded_rows import declare
from app.sound_lists.own_columns.rules import ColumnKind
from app.sound_lists.rules import CueChannels, CueState, Need, Phase, Reverb, folded


def _folded_stem(context: DefaultExecutionContext) -> str:
    parameters: dict[str, Any] = context.get_current_parameters()  # type: ignore[no-untyped-call]  # SQLAlchemy gives it no types
    return folded(parameters["stem"])


class Cue(StudioOwned, Dated, Base):
    """One line of the list: one sound that the game needs."""

    __tablename__ = "sound_lists_cues"
    __table_args__ = (
        UniqueConstraint("project_id", "number"),
        Index("ix_sound_lists_cues_order", "project_id", "position", "number"),
        # What cues are counted by. The state comes first, so that queries for a project's cues do not use this index.
        Index("ix_sound_lists_cues_counted", "state", "project_id", "variations", "placeholder"),
        # Sums of what is delivered for a cue refer to these, and so follow them.
        Index("uq_sound_lists_cues_summed", "id", "state", "variations", "placeholder", unique=True),
        Index(
            "ix_sound_lists_cues_palette",
            *("project_id", "position", "number"),
            sqlite_where=text("palette = 1"),
            postgresql_where=text("palette"),
        ),
        # The cues of a category, of which no row is read.
        Index("ix_sound_lists_cues_category", "project_id", "category", "id", "studio_id"),
        CheckConstraint("variations between 1 and 99", name="variations_in_range"),
        CheckConstraint("duration_s is null or duration_s > 0", name="duration_positive"),
        CheckConstraint("duration_min_s > 0 and duration_max_s >= duration_min_s", name="duration_bounds_in_order"),
        CheckConstraint("(state = 'cut') = (cut_at is not null)", name="cut_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    number: Mapped[int]  # shown as SW-014
    position: Mapped[int]
    name: Mapped[str]
    file_name: Mapped[str] = mapped_column(default="")  # as typed; empty: the slug of the name
    category: Mapped[str] = mapped_column(default="")
    description: Mapped[str] = mapped_column(default="")
    use: Mapped[str] = mapped_column(default="")
    trigger: Mapped[str] = mapped_column(default="")
    duration_s: Mapped[float | None]  # asked for, within a quarter; with bounds, what is planned with
    duration_min_s: Mapped[float | None]
    duration_max_s: Mapped[float | None]
    length_locked: Mapped[bool] = mapped_column(default=False)
    frame_rate_fps: Mapped[float | None]
    loop: Mapped[bool] = mapped_column(default=False)
    reverb: Mapped[Reverb | None]
    channels: Mapped[CueChannels | None]  # None: as the delivery spec says
    variations: Mapped[int] = mapped_column(default=1)
    state: Mapped[CueState] = mapped_column(default=CueState.PROTOTYPE)
    phase: Mapped[Phase | None]
    need: Mapped[Need] = mapped_column(default=Need.MUST)
    playback_priority: Mapped[int | None]
    due_on: Mapped[date | None]  # the day on which the sound is needed
    placeholder: Mapped[bool] = mapped_column(default=False)  # the game plays a placeholder file until the sound comes
    palette: Mapped[bool] = mapped_column(default=False)
    implementer_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    recorder_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    extra: Mapped[dict[str, Any]] = mapped_column(default=dict)  # by column: the project's own, and imported ones
    dismissed_facts: Mapped[list[str]] = mapped_column(default=list)  # what the clarity check asks no more
    edition: Mapped[int] = mapped_column(default=1)  # counts edits, so that two editors notice each other
    cut_reason: Mapped[str | None]
    cut_at: Mapped[datetime | None]
    stems: Mapped[list["Stem"]] = relationship(lazy="raise", back_populates="cue", cascade="all, delete-orphan")

    @hybrid_property
    def planned_length_s(self) -> float | None:
        """Return the length to plan with: the one asked for, else the longest allowed, else the shortest."""
        return self.duration_s or self.duration_max_s or self.duration_min_s

    @planned_length_s.inplace.expression
    @classmethod
    def _planned_length_s(cls) -> ColumnElement[float | None]:
        return func.coalesce(cls.duration_s, cls.duration_max_s, cls.duration_min_s)


class OwnColumn(StudioOwned, Base):
    """A column of the project's own; each cue keeps its value under the column's name, in `extra`."""

    __tablename__ = "sound_lists_columns"
    __table_args__ = (UniqueConstraint("project_id", "folded"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    name: Mapped[str]
    folded: Mapped[str]  # two names that differ in case only cannot both be
    kind: Mapped[ColumnKind]
    choices: Mapped[list[str]] = mapped_column(default=list)  # of a choice, in the order shown
    position: Mapped[int]


class Stem(StudioOwned, Base):
    """A file name without its ending that one variation of a cue owns; unique in the project."""

    __tablename__ = "sound_lists_stems"
    __table_args__ = (UniqueConstraint("project_id", "folded"), UniqueConstraint("cue_id", "variation"))

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    variation: Mapped[int]
    stem: Mapped[str]  # in NFC; files match it exactly
    folded: Mapped[str] = mapped_column(default=_folded_stem)  # two stems that differ in case only cannot both be
    cue: Mapped[Cue] = relationship(lazy="raise", back_populates="stems")


class Revision(ProjectOwned, Dated, Base):
    """One saved change of the list, with what each touched cue said before and after."""

    __tablename__ = "sound_lists_revisions"
    __table_args__ = (UniqueConstraint("project_id", "number"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    number: Mapped[int]
    summary: Mapped[str]
    changed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    author: Mapped[Person] = relationship(lazy="raise")


class CueChange(StudioOwned, Base):
    """The change of one cue by one revision: only the facts that differ."""

    __tablename__ = "sound_lists_cue_changes"

    revision_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_revisions.id"), primary_key=True)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), primary_key=True, index=True)
    before: Mapped[dict[str, Any]]  # empty: the cue was added
    after: Mapped[dict[str, Any]]


class SpokenPlaceholder(Base):
    """A word that a person of the team said for a cue, heard in its placeholder files until the sound comes."""

    __tablename__ = "sound_lists_spoken_placeholders"
    __table_args__ = (
        UniqueConstraint("cue_id"),
        CheckConstraint("file_bytes > 0", name="not_empty"),
        Index("ix_sound_lists_spoken_placeholders_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    duration_s: Mapped[float]
    recorded_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    recorded_at: Mapped[datetime] = mapped_column(default=clock.now)
    speaker: Mapped[Person] = relationship(lazy="raise")


class Question(ProjectOwned, Base):
    """A designer's question on a cue; the answer becomes part of the cue."""

    __tablename__ = "sound_lists_questions"
    __table_args__ = (
        Index(
            "ix_sound_lists_questions_open",
            "project_id",
            "cue_id",
            sqlite_where=text("answered_at is null"),
            postgresql_where=text("answered_at is null"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    text: Mapped[str]
    asked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    asked_at: Mapped[datetime] = mapped_column(default=clock.now)
    answer: Mapped[str | None]
    answered_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    answered_at: Mapped[datetime | None]
    owner_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # of the team, who is to answer
    due_on: Mapped[date | None]
    blocks: Mapped[bool] = mapped_column(default=False)  # work on the cue waits for the answer
    cue: Mapped[Cue] = relationship(lazy="raise")
    owner: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[owner_id])
    asker: Mapped[Person] = relationship(lazy="raise", foreign_keys=[asked_by])
    answerer: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[answered_by])


declare(Question, "question", owners=None, left_out=("owner_id", "due_on", "blocks"))
