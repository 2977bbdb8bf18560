"""Hands out a blob over HTTP: whole or a range, by our own stream or by a link to the store that signs for itself."""

import re
from collections.abc import Mapping
from uuid import UUID

from fastapi import Request, Response
from fastapi.responses import RedirectResponse, StreamingResponse

from app.core.storage import READ_BYTES, Store
from app.core.web.downloads import content_disposition

# What is stored never changes, and may be seen by authorized callers only, so no shared cache keeps it.
IMMUTABLE = "private, max-age=31536000, immutable"
WHILE_ASKED = "private, no-cache"  # a file to keep: each later request is authenticated again
WHILE_SIGNED = "private, max-age=300"  # well within the time that a signed link works
RANGE = re.compile(r"bytes=([0-9]{0,18})-([0-9]{0,18})")  # no file has more bytes


def blob_response(
    request: Request,
    store: Store,
    studio_id: UUID,
    sha256: str,
    *,
    media_type: str,
    file_name: str | None = None,
    headers: Mapping[str, str] | None = None,
    by_link: bool = False,
) -> Response:
    """Answer with a blob, or a range of it; with `by_link`, send the caller to the store where that offers links.

    Raises BlobMissing, BlobAltered and StoreUnavailable before anything is sent: a blob is hashed before its first
    byte, or a link to it, leaves, and again while a whole one is sent.
    """
    disposition = None if file_name is None else content_disposition(file_name)
    if by_link and store.public_origin is not None:
        store.ensure_intact(studio_id, sha256)
        url = store.signed_url(studio_id, sha256, media_type=media_type, disposition=disposition)
        if url is not None:
            return RedirectResponse(url, 307, {"Cache-Control": WHILE_SIGNED})
    etag = f'"{sha256}"'
    kept = IMMUTABLE if disposition is None else WHILE_ASKED
    given = {"ETag": etag, "Accept-Ranges": "bytes", "Cache-Control": kept, **(headers or {})}
    if disposition is not None:
        given["Content-Disposition"] = disposition
    if etag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=given)
    store.ensure_intact(studio_id, sha256)
    size_bytes = store.size_bytes(studio_id, sha256)
    asked = request.headers.get("range") if request.headers.get("if-range", etag) == etag else None
    span = _span(asked, size_bytes)
    if span is None and size_bytes <= READ_BYTES:
        return Response(store.read(studio_id, sha256), 200, given, media_type)
    if span is None:
        content = store.stream(studio_id, sha256)
        return StreamingResponse(content, 200, {**given, "Content-Length": str(size_bytes)}, media_type)
    start, end = span
    if start >= end:
        return Response(status_code=416, headers={"Content-Range": f"bytes */{size_bytes}"})
    given |= {"Content-Range": f"bytes {start}-{end - 1}/{size_bytes}", "Content-Length": str(end - start)}
    return StreamingResponse(store.stream(studio_id, sha256, start, end), 206, given, media_type)


def _span(asked: str | None, size_bytes: int) -> tuple[int, int] | None:
    """Return the first byte asked for and the one after the last; None for all, as for ranges that we do not read."""
    match = RANGE.fullmatch(asked or "")
    if match is None or match[0] == "bytes=-":
        return None
    first, last = match.groups()
    if not first:
        return max(0, size_bytes - int(last)), size_bytes
    if last and int(last) < int(first):
        return None
    return int(first), min(int(last) + 1, size_bytes) if last else size_bytes
