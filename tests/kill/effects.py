"""What was done to one take, counted: everything once, whichever process was killed in between."""

from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy import func, select

from app.conformance.models import CheckRun
from app.core.db import Base
from app.core.jobs import queue
from app.deliveries.models import Take
from app.notifications.models import Mail
from app.projects.queries import current_spec
from app.renders.models import Picture, Render, RenderSet
from app.renders.rules import RenderState
from app.reviews.models import Verdict
from tests.kill.processes import ProcessServer, wait_until


def is_idle(server: ProcessServer) -> bool:
    """Whether nothing runs or waits for its turn; what waits for a later hour may."""
    return not {"waiting", "running"} & {count.state for count in server.runtime.queue.counts()}


def nothing_failed(server: ProcessServer) -> bool:
    """Whether no job gave up."""
    return not server.runtime.queue.unfinished(only_failed=True)


def jobs_written(server: ProcessServer, job: str) -> int:
    """Return how many jobs of a name were ever written."""
    jobs = queue.workflows(is_sqlite=server.runtime.database.is_sqlite)
    written = select(func.count()).select_from(jobs).where(jobs.c.workflow_uuid.like(f"%:{job}"))
    with server.runtime.database.reading() as session:
        return session.scalar(written) or 0


def rows(server: ProcessServer, table: type[Base], **facts: Any) -> int:
    """Return how many rows of a table have these facts."""
    counted = (
        select(func.count()).select_from(table).where(*(getattr(table, name) == is_ for name, is_ in facts.items()))
    )
    with server.runtime.database.reading() as session:
        return session.scalar(counted) or 0


def assert_done_once(server: ProcessServer, take_id: UUID) -> None:
    """Assert that a take was checked, drawn and rendered, and its people notified, once."""
    with server.runtime.database.reading() as session:
        take = session.get_one(Take, take_id)
        spec = current_spec(session, take.project_id)
        targets = sorted(session.scalars(select(Render.target).where(Render.take_id == take_id)))
        sounds = {take.master_sha256, *session.scalars(select(Render.sha256).where(Render.take_id == take_id))}
        sets = session.execute(sa.select(RenderSet.spec_id).where(RenderSet.take_id == take_id)).all()
    assert targets == ["game", "handheld"]
    assert rows(server, Render, take_id=take_id, state=RenderState.MADE) == 2
    assert rows(server, CheckRun, take_id=take_id) == 1
    assert rows(server, Picture) == len(sounds)
    assert sets == [(spec.id,)]
    assert jobs_written(server, "notifications.notify_checks") == 1
    wait_until(lambda: notified_of(server))  # with what else is said in the same seconds
    wait_until(lambda: is_idle(server))
    assert notified_of(server) == 1
    assert nothing_failed(server)


def notified_of(server: ProcessServer) -> int:
    """Return how often a person was notified that a sound waits to be heard."""
    with server.runtime.database.reading() as session:
        mails = session.scalars(select(Mail.lines)).all()
    return sum("passed the check" in line for lines in mails for line in lines)


def verdicts(server: ProcessServer, take_id: UUID) -> int:
    """Return how many verdicts stand on record."""
    return rows(server, Verdict, take_id=take_id)
