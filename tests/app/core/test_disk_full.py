"""A database whose disk is full says so, and goes on when there is room again."""

from pathlib import Path

import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal

from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer, World


@pytest.mark.slow
def test_a_full_database_is_reported_and_nothing_is_saved(tmp_path: Path):
    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        world = World(RunningServer(runtime, create_app(runtime), portal))
        project = {"studio_id": str(world.studio_id), "name": "Deep Field", "cue_prefix": "DF"}
        assert world.producer.get("/v1/me").status_code == 200

        def limit(connection: sa.Connection) -> None:
            connection.exec_driver_sql("PRAGMA max_page_count=1")  # no page more than there are

        sa.event.listen(runtime.database.engine, "begin", limit)
        answers = []
        for number in range(200):
            answers.append(world.producer.post("/v1/projects", json=project | {"cue_prefix": f"D{number}"}))
            if answers[-1].status_code != 201:
                break
        refused = answers[-1]
        assert (refused.status_code, refused.json()["code"]) == (507, "disk-full"), refused.text
        assert "free disk space" in refused.json()["fix"]
        sa.event.remove(runtime.database.engine, "begin", limit)
        runtime.database.dispose()
        assert world.producer.post("/v1/projects", json=project).status_code == 201
    runtime.close()
