"""Files that were compressed when the frontend was built; the proxy compresses what is made for each request."""

import mimetypes
import os
from pathlib import Path

from starlette.datastructures import Headers
from starlette.responses import FileResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

ENCODINGS = {"br": ".br", "gzip": ".gz"}  # the smallest first; the names that the frontend's build gives


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
                full_path, status = self.lookup_path(path + ending)
            except OSError:  # a name that is too long for the file system; the uncompressed file gives the right answer
                break
            if status is not None:
                return self._compressed(Path(full_path), status, headers, encoding)
        response = await super().get_response(path, scope)
        response.headers["Vary"] = "Accept-Encoding"
        return response

    def _compressed(self, file: Path, status: os.stat_result, headers: Headers, encoding: str) -> Response:
        media_type = mimetypes.guess_type(file.stem)[0]
        more = {"Content-Encoding": encoding, "Vary": "Accept-Encoding"}
        response = FileResponse(file, headers=more, media_type=media_type, stat_result=status)
        if self.is_not_modified(response.headers, headers):
            return Response(status_code=304, headers={**more, "ETag": response.headers["etag"]})
        return response
