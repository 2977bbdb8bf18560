"""The approved game files, one by one, and where each comes from."""

import hashlib
from typing import Any

import pytest

from tests.app.builds.approved import accepted_list, sound
from tests.app.builds.test_builds import token
from tests.app.builds.test_sealed_packs import SOUNDS, seal
from tests.app.builds.test_unpaid_downloads import Work, gross
from tests.app.reviews.making import body_of, refused
from tests.support.adoptions import adopted
from tests.support.deliver import deliver
from tests.support.server import World

pytestmark = pytest.mark.slow

BOTH = pytest.mark.both_databases  # row policies hide contracts, approvals and people from a build, or do not


def listing(world: World, by: Any = None, **params: Any) -> dict[str, Any]:
    client = by or world.reviewer
    said: dict[str, Any] = body_of(client.get(f"/v1/projects/{world.project_id}/game-files", params=params))
    return said


def origins(world: World, by: Any, **params: Any) -> Any:
    return by.get(f"/v1/projects/{world.project_id}/game-files/origins", params=params)


def replaced(world: World) -> None:
    """Approve another version of the single sound."""
    take = deliver(world, "ui_confirm.wav", sound(77))
    world.server.wait_for_jobs()
    body_of(world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}))
    world.server.wait_for_jobs()


@BOTH
def test_a_build_reads_the_list_and_each_file_of_it(world: World) -> None:
    accepted_list(world)
    build = token(world, "manifest:read")
    said = listing(world, build, target="game")
    assert [one["path"] for one in said["files"]] == SOUNDS
    assert [one["cue"] for one in said["files"]] == ["SW-001", "SW-001", "SW-002"]
    assert said["missing"] == []
    assert [(one["path"], one["cue"]) for one in said["placeholders"]] == [("warp_in.wav", "SW-003")]
    for one in said["files"]:
        content = build.get(one["url"]).content
        assert (len(content), hashlib.sha256(content).hexdigest()) == (one["bytes"], one["sha256"])
        rest = build.get(one["url"], headers={"Range": "bytes=100-"})
        assert (rest.status_code, rest.content) == (206, content[100:])


def test_a_file_is_downloaded_while_its_version_is_approved_or_was_sealed(world: World) -> None:
    accepted_list(world)
    build = token(world, "manifest:read")
    first = listing(world)["files"][2]
    replaced(world)
    second = listing(world)["files"][2]
    assert second["sha256"] != first["sha256"]
    assert second["sound"] != first["sound"]
    for client in (build, world.producer):
        assert refused(client.get(first["url"])) == (409, "game-file-not-approved")
        assert client.get(second["url"]).status_code == 200
    seal(world)
    replaced_again = deliver(world, "ui_confirm.wav", sound(78))
    world.server.wait_for_jobs()
    body_of(world.approver.post(f"/v1/takes/{replaced_again['id']}/verdict", json={"kind": "approve"}))
    assert build.get(second["url"]).status_code == 200
    other = World(world.server)
    elsewhere = second["url"].replace(str(world.project_id), str(other.project_id))
    assert refused(other.producer.get(elsewhere)) == (404, "render-not-found")


@BOTH
def test_what_opens_by_payment_is_missing_until_it_is_paid(world: World) -> None:
    work = Work(world, "laser")
    work.approve()
    build = token(world, "manifest:read", "rights:read")
    said = listing(world, build)
    assert said["files"] == []
    assert [(one["path"], one["reason"]) for one in said["missing"]] == [
        ("laser.wav", "its files open by payment, and it is not paid yet")
    ]
    assert said["placeholders"] == []
    render = work.sounds(by="designer")["renders"][0]["file_url"].split("/")[3]
    url = f"/v1/projects/{world.project_id}/game-files/{render}"
    assert refused(build.get(url)) == (403, "download-unpaid")
    invoice = work.agreed.invoice()
    assert work.agreed.pay(invoice, gross(invoice)).status_code == 201
    assert [one["path"] for one in listing(world, build)["files"]] == ["laser.wav"]
    (origin,) = body_of(origins(world, build, name="laser"))
    assert ", agreed " in origin["contract"]


@BOTH
def test_a_name_leads_to_cue_approval_contract_and_sources(world: World) -> None:
    accepted_list(world)
    build = token(world, "rights:read")
    take_id = listing(world)["files"][2]["take_id"]
    library = {"name": "Metal Hits", "licence": "royalty free", "file": "MH_12.wav"}
    stated = {"from_scratch": False, "libraries": [library]}
    body_of(world.designer.put(f"/v1/takes/{take_id}/sources", json=stated))
    for name in ("ui_confirm", "ui_confirm.wav", "SW-002"):
        (origin,) = body_of(origins(world, build, name=name))
        assert origin | {"take_id": take_id} == origin
        assert (origin["cue"], origin["cue_name"], origin["target"]) == ("SW-002", "UI confirm", "game")
        assert (origin["approved_by"], origin["designer"]) == ("Audio director", "Sound designer")
        assert origin["libraries"] == "Metal Hits, royalty free, MH_12.wav"
        assert (origin["contract"], origin["spec_version"]) == ("no contract in Soundlist", 1)
        assert origin["is_current"]
    assert [one["path"] for one in body_of(origins(world, world.producer, name="SW-001"))] == SOUNDS[:2]
    assert body_of(origins(world, build, name="SW-003")) == []
    assert refused(origins(world, world.approver, name="SW-002")) == (403, "producer-needed")


def test_a_version_that_was_replaced_keeps_its_origin(world: World) -> None:
    accepted_list(world)
    first = listing(world)["files"][2]["take_id"]
    replaced(world)
    (old,) = body_of(origins(world, world.producer, name="ui_confirm.wav", take=first))
    (new,) = body_of(origins(world, world.producer, name="ui_confirm.wav"))
    assert (old["take_id"], old["is_current"], new["is_current"]) == (first, False, True)
    assert old["master_sha256"] != new["master_sha256"]
    other = World(world.server)
    assert body_of(origins(other, other.producer, name="x", take=first)) == []


def test_nobody_is_said_to_have_made_what_was_adopted(world: World) -> None:
    adopted(world, {"ui/click.wav": sound(1)})
    (origin,) = body_of(origins(world, world.producer, name="click"))
    assert (origin["approved_by"], origin["designer"]) == ("Producer (adopted)", "not known (adopted)")
