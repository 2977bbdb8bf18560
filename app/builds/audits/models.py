"""The tables of audits of game builds, of listening passes, and of the tasks that come from both."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.builds.audits.rules import AuditStatus, CueMark, Drift, HeardAs, TaskKind, TaskRole
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id


class BuildAudit(StudioOwned, Dated, Base):
    """One audit of a game build by `audio-checks audit`, as the game's CI posted it."""

    __tablename__ = "builds_audits"
    __table_args__ = (Index("ix_builds_audits_newest", "project_id", "target", "id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    label: Mapped[str]
    commit: Mapped[str] = mapped_column(default="")
    target: Mapped[str] = mapped_column(default="")
    engine: Mapped[str] = mapped_column(default="")  # empty: files alone were compared
    sounds: Mapped[int]
    drifted: Mapped[int]
    new_drifts: Mapped[int]  # those that the audit before did not have, and that nobody had accepted
    unread: Mapped[list[dict[str, Any]]]  # files of the game's project that could not be read
    token_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_tokens.id"))


class AuditedSound(StudioOwned, Base):
    """One audit's result on one sound."""

    __tablename__ = "builds_audited_sounds"
    __table_args__ = (
        Index("ix_builds_audited_sounds_history", "project_id", "path", "audit_id"),
        Index("ix_builds_audited_sounds_drift", "audit_id", "has_drifted", "place"),
    )

    audit_id: Mapped[UUID] = mapped_column(ForeignKey("builds_audits.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    path: Mapped[str]
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    take_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"))
    status: Mapped[AuditStatus]
    played_status: Mapped[AuditStatus]
    has_drifted: Mapped[bool]
    gain_db: Mapped[float | None]  # file and properties together, against what was approved
    file_db: Mapped[float | None]
    property_db: Mapped[float | None]
    message: Mapped[str]
    moves: Mapped[list[dict[str, Any]]]  # the gains that are others, each with object, file and changelist
    depends: Mapped[list[str]]
    events: Mapped[list[str]]

    @property
    def drift(self) -> Drift:
        """Return its drift, to be compared with another."""
        return Drift(self.path, self.status, self.played_status, self.gain_db)


class AcceptedDrift(StudioOwned, Base):
    """A drift that a person accepted with a reason; it holds while the drift stays the same."""

    __tablename__ = "builds_accepted_drifts"
    __table_args__ = (
        Index("ix_builds_accepted_drifts_project", "project_id", "id"),
        CheckConstraint("(withdrawn_at is null) = (withdrawn_by is null)", name="withdrawn_by_a_person"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    target: Mapped[str]
    path: Mapped[str]
    status: Mapped[AuditStatus]
    played_status: Mapped[AuditStatus]
    gain_db: Mapped[float | None]
    reason: Mapped[str]
    accepted_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    accepted_at: Mapped[datetime] = mapped_column(default=clock.now)
    withdrawn_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    withdrawn_at: Mapped[datetime | None]
    author: Mapped[Person] = relationship(lazy="raise", foreign_keys=[accepted_by])

    @property
    def drift(self) -> Drift:
        """Return the accepted drift."""
        return Drift(self.path, self.status, self.played_status, self.gain_db)


class ListeningPass(ProjectOwned, Base):
    """A session in which people listen to the cues of one build in the running game."""

    __tablename__ = "builds_listening_passes"
    __table_args__ = (
        Index(
            "uq_builds_listening_passes_open", "project_id", unique=True,
            sqlite_where=text("closed_at is null"), postgresql_where=text("closed_at is null"),
        ),
        CheckConstraint("(closed_at is null) = (closed_by is null)", name="closed_by_a_person"),
    )  # fmt: skip

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    audit_id: Mapped[UUID] = mapped_column(ForeignKey("builds_audits.id"))
    started_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    started_at: Mapped[datetime] = mapped_column(default=clock.now)
    closed_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    closed_at: Mapped[datetime | None]
    audit: Mapped[BuildAudit] = relationship(lazy="raise")


class ListeningNote(StudioOwned, Base):
    """One person's remark on one cue in a listening pass; its id is made where it was written, so it counts once."""

    __tablename__ = "builds_listening_notes"
    __table_args__ = (
        Index("ix_builds_listening_notes_pass", "pass_id", "cue_id"),
        Index("ix_builds_listening_notes_heard", "project_id", "said", "cue_id"),
        CheckConstraint("(recording_id is null) = (at_s is null)", name="recording_has_a_time"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    pass_id: Mapped[UUID] = mapped_column(ForeignKey("builds_listening_passes.id"))
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    said: Mapped[HeardAs]
    amount_db: Mapped[float | None]  # the gain that is suggested
    text: Mapped[str]
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    written_at: Mapped[datetime]  # when the key was pressed
    received_at: Mapped[datetime] = mapped_column(default=clock.now)
    undone_at: Mapped[datetime | None]  # taken back, or replaced by a later note of the same person
    recording_id: Mapped[UUID | None] = mapped_column(ForeignKey("references_versions.id"), index=True)
    at_s: Mapped[float | None]  # where in the recording of the game it was heard
    author: Mapped[Person] = relationship(lazy="raise")


class GameTask(StudioOwned, Base):
    """Something to do so that the game plays a sound as it should: from a note of a listening pass, or a drift."""

    __tablename__ = "builds_game_tasks"
    __table_args__ = (
        UniqueConstraint("note_id"),
        Index("ix_builds_game_tasks_project", "project_id", "done_at", "id"),
        CheckConstraint("(done_at is null) = (done_by is null)", name="done_by_a_person"),
        CheckConstraint("(note_id is null) <> (audit_id is null)", name="from_note_or_audit"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"))
    path: Mapped[str]  # of the sound in the build; empty where the build was not asked
    kind: Mapped[TaskKind]
    role: Mapped[TaskRole]
    assignee_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # the designer of the sound
    gain_db: Mapped[float | None]  # the change that is suggested
    where: Mapped[str]  # the object and property, or the file, that it is about
    text: Mapped[str]
    note_id: Mapped[UUID | None] = mapped_column(ForeignKey("builds_listening_notes.id"))
    audit_id: Mapped[UUID | None] = mapped_column(ForeignKey("builds_audits.id"))
    asked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    asked_at: Mapped[datetime] = mapped_column(default=clock.now)
    done_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    done_at: Mapped[datetime | None]
    author: Mapped[Person] = relationship(lazy="raise", foreign_keys=[asked_by])


class MarkedCue(ProjectOwned, Base):
    """A state of a cue in the game that a person set by hand, where no audit or listening pass says it."""

    __tablename__ = "builds_marked_cues"

    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), primary_key=True)
    mark: Mapped[CueMark] = mapped_column(primary_key=True)
    marked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    marked_at: Mapped[datetime] = mapped_column(default=clock.now)
