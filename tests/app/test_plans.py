"""Screens find their rows by an index: what a statement reads does not grow with the rest of the server."""

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import pytest
import sqlalchemy as sa
from fastapi.testclient import TestClient

from app.accounts.endpoints import CSRF_HEADER, SESSION_COOKIE, csrf_token
from app.kit.db import Base
from benchmarks.bulk import filling
from benchmarks.studios import Made, ProjectMaker, make_team
from tests.support.server import RunningServer

# Few rows however much is delivered: one or some for each studio, person or project.
SMALL = {
    "accounts_studios", "accounts_people", "accounts_memberships", "accounts_sign_ins", "accounts_tokens",
    "kit_heartbeats", "projects_projects", "projects_specs", "projects_engagements",
    "projects_liaisons", "projects_decider_changes",
}  # fmt: skip
LARGE = set(Base.metadata.tables) - SMALL
Statement = tuple[str, Any]


@dataclass(frozen=True)
class Screen:
    """One request, and who makes it."""

    path: str
    by: str = "decider"


SCREENS = {
    "review queue": Screen("/v1/review-queue?project_id={project}"),
    "review queue of all projects": Screen("/v1/review-queue"),
    "sound list": Screen("/v1/projects/{project}/sound-list?limit=20"),
    "where its cues stand": Screen("/v1/projects/{project}/sound-list/standing?limit=20"),
    "where a designer's cues stand": Screen("/v1/projects/{project}/sound-list/standing?limit=20", "designer"),
    "counts": Screen("/v1/projects/{project}/sound-list/counts"),
    "search": Screen("/v1/projects/{project}/find?q=laser"),
    "judged lately": Screen("/v1/projects/{project}/judged-lately"),
    "today": Screen("/v1/projects/{project}/today"),
    "desk": Screen("/v1/projects/{project}/desk", "designer"),
    "overview": Screen("/v1/projects/{project}/overview"),
    "takes": Screen("/v1/projects/{project}/takes"),
    "takes without a cue": Screen("/v1/projects/{project}/takes?unmatched=true"),
    "drafts": Screen("/v1/projects/{project}/change-requests?state=draft"),
    "changes": Screen("/v1/projects/{project}/change-requests"),
    "questions": Screen("/v1/projects/{project}/questions?only_open=true"),
    "deliveries": Screen("/v1/projects/{project}/deliveries"),
}


@pytest.fixture(scope="module")
def made(server: RunningServer) -> Made:
    """A project among others; nothing was counted for the planner, as on a server that has just been filled."""
    with filling(server.runtime.database, analysed=False) as bulk:
        ProjectMaker(bulk, make_team(bulk, "Beside it"), takes=200, seed=2).make()
        return ProjectMaker(bulk, make_team(bulk, "Measured"), takes=300, seed=1).make()


@pytest.fixture
def browser_of(server: RunningServer, made: Made) -> Callable[[str], TestClient]:
    def browser_of(by: str) -> TestClient:
        secret = made.decider_secret if by == "decider" else made.designer_secret
        client = server.browser()
        client.cookies.set(SESSION_COOKIE, secret)
        client.headers[CSRF_HEADER] = csrf_token(server.runtime.settings, secret)
        return client

    return browser_of


@contextmanager
def heard(engine: sa.Engine) -> Iterator[list[Statement]]:
    """Gather the statements that are executed during a block."""
    statements: list[Statement] = []

    def hear(_connection: Any, _cursor: Any, statement: str, parameters: Any, *_: Any) -> None:
        statements.append((statement, parameters))

    sa.event.listen(engine, "before_cursor_execute", hear)
    yield statements
    sa.event.remove(engine, "before_cursor_execute", hear)


def plan_of(connection: sa.Connection, statement: Statement) -> list[str]:
    """Return the lines of what the database says it will do."""
    text, parameters = statement
    if connection.dialect.name == "sqlite":
        return [row[3] for row in connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {text}", parameters)]
    connection.exec_driver_sql("SET LOCAL enable_seqscan = off")  # with few rows an index is never worth it
    return [row[0] for row in connection.exec_driver_sql(f"EXPLAIN {text}", parameters)]


def whole_reads(connection: sa.Connection, statement: Statement) -> set[str]:
    """Return the large tables that a statement reads from one end to the other."""
    if not re.match(r"\s*(SELECT|WITH)\b", statement[0]) or "set_config" in statement[0]:
        return set()
    whole = r"SCAN (\w+)" if connection.dialect.name == "sqlite" else r".*Seq Scan on (\w+)"
    names = [found.group(1) for line in plan_of(connection, statement) if (found := re.match(whole, line))]
    return {name for name in (re.sub(r"_\d+$", "", name) for name in names) if name in LARGE}


@pytest.mark.parametrize("name", SCREENS)
def test_no_large_table_is_read_whole(server: RunningServer, made: Made, browser_of, name: str):
    screen, engine = SCREENS[name], server.runtime.database.engine
    with heard(engine) as statements:
        answer = browser_of(screen.by).get(screen.path.format(project=made.project_id))
    assert answer.status_code == 200, answer.text
    assert any("SELECT" in text for text, _ in statements)
    with engine.connect() as connection:
        found = [(each[0], whole_reads(connection, each)) for each in statements]
    assert not [(text, tables) for text, tables in found if tables]


def test_a_whole_read_would_be_noticed(server: RunningServer, made: Made):
    with server.runtime.database.engine.connect() as connection:
        assert whole_reads(connection, ("SELECT * FROM deliveries_takes WHERE note = ''", ())) == {"deliveries_takes"}


def test_jobs_that_are_done_are_not_read_to_tell_of_the_others(server: RunningServer, made: Made):
    """They are kept for a month: only an index that holds none of them will do."""
    jobs, engine, studio_id = server.runtime.queue, server.runtime.database.engine, made.project_id
    with heard(engine) as statements:
        jobs.counts(), jobs.lanes(studio_id), jobs.in_hand()
        jobs.unfinished(limit=50), jobs.unfinished(studio_id=studio_id, state="parked", after=(1, "x"))
    with engine.connect() as connection:
        plans = [plan_of(connection, each) for each in statements if "workflow_status" in each[0]]
    reads = [line for plan in plans for line in plan if re.search(r"(SCAN|SEARCH|Scan) .*workflow_status", line)]
    assert len(plans) >= 5, "and what the worker reads meanwhile"
    assert len(reads) > len(plans)
    without = r"idx_workflow_status_(in_flight|partition_dequeue|pending|delayed|failed)|Bitmap Heap Scan"
    assert [line for line in reads if not re.search(without, line)] == []
