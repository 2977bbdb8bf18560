"""Jobs that look after what the server stores, and erase what people asked for."""

from datetime import timedelta

import structlog

from app.core import clock
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.operations.erasure import queries as erasure_queries
from app.operations.erasure import requests as erasure_requests
from app.operations.errors import ErasureRefused
from app.operations.retention import queries as retention_queries
from app.operations.retention import service as retention
from app.operations.scrubbing import queries as blob_queries
from app.operations.scrubbing import service as scrubbing

SCRUB_EVERY = timedelta(days=1)
SCRUB_BYTES = 2 << 30  # each five minutes, so 560 GiB a day
SCRUB_BYTES_PER_S = 64 << 20
log = structlog.get_logger(__name__)


@job("operations.scrub_blobs")
def scrub_blobs(runtime: Runtime, _payload: Payload) -> None:
    """Read and hash some more stored files; a pass over all begins once a day."""
    with runtime.database.reading() as session:
        scrub = blob_queries.newest_scrub(session)
    if scrub is None or (scrub.finished_at and clock.now() - scrub.started_at >= SCRUB_EVERY):
        scrub = scrubbing.begin(runtime.database)
    elif scrub.finished_at:
        return
    rate = scrubbing.RateLimit(SCRUB_BYTES_PER_S)
    scrub_id = scrub.id
    for damage in scrubbing.run(runtime, scrub, rate=rate, max_bytes=SCRUB_BYTES):
        log.error("a stored file is damaged", state=damage.state, studio_id=str(damage.studio_id), sha256=damage.sha256)
    with runtime.database.reading() as session:
        ended = blob_queries.newest_scrub(session, finished=True)
    if ended is not None and ended.id == scrub_id:
        deleted = sum(1 for _ in scrubbing.delete_orphans(runtime, scrubbing.ORPHANS_KEPT))
        log.info("unused files were deleted", files=deleted)


@job("operations.carry_out_erasures")
def carry_out_erasures(runtime: Runtime, _payload: Payload) -> None:
    """Erase the projects and studios whose days of grace are over."""
    with runtime.database.reading() as session:
        due = erasure_queries.due_erasures(session, clock.now())
    for erasure_id in due:
        try:
            with runtime.database.writing() as session:
                erasure_requests.carry_out(session, erasure_id)
            log.info("an erasure was carried out", erasure_id=str(erasure_id))
        except ErasureRefused as error:
            with runtime.database.writing() as session:
                erasure_requests.give_up(session, erasure_id, error.message)


@job("operations.end_masters")
def end_masters(runtime: Runtime, _payload: Payload) -> None:
    """Announce the deletion of masters whose contracts' years are over, and delete those whose day has come."""
    with runtime.database.reading() as session:
        candidates = retention_queries.candidates(session, clock.now())
    for project_id, designer_id in candidates:
        with runtime.database.writing() as session:
            done = retention.look_after(session, project_id, designer_id, base_url=runtime.settings.base_url)
        if done:
            log.info("masters end", done=done, project_id=str(project_id), designer_id=str(designer_id))
