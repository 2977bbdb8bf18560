"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, ForeignKeyConstraint, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.core.recorded_rows import declare
from app.core.uploads import Upload
from app.deliveries.rules import ArchiveState, SourceFileKind, TakeState, TrayActionKind
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


class Delivery(ProjectOwned, Dated, Base):
    """One upload of takes by a designer, with notes."""

    __tablename__ = "deliveries_deliveries"
    __table_args__ = (UniqueConstraint("project_id", "number"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    number: Mapped[int]
    note: Mapped[str] = mapped_column(default="")
    closed_at: Mapped[datetime | None]
    designer: Mapped[Person] = relationship(lazy="raise")


class Take(Base):
    """One delivered file for a cue; its master is never altered."""

    __tablename__ = "deliveries_takes"
    __table_args__ = (
        UniqueConstraint("cue_id", "variation", "number"),
        UniqueConstraint("archive_id", "archive_entry"),
        CheckConstraint("master_bytes >= 0", name="master_size_known"),
        CheckConstraint("(cue_id is null) = (number is null)", name="numbered_when_matched"),
        CheckConstraint(
            "(split_of_id is null) = (split_first_frame is null) and (split_of_id is null) = (split_end_frame is null)",
            name="split_has_range",
        ),
        # What waits is read in order of waiting, in one project or in all of a studio's.
        Index(
            "ix_deliveries_takes_project_waiting",
            *("project_id", "state", "state_since", "cue_id", "designer_id"),
            "studio_id",  # which the row policies of PostgreSQL ask for
        ),
        Index("ix_deliveries_takes_studio_waiting", "studio_id", "state", "state_since", "cue_id"),
        # Everything that is summed up of a list's takes, so that no take itself is read.
        Index(
            "ix_deliveries_takes_sums",
            *("project_id", "cue_id", "variation", "state", "number", "designer_id"),
            "studio_id",  # which the row policies of PostgreSQL ask for
        ),
        # A project's takes, the newest first; a search reads all their names here and no take.
        Index(
            "ix_deliveries_takes_file_names",
            *("project_id", "id", "file_name", "designer_id", "discarded_at"),
            "studio_id",  # which the row policies of PostgreSQL ask for
        ),
        Index("ix_deliveries_takes_kept", "studio_id", "master_sha256", "master_bytes", "master_deleted_at"),
        # Labels that hold typed words are found, the newest take first, without a look at takes that have none.
        Index(
            "ix_deliveries_takes_labelled",
            *("project_id", "id", "label", "designer_id", "cue_id"),
            "studio_id",  # which the row policies of PostgreSQL ask for
            sqlite_where=text("label is not null"),
            postgresql_where=text("label is not null"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    delivery_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_deliveries.id"), index=True)
    # Without an index: SQLite would go through all that a designer ever made, where a few cues are asked for.
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    upload_id: Mapped[UUID | None] = mapped_column(ForeignKey(Upload.id), unique=True)  # an upload is one take
    archive_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_archives.id"))  # the ZIP that it came in
    archive_entry: Mapped[int | None]  # its place in there
    fix_of_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)  # made from it by us
    split_of_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)  # cut from it by us
    split_first_frame: Mapped[int | None] = mapped_column(BigInteger)  # of the range that was cut
    split_end_frame: Mapped[int | None] = mapped_column(BigInteger)  # the first one after it
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"))  # None: unmatched
    variation: Mapped[int] = mapped_column(default=1)  # 1 for a single file
    number: Mapped[int | None]  # 1 for the first take of a cue and variation; alternates count on
    alternate: Mapped[int | None]  # 2 for _altB or __alt2; None for a file without such an ending
    state: Mapped[TakeState] = mapped_column(default=TakeState.RECEIVED)
    late: Mapped[bool] = mapped_column(default=False)
    file_name: Mapped[str]  # as the designer named it; never a path
    note: Mapped[str] = mapped_column(default="")
    master_sha256: Mapped[str] = mapped_column(index=True)
    master_bytes: Mapped[int] = mapped_column(BigInteger)
    received_at: Mapped[datetime] = mapped_column(default=clock.now)
    state_since: Mapped[datetime] = mapped_column(default=clock.now)
    conforming_since: Mapped[datetime | None]  # for deemed acceptance, see ReviewClock; no re-check sets it again
    returned_since: Mapped[datetime | None]  # the clock is paused since then
    edition: Mapped[int] = mapped_column(default=1)  # counts matches and re-checks: a job writes only for its own
    rechecked_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # who asked for the last check
    discarded_at: Mapped[datetime | None]  # out of the list and the tray, its master kept; has no cue then
    master_deleted_at: Mapped[datetime | None]  # when the contract's years of keeping it were over
    label: Mapped[str | None]  # what it is among alternates, in the words of its designer or the team
    labelled_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    labelled_at: Mapped[datetime | None]
    # Why it is approved or has to change, as the reviewer chose; a copy from its verdict in a room above.
    verdict_reasons: Mapped[list[str]] = mapped_column(default=list)
    delivery: Mapped[Delivery] = relationship(lazy="raise")
    designer: Mapped[Person] = relationship(lazy="raise", foreign_keys=[designer_id])
    cue: Mapped[Cue | None] = relationship(lazy="raise")


class TrayAction(Base):
    """One action on many takes, with the earlier place of each: it can be undone."""

    __tablename__ = "deliveries_tray_actions"
    __table_args__ = (Index("ix_deliveries_tray_actions_project", "project_id", "id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    kind: Mapped[TrayActionKind]
    done_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    done_at: Mapped[datetime] = mapped_column(default=clock.now)
    undone_at: Mapped[datetime | None]
    takes: Mapped[list[dict[str, Any]]]  # id, edition after the action, and the place before it


class TakeCounts(Base):
    """Counts of a cue's takes: of all for the team, and of each designer's for that designer.

    The cue's facts are copied here, so that cues are counted by this table alone: when they change in the list,
    the database updates them here too (ON UPDATE CASCADE).
    """

    __tablename__ = "deliveries_take_counts"
    __table_args__ = (
        ForeignKeyConstraint(
            ["cue_id", "state", "variations", "placeholder"],
            [f"sound_lists_cues.{name}" for name in ("id", "state", "variations", "placeholder")],
            name="fk_deliveries_take_counts_cue",
            onupdate="CASCADE",
        ),
        Index(
            "ix_deliveries_take_counts_alike",
            *("project_id", "viewer_id", "state", "variations", "placeholder", "facts"),
            "studio_id",  # which the row policies of PostgreSQL ask for
        ),
        Index(
            "ix_deliveries_take_counts_newest_back",
            *("project_id", "viewer_id", "newest_back_since"),
            sqlite_where=text("newest_back_since is not null"),
            postgresql_where=text("newest_back_since is not null"),
        ),
        Index(
            "ix_deliveries_take_counts_back",
            *("project_id", "viewer_id", "back_since", "cue_id"),
            sqlite_where=text("back_since is not null"),
            postgresql_where=text("back_since is not null"),
        ),
        {"sqlite_with_rowid": False},
    )

    cue_id: Mapped[UUID] = mapped_column(primary_key=True)
    viewer_id: Mapped[UUID] = mapped_column(primary_key=True)  # whose view: a designer's, or under the studio's id all
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    state: Mapped[CueState]
    variations: Mapped[int]
    placeholder: Mapped[bool]
    facts: Mapped[str]  # this and what follows: see Sums
    newest_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    newest_back_since: Mapped[datetime | None]
    back_since: Mapped[datetime | None]


class DryStem(Base):
    """A sound of a delivery without its reverb, by its name: what the takes of that name are compared with.

    The newest that is not withdrawn counts. A withdrawn one is on record still, as everything that was delivered.
    """

    __tablename__ = "deliveries_dry_stems"
    __table_args__ = (
        UniqueConstraint("upload_id", "stem"),
        UniqueConstraint("archive_id", "archive_entry"),
        CheckConstraint("file_bytes >= 0", name="size_known"),
        Index("ix_deliveries_dry_stems_of_takes", "delivery_id", "stem"),
        Index("ix_deliveries_dry_stems_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    delivery_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_deliveries.id"))
    stem: Mapped[str]  # of the takes that it is for: their file names without the ending
    upload_id: Mapped[UUID | None] = mapped_column(ForeignKey(Upload.id))
    archive_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_archives.id"))  # the ZIP that it came in
    archive_entry: Mapped[int | None]  # its place in there
    file_name: Mapped[str]  # as the designer named it; never a path
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    received_at: Mapped[datetime] = mapped_column(default=clock.now)
    withdrawn_at: Mapped[datetime | None]


class SourceStatement(Base):
    """The sources of a take, as its designer states them; without a take, those of the rest of a delivery."""

    __tablename__ = "deliveries_source_statements"
    __table_args__ = (
        Index(
            "uq_deliveries_source_statements_delivery",
            "delivery_id",
            unique=True,
            sqlite_where=text("take_id is null"),
            postgresql_where=text("take_id is null"),
        ),
        Index("ix_deliveries_source_statements_remembered", "studio_id", "designer_id", "stated_at"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    delivery_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_deliveries.id"), index=True)
    take_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_takes.id"), unique=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    sources: Mapped[dict[str, Any]]  # see Sources
    stated_at: Mapped[datetime] = mapped_column(default=clock.now)
    designer: Mapped[Person] = relationship(lazy="raise")


class SourceBank(ProjectOwned, Base):
    """The recipe of a take: its plug-ins, and how it was made."""

    __tablename__ = "deliveries_source_banks"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    plug_ins: Mapped[list[str]] = mapped_column(default=list)
    recipe: Mapped[str] = mapped_column(default="")
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)


class SourceFile(ProjectOwned, Base):
    """A file that a take was made from: its session, or one of its layers."""

    __tablename__ = "deliveries_source_files"
    __table_args__ = (
        UniqueConstraint("take_id", "upload_id"),
        CheckConstraint("file_bytes >= 0", name="size_known"),
        Index("ix_deliveries_source_files_kept", "studio_id", "sha256", "file_bytes"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"))
    upload_id: Mapped[UUID] = mapped_column(ForeignKey(Upload.id), index=True)
    kind: Mapped[SourceFileKind]
    file_name: Mapped[str]  # as the designer named it; never a path
    sha256: Mapped[str]
    file_bytes: Mapped[int] = mapped_column(BigInteger)
    received_at: Mapped[datetime] = mapped_column(default=clock.now)


class Handoff(ProjectOwned, Dated, Base):
    """A cue that its maker leaves unfinished: what is done, what is missing, and who continues it."""

    __tablename__ = "deliveries_handoffs"
    __table_args__ = (
        CheckConstraint("done_percent between 0 and 100", name="percent_in_range"),
        CheckConstraint("to_id is null or to_id != from_id", name="to_another"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    from_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    to_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: nobody continues it yet
    done_percent: Mapped[int]
    missing: Mapped[str]
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    maker: Mapped[Person] = relationship(lazy="raise", foreign_keys=[from_id])
    next_maker: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[to_id])
    author: Mapped[Person] = relationship(lazy="raise", foreign_keys=[written_by])


class Adoption(StudioOwned, Dated, Base):
    """A folder of shipped files that becomes cues with approved takes, in one revision and one delivery.

    It stays on record when it is undone.
    """

    __tablename__ = "deliveries_adoptions"
    __table_args__ = (
        CheckConstraint("(adopted_at is null) = (adopted_by is null)", name="adopted_by_a_person"),
        CheckConstraint("(undone_at is null) = (undone_by is null)", name="undone_by_a_person"),
        CheckConstraint("undone_at is null or adopted_at is not null", name="undone_after_adopted"),
        Index("ix_deliveries_adoptions_project_id_id", "project_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    folder: Mapped[str]  # its name, without the path to it
    files: Mapped[list[dict[str, Any]]]  # see ShippedFileIn
    game: Mapped[dict[str, Any] | None]  # what the game's project says of its sounds; None: no project was sent
    opened_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: a build
    delivery_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_deliveries.id"))  # that holds its takes
    adopted_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    adopted_at: Mapped[datetime | None]
    undone_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    undone_at: Mapped[datetime | None]
    adopter: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[adopted_by])


class Archive(ProjectOwned, Base):
    """A delivered ZIP and what happened to it."""

    __tablename__ = "deliveries_archives"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    delivery_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_deliveries.id"), index=True)
    upload_id: Mapped[UUID] = mapped_column(ForeignKey(Upload.id), unique=True)
    file_name: Mapped[str]
    sha256: Mapped[str]
    archive_bytes: Mapped[int] = mapped_column(BigInteger)
    state: Mapped[ArchiveState] = mapped_column(default=ArchiveState.RECEIVED)
    message: Mapped[str] = mapped_column(default="")
    entries: Mapped[list[dict[str, Any]]] = mapped_column(default=list)  # path, taken or why left out
    received_at: Mapped[datetime] = mapped_column(default=clock.now)


TAKE_ON_RECORD = (
    *("delivery_id", "designer_id", "cue_id", "variation", "number"),
    *("file_name", "master_sha256", "master_bytes", "received_at"),
)
declare(Take, "take", owners=None, only=TAKE_ON_RECORD)
