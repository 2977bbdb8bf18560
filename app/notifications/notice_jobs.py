"""Notices leave after a time."""

from app.kit import clock
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.notifications import notices


@job("notifications.delete_old_notices")
def delete_old_notices(runtime: Runtime, _payload: Payload) -> None:
    """Delete notices that were read long ago."""
    with runtime.database.writing() as session:
        notices.delete_old(session, clock.now())
