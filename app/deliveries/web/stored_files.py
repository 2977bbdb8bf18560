"""Hands out a stored file of a designer over HTTP."""

from uuid import UUID

from fastapi import Request, Response

from app.core.runtime import Runtime
from app.core.web.blob_response import blob_response
from app.deliveries.rules import base_name, shown_name


def stored_file_response(request: Request, runtime: Runtime, studio_id: UUID, sha256: str, file_name: str) -> Response:
    """Answer with a file, or a range of it, exactly as it was delivered; a browser runs nothing in it."""
    return blob_response(
        request,
        runtime.store,
        studio_id,
        sha256,
        media_type="application/octet-stream",
        file_name=shown_name(base_name(file_name)),
        headers={"Content-Security-Policy": "sandbox"},
        by_link=True,
    )
