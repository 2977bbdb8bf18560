"""The bodies of this room."""

from datetime import datetime
from enum import StrEnum
from uuid import UUID

from pydantic import Field

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
    job: str = Field(examples=["conformance.check_take"])
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


class StorageRead(Schema):
    """What a studio keeps; the same bytes delivered twice are kept once."""

    studio_id: UUID
    studio_name: str
    masters: int
    master_bytes: int
    renders: int
    render_bytes: int


class WorkerRead(Schema):
    """A worker process, and when it last said that it lives."""

    id: str
    beat_at: datetime


class StudioOperations(Schema):
    """A studio's jobs and storage, and whether somebody does the work."""

    counts: list[JobCountRead]
    storage: StorageRead
    workers: int = Field(description="Worker processes that live.")


class ServerOperations(Schema):
    """The whole server's jobs, storage and workers."""

    counts: list[JobCountRead]
    storage: list[StorageRead] = Field(description="By studio, the largest first.")
    workers: list[WorkerRead] = Field(description="Those that said within the hour that they live.")
