"""Contracts to plan and to be paid by."""

import pytest

from tests.app.agreements.conftest import Contracts
from tests.support.server import World


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)
