"""The tables of this room."""

from datetime import datetime, time
from typing import Any
from uuid import UUID

from sqlalchemy import ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock
from app.core.columns import Dated, StudioOwned
from app.core.db import Base, new_id


class Mail(Dated, Base):
    """One mail to one person, gathering news of one kind until it is sent."""

    __tablename__ = "notifications_mails"
    __table_args__ = (
        Index(
            "uq_notifications_mails_open",
            "topic",
            "recipient",
            unique=True,
            sqlite_where=text("sealed_at is null"),
            postgresql_where=text("sealed_at is null"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_studios.id"), index=True)  # None: account mail
    about_project_id: Mapped[UUID | None]  # no foreign key: a mail outlives a project that is erased
    topic: Mapped[str]  # what it is about: news of the same topic joins an open mail
    recipient: Mapped[str]
    subject: Mapped[str]
    lines: Mapped[list[str]]
    line_project_ids: Mapped[list[str]] = mapped_column(default=list)  # of a digest: the project of each line, or ""
    spots: Mapped[dict[str, Any]] = mapped_column(default=dict)  # places in sounds, by the addresses in the lines
    event_ids: Mapped[list[str]]  # each event is mailed once, however often its job runs
    folds: Mapped[dict[str, Any]] = mapped_column(default=dict)  # of a digest, by topic: the line and what it folds
    news: Mapped[str | None]  # its kind; empty: a digest of several; None: sent whatever its reader wishes
    link: Mapped[str | None]  # cleared once the mail is sent
    secret_of: Mapped[str | None]  # the event whose secret link it contains; made when sent or, without SMTP, shown
    secret_of_id: Mapped[UUID | None]
    send_after: Mapped[datetime] = mapped_column(default=clock.now)
    sealed_at: Mapped[datetime | None]  # from here on nothing is added
    claimed_until: Mapped[datetime | None]  # until then one worker hands it to the server, and no other does
    sent_at: Mapped[datetime | None]
    failure: Mapped[str | None]


class MailPreferences(Base):
    """The mails that a person wants, and their times."""

    __tablename__ = "notifications_mail_preferences"

    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    cadences: Mapped[dict[str, Any]]  # by kind of news; what is missing is mailed at once
    time_zone: Mapped[str]  # an IANA name: Europe/Berlin
    daily_at: Mapped[time]  # in that time zone, as the two below
    quiet_from: Mapped[time | None]
    quiet_until: Mapped[time | None]


class Notice(StudioOwned, Base):
    """News for one person, shown in the app whatever they are mailed."""

    __tablename__ = "notifications_notices"
    __table_args__ = (
        UniqueConstraint("person_id", "topic", "event_id"),  # an event is noticed once, however often its job runs
        Index("ix_notifications_notices_of_person", "person_id", "id"),
        Index(
            "ix_notifications_notices_unread",
            "person_id",
            sqlite_where=text("read_at is null"),
            postgresql_where=text("read_at is null"),
        ),
        Index(
            "uq_notifications_notices_open",
            *("person_id", "topic"),
            unique=True,
            sqlite_where=text("is_open"),
            postgresql_where=text("is_open"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    project_id: Mapped[UUID | None] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    topic: Mapped[str]
    event_id: Mapped[str]  # the first, where several are folded into it
    event_ids: Mapped[list[str]] = mapped_column(default=list)  # of all that are folded into it
    count: Mapped[int] = mapped_column(default=1)  # of what it reports
    is_open: Mapped[bool] = mapped_column(default=False)  # further events of its topic are folded into it
    news: Mapped[str]  # its kind, as of mails
    subject: Mapped[str]
    text: Mapped[str]
    path: Mapped[str]  # of the page it leads to
    created_at: Mapped[datetime] = mapped_column(default=clock.now)  # when the newest of it came
    read_at: Mapped[datetime | None] = mapped_column(index=True)
