"""A server without a worker: policies need answers, not jobs, and one process runs one worker at most."""

from collections.abc import Iterator

import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal

from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The application on a database of its own."""
    folder = tmp_path_factory.mktemp("policies")
    runtime = Runtime.of(Settings(data_dir=folder, sign_up="open", secret_key="only for tests"))
    sa.event.listen(runtime.database.engine, "connect", lambda link, _: link.execute("PRAGMA synchronous=OFF"))
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.database.dispose()
