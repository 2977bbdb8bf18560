"""Endpoints that answer a file: what their decorator says of it, and the answer itself."""

from typing import Any
from urllib.parse import quote

from fastapi import Response

from app.core.errors import Refused
from app.core.web.http import problems


def downloads(media_types: str | tuple[str, ...], *refusals: type[Refused]) -> dict[str, Any]:
    """Return the arguments by which an endpoint's decorator declares a file of one of some types."""
    content = {}
    for media_type in (media_types,) if isinstance(media_types, str) else media_types:
        schema = {"type": "string"} if media_type.startswith("text/") else {"type": "string", "format": "binary"}
        content[media_type.partition(";")[0]] = {"schema": schema}
    return {"response_class": Response, "responses": {**problems(*refusals), 200: {"content": content}}}


def file_response(content: str | bytes, media_type: str, file_name: str, *, inline: bool = False) -> Response:
    """Return a file that the browser saves under a name, or shows where it is inline."""
    headers = {"Content-Disposition": content_disposition(file_name, inline=inline)}
    return Response(content, media_type=media_type, headers=headers)


def content_disposition(file_name: str, *, inline: bool = False) -> str:
    """Return the header that names a file; a name beyond ASCII is also given in letters of it, for old programs."""
    kind = "inline" if inline else "attachment"
    plain = "".join(letter if letter.isascii() and letter.isprintable() else "_" for letter in file_name)
    plain = plain.replace("\\", "_").replace('"', "_")
    if plain == file_name:
        return f'{kind}; filename="{file_name}"'
    return f"{kind}; filename=\"{plain}\"; filename*=UTF-8''{quote(file_name, safe='')}"
