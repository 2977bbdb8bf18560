"""The bodies of this room."""

from datetime import date, datetime
from enum import StrEnum
from uuid import UUID

from pydantic import Field

from app.accounts.quotas.service import QuotaKind
from app.core.web.http import Schema


class JobState(StrEnum):
    """The state of an unfinished job; done ones are not listed."""

    PARKED = "parked"
    RUNNING = "running"
    WAITING = "waiting"
    DELAYED = "delayed"
    BROKEN = "broken"  # ended where it could not even be parked; it cannot be tried again


class JobRead(Schema):
    """One job that waits, runs or gave up."""

    id: str
    job: str = Field(examples=["renders.prepare_take"])
    studio_id: UUID | None = Field(description="Whose work it is; null for what concerns one person's account alone.")
    studio_name: str | None
    state: JobState
    tries: int
    since: datetime
    reason: str | None = Field(
        description="The last failure. A producer sees the kind of failure, an operator the details."
    )


class JobCountRead(Schema):
    """The number of jobs of one name in one state."""

    job: str
    state: JobState
    jobs: int
    oldest_at: datetime


class Urgency(StrEnum):
    """The urgency of a lane's jobs: those that people wait for go before a re-render of thousands."""

    URGENT = "urgent"
    NORMAL = "normal"
    BULK = "bulk"


class LaneRead(Schema):
    """The jobs of one studio and one urgency; lanes take turns."""

    studio_id: UUID | None = Field(description="Null for what is done on no studio's behalf.")
    studio_name: str | None
    urgency: Urgency
    waiting: int
    running: int
    delayed: int = Field(description="Failed, and to be tried again later.")
    oldest_at: datetime | None = Field(description="Since when the one waits that has waited longest.")


class KeptKind(StrEnum):
    """The kind of a stored file."""

    MASTERS = "masters"
    DRY_STEMS = "dry_stems"  # withdrawn ones too
    SOURCE_FILES = "source_files"  # sessions and layers of source banks
    ARCHIVES = "archives"  # ZIPs as they were delivered
    GAME_FILES = "game_files"
    DRAWINGS = "drawings"  # wave shapes, spectrum and preview of one sound together
    FIXES = "fixes"  # those that no designer has made a take of
    REELS = "reels"
    EXPORTS = "exports"  # masters with what is known of them, made to be handed out
    PLACEHOLDER_FILES = "placeholder_files"
    REFERENCES = "references"  # every version, and the previews of pictures
    GUEST_COPIES = "guest_copies"  # previews as guests get them
    ROSTER_REELS = "roster_reels"  # sounds of reels on the roster, and samples that came with bids
    DOCUMENTS = "documents"  # contracts, and the keys that go with packs
    UPLOADS = "uploads"  # finished, and not yet used; not counted as kept


class KeptFiles(Schema):
    """The number of stored files of one kind, and their total size."""

    kind: KeptKind
    files: int
    size_bytes: int


class QuotaRead(Schema):
    """One limit of a studio, and what it has of that."""

    kind: QuotaKind
    used: int
    limit: int
    default: int


class StudioQuotas(Schema):
    """The limits of one studio, the nearest first."""

    studio_id: UUID
    studio_name: str
    quotas: list[QuotaRead]


class StorageRead(Schema):
    """The storage of a studio; within a kind, the same bytes are stored and counted once."""

    studio_id: UUID
    studio_name: str
    size_bytes: int
    kept: list[KeptFiles] = Field(description="Kinds without a file are left out.")


class WorkerRead(Schema):
    """A worker process, its last heartbeat, and the number of jobs that it is running."""

    id: str
    beat_at: datetime
    is_alive: bool = Field(description="Whether it said so lately; the jobs of one that is silent others take over.")
    running: int


class StudioOperations(Schema):
    """A studio's jobs, and whether a worker is running."""

    counts: list[JobCountRead]
    lanes: list[LaneRead]
    workers: int = Field(description="Worker processes that live.")


class ServerOperations(Schema):
    """The whole server's jobs and workers."""

    counts: list[JobCountRead]
    lanes: list[LaneRead] = Field(description="The longest first, fifty at most.")
    workers: list[WorkerRead] = Field(description="Those that said within the hour that they live.")


class ScrubRead(Schema):
    """The newest pass over all stored files: each is read and compared with its hash."""

    started_at: datetime
    finished_at: datetime | None = Field(description="Null while it goes on.")
    files: int
    size_bytes: int
    missing: int = Field(description="Files that the database names and the store lacks.")
    altered: int = Field(description="Files whose content is not what was stored.")
    orphaned: int = Field(description="Files that nothing in the database names.")
    orphaned_bytes: int


class ServerStorage(Schema):
    """The storage of the whole server."""

    studios: list[StorageRead] = Field(description="The largest first.")
    free_bytes: int | None = Field(description="What the disk of the store has left; null where the store is a bucket.")
    scrub: ScrubRead | None = Field(description="Null until the first pass over all stored files begins.")


class DepartureKind(StrEnum):
    """A thing that a membership gave.

    Another person takes over first from an approver and a signer; an engagement goes on; tokens, links and webhooks may
    be kept; everything else ends.
    """

    APPROVER = "approver"
    SIGNER = "signer"
    LIAISON = "liaison"
    CATEGORY_APPROVER = "category_approver"
    DEPUTY = "deputy"
    INVITATION = "invitation"
    TOKEN = "token"  # noqa: S105
    GUEST_LINK = "guest_link"
    POSTING_LINK = "posting_link"
    WEBHOOK = "webhook"
    ENGAGEMENT = "engagement"


class DepartureItem(Schema):
    """One thing that a member would lose, or that another person must take over first."""

    kind: DepartureKind
    id: UUID | None = Field(description="Null: in a project that the reader is not in.")
    name: str = Field(description="Its own name: of a project, a contract, a category, a link; the address of a call.")
    project_id: UUID | None = Field(description="Null: of the studio.")
    project_name: str | None


class KeptItem(Schema):
    """The remains of an erasure, and their reason."""

    name: str = Field(examples=["3 signatures"])
    reason: str = Field(examples=["evidence of a contract; with the name as signed"])


class ErasureRead(Schema):
    """An erasure's deletions, its remains with reasons, and things to end first."""

    name: str
    confirmation: str = Field(description="What must be typed to erase it: its name, or the address of the account.")
    obstacles: list[str] = Field(description="What must end first; none: it can be erased.")
    deleted: list[str] = Field(description="Kinds of rows with their number, such as 12 sounds.")
    kept: list[KeptItem]
    grace_days: int = Field(description="The days until it is carried out, in which it can be cancelled; 0: at once.")
    due_at: datetime | None = Field(description="When it is carried out; null unless it was requested.")
    requested_by: str | None = Field(description="The name of the person who requested it.")


class ErasureRequest(Schema):
    """The confirmation of an erasure."""

    confirmation: str = Field(
        max_length=400, description="The `confirmation` of the list of what is deleted, typed by the person."
    )


class MasterRetentionRead(Schema):
    """The retention of the masters that a contract's designer delivered in its project."""

    years: int | None = Field(description="From the last delivery, as the contracts have it; null: without an end.")
    last_delivery_on: date | None = Field(description="Null while nothing was delivered.")
    masters: int = Field(description="The number of masters that are kept.")
    ends_on: date | None = Field(description="When they are deleted, or are to be; null: without an end.")
    announced_at: datetime | None = Field(description="When both parties were mailed; null: not yet.")
    obstacles: list[str] = Field(description="What must be settled before they are deleted.")
    kept_by: str | None = Field(description="The producer who keeps them longer; null: nobody.")
    deleted_at: datetime | None = Field(description="When masters were deleted; null: none were.")


class MasterRetentionSet(Schema):
    """The choice to keep masters longer than the contracts ask."""

    keep: bool = Field(description="False: they are deleted after the contracts' years.")
