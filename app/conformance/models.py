"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.conformance.rules import FixState
from app.core.columns import Dated, ProjectOwned
from app.core.db import Base, new_id


class CheckRun(ProjectOwned, Dated, Base):
    """The result of the checks of one master against one spec, as one cue."""

    __tablename__ = "conformance_check_runs"
    __table_args__ = (
        Index(
            "uq_conformance_check_runs_current",
            "take_id",
            unique=True,
            sqlite_where=text("is_current"),
            postgresql_where=text("is_current"),
        ),
        Index(
            "ix_conformance_check_runs_unnotified",
            "project_id",
            sqlite_where=text("needs_notification"),
            postgresql_where=text("needs_notification"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    spec_id: Mapped[UUID] = mapped_column(ForeignKey("projects_specs.id"))
    key: Mapped[str] = mapped_column(index=True)  # hash of master, resolved spec, cue facts and tool version
    is_current: Mapped[bool] = mapped_column(default=True)
    needs_notification: Mapped[bool] = mapped_column(default=False)  # those whom it concerns do not know
    verdict: Mapped[str]  # conforming, rejected, unreadable, unjudged
    pcm_sha256: Mapped[str | None]
    report: Mapped[dict[str, Any]]  # the file object of the report: facts, measurements, judgements, findings
    tool_version: Mapped[str]


class Waiver(ProjectOwned, Dated, Base):
    """The approver let a returned take through, with a reason; its findings stay."""

    __tablename__ = "conformance_waivers"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    check_run_id: Mapped[UUID] = mapped_column(ForeignKey("conformance_check_runs.id"))
    master_sha256: Mapped[str]
    codes: Mapped[list[str]]
    reason: Mapped[str]
    waived_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    approver: Mapped[Person] = relationship(lazy="raise")


class Fix(ProjectOwned, Dated, Base):
    """A fixed copy of a take's master, to see and play; its designer's consent makes it a take."""

    __tablename__ = "conformance_fixes"
    __table_args__ = (
        UniqueConstraint("take_id", "key"),
        CheckConstraint("(state = 'made') = (sha256 is not null)", name="made_has_file"),
        CheckConstraint("(used_by is null) = (new_take_id is null)", name="used_is_a_take"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    key: Mapped[str]  # of the check that it answers: master, resolved spec, cue facts and tool version
    state: Mapped[FixState] = mapped_column(default=FixState.MAKING)
    asked_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: made ready by the check
    made_at: Mapped[datetime | None]
    refusal: Mapped[str | None]  # in words, with what the designer can do
    sha256: Mapped[str | None] = mapped_column(index=True)
    fixed_bytes: Mapped[int | None] = mapped_column(BigInteger)
    made: Mapped[dict[str, Any]] = mapped_column(default=dict)  # repairs, what is left, figures and spots
    used_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    used_at: Mapped[datetime | None]
    new_take_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)


class Split(ProjectOwned, Dated, Base):
    """The parts of a take's master, to see before its designer makes them variations of a cue."""

    __tablename__ = "conformance_splits"
    __table_args__ = (
        UniqueConstraint("take_id", "shortest_pause_s"),
        CheckConstraint("(state = 'made') = (found_by is not null)", name="made_has_parts"),
        CheckConstraint("(found_by is null) = (sample_rate_hz is null)", name="rate_with_parts"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    shortest_pause_s: Mapped[float]  # shorter silence is part of a sound
    state: Mapped[FixState] = mapped_column(default=FixState.MAKING)
    asked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    asked_at: Mapped[datetime]  # for the last time: the newest is shown
    refusal: Mapped[str | None]  # in words, with what the designer can do
    found_by: Mapped[str | None]  # regions, markers, silence
    sample_rate_hz: Mapped[int | None]
    tray_action_id: Mapped[UUID | None] = mapped_column(  # of its last use
        ForeignKey("deliveries_tray_actions.id"), index=True
    )
    parts: Mapped[list["SplitPart"]] = relationship(lazy="raise", order_by="SplitPart.number")


class SplitPart(ProjectOwned, Base):
    """One part of a take's master, as a file of its own."""

    __tablename__ = "conformance_split_parts"
    __table_args__ = (CheckConstraint("first_frame < end_frame", name="holds_frames"),)

    split_id: Mapped[UUID] = mapped_column(ForeignKey("conformance_splits.id"), primary_key=True)
    number: Mapped[int] = mapped_column(primary_key=True)  # from 1, in the order of the sound
    first_frame: Mapped[int] = mapped_column(BigInteger)
    end_frame: Mapped[int] = mapped_column(BigInteger)  # the first one after it
    label: Mapped[str]  # of its marker; empty for none
    sha256: Mapped[str] = mapped_column(index=True)
    part_bytes: Mapped[int] = mapped_column(BigInteger)
