"""What a worker makes on request, with a kill before each is recorded."""

import hashlib
from collections.abc import Callable
from typing import Any
from uuid import UUID

import pytest

from app.builds.models import PackedFile, PlaceholderFile, SealedPack
from app.conformance.models import Fix
from app.renders.models import MasterExport, Reel
from tests.app.builds.approved import sound
from tests.app.conformance.test_fixes import loud
from tests.kill.effects import is_idle, jobs_written, nothing_failed, rows
from tests.kill.processes import ProcessServer, SomeOf, wait_until
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

pytestmark = [pytest.mark.kill, pytest.mark.slow]
POINTS = (
    "conformance.before_fix",
    "conformance.after_fix",
    "renders.before_reel",
    "renders.before_export",
    "builds.before_placeholder_file",
    "builds.before_seal",
)
STAND_INS = 3  # a set of two that nobody delivered, and one sound that came back


@pytest.mark.killed_on("sqlite")
def test_what_was_asked_for_is_made_once(server: ProcessServer, world: World, some_of: SomeOf) -> None:
    laser, *_ = add_cues(world, {"name": "laser"}, {"name": "airlock"}, {"name": "siren", "variations": 2})
    delivery_id = open_delivery(world)
    deadly = some_of(POINTS, len(POINTS))

    def made(points: str, asked_for: Callable[[], dict[str, Any]]) -> dict[str, Any]:
        """Ask for something, let a worker die at each of its points, and one that does not die make it."""
        here = [point for point in deadly if point.startswith(points)]
        if here:
            server.stop()
        asked = asked_for()
        for point in here:
            server.wait_for_death(server.work(point), point)
        if here:
            server.work()
        wait_until(lambda: is_idle(server))
        return asked

    returned = made("conformance.", lambda: deliver(world, "airlock.wav", loud(), delivery_id=delivery_id))
    taken = deliver(world, "laser.wav", sound(1), delivery_id=delivery_id)
    wait_until(lambda: is_idle(server))
    assert world.approver.post(f"/v1/takes/{taken['id']}/verdict", json={"kind": "approve"}).status_code == 200

    project = f"/v1/projects/{world.project_id}"
    reel = made("renders.before_reel", lambda: ask(world, f"/v1/cues/{laser['id']}/reels", slates="none"))["id"]
    export = made("renders.before_export", lambda: ask(world, f"/v1/takes/{taken['id']}/master-exports"))["id"]
    made("builds.before_placeholder_file", lambda: ask(world, f"{project}/placeholders", target="game"))
    pack = made("builds.before_seal", lambda: ask(world, f"{project}/packs", target="game", placeholders=True))["id"]

    assert rows(server, Fix, take_id=UUID(returned["id"]), state="made") == rows(server, Fix) == 1
    assert jobs_written(server, "renders.draw_fix") == 1
    assert fetched(world, f"/v1/reels/{reel}")["state"] == "made"
    assert fetched(world, f"/v1/master-exports/{export}")["state"] == "made"
    assert (rows(server, Reel), rows(server, MasterExport)) == (1, 1)
    assert rows(server, PlaceholderFile, refusal=None) == rows(server, PlaceholderFile) == STAND_INS
    sealed = fetched(world, f"/v1/packs/{pack}")
    assert (sealed["number"], sealed["state"], sealed["placeholder_files"]) == (1, "sealed", STAND_INS)
    assert rows(server, SealedPack) == rows(server, PackedFile, kind="game") == 1
    assert rows(server, PackedFile, kind="placeholder") == STAND_INS
    zips = [world.producer.get(f"/v1/packs/{pack}/pack.zip").content for _ in range(2)]
    assert len({hashlib.sha256(content).digest() for content in zips}) == 1
    assert nothing_failed(server)


def ask(world: World, path: str, **how: Any) -> dict[str, Any]:
    answer = world.producer.post(path, json=how)
    assert answer.status_code in (201, 202), answer.text
    return dict(answer.json()) if answer.content else {}


def fetched(world: World, path: str) -> dict[str, Any]:
    answer = world.producer.get(path)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())
