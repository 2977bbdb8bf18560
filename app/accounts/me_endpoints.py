"""The endpoints of the caller's own account: name, password, address, and the browsers signed in to it."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter, Request

from app.accounts import addresses, desk_tokens, people, sign_ins
from app.accounts.authentication import SESSION_COOKIE, sha256_of
from app.accounts.errors import (
    AlreadyVerified,
    DeskTokenNotFound,
    NotInDemo,
    PasswordTooWeak,
    RecentSignInNeeded,
    SignInNotFound,
    TooManyAttempts,
    TooManyDeskTokens,
    VerificationNotFound,
    WrongPassword,
)
from app.accounts.models import DeskToken, Person
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import (
    DeskTokenAdd,
    DeskTokenMade,
    DeskTokenRead,
    NameChange,
    PasswordChange,
    PersonRead,
    SignInRead,
)
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_mail_allowed,
    ensure_sign_in_allowed,
)
from app.core.web.http import DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.put("/me", response_model=PersonRead)
def change_my_name(body: NameChange, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> Person:
    """Change the caller's name."""
    return people.rename(session, actor, body.name)


@_unsaved_router.put(
    "/me/password", status_code=204, responses=problems(WrongPassword, NotInDemo, PasswordTooWeak, TooManyAttempts)
)
def change_my_password(
    body: PasswordChange, request: Request, begin: DeferredSession, actor: Actor = allows(Audience.PERSON)
) -> None:
    """Change the caller's password, and end their other sign-ins."""
    ensure_sign_in_allowed(request, str(actor.person))
    kept_secret = request.cookies.get(SESSION_COOKIE)
    with begin() as session:
        people.change_password(session, actor, current=body.current, new=body.new, kept_secret=kept_secret)


@router.get("/me/sign-ins")
def list_my_sign_ins(request: Request, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> list[SignInRead]:
    """Return the browsers in which the caller is signed in, the one used last first."""
    current = sha256_of(request.cookies.get(SESSION_COOKIE, ""))
    return [
        SignInRead(
            id=sign_in.id,
            device=sign_in.device,
            place=sign_in.place,
            is_current=sign_in.secret_sha256 == current,
            created_at=sign_in.created_at,
            last_seen_at=sign_in.last_seen_at,
            expires_at=sign_in.expires_at,
        )
        for sign_in in sign_ins.sign_ins_of(session, actor)
    ]


@router.delete("/me/sign-ins/{sign_in_id}", status_code=204, responses=problems(SignInNotFound))
def end_my_sign_in(sign_in_id: UUID, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Sign one of the caller's browsers out."""
    sign_ins.end_one(session, actor, sign_in_id)


@router.delete("/me/sign-ins", status_code=204)
def end_my_other_sign_ins(request: Request, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Sign every other browser of the caller out."""
    sign_ins.end_others(session, actor, request.cookies.get(SESSION_COOKIE))


@router.get("/me/desk-tokens", response_model=list[DeskTokenRead])
def list_my_desk_tokens(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> Sequence[DeskToken]:
    """Return the caller's keys for `soundlist desk`, without their secrets."""
    return desk_tokens.desk_tokens_of(session, actor)


@_unsaved_router.post(
    "/me/desk-tokens", status_code=201, responses=problems(NotInDemo, RecentSignInNeeded, TooManyDeskTokens)
)
def create_my_desk_token(
    body: DeskTokenAdd, session: DbSession, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)
) -> DeskTokenMade:
    """Make a key for `soundlist desk`, which reads what the caller owes; its secret is shown this once."""
    token, secret = desk_tokens.create_desk_token(session, actor, body.name, days=body.days)
    return DeskTokenMade(**DeskTokenRead.model_validate(token).model_dump(), secret=secret)


@router.delete("/me/desk-tokens/{desk_token_id}", status_code=204, responses=problems(DeskTokenNotFound))
def revoke_my_desk_token(desk_token_id: UUID, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Revoke one of the caller's keys for `soundlist desk` at once."""
    desk_tokens.revoke_desk_token(session, actor, desk_token_id)


@router.post(
    "/me/email-verifications", status_code=202, responses=problems(AlreadyVerified, NotInDemo, TooManyAttempts)
)
def request_email_verification(
    request: Request, begin: DeferredSession, actor: Actor = allows(Audience.PERSON)
) -> None:
    """Mail the caller a link that verifies their address."""
    ensure_mail_allowed(request, str(actor.person))
    with begin() as session:
        addresses.request_verification(session, actor)


@router.post("/email-verifications/{secret}", response_model=PersonRead, responses=problems(VerificationNotFound))
def verify_email(secret: str, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> Person:
    """Verify the caller's address by the link mailed to it."""
    return addresses.verify_by_link(session, actor, secret)


router.include_router(_unsaved_router)
