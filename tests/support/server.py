"""A real server inside the test process, and the people who use it."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import timedelta
from functools import cached_property
from pathlib import Path
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from anyio.from_thread import BlockingPortal, start_blocking_portal
from httpx2 import Client
from pwdlib import PasswordHash
from pwdlib.hashers.argon2 import Argon2Hasher
from sqlalchemy.orm import Session

import audio_checks
from app import logs
from app.accounts import passwords
from app.accounts.authentication import CSRF_HEADER, SESSION_COOKIE, csrf_token, sha256_of
from app.accounts.models import Membership, Person, RateLimit, SignIn, Studio
from app.accounts.rules import Role
from app.core import clock, typesetting
from app.core.db import new_id
from app.core.jobs import workers
from app.core.jobs.workers import Worker
from app.core.runtime import Runtime
from app.core.web.host_cookies import PREFIX
from app.main import create_app
from app.migrate import migrate
from app.projects.models import ApproverChange, Engagement, Liaison, Project, Spec
from app.projects.rules import EngagementKind
from app.settings import Settings
from app.worker import start_worker
from tests.support.client import browser
from tests.support.statements import Recorder

LONG_AGO_S = 300.0  # ends what hangs, however busy the machine is
JOBS_END_WITHIN_S = 300
REQUESTS = "AnyIO worker thread"  # name of the threads that answer requests


@dataclass
class RunningServer:
    """The parts of a running server that tests reach into."""

    runtime: Runtime
    application: Any
    portal: BlockingPortal
    worker: Worker | None = None  # where one runs
    recorder: Recorder | None = None  # where what is sent is recorded

    def browser(self) -> Client:
        """Return a client without credentials."""
        return browser(self.application, self.portal)

    def wait_for_jobs(self, seconds: float = LONG_AGO_S) -> None:
        """Return when no job waits or runs."""
        deadline = time.monotonic() + seconds
        status = sa.column("status", sa.Text)
        jobs = sa.table("workflow_status", status, schema=None if self.runtime.database.is_sqlite else "dbos")
        unfinished = sa.select(sa.func.count()).select_from(jobs).where(status.in_(("ENQUEUED", "PENDING")))
        while time.monotonic() < deadline:
            with self.runtime.database.reading() as session:
                if session.scalar(unfinished) == 0:
                    return
            time.sleep(0.03)
        raise AssertionError(f"jobs still run after {seconds} s: {self.runtime.queue.unfinished()}")

    @contextmanager
    def counted_selects(self) -> Iterator[list[str]]:
        """Gather what requests read from the database; the worker in this process reads when it likes."""
        selects: list[str] = []

        def note(_connection: Any, _cursor: Any, statement: str, *_more: Any) -> None:
            if statement.lstrip().upper().startswith("SELECT") and threading.current_thread().name == REQUESTS:
                selects.append(statement)

        engine = self.runtime.database.engine
        sa.event.listen(engine, "before_cursor_execute", note)
        try:
            yield selects
        finally:
            sa.event.remove(engine, "before_cursor_execute", note)

    def forget_tries(self) -> None:
        """Let all try again what was tried too often: all tests come from one place."""
        with self.runtime.database.writing() as session:
            session.execute(sa.delete(RateLimit))

    def in_database(self, work: Callable[[Session], Any]) -> Any:
        """Run work in a transaction of its own."""
        with self.runtime.database.writing() as session:
            return work(session)


@contextmanager
def run_server(folder: Path, **settings: Any) -> Iterator[RunningServer]:
    """Run web application and worker in this process."""
    logs.configure()
    passwords._hasher = PasswordHash((Argon2Hasher(time_cost=1, memory_cost=8, parallelism=1),))  # 0.4 s dearer each
    # Requests and jobs make their PDFs in one process here: they wait for each other, however slow the machine is.
    typesetting._in_hand, typesetting.MAX_WAIT_S = threading.BoundedSemaphore(100), 300.0
    workers.POLL_EVERY_S = 0.05
    settings = {"secret_key": "only for tests", "worker_silent_s": 1.5, "sign_up": "open", **settings}
    runtime = Runtime.of(Settings(data_dir=folder, **settings))
    if runtime.database.engine.dialect.name == "sqlite":  # tests/kill is there for what a commit survives
        sa.event.listen(runtime.database.engine, "connect", lambda link, _: link.execute("PRAGMA synchronous=OFF"))
    migrate(runtime.database)
    application = create_app(runtime)
    worker = start_worker(runtime)
    try:
        with start_blocking_portal() as portal:
            yield RunningServer(runtime, application, portal, worker)
    finally:
        worker.stop(wait_s=JOBS_END_WITHIN_S)  # a job that outlives its runtime fails where nobody looks
        runtime.close()


class World:
    """A studio of one test, and the people in it and outside."""

    def __init__(self, server: RunningServer, preset: str = "44k1") -> None:
        self.server = server
        with server.runtime.database.writing() as session:
            studio = Studio(name="Test studio")
            session.add(studio)
            self.producer_id = self._person(session, "Producer")
            self.approver_id = self._person(session, "Audio director")
            self.reviewer_id = self._person(session, "Composer")
            self.designer_id = self._person(session, "Sound designer")
            self.other_designer_id = self._person(session, "Another sound designer")
            self.stranger_id = self._person(session, "Producer elsewhere")
            session.flush()
            self.studio_id: UUID = studio.id
            elsewhere = Studio(name="Another studio")
            session.add(elsewhere)
            session.flush()
            for studio_id, person_id, roles in (
                (studio.id, self.producer_id, [Role.PRODUCER]),
                (studio.id, self.approver_id, [Role.LIAISON]),
                (studio.id, self.reviewer_id, [Role.REVIEWER]),
                (elsewhere.id, self.stranger_id, [Role.PRODUCER]),
            ):
                session.add(Membership(studio_id=studio_id, person_id=person_id, roles=list(roles)))
            project = Project(studio_id=studio.id, name="Shield Wing", cue_prefix="SW", created_by=self.producer_id)
            session.add(project)
            session.flush()
            self.project_id: UUID = project.id
            session.add(Liaison(project_id=project.id, person_id=self.approver_id, studio_id=studio.id))
            session.add(
                ApproverChange(
                    studio_id=studio.id,
                    project_id=project.id,
                    person_id=self.approver_id,
                    reason="named when the project opened",
                    changed_by=self.producer_id,
                )
            )
            session.add(
                Engagement(
                    studio_id=studio.id,
                    project_id=project.id,
                    designer_id=self.designer_id,
                    kind=EngagementKind.CONTRACT,
                )
            )
            toml = audio_checks.new_spec(preset, name="Shield Wing")
            session.add(
                Spec(
                    studio_id=studio.id,
                    project_id=project.id,
                    version=1,
                    toml=toml,
                    sha256=audio_checks.parse_spec(toml).sha256,
                    created_by=self.producer_id,
                )
            )

    @staticmethod
    def _person(session: Session, name: str) -> UUID:
        person_id = new_id()
        session.add(Person(id=person_id, email=f"{person_id}@example.test", name=name))
        return person_id

    def signed_in(self, person_id: UUID) -> Client:
        """Return a browser in which this person is signed in."""
        secret = f"secret of {new_id()}"
        expires_at = clock.now() + timedelta(days=365)
        with self.server.runtime.database.writing() as session:
            session.add(SignIn(person_id=person_id, secret_sha256=sha256_of(secret), expires_at=expires_at))
        client = self.server.browser()
        if self.server.recorder:
            self.server.recorder.watch_requests(client, self._kind_of(person_id))
        prefix = PREFIX if self.server.runtime.settings.is_https else ""
        client.cookies.set(f"{prefix}{SESSION_COOKIE}", secret)
        client.headers[CSRF_HEADER] = csrf_token(self.server.runtime.settings, secret)
        return client

    def _kind_of(self, person_id: UUID) -> str:
        """Return which of the people of this studio it is."""
        kinds = (name.removesuffix("_id") for name, value in vars(self).items() if value == person_id)
        return next(kinds, "another")

    @cached_property
    def producer(self) -> Client:
        """The producer's browser."""
        return self.signed_in(self.producer_id)

    @cached_property
    def approver(self) -> Client:
        """The browser of the audio director, who decides."""
        return self.signed_in(self.approver_id)

    @cached_property
    def reviewer(self) -> Client:
        """The browser of the composer, who advises."""
        return self.signed_in(self.reviewer_id)

    @cached_property
    def designer(self) -> Client:
        """The browser of the designer who is engaged on the project."""
        return self.signed_in(self.designer_id)

    @cached_property
    def other_designer(self) -> Client:
        """The browser of a designer who is engaged on nothing here."""
        return self.signed_in(self.other_designer_id)

    @cached_property
    def stranger(self) -> Client:
        """The browser of another studio's producer."""
        return self.signed_in(self.stranger_id)

    @cached_property
    def nobody(self) -> Client:
        """A browser without credentials."""
        return self.server.browser()
