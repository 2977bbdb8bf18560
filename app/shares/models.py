"""The tables of this room."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.deliveries.models import Take
from app.shares.rules import SharedKind, ViewedPage


class GuestLink(StudioOwned, Dated, Base):
    """A link by which people without an account hear some takes; its address is derived from its id, and not kept."""

    __tablename__ = "shares_guest_links"
    __table_args__ = (
        CheckConstraint("(revoked_at is null) = (revoked_by is null)", name="revoked_by_a_person"),
        CheckConstraint("max_openings is null or max_openings > 0", name="opened_at_least_once"),
        Index("ix_shares_guest_links_project", "project_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    kind: Mapped[SharedKind]
    title: Mapped[str]
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    password_hash: Mapped[str | None]
    may_comment: Mapped[bool]
    has_beeps: Mapped[bool]
    expires_at: Mapped[datetime | None]
    max_openings: Mapped[int | None]
    openings: Mapped[int] = mapped_column(default=0)
    made_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    revoked_at: Mapped[datetime | None]
    revoked_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    maker: Mapped[Person] = relationship(lazy="raise", foreign_keys=[made_by])


class GuestSound(ProjectOwned, Base):
    """One take that a guest link shares; the list stays as it was when the link was made."""

    __tablename__ = "shares_guest_sounds"

    link_id: Mapped[UUID] = mapped_column(ForeignKey("shares_guest_links.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)  # from 1; what guests name a sound by
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    take: Mapped[Take] = relationship(lazy="raise")


class GuestVisit(ProjectOwned, Base):
    """One time that a guest opened a link, under the name that they typed."""

    __tablename__ = "shares_guest_visits"
    __table_args__ = (Index("ix_shares_guest_visits_link", "link_id", "id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    link_id: Mapped[UUID] = mapped_column(ForeignKey("shares_guest_links.id"))
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    guest_name: Mapped[str]
    opened_at: Mapped[datetime] = mapped_column(default=clock.now)
    link: Mapped[GuestLink] = relationship(lazy="raise")


class GuestPlay(ProjectOwned, Base):
    """The number of plays of a sound in one visit."""

    __tablename__ = "shares_guest_plays"

    visit_id: Mapped[UUID] = mapped_column(ForeignKey("shares_guest_visits.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)
    plays: Mapped[int]
    last_at: Mapped[datetime] = mapped_column(default=clock.now)


class GuestCopy(Dated, Base):
    """A preview as guests get it: no metadata, and beeps where a link wants them; made once for all links."""

    __tablename__ = "shares_guest_copies"
    __table_args__ = (CheckConstraint("sha256 is null or refusal is null", name="made_or_refused"),)

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    key: Mapped[str] = mapped_column(primary_key=True)  # hash of the preview and of the beeps in it
    preview_sha256: Mapped[str]
    has_beeps: Mapped[bool]
    sha256: Mapped[str | None]  # None until it is made
    file_bytes: Mapped[int | None] = mapped_column(BigInteger)
    refusal: Mapped[str | None]  # in words


class Playlist(StudioOwned, Dated, Base):
    """Takes in an order that a person set, to be played through."""

    __tablename__ = "shares_playlists"
    __table_args__ = (Index("ix_shares_playlists_project", "project_id", "id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    name: Mapped[str]
    edition: Mapped[int] = mapped_column(default=1)  # counts changes, so that two editors notice each other
    made_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    removed_at: Mapped[datetime | None]
    maker: Mapped[Person] = relationship(lazy="raise")


class PlaylistEntry(ProjectOwned, Base):
    """One take in its place of a playlist."""

    __tablename__ = "shares_playlist_entries"
    __table_args__ = (UniqueConstraint("playlist_id", "take_id"),)

    playlist_id: Mapped[UUID] = mapped_column(ForeignKey("shares_playlists.id"), primary_key=True)
    place: Mapped[int] = mapped_column(primary_key=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)


class PlaylistPosition(ProjectOwned, Base):
    """The place where a person stopped in a playlist."""

    __tablename__ = "shares_playlist_positions"

    playlist_id: Mapped[UUID] = mapped_column(ForeignKey("shares_playlists.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    at_s: Mapped[float]


class LiveSession(ProjectOwned, Base):
    """The common playback in the session of a playlist: the playhead, as its holder last set it."""

    __tablename__ = "shares_live_sessions"

    playlist_id: Mapped[UUID] = mapped_column(ForeignKey("shares_playlists.id"), primary_key=True)
    sequence: Mapped[int] = mapped_column(default=0)  # counts what the holders did
    holder_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    take_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"))
    is_playing: Mapped[bool] = mapped_column(default=False)
    position_s: Mapped[float] = mapped_column(default=0.0)
    set_at: Mapped[datetime] = mapped_column(default=clock.now)  # when the playhead stood at position_s


class LiveListener(ProjectOwned, Base):
    """A person in the session of a playlist, and when their page last reported."""

    __tablename__ = "shares_live_listeners"

    playlist_id: Mapped[UUID] = mapped_column(ForeignKey("shares_playlists.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    seen_at: Mapped[datetime]
    page_id: Mapped[UUID | None]  # the one of the person's pages that plays and may have control
    person: Mapped[Person] = relationship(lazy="raise")


class SavedView(StudioOwned, Dated, Base):
    """A filter of a page under a name: each person has their own of the list, the team shares those of the queue."""

    __tablename__ = "shares_saved_views"
    __table_args__ = (UniqueConstraint("project_id", "person_id", "page", "name"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    page: Mapped[ViewedPage]
    name: Mapped[str]
    query: Mapped[str]  # of the page's address, without its question mark
