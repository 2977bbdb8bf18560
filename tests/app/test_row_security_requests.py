"""The second lock under the web application: a forgotten condition shows no other studio."""

import json
from collections.abc import Iterator
from typing import Any

import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal
from sqlalchemy.orm import Session

from app import tables  # noqa: F401
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.projects import queries
from app.projects.models import Project
from app.settings import Settings
from tests.support.postgres import Postgres
from tests.support.server import RunningServer, World

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def server(postgres: Postgres, tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The web application on a database of its own, without a worker."""
    settings = Settings(
        data_dir=tmp_path_factory.mktemp("data"),
        secret_key="only for tests",
        database_url=postgres.new_database("second_lock"),
    )
    runtime = Runtime.of(settings)
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


def test_a_forgotten_where_shows_no_other_studio(server: RunningServer, monkeypatch: pytest.MonkeyPatch):
    def forgetful(session: Session, *_: Any, **__: Any) -> list[Project]:
        return list(session.scalars(sa.select(Project).options(sa.orm.joinedload(Project.studio))))

    monkeypatch.setattr(queries, "projects_seen", forgetful)
    world, other = World(server), World(server)
    for browser, mine in (
        (world.producer, {str(world.project_id)}),
        (world.designer, {str(world.project_id)}),
        (other.producer, {str(other.project_id)}),
        (world.stranger, set()),
    ):
        assert {each["id"] for each in browser.get("/v1/projects").json()["items"]} == mine


def test_an_answer_kept_for_a_key_is_not_seen_by_the_request_that_keeps_it(server: RunningServer):
    world = World(server)
    headers = {"Idempotency-Key": "a key of mine"}
    asked = [
        world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={"note": "first"}, headers=headers)
        for _ in range(2)
    ]
    assert [answer.status_code for answer in asked] == [201, 201]
    assert asked[0].json() == json.loads(asked[1].text)
