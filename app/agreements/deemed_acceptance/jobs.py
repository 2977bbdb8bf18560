"""Reminders of cues that a clause will accept, and their acceptance."""

from app.agreements.deemed_acceptance import service
from app.core import clock
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime


@job("agreements.apply_deemed_acceptance")
def apply_deemed_acceptance(runtime: Runtime, _payload: Payload) -> None:
    """Remind approvers of cues that a clause on silence will accept, and accept those whose days are over."""
    now = clock.now()
    with runtime.database.reading() as session:
        cue_ids = service.deemed_cues_due(session, now)
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            service.apply_deemed(session, cue_id, now)
