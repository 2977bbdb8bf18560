"""Screens find their rows by an index: what a statement reads does not grow with the rest of the server."""

import re
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal

from app.core.db import Base
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from benchmarks.bulk import filling
from benchmarks.plans import heard, indexes_used, plan_of, whole_reads
from benchmarks.screens import SCREENS, sign_in
from benchmarks.studios import Made, ProjectMaker, make_team
from tests.support.server import RunningServer

# Few rows however much is delivered: one or some for each studio, person or project.
SMALL = {
    "accounts_studios", "accounts_people", "accounts_memberships", "accounts_sign_ins", "accounts_tokens",
    "accounts_passkeys", "core_heartbeats", "projects_projects", "projects_specs", "projects_engagements",
    "projects_liaisons", "projects_members", "projects_approver_changes",
}  # fmt: skip
LARGE = set(Base.metadata.tables) - SMALL


pytestmark = pytest.mark.both_databases


@pytest.fixture(scope="module")
def server(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, database_url: str
) -> Iterator[RunningServer]:
    """An application on a database of its own: PostgreSQL, which counts nothing here, goes by how large a table is."""
    url = request.getfixturevalue("postgres").new_database("plans") if database_url else ""
    runtime = Runtime.of(
        Settings(data_dir=tmp_path_factory.mktemp("plans"), database_url=url, secret_key="only for tests")
    )
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


@pytest.fixture(scope="module")
def made(server: RunningServer) -> Made:
    """A project among others; nothing was counted for the planner, as on a server that has just been filled."""
    with filling(server.runtime.database) as bulk:
        ProjectMaker(bulk, make_team(bulk, "Beside it"), takes=200, seed=2).make()
        # With fewer, PostgreSQL finds it as cheap to go through a whole index as to look up each cue of a page.
        return ProjectMaker(bulk, make_team(bulk, "Measured"), takes=2_000, seed=1).make()


@contextmanager
def planning(engine: sa.Engine) -> Iterator[sa.Connection]:
    """Give a connection that explains statements as if there were very many rows."""
    with engine.connect() as connection:
        if connection.dialect.name == "postgresql":
            for way in ("seqscan", "hashjoin", "mergejoin"):  # with few rows to look one up is never worth it
                connection.exec_driver_sql(f"SET LOCAL enable_{way} = off")
        yield connection


@pytest.mark.slow
@pytest.mark.parametrize("name", SCREENS)
def test_no_large_table_is_read_whole(server: RunningServer, made: Made, name: str):
    screen, engine = SCREENS[name], server.runtime.database.engine
    asking = sign_in(server.browser(), server.runtime.settings, screen.secret(made))
    with heard(engine) as statements:
        answer = asking.get(screen.address(made).format(words="laser"))
    assert answer.status_code == 200, answer.text
    assert any("SELECT" in text for text, _ in statements)
    with planning(engine) as connection:
        found = [(each[0], whole_reads(connection, each, LARGE)) for each in statements]
    assert not [(text, tables) for text, tables in found if tables]


@pytest.mark.slow
@pytest.mark.parametrize(
    "asked",
    ["SELECT * FROM deliveries_takes WHERE note = ''", "SELECT id FROM deliveries_takes ORDER BY id"],
    ids=["of the table", "of an index"],
)
def test_a_whole_read_would_be_noticed(server: RunningServer, made: Made, asked: str):
    with planning(server.runtime.database.engine) as connection:
        whole = whole_reads(connection, (asked, ()), LARGE)
        assert whole == {"deliveries_takes"}


@pytest.mark.parametrize(
    ("name", "index"),
    [
        # The studio has one project, so that the waiting takes of both are the same.
        ("review queue", r"ix_deliveries_takes_(project|studio)_waiting"),
        ("review queue of all projects", "ix_deliveries_takes_studio_waiting"),
        ("how many wait for review", "ix_deliveries_takes_project_waiting"),
        ("sound list", "ix_sound_lists_cues_order"),
        ("where its cues stand", "ix_sound_lists_cues_order"),
    ],
)
def test_a_page_is_found_by_the_index_that_was_made_for_it(server: RunningServer, made: Made, name: str, index: str):
    screen, engine = SCREENS[name], server.runtime.database.engine
    asking = sign_in(server.browser(), server.runtime.settings, screen.secret(made))
    with heard(engine) as statements:
        assert asking.get(screen.address(made)).status_code == 200
    with planning(engine) as connection:
        found = set().union(*(indexes_used(connection, each, LARGE) for each in statements))
    assert any(re.fullmatch(index, used) for used in found)


@pytest.mark.slow
def test_comments_of_the_queue_are_not_found_among_all_that_are_no_replies(server: RunningServer, made: Made):
    screen, engine = SCREENS["review queue"], server.runtime.database.engine
    asking = sign_in(server.browser(), server.runtime.settings, screen.secret(made))
    with heard(engine) as statements:
        assert asking.get(screen.address(made)).status_code == 200
    with engine.connect() as connection:
        counting = [each for each in statements if "FROM reviews_comments" in each[0]]
        found = set().union(*(indexes_used(connection, each, {"reviews_comments"}) for each in counting))
    assert counting
    assert "ix_reviews_comments_reply_to_id" not in found


def test_a_designers_takes_of_a_page_are_found_by_its_cues(server: RunningServer, made: Made):
    """And not by going through all that the designer ever made."""
    screen, engine = SCREENS["where a designer's cues stand"], server.runtime.database.engine
    asking = sign_in(server.browser(), server.runtime.settings, screen.secret(made))
    with heard(engine) as statements:
        assert asking.get(screen.address(made)).status_code == 200
    with planning(engine) as connection:
        selects = [each for each in statements if "FROM deliveries_takes" in each[0]]
        lines = [line for each in selects for line in plan_of(connection, each)]
    assert len(selects) >= 5
    assert not [line for line in lines if re.search(r"\(designer_id ?=", line) and "Filter" not in line]


def test_jobs_that_are_done_are_not_read_to_report_the_others(server: RunningServer, made: Made):
    """They are kept for a month: only an index that holds none of them will do."""
    jobs, engine, studio_id = server.runtime.queue, server.runtime.database.engine, made.project_id
    with heard(engine) as statements:
        jobs.counts(), jobs.lanes(studio_id), jobs.running_jobs_by_worker()
        jobs.unfinished(limit=50), jobs.unfinished(studio_id=studio_id, state="parked", after=(1, "x"))
    with planning(engine) as connection:
        plans = [plan_of(connection, each) for each in statements if "workflow_status" in each[0]]
    reads = [line for plan in plans for line in plan if re.search(r"(SCAN|SEARCH|Scan) .*workflow_status", line)]
    assert len(plans) >= 5
    assert len(reads) > len(plans)
    without = r"idx_workflow_status_(in_flight|partition_dequeue|pending|delayed|failed)|Bitmap Heap Scan"
    assert [line for line in reads if not re.search(without, line)] == []


def test_what_a_studio_keeps_is_summed_along_an_index(server: RunningServer, made: Made):
    """And not sorted first, which takes longer than the sums."""
    screen, engine = SCREENS["what a studio keeps"], server.runtime.database.engine
    if engine.dialect.name != "sqlite":
        pytest.skip("how PostgreSQL finds equal rows depends on their number")
    asking = sign_in(server.browser(), server.runtime.settings, screen.secret(made))
    with heard(engine) as statements:
        assert asking.get(screen.address(made)).status_code == 200
    with engine.connect() as connection:
        (summing,) = [each for each in statements if "UNION ALL" in each[0]]
        lines = plan_of(connection, summing)
    for index in ("ix_deliveries_takes_kept", "ix_renders_renders_kept"):
        (place,) = [place for place, line in enumerate(lines) if index in line]
        assert "TEMP B-TREE" not in "".join(lines[place : place + 3])
    assert not [line for line in lines if "TEMP B-TREE FOR GROUP BY" in line]
