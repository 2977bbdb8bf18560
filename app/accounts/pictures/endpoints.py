"""The endpoints of the caller's own picture."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Depends, Request
from sqlalchemy.orm import Session

from app.accounts.errors import PictureRefused
from app.accounts.models import Person
from app.accounts.pictures import service as pictures
from app.accounts.pictures.drawing import MAX_BYTES, draw_square
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import accepts_body
from app.core.web.http import DbSession, problems

router = APIRouter(prefix="/v1", tags=["accounts"])
_BINARY = {"schema": {"type": "string", "format": "binary"}}
PICTURE_BODY = {"requestBody": {"content": {"application/octet-stream": _BINARY}, "required": True}}
ANY = UUID(int=0)


def _themselves(_session: Session, _actor: Actor, _whose: UUID) -> None:
    """Permit any person: the picture is their own."""


async def _drawn(request: Request) -> bytes:
    """Return the square that a child drew of the picture that was sent."""
    body = await request.body()
    return await parse_request(request, draw_square, body, refusal=PictureRefused, permit=_themselves, whose=ANY)


@router.put(
    "/me/picture",
    response_model=PersonBrief,
    openapi_extra=PICTURE_BODY,
    responses=problems(PictureRefused, ParsingBusy),
)
@accepts_body(MAX_BYTES)
def save_my_picture(
    actor: Annotated[Actor, allows(Audience.PERSON)], drawn: Annotated[bytes, Depends(_drawn)], session: DbSession
) -> Person:
    """Show a picture beside the caller's name: a PNG, JPEG or WebP, of which the middle is kept as a small square."""
    return pictures.save_picture(session, actor, drawn)


@router.delete("/me/picture", status_code=204)
def remove_my_picture(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Take the caller's picture away; their initials are shown."""
    pictures.remove_picture(session, actor)
