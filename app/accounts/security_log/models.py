"""The table of the security log."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey, Index
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.accounts.security_log.rules import SecurityEventKind
from app.core import clock
from app.core.db import Base, new_id


class SecurityEvent(Base):
    """One line of a studio's security log; lines are only added."""

    __tablename__ = "accounts_security_events"
    __table_args__ = (Index("ix_accounts_security_events_studio_id", "studio_id", "id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID | None] = mapped_column(  # None: of the studio, or of a project that is erased
        ForeignKey("projects_projects.id", ondelete="SET NULL"), index=True
    )
    kind: Mapped[SecurityEventKind]
    summary: Mapped[str]  # holds no name and no address of a person
    person_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)  # None: the server
    about_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)  # None: nobody else
    network: Mapped[str]  # an IPv4 address or the /64 of an IPv6 one; empty: the command line or a job
    at: Mapped[datetime] = mapped_column(default=clock.now, index=True)
    person: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[person_id])
    about: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[about_id])
