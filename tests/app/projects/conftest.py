"""Every test begins with no tries counted: they all come from one place."""

import pytest

from tests.support.server import RunningServer


@pytest.fixture(autouse=True)
def _no_tries_yet(request: pytest.FixtureRequest) -> None:
    if "server" in request.fixturenames:
        server: RunningServer = request.getfixturevalue("server")
        server.forget_tries()
