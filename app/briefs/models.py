"""The tables of this room."""

from datetime import date, datetime
from typing import Any
from uuid import UUID

from sqlalchemy import ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id


class Brief(StudioOwned, Base):
    """The answers of a project as they stand; a project without a brief has no row."""

    __tablename__ = "briefs_briefs"
    __table_args__ = (UniqueConstraint("project_id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    revision: Mapped[int] = mapped_column(default=0)  # counts saves; each answer names the one that changed it last
    answers: Mapped[dict[str, Any]] = mapped_column(default=dict)  # by question, as rules.Answer
    changed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)


class BriefVersion(StudioOwned, Base):
    """The answers as they were when a version was published; never changed."""

    __tablename__ = "briefs_versions"
    __table_args__ = (UniqueConstraint("project_id", "number"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    number: Mapped[int]
    answers: Mapped[dict[str, Any]]
    note: Mapped[str] = mapped_column(default="")
    published_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    published_at: Mapped[datetime] = mapped_column(default=clock.now)
    publisher: Mapped[Person] = relationship(lazy="raise")


class BriefRead(ProjectOwned, Base):
    """The first time that a designer opened a version of the brief."""

    __tablename__ = "briefs_reads"

    version_id: Mapped[UUID] = mapped_column(ForeignKey("briefs_versions.id"), primary_key=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True, index=True)
    read_at: Mapped[datetime] = mapped_column(default=clock.now)
    version: Mapped[BriefVersion] = relationship(lazy="raise")


class FollowUp(ProjectOwned, Base):
    """A designer's question about a question of the brief, and the team's answer."""

    __tablename__ = "briefs_follow_ups"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    question: Mapped[str]  # its key
    text: Mapped[str]
    asked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    asked_at: Mapped[datetime] = mapped_column(default=clock.now)
    answer: Mapped[str | None]
    answered_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    answered_at: Mapped[datetime | None]
    asker: Mapped[Person] = relationship(lazy="raise", foreign_keys=[asked_by])
    answerer: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[answered_by])


class Decision(ProjectOwned, Dated, Base):
    """A decision of the talks before a contract; it can be changed until a contract of the project is signed."""

    __tablename__ = "briefs_decisions"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    decided_on: Mapped[date]
    attended: Mapped[str]  # names, as typed
    text: Mapped[str]  # it names questions of the brief and cues by their numbers
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    signed_at: Mapped[datetime | None]  # since then it stands in the record of a contract
    author: Mapped[Person] = relationship(lazy="raise")
