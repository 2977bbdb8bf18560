"""Notices leave after a time."""

from app.core import clock
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.notifications.notices import service as notices


@job("notifications.delete_old_notices")
def delete_old_notices(runtime: Runtime, _payload: Payload) -> None:
    """Delete notices that were read long ago."""
    with runtime.database.writing() as session:
        notices.delete_old(session, clock.now())
