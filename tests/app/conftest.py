"""What every room's tests have: a studio of their own on the one server."""

import pytest

from tests.support.server import RunningServer, World


@pytest.fixture
def world(server: RunningServer) -> World:
    """A new studio with a producer, an audio director who decides, a designer, a project, and strangers."""
    return World(server)
