"""Cues and deliveries for tests, made over HTTP as their users make them."""

from typing import Any

from tests.support.server import World
from tests.support.waves import Samples, wav_bytes


def add_cue(world: World, name: str, **facts: Any) -> dict[str, Any]:
    """Put a cue on the list, and return it."""
    answer = world.producer.post(
        f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": name, "file_name": name, **facts}]}
    )
    assert answer.status_code == 201, answer.text
    found = [cue for cue in sound_list(world) if cue["name"] == name]
    return found[0]


def sound_list(world: World) -> list[dict[str, Any]]:
    """Return the cues of the project."""
    answer = world.producer.get(f"/v1/projects/{world.project_id}/sound-list")
    assert answer.status_code == 200, answer.text
    cues: list[dict[str, Any]] = answer.json()["cues"]
    return cues


def deliver(world: World, *files: tuple[str, bytes], note: str = "") -> list[dict[str, Any]]:
    """Upload files in one delivery of the designer, and return their takes as they came in."""
    opened = world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={"note": note})
    assert opened.status_code == 201, opened.text
    delivery_id = opened.json()["id"]
    takes = []
    for file_name, content in files:
        upload = world.designer.put(
            "/v1/uploads",
            params={"delivery_id": delivery_id, "file_name": file_name},
            content=content,
            headers={"Content-Type": "application/octet-stream"},
        )
        assert upload.status_code == 201, upload.text
        take = world.designer.post(
            f"/v1/deliveries/{delivery_id}/takes",
            json={"upload_id": upload.json()["upload_id"], "file_name": file_name},
        )
        assert take.status_code in (200, 201), take.text
        takes.append(take.json())
    return takes


def deliver_sound(world: World, file_name: str, samples: Samples, *, rate: int = 96_000, bits: int = 24) -> str:
    """Upload one sound, wait until check and renders are done, and return its take's id."""
    (take,) = deliver(world, (file_name, wav_bytes(samples, rate=rate, bits=bits)))
    world.server.wait_for_jobs()
    take_id: str = take["id"]
    return take_id
