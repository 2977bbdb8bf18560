"""What this room's tests have: one project whose sounds are approved."""

import pytest

from tests.app.reviews.making import Stage
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    """A project with a delivery."""
    return Stage(world)
