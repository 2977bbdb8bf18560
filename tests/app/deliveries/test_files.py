"""Small files: upload and take in one request."""

import hashlib
from typing import Any

import pytest
from httpx2 import Client
from sqlalchemy import select

from app.core.uploads import Upload
from app.deliveries.uploads.file_endpoints import MAX_SMALL_FILE_BYTES
from tests.support.deliver import add_cues, open_delivery, upload
from tests.support.server import World

CONTENT = b"RIFF" + bytes(range(256)) * 100
SHA256 = hashlib.sha256(CONTENT).hexdigest()


def send(
    client: Client,
    delivery_id: str,
    content: bytes = CONTENT,
    *,
    headers: dict[str, str] | None = None,
    **query: Any,
) -> Any:
    given = {"file_name": "laser_fire.wav"} | query
    return client.post(f"/v1/deliveries/{delivery_id}/files", params=given, content=content, headers=headers)


def uploads_of(world: World) -> int:
    with world.server.runtime.database.reading() as session:
        return len(session.scalars(select(Upload).where(Upload.studio_id == world.studio_id)).all())


def test_one_request_makes_the_take_of_its_cue(world: World) -> None:
    [laser] = add_cues(world, {"name": "Laser fire"})
    answer = send(world.designer, open_delivery(world))
    assert (answer.status_code, answer.json()["cue"]["id"]) == (201, laser["id"])
    assert (answer.json()["master_bytes"], answer.json()["already_here"]) == (len(CONTENT), False)
    assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT


@pytest.mark.slow
def test_the_same_bytes_again_are_the_same_take(world: World) -> None:
    add_cues(world, {"name": "Laser fire"})
    delivery_id = open_delivery(world)
    first, again = send(world.designer, delivery_id), send(world.designer, delivery_id)
    assert (first.status_code, again.status_code) == (201, 200)
    assert first.json()["id"] == again.json()["id"]


@pytest.mark.parametrize("name", ["", "\t", " \n "])
def test_a_file_has_a_name(world: World, name: str) -> None:
    answer = send(world.designer, open_delivery(world), file_name=name)
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid-request")
    assert uploads_of(world) == 0


def test_a_cue_may_be_given(world: World) -> None:
    [laser] = add_cues(world, {"name": "Laser fire"})
    answer = send(world.designer, open_delivery(world), file_name="stray.wav", cue_id=laser["id"])
    assert (answer.status_code, answer.json()["cue"]["id"]) == (201, laser["id"])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("more", "status", "code"),
    [
        ({"headers": {"X-Content-SHA256": "0" * 64}}, 460, "checksum-mismatch"),
        ({"cue_id": "00000000-0000-7000-8000-000000000000"}, 404, "cue-not-found"),
        ({"content": bytes(MAX_SMALL_FILE_BYTES + 1)}, 413, "body-too-large"),
    ],
)
def test_what_is_refused_leaves_nothing(world: World, more: dict[str, Any], status: int, code: str) -> None:
    answer = send(world.designer, open_delivery(world), **more)
    assert (answer.status_code, answer.json()["code"]) == (status, code)
    assert not [blob for studio_id, blob in world.server.runtime.store.blobs() if studio_id == world.studio_id]
    assert uploads_of(world) == 0


def test_a_closed_delivery_takes_none(world: World) -> None:
    delivery_id = open_delivery(world)
    world.designer.post(f"/v1/deliveries/{delivery_id}/close")
    assert send(world.designer, delivery_id).json()["code"] == "delivery-closed"


def test_a_delivery_of_another_person_is_not_found(world: World) -> None:
    assert send(world.stranger, open_delivery(world)).status_code == 404


@pytest.mark.slow
def test_a_renamed_file_keeps_the_name_that_it_had(world: World) -> None:
    delivery_id = open_delivery(world)
    small = send(world.designer, delivery_id, received_name="old/bounce 7.wav").json()
    other = upload(world, delivery_id, "bounce 8.wav", CONTENT + b"8")
    large = world.designer.post(
        f"/v1/deliveries/{delivery_id}/takes", json={"upload_id": other, "file_name": "laser_hit.wav"}
    ).json()
    same = send(world.designer, delivery_id, CONTENT + b"9", file_name="old/laser_end.wav").json()
    shown = [world.producer.get(f"/v1/takes/{take['id']}").json() for take in (small, large, same)]
    assert [(one["file_name"], one["received_name"]) for one in shown] == [
        ("laser_fire.wav", "old/bounce 7.wav"),
        ("laser_hit.wav", "bounce 8.wav"),
        ("old/laser_end.wav", None),
    ]
