"""Adopts folders over HTTP, as a browser or the client does."""

import hashlib
from collections.abc import Mapping
from typing import Any

from httpx import Response
from httpx2 import Client

from tests.support.deliver import BYTES, TUS, metadata
from tests.support.server import World


def folder(files: Mapping[str, bytes], **facts: Any) -> dict[str, Any]:
    """Return the body that lists a folder's files."""
    listed = [
        {"path": path, "sha256": hashlib.sha256(content).hexdigest(), "size_bytes": len(content), **facts}
        for path, content in files.items()
    ]
    return {"folder": "Sounds", "files": listed}


def plan(world: World, files: Mapping[str, bytes], by: Client | None = None, **facts: Any) -> dict[str, Any]:
    """Return what adopting files would do."""
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/adoption-plan", json=folder(files, **facts))
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def opened(world: World, files: Mapping[str, bytes], by: Client | None = None) -> dict[str, Any]:
    """Open an adoption."""
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/adoptions", json=folder(files))
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def send(world: World, adoption_id: str, name: str, content: bytes, by: Client | None = None) -> Response:
    """Send one file of an adoption in one request."""
    headers = {**TUS, **BYTES, "Upload-Length": str(len(content))}
    headers["Upload-Metadata"] = metadata(adoption_id=adoption_id, file_name=name)
    answer: Response = (by or world.producer).post("/v1/uploads", content=content, headers=headers)
    return answer


def sent(world: World, files: Mapping[str, bytes], by: Client | None = None) -> str:
    """Open an adoption and send what it asks for; return its id."""
    adoption = opened(world, files, by)
    for path in adoption["missing"]:
        answer = send(world, adoption["id"], path, files[path], by)
        assert answer.status_code == 201, answer.text
    return str(adoption["id"])


def adopt(world: World, adoption_id: str, by: Client | None = None) -> Response:
    """Adopt what was sent."""
    answer: Response = (by or world.producer).post(f"/v1/adoptions/{adoption_id}/adopt")
    return answer


def adopted(world: World, files: Mapping[str, bytes], by: Client | None = None) -> dict[str, Any]:
    """Adopt a folder, and wait for its checks and game files; return what the server answered."""
    answer = adopt(world, sent(world, files, by), by)
    assert answer.status_code == 200, answer.text
    world.server.wait_for_jobs()
    return dict(answer.json())


def undo(world: World, adoption_id: str, by: Client | None = None) -> Response:
    """Undo an adoption."""
    answer: Response = (by or world.producer).post(f"/v1/adoptions/{adoption_id}/undo")
    return answer
