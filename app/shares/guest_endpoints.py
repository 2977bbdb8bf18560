"""The endpoints that guests reach without an account, by the secret of their link or of their visit."""

from typing import Annotated

from fastapi import APIRouter, Path, Request, Response

from app.accounts.authentication import sha256_of
from app.accounts.errors import TooManyAttempts
from app.accounts.rate_limits import GUEST_COMMENTS_FROM_NETWORK
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_guest_guess_allowed,
    ensure_guest_visit_allowed,
    ensure_within_limits,
    network_of,
    reset_guest_guesses,
)
from app.core.storage import BlobMissing
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED
from app.reviews.errors import RangeInvalid
from app.shares import guests
from app.shares.errors import (
    CommentsClosed,
    GuestLinkNotFound,
    GuestPasswordWrong,
    GuestSoundNotFound,
    GuestSoundNotMade,
    GuestSoundUnplayed,
    GuestVisitOver,
)
from app.shares.rules import MAX_SOUNDS
from app.shares.schemas import (
    GuestAccess,
    GuestCommentAdd,
    GuestCommentRead,
    GuestRoom,
    GuestVisitAdd,
    GuestVisitMade,
)

router = APIRouter(prefix="/v1", tags=["guest-visits"])
_unsaved_router = APIRouter(dependencies=UNSAVED)
ANYONE: Actor = allows(Audience.ANYONE)
Place = Annotated[int, Path(ge=1, le=MAX_SOUNDS, description="Of the sound in the link, from 1.")]


@router.get("/guest-access/{secret}", responses=problems(GuestLinkNotFound))
def see_guest_access(secret: str, session: DbSession, _actor: Actor = ANYONE) -> GuestAccess:
    """Return whether a link asks for a password; 404 in the same words for every link that opens nothing."""
    return GuestAccess(needs_password=guests.access_password(session, secret) is not None)


@_unsaved_router.post(
    "/guest-access/{secret}/visits",
    status_code=201,
    responses=problems(GuestLinkNotFound, GuestPasswordWrong, TooManyAttempts),
)
def open_guest_link(
    secret: str,
    body: GuestVisitAdd,
    request: Request,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = ANYONE,
) -> GuestVisitMade:
    """Open a link under a name; visits and guesses at its password are limited for each network by itself."""
    ensure_guest_visit_allowed(request)
    password_hash = guests.password_hash_of(runtime.database, secret)
    link = sha256_of(secret)
    if password_hash is not None:
        ensure_guest_guess_allowed(request, link)
    guests.ensure_password(password_hash, body.password)
    with begin() as session:
        if password_hash is not None:
            reset_guest_guesses(session, request, link)
        opened = guests.open_link(session, secret, body.guest_name)
    return GuestVisitMade(visit=opened.secret, room=opened.room)


@router.get("/guest-visits/{secret}", responses=problems(GuestVisitOver))
def get_guest_room(secret: str, session: DbSession, _actor: Actor = ANYONE) -> GuestRoom:
    """Return a visit's content: names, lengths and shapes of the shared sounds, and nothing of those who made them."""
    return guests.room_of(session, secret)


@router.post(
    "/guest-visits/{secret}/sounds/{place}/plays",
    status_code=204,
    responses=problems(GuestVisitOver, GuestSoundNotFound),
)
def record_guest_play(secret: str, place: Place, session: DbSession, _actor: Actor = ANYONE) -> None:
    """Count one playing of a sound; its preview is sent to guests of whom one is on record."""
    guests.record_play(session, secret, place)


@router.get(
    "/guest-visits/{secret}/sounds/{place}/preview",
    **downloads("audio/wav", GuestVisitOver, GuestSoundNotFound, GuestSoundUnplayed, GuestSoundNotMade, BlobMissing),
)
def get_guest_preview(
    secret: str,
    place: Place,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    _actor: Actor = ANYONE,
) -> Response:
    """Play a sound: at most 48 kHz, 16 bit, without metadata, with beeps where the link has them; never the master."""
    studio_id, sha256 = guests.played_sha256(session, secret, place)
    headers = {"Cache-Control": WHILE_ASKED}  # a link that was revoked plays nothing from a cache
    return blob_response(request, runtime.store, studio_id, sha256, media_type="audio/wav", headers=headers)


@_unsaved_router.post(
    "/guest-visits/{secret}/sounds/{place}/comments",
    status_code=201,
    responses=problems(GuestVisitOver, GuestSoundNotFound, CommentsClosed, RangeInvalid, TooManyAttempts),
)
def add_guest_comment(
    secret: str,
    place: Place,
    body: GuestCommentAdd,
    request: Request,
    begin: DeferredSession,
    _actor: Actor = ANYONE,
) -> GuestCommentRead:
    """Write advice on a sound, which everyone who sees its version reads as from a guest."""
    ensure_within_limits(request, (GUEST_COMMENTS_FROM_NETWORK, network_of(request)))
    with begin() as session:
        return guests.comment(session, secret, place, text=body.text, start_s=body.start_s, end_s=body.end_s)


router.include_router(_unsaved_router)
