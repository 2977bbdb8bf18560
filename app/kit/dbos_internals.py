"""Everything that Soundlist uses of DBOS beside its public interface: pyproject.toml pins one exact version for it.

docs/decisions/0023-an-engine-for-jobs.md says what each part buys. tests/app/kit/test_dbos_internals.py names each, and
fails where a newer version lacks it or changed its parameters.
"""

import base64
import io
import pickle
import secrets
from collections.abc import Iterator
from concurrent.futures import Future
from typing import Any, NoReturn

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSPortableJSONSerializer, Queue
from dbos._core import WorkflowHandleFuture, execute_dequeued_workflow
from dbos._serialization import DefaultSerializer
from sqlalchemy.dialects.postgresql import JSONB

# A job's arguments are stored as JSON, so that write access to the database is no way to run code in a worker.
SERIALIZER = DBOSPortableJSONSerializer()
FAILED_STATES = ("ERROR", "CANCELLED", "MAX_RECOVERY_ATTEMPTS_EXCEEDED")
INDEXED_CONDITIONS = {  # conditions of DBOS's partial indexes, and the states that each is for
    "status in ('ENQUEUED', 'PENDING')": ("ENQUEUED", "PENDING"),
    "status = 'DELAYED'": ("DELAYED",),
    "status in ('ERROR', 'CANCELLED', 'MAX_RECOVERY_ATTEMPTS_EXCEEDED')": FAILED_STATES,
}
log = structlog.get_logger(__name__)


class _PlainValues(pickle.Unpickler):
    """Reads text, numbers, lists and mappings; refuses every name that would be looked up in a module."""

    def find_class(self, module: str, name: str) -> NoReturn:
        """Refuse a name."""
        raise pickle.UnpicklingError(f"a stored job names {module}.{name}; only plain values are read")


def _read(_serializer: DefaultSerializer, stored: str) -> Any:
    return _PlainValues(io.BytesIO(base64.b64decode(stored))).load()


def refuse_pickled_classes() -> None:
    """Have DBOS read plain values only from pickles, in this process.

    Each row names the format of its own arguments, and DBOS reads pickles wherever a row says so, whatever serializer
    it was given.
    """
    setattr(DefaultSerializer, "deserialize", _read)  # noqa: B010  mypy refuses an assignment to a method


def workflows(*, is_sqlite: bool) -> sa.TableClause:
    """Return DBOS's table of jobs, as far as we read it."""
    return sa.table(
        "workflow_status",
        sa.column("workflow_uuid", sa.Text),
        sa.column("status", sa.Text),
        sa.column("name", sa.Text),
        sa.column("queue_name", sa.Text),  # null once a job is parked
        sa.column("queue_partition_key", sa.Text),
        sa.column("priority", sa.Integer),
        sa.column("executor_id", sa.Text),
        sa.column("attributes", sa.JSON().with_variant(JSONB(), "postgresql")),
        sa.column("created_at", sa.BigInteger),
        sa.column("completed_at", sa.BigInteger),
        sa.column("recovery_attempts", sa.BigInteger),
        schema=None if is_sqlite else "dbos",
    )


def begin_jobs(
    dbos: DBOS, queue: Queue, worker_id: str, *, version: str, running: int
) -> Iterator["Future[Any] | None"]:
    """Claim the jobs at the head of a queue that the worker has slots for, and begin each; None for one that cannot.

    DBOS's own listener fills free slots at fixed intervals only.
    """
    system, owner = dbos._sys_db, secrets.token_hex(16)
    job_ids, _ = system.start_queued_workflows(
        queue, worker_id, version, None, running, owner_xid=owner, is_latest_version=False
    )
    jobs = {job["workflow_uuid"]: job for job in system.get_workflow_statuses(job_ids)} if job_ids else {}
    for job_id in job_ids:
        try:
            handle = execute_dequeued_workflow(dbos, jobs[job_id], owner)
        except Exception as error:  # it killed its worker too often, or cannot be read: the others are not to wait
            log.error("a job cannot begin", job_id=job_id, error=str(error))
            yield None
        else:
            yield handle.future if isinstance(handle, WorkflowHandleFuture) else None


def running_jobs(dbos: DBOS) -> set[str]:
    """Return the ids of the jobs that this process runs."""
    return set(dbos._active_workflows_set.activeList())


def take_over(worker_id: str) -> None:
    """Put the jobs of a dead worker back into the queue."""
    DBOS._recover_pending_workflows([worker_id])


def requeue(dbos: DBOS, job_id: str, *, worker_id: str, queue_name: str) -> None:
    """Put one job back into the queue that is recorded as run by a worker and is not."""
    dbos._sys_db.reenqueue_for_recovery(job_id, [worker_id], queue_name)


def engine(dbos: DBOS) -> sa.Engine:
    """Return the connections of DBOS to its tables."""
    return dbos._sys_db.engine
