"""The endpoint of the pictures of people."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts.errors import PictureNotFound
from app.accounts.pictures.drawing import MEDIA_TYPE
from app.accounts.queries import picture_of
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.db import bypass_row_policies
from app.core.web.blob_response import IMMUTABLE, WHILE_ASKED
from app.core.web.downloads import downloads
from app.core.web.http import DbSession
from app.dashboards.pictures.queries import sees_name

router = APIRouter(prefix="/v1", tags=["dashboards"])
LOCKED = {"Content-Security-Policy": "default-src 'none'; sandbox", "X-Content-Type-Options": "nosniff"}
Hash = Annotated[
    str | None, Query(max_length=64, description="Of the picture, as its address has it: the answer never changes.")
]


@router.get(
    "/people/{person_id}/picture",
    **downloads(MEDIA_TYPE, PictureNotFound),
)
def get_picture(
    person_id: UUID,
    request: Request,
    session: DbSession,
    sha256: Hash = None,
    actor: Actor = allows(Audience.PERSON),
) -> Response:
    """Show the picture of a person whose name the caller sees."""
    with bypass_row_policies(session):  # a designer sees neither the members of a studio nor others' pictures
        picture = picture_of(session, person_id) if sees_name(session, actor, person_id) else None
    if picture is None or sha256 not in (None, picture.sha256):
        raise PictureNotFound(f"no picture of a person {person_id}")
    etag = f'"{picture.sha256}"'
    headers = {**LOCKED, "ETag": etag, "Cache-Control": IMMUTABLE if sha256 else WHILE_ASKED}
    if etag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    return Response(picture.content, media_type=MEDIA_TYPE, headers=headers)
