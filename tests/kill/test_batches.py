"""A batch of game files, with a kill at every step of it: each file is made once, and none is forgotten."""

from uuid import UUID

import pytest

from app.renders.models import BatchItem, Render
from app.renders.rules import ItemState
from tests.app.builds.approved import sound
from tests.app.renders.test_batches import add_target, batch, listed
from tests.kill.effects import is_idle, nothing_failed, rows
from tests.kill.processes import ProcessServer, SomeOf, wait_until
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

pytestmark = [pytest.mark.kill, pytest.mark.slow]
POINTS = ("batch_planned", "batch_item_made", "batch_before_commit", "batch_after_commit")
SOUNDS = 3


@pytest.mark.killed_on("sqlite")
def test_a_batch_goes_on_after_a_kill_at_every_step(server: ProcessServer, world: World, some_of: SomeOf) -> None:
    add_cues(world, *({"name": f"laser {place}"} for place in range(SOUNDS)))
    delivery_id = open_delivery(world)
    takes = [
        deliver(world, f"laser_{place}.wav", sound(place, rate=48_000), delivery_id=delivery_id)
        for place in range(SOUNDS)
    ]
    server.work()
    wait_until(lambda: is_idle(server))
    for take in takes:
        assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
    wait_until(lambda: is_idle(server))
    server.stop()
    add_target(world, "trailer", 32_000)
    for point in some_of(POINTS, 2):
        server.wait_for_death(server.work(f"renders.{point}"), f"renders.{point}")
    server.work()
    wait_until(lambda: is_idle(server))
    (reported,) = listed(world)
    assert (reported["state"], reported["files"], reported["refused"], reported["left"]) == ("done", 3 * SOUNDS, 0, 0)
    assert (reported["made"], reported["kept"]) == (SOUNDS, 2 * SOUNDS)
    assert rows(server, BatchItem, batch_id=UUID(reported["id"]), state=ItemState.MADE) == SOUNDS
    assert rows(server, Render, target="trailer") == SOUNDS
    assert {row["target"]: row["files"] for row in batch(world, reported["id"])["sizes"]}["trailer"] == SOUNDS
    assert nothing_failed(server)
