"""Adds references over HTTP, as a producer's page does, and makes the files for them."""

import io
import struct
import zlib
from typing import Any

from httpx import Response
from httpx2 import Client
from PIL import Image

from tests.support.deliver import BYTES, TUS, metadata
from tests.support.server import World


def begin_upload(world: World, name: str, content: bytes, by: Client | None = None, **more: str) -> Response:
    """Send a whole file towards the references of the project, by tus."""
    said = metadata(**({"project_id": str(world.project_id), "file_name": name} | more))
    headers = {**TUS, **BYTES, "Upload-Length": str(len(content)), "Upload-Metadata": said}
    return (by or world.producer).post("/v1/uploads", headers=headers, content=content)


def uploaded(world: World, name: str, content: bytes, by: Client | None = None) -> str:
    """Send a whole file, and return the id of its upload."""
    begun = begin_upload(world, name, content, by)
    assert begun.status_code == 201, begun.text
    return begun.headers["location"].rpartition("/")[2]


def add(world: World, by: Client | None = None, **body: Any) -> Response:
    """Put something on the board of the project."""
    return (by or world.producer).post(f"/v1/projects/{world.project_id}/references", json=body)


def added(world: World, name: str, content: bytes, **body: Any) -> dict[str, Any]:
    """Put a file on the board, and return the reference."""
    made = add(world, upload_id=uploaded(world, name, content), **body)
    assert made.status_code == 201, made.text
    return dict(made.json())


def board(world: World, by: Client | None = None, **query: str) -> list[dict[str, Any]]:
    """Return what is on the board."""
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/references", params=query)
    assert answer.status_code == 200, answer.text
    return list(answer.json()["items"])


def opened(world: World, reference: dict[str, Any], part: str = "file", by: Client | None = None) -> Response:
    """Open a reference as the page does: recorded first, then fetched."""
    client, version = by or world.producer, f"/v1/reference-versions/{reference['version']['id']}"
    recorded = client.post(f"{version}/openings")
    assert recorded.status_code == 204, recorded.text
    return client.get(f"{version}/{part}")


def png(width: int, height: int, pixels: bytes | None = None) -> bytes:
    """Return a PNG of 8-bit grey whose header says that size, written by hand: black unless other rows are given."""

    def chunk(kind: bytes, payload: bytes) -> bytes:
        return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))

    rows = b"".join(b"\0" + bytes(width) for _ in range(height)) if pixels is None else pixels
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def picture(form: str, size: tuple[int, int] = (40, 30), colour: str = "#cc3300", **options: Any) -> bytes:
    """Return a picture of one colour in a format."""
    out = io.BytesIO()
    Image.new("RGB", size, colour).save(out, form, **options)
    return out.getvalue()
