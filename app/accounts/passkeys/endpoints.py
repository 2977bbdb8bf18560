"""The endpoints of passkeys: the caller's own, and signing in with one."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts import rate_limits
from app.accounts.authentication import SESSION_COOKIE
from app.accounts.errors import (
    NotInDemo,
    PasskeyNotFound,
    PasskeyRefused,
    RecentSignInNeeded,
    TooManyAttempts,
    TooManyPasskeys,
)
from app.accounts.models import Passkey, Person
from app.accounts.passkeys import service as passkeys
from app.accounts.passkeys.schemas import PasskeyAdd, PasskeyMade, PasskeyOptions, PasskeyRead, PasskeySignIn
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonRead
from app.accounts.web.browser_sign_ins import sign_in_browser
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_within_limits,
    network_of,
)
from app.core.access_scope import AccessScope
from app.core.db import set_access_scope
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.get("/me/passkeys", response_model=list[PasskeyRead])
def list_my_passkeys(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> Sequence[Passkey]:
    """Return the caller's passkeys, the oldest first."""
    return passkeys.passkeys_of(session, actor)


@_unsaved_router.post("/me/passkeys/options", responses=problems(NotInDemo, RecentSignInNeeded, TooManyPasskeys))
def begin_my_passkey(
    session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)
) -> PasskeyOptions:
    """Return the options by which a browser makes a passkey for the caller, within five minutes."""
    return PasskeyOptions(public_key=passkeys.begin_passkey(session, actor, runtime.settings))


@_unsaved_router.post(
    "/me/passkeys", status_code=201, responses=problems(PasskeyRefused, RecentSignInNeeded, TooManyPasskeys)
)
def add_my_passkey(
    body: PasskeyAdd,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PERSON, recent_sign_in=True),
) -> PasskeyMade:
    """Keep a passkey, and sign every other browser of the caller out."""
    passkey, codes = passkeys.add_passkey(
        session,
        actor,
        runtime.settings,
        name=body.name,
        credential=body.credential,
        kept_secret=request.cookies.get(SESSION_COOKIE),
    )
    return PasskeyMade(**PasskeyRead.model_validate(passkey).model_dump(), recovery_codes=codes)


@router.delete("/me/passkeys/{passkey_id}", status_code=204, responses=problems(PasskeyNotFound, RecentSignInNeeded))
def remove_my_passkey(
    passkey_id: UUID, session: DbSession, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)
) -> None:
    """Remove one of the caller's passkeys."""
    passkeys.remove_passkey(session, actor, passkey_id)


@_unsaved_router.post("/passkeys/options")
def begin_passkey_sign_in(runtime: CurrentRuntime, _actor: Actor = allows(Audience.ANYONE)) -> PasskeyOptions:
    """Return the options by which a browser asks for a passkey of this server, within five minutes."""
    return PasskeyOptions(public_key=passkeys.sign_in_options(runtime.settings))


@_unsaved_router.post(
    "/passkeys/sign-in", response_model=PersonRead, responses=problems(PasskeyRefused, TooManyAttempts)
)
def sign_in_with_passkey(
    body: PasskeySignIn,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Sign in with a passkey, which stands for both password and second factor."""
    ensure_within_limits(request, (rate_limits.SIGN_INS_FROM_NETWORK, network_of(request)))
    with begin() as session:
        person_id = passkeys.person_with_passkey(session, runtime.settings, body.credential)
        set_access_scope(session, AccessScope(person_id=person_id))
        person = session.get_one(Person, person_id)
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


router.include_router(_unsaved_router)
