"""What every room's tests have: a studio of their own on the one server, and no tries counted."""

import pytest

from tests.support.server import RunningServer, World


@pytest.fixture
def world(server: RunningServer) -> World:
    """A new studio with a producer, an audio director who decides, a designer, a project, and strangers."""
    return World(server)


@pytest.fixture(autouse=True)
def _no_tries_yet(request: pytest.FixtureRequest) -> None:
    """Forget what earlier tests tried: all come from one place, and write to the same mailboxes."""
    if "server" in request.fixturenames:
        server: RunningServer = request.getfixturevalue("server")
        server.forget_tries()
