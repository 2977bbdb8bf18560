"""Contracts to change and to end."""

import pytest

from tests.app.agreements.conftest import Contracts
from tests.support.server import World


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)
