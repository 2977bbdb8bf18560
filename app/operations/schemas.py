"""The bodies of this room."""

from datetime import datetime
from enum import StrEnum
from uuid import UUID

from pydantic import Field

from app.accounts.quotas import QuotaKind
from app.kit.http import Schema


class JobState(StrEnum):
    """Where an unfinished job stands; done ones are not listed."""

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
        description="Why it failed last. A producer is told the kind of failure, an operator all of it."
    )


class JobCountRead(Schema):
    """How many jobs of one name are in one state."""

    job: str
    state: JobState
    jobs: int
    oldest_at: datetime


class Urgency(StrEnum):
    """How soon a lane's jobs want to be done: what people wait for goes before a re-render of thousands."""

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
    """What a kept file is."""

    MASTERS = "masters"
    DRY_STEMS = "dry_stems"  # withdrawn ones too
    ARCHIVES = "archives"  # ZIPs as they were delivered
    GAME_FILES = "game_files"
    DRAWINGS = "drawings"  # wave shapes, spectrum and preview of one sound together
    MENDS = "mends"  # those that no designer has made a take of
    REELS = "reels"
    EXPORTS = "exports"  # masters with what is known of them, made to be handed out
    STAND_INS = "stand_ins"
    DOCUMENTS = "documents"  # contracts, and the keys that go with packs


class KeptFiles(Schema):
    """How many files of one kind are kept, and how large they are together."""

    kind: KeptKind
    files: int
    size_bytes: int


class QuotaRead(Schema):
    """One limit of a studio, and what it has of that."""

    kind: QuotaKind
    used: int
    limit: int
    default: int


class StorageRead(Schema):
    """What a studio keeps; of a kind, the same bytes are kept and counted once."""

    studio_id: UUID
    studio_name: str
    size_bytes: int
    kept: list[KeptFiles] = Field(description="Kinds without a file are left out.")


class WorkerRead(Schema):
    """A worker process, when it last said that it lives, and how many jobs it has in hand."""

    id: str
    beat_at: datetime
    is_alive: bool = Field(description="Whether it said so lately; the jobs of one that is silent others take over.")
    running: int


class StudioOperations(Schema):
    """A studio's jobs, and whether somebody does the work."""

    counts: list[JobCountRead]
    lanes: list[LaneRead]
    workers: int = Field(description="Worker processes that live.")


class ServerOperations(Schema):
    """The whole server's jobs and workers."""

    counts: list[JobCountRead]
    lanes: list[LaneRead] = Field(description="The longest first, fifty at most.")
    workers: list[WorkerRead] = Field(description="Those that said within the hour that they live.")


class ServerStorage(Schema):
    """What the whole server keeps."""

    studios: list[StorageRead] = Field(description="The largest first.")
    free_bytes: int | None = Field(description="What the disk of the store has left; null where the store is a bucket.")
