"""A sound that was adopted from the game's own folder is owed nothing by a contract that comes later."""

from uuid import UUID

import pytest
import sqlalchemy as sa

from app.deliveries.models import Take
from tests.app.agreements.conftest import Contracts
from tests.app.money.test_adoption import agree, owed
from tests.support.adoptions import adopted
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

pytestmark = pytest.mark.slow

CLICK = wav_bytes(noise(dbfs=-24, seconds=0.2, rate=44_100), rate=44_100, bits=16)


def test_a_contract_pays_nothing_for_what_was_adopted_before_it(world: World, contracts: Contracts) -> None:
    adopted(world, {"ui/click.wav": CLICK})
    [cue] = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    # The case in which who adopts is the contract's own designer, as where a studio's member makes sounds too.
    own = sa.update(Take).where(Take.cue_id == UUID(cue["id"])).values(designer_id=world.designer_id)
    world.server.in_database(lambda session: session.execute(own))
    assert owed(contracts, agree(contracts, UUID(cue["id"]))) == []
