"""Delivers files over HTTP, as a designer's browser or a script does."""

import base64
from typing import Any

from httpx2 import Client

from tests.support.server import World

TUS = {"Tus-Resumable": "1.0.0"}
BYTES = {"Content-Type": "application/offset+octet-stream"}


def metadata(**values: str) -> str:
    """Return an Upload-Metadata header."""
    return ",".join(f"{name} {base64.b64encode(value.encode()).decode()}" for name, value in values.items())


def add_cues(world: World, *cues: dict[str, Any]) -> list[dict[str, Any]]:
    """Add cues to the list as the producer."""
    added = world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": list(cues)})
    assert added.status_code == 201, added.text
    return list(added.json())


def open_delivery(world: World, by: Client | None = None) -> str:
    """Open a delivery as the designer, and return its id."""
    opened = (by or world.designer).post(f"/v1/projects/{world.project_id}/deliveries", json={"note": "first batch"})
    assert opened.status_code == 201, opened.text
    return str(opened.json()["id"])


def upload(world: World, delivery_id: str, name: str, content: bytes, by: Client | None = None) -> str:
    """Send a whole file into a delivery, and return the id of the upload."""
    sent = (by or world.designer).put(
        "/v1/uploads", params={"delivery_id": delivery_id, "file_name": name[:100_000]}, content=content
    )
    assert sent.status_code == 201, sent.text
    return str(sent.json()["upload_id"])


def deliver(world: World, name: str, content: bytes, *, delivery_id: str | None = None, **more: Any) -> dict[str, Any]:
    """Send a file and make it a take; return the take as answered."""
    delivery_id = delivery_id or open_delivery(world)
    upload_id = upload(world, delivery_id, name, content)
    made = world.designer.post(
        f"/v1/deliveries/{delivery_id}/takes", json={"upload_id": upload_id, "file_name": name} | more
    )
    assert made.status_code in (200, 201), made.text
    return dict(made.json())


def checked(world: World, take_id: str, by: Client | None = None) -> dict[str, Any]:
    """Wait for the jobs, and return what the check says."""
    world.server.wait_for_jobs()
    answer = (by or world.designer).get(f"/v1/takes/{take_id}/check")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())
