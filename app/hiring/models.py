"""The tables of this room."""

from datetime import date, datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import MailedLink, Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.hiring.roster.rules import BusyKind, Exclusivity, RateUnit
from app.hiring.rules import AskedScope, BidNoteKind, BidState, PostingPhase, PostingState, SampleState
from app.projects.models import Project


class Posting(ProjectOwned, Dated, Base):
    """Work that a studio offers: what is asked for, when, and how it is open."""

    __tablename__ = "hiring_postings"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    title: Mapped[str]
    text: Mapped[str] = mapped_column(default="")
    equipment: Mapped[str] = mapped_column(default="")  # that the work needs
    phase: Mapped[PostingPhase]
    state: Mapped[PostingState] = mapped_column(default=PostingState.DRAFT)
    revision: Mapped[int] = mapped_column(default=1)  # counts changes; a change names the one that was read
    currency: Mapped[str]  # ISO 4217
    price_minor: Mapped[int | None] = mapped_column(BigInteger)  # of an advisory phase, where the studio names it
    budget_minor: Mapped[int | None] = mapped_column(BigInteger)
    is_budget_shown: Mapped[bool] = mapped_column(default=False)
    rate_floor_minor: Mapped[int | None] = mapped_column(BigInteger)  # an hour below it is pointed out to the team
    scope: Mapped[AskedScope]
    categories: Mapped[list[str]]
    cue_ids: Mapped[list[str]]
    lines: Mapped[list[dict[str, Any]]]  # counted from the list; fixed once the posting is open
    headings: Mapped[list[str]]  # what the team scores
    bids_until_on: Mapped[date | None]
    work_from_on: Mapped[date | None]
    work_to_on: Mapped[date | None]
    secret_sha256: Mapped[str | None] = mapped_column(unique=True)  # of the link for everyone; None: there is none
    link_made_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    opened_at: Mapped[datetime | None]
    closed_at: Mapped[datetime | None]
    awarded_bid_id: Mapped[UUID | None]
    awarded_at: Mapped[datetime | None]
    contract_id: Mapped[UUID | None]  # the draft that the award opened; a higher room's, so no foreign key
    project: Mapped[Project] = relationship(lazy="raise")


class Candidate(MailedLink, ProjectOwned, Dated, Base):
    """A person who may bid on a posting: invited by mail, or come by its link."""

    __tablename__ = "hiring_candidates"
    __table_args__ = (UniqueConstraint("posting_id", "email"), UniqueConstraint("posting_id", "person_id"))

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    posting_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_postings.id"))
    email: Mapped[str]
    person_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    invited_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: came by the link
    expires_at: Mapped[datetime]
    joined_at: Mapped[datetime | None]
    revoked_at: Mapped[datetime | None]
    posting: Mapped[Posting] = relationship(lazy="raise")
    person: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[person_id])


class Bid(ProjectOwned, Base):
    """A designer's offer on a posting: as it is typed, and as it was sent last."""

    __tablename__ = "hiring_bids"
    __table_args__ = (UniqueConstraint("posting_id", "designer_id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    posting_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_postings.id"))
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    state: Mapped[BidState] = mapped_column(default=BidState.DRAFT)
    revision: Mapped[int] = mapped_column(default=0)
    content: Mapped[dict[str, Any]]  # as the designer has it; the studio does not see it
    sent: Mapped[dict[str, Any] | None]  # as the studio sees it
    sent_at: Mapped[datetime | None]  # the first time: its place in the comparison
    resent_at: Mapped[datetime | None]
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)
    is_shortlisted: Mapped[bool] = mapped_column(default=False)
    posting: Mapped[Posting] = relationship(lazy="raise")
    designer: Mapped[Person] = relationship(lazy="raise")


class Sample(ProjectOwned, Base):
    """A sound that a designer adds to a bid; it is checked by the project's spec and is never a take."""

    __tablename__ = "hiring_samples"
    __table_args__ = (CheckConstraint("file_bytes > 0", name="not_empty"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    bid_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_bids.id"), index=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    line_key: Mapped[str]  # of the posting's line that it is for
    file_name: Mapped[str]
    media_type: Mapped[str]
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    state: Mapped[SampleState] = mapped_column(default=SampleState.PENDING)
    spec_version: Mapped[int | None]  # that it was checked by
    findings: Mapped[list[dict[str, Any]]] = mapped_column(default=list)
    problem: Mapped[str] = mapped_column(default="")  # why it could not be checked
    added_at: Mapped[datetime] = mapped_column(default=clock.now)


class PostingQuestion(ProjectOwned, Base):
    """A candidate's question about a posting, and the team's answer, for all or for one."""

    __tablename__ = "hiring_questions"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    posting_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_postings.id"), index=True)
    text: Mapped[str]
    asked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    asked_at: Mapped[datetime] = mapped_column(default=clock.now)
    answer: Mapped[str | None]
    is_for_all: Mapped[bool] = mapped_column(default=False)
    answered_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    answered_at: Mapped[datetime | None]
    posting: Mapped[Posting] = relationship(lazy="raise")
    asker: Mapped[Person] = relationship(lazy="raise", foreign_keys=[asked_by])


class Score(ProjectOwned, Base):
    """The scores of one person of the team for a bid under each heading, 1 to 5, with a note."""

    __tablename__ = "hiring_scores"

    bid_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_bids.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    scores: Mapped[dict[str, Any]]  # by heading
    note: Mapped[str] = mapped_column(default="")
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)
    person: Mapped[Person] = relationship(lazy="raise")


class BidNote(ProjectOwned, Dated, Base):
    """A note of the team on a bid: of a call, an interview or anything else. The bidder never sees it."""

    __tablename__ = "hiring_bid_notes"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    bid_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_bids.id"), index=True)
    kind: Mapped[BidNoteKind]
    held_on: Mapped[date]
    text: Mapped[str]
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    author: Mapped[Person] = relationship(lazy="raise")


class RosterEntry(StudioOwned, Base):
    """A sound designer whom a studio keeps on file, as the studio knows them; the designer may have no account."""

    __tablename__ = "hiring_roster_entries"
    __table_args__ = (
        UniqueConstraint("studio_id", "email"),
        CheckConstraint("email = lower(email)", name="email_lower_case"),
        CheckConstraint("(rate_minor is null) = (rate_unit is null)", name="rate_has_a_unit"),
        CheckConstraint("weekly_hours is null or weekly_hours between 1 and 168", name="hours_of_a_week"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    name: Mapped[str]
    email: Mapped[str]  # imports and accounts are matched by it
    specialities: Mapped[list[str]]
    services: Mapped[list[str]]  # of RosterService
    languages: Mapped[list[str]]
    equipment: Mapped[str] = mapped_column(default="")
    credits: Mapped[str] = mapped_column(default="")
    referees: Mapped[str] = mapped_column(default="")  # people who can recommend them
    links: Mapped[list[dict[str, Any]]]  # title, url
    exclusivity: Mapped[Exclusivity] = mapped_column(default=Exclusivity.UNKNOWN)
    weekly_hours: Mapped[int | None]  # that they can give, as they say
    available_from_on: Mapped[date | None]
    notes: Mapped[str] = mapped_column(default="")
    rate_minor: Mapped[int | None] = mapped_column(BigInteger)  # for the studio's producers only
    rate_currency: Mapped[str] = mapped_column(default="USD")  # ISO 4217
    rate_unit: Mapped[RateUnit | None]
    calendar_name: Mapped[str | None]  # of the calendar file that was read last
    calendar_read_at: Mapped[datetime | None]
    calendar_to_on: Mapped[date | None]  # repeating events were followed to this day
    revision: Mapped[int] = mapped_column(default=1)  # counts changes; a change names the one that was read
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)


class BusyRange(StudioOwned, Base):
    """Days on which a designer of the roster is booked, or has half days only."""

    __tablename__ = "hiring_busy_ranges"
    __table_args__ = (CheckConstraint("from_on <= to_on", name="in_order"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    entry_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_roster_entries.id"), index=True)
    from_on: Mapped[date]
    to_on: Mapped[date]  # the last day
    kind: Mapped[BusyKind] = mapped_column(default=BusyKind.BOOKED)
    note: Mapped[str] = mapped_column(default="")
    is_from_calendar: Mapped[bool] = mapped_column(default=False)  # replaced when a calendar file is read again


class Loan(StudioOwned, Base):
    """A piece of equipment that a studio lends to a designer on its roster."""

    __tablename__ = "hiring_loans"
    __table_args__ = (
        CheckConstraint("due_on is null or due_on >= lent_on", name="due_after_lent"),
        CheckConstraint("returned_on is null or returned_on >= lent_on", name="returned_after_lent"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    entry_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_roster_entries.id"), index=True)
    item: Mapped[str]
    lent_on: Mapped[date]
    due_on: Mapped[date | None]
    returned_on: Mapped[date | None]  # None: it is still lent


class ReelSound(StudioOwned, Base):
    """A sound of a designer's reel that a studio keeps, to play on the page."""

    __tablename__ = "hiring_reel_sounds"
    __table_args__ = (CheckConstraint("file_bytes > 0", name="not_empty"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    entry_id: Mapped[UUID] = mapped_column(ForeignKey("hiring_roster_entries.id"), index=True)
    title: Mapped[str]
    file_name: Mapped[str]
    media_type: Mapped[str]
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)
