"""Answers over slow networks: files compressed when the frontend was built, and text compressed as it is sent."""

import mimetypes
import os
from pathlib import Path

from starlette.datastructures import Headers, MutableHeaders
from starlette.middleware.gzip import DEFAULT_EXCLUDED_CONTENT_TYPES, GZipMiddleware
from starlette.responses import FileResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send

ENCODINGS = {"br": ".br", "gzip": ".gz"}  # the smallest first; the names that the frontend's build gives
SMALLEST_BYTES = 1_000  # below this an answer fills one packet anyway
LEVEL = 4  # 3 % larger than level 6, in half the time
COMPRESSED_ALREADY = (*DEFAULT_EXCLUDED_CONTENT_TYPES, "application/octet-stream", "application/pdf")


def accepted_encodings(accept_encoding: str) -> set[str]:
    """Return the encodings that a request takes, those with a weight of zero left out (RFC 9110, 12.5.3)."""
    accepted = set()
    for entry in accept_encoding.lower().split(","):
        name, _, weight = entry.partition(";")
        if not weight.replace(" ", "").removeprefix("q=").strip("0.") and weight:
            continue
        accepted.add(name.strip())
    return accepted


class PrecompressedFiles(StaticFiles):
    """Serves a folder's files, or the smallest of their precompressed copies that the browser accepts."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Answer with the file at this path; Content-Type is that of the file as it was before it was compressed."""
        headers = Headers(scope=scope)
        accepted = accepted_encodings(headers.get("accept-encoding", ""))
        for encoding, ending in ENCODINGS.items():
            if encoding not in accepted or "range" in headers:
                continue
            try:
                full_path, found = self.lookup_path(path + ending)
            except OSError:  # a name that is too long for the file system; the uncompressed file gives the right answer
                break
            if found is not None:
                return self._compressed(Path(full_path), found, headers, encoding)
        response = await super().get_response(path, scope)
        response.headers["Vary"] = "Accept-Encoding"
        return response

    def _compressed(self, file: Path, found: os.stat_result, headers: Headers, encoding: str) -> Response:
        media_type = mimetypes.guess_type(file.stem)[0]
        more = {"Content-Encoding": encoding, "Vary": "Accept-Encoding"}
        response = FileResponse(file, headers=more, media_type=media_type, stat_result=found)
        if self.is_not_modified(response.headers, headers):
            return Response(status_code=304, headers={**more, "ETag": response.headers["etag"]})
        return response


class CompressedAnswers:
    """Compresses answers to GET that are not compressed already.

    BREACH reads a secret out of an answer's length, by having a signed-in browser ask many times with guesses. What
    another site's page asks for is marked by browsers (Sec-Fetch-Site) and is not compressed here. Its requests also
    lack the session cookie (SameSite=Lax), but for top-level navigations. New secrets are in answers to POST only.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._plain = app
        self._compressed = GZipMiddleware(app, SMALLEST_BYTES, LEVEL, exclude_content_types=COMPRESSED_ALREADY)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the answer, compressed where that is safe and useful."""
        if scope["type"] != "http" or scope["method"] != "GET" or _is_caused_elsewhere(scope):
            await self._plain(scope, receive, send)
            return

        async def send_with_weak_tag(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                tag = headers.get("etag", "")
                # A strong tag promises the same bytes, which differ by encoding.
                if headers.get("content-encoding") == "gzip" and tag.startswith('"'):
                    headers["ETag"] = f"W/{tag}"
            await send(message)

        await self._compressed(scope, receive, send_with_weak_tag)


def _is_caused_elsewhere(scope: Scope) -> bool:
    return Headers(scope=scope).get("sec-fetch-site", "none") not in ("none", "same-origin")
