"""The endpoints of signing in and out."""

import structlog
from fastapi import APIRouter, Request, Response

from app.accounts import authentication, people, sign_ins
from app.accounts.authentication import (
    DEMO_PARTS,
    SESSION_COOKIE,
    sha256_of,
)
from app.accounts.errors import (
    DemoUnavailable,
    SecondFactorNeeded,
    TooManyAttempts,
    WrongSecondFactor,
    WrongSignIn,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Audience, normalised_email
from app.accounts.schemas import DemoPart, PersonBrief, PersonRead, SessionRead, SignInAdd
from app.accounts.second_factors import service as second_factors
from app.accounts.web.browser_sign_ins import give_csrf_token, sign_in_browser
from app.accounts.web.policies import allows, authenticate, demo_role
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_second_factor_allowed,
    ensure_sign_in_allowed,
    network_of,
    reset_attempts,
)
from app.core.access_scope import AccessScope
from app.core.db import set_access_scope
from app.core.web.http import (
    CurrentRuntime,
    DbSession,
    problems,
)
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)
log = structlog.get_logger(__name__)


@router.get("/session")
def read_session(
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    actor: Actor = allows(Audience.ANYONE),
) -> SessionRead:
    """Return whether the caller is signed in, and the token that the page's writes must carry."""
    if actor.person_id is None:
        return SessionRead(signed_in=False, demo=False, person=None)
    auth = authenticate(request)
    if auth.secret:
        give_csrf_token(response, runtime.settings, auth.secret)
    person = session.get_one(Person, actor.person_id)
    return SessionRead(signed_in=True, demo=auth.demo_part is not None, person=PersonBrief.model_validate(person))


@_unsaved_router.post(
    "/sign-in",
    response_model=PersonRead,
    responses=problems(WrongSignIn, SecondFactorNeeded, WrongSecondFactor, TooManyAttempts),
)
def sign_in(
    body: SignInAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Sign in with address and password, and with a second factor where the account has one."""
    account = normalised_email(body.email)
    ensure_sign_in_allowed(request, account)
    person_id = people.person_with_password(runtime.database, account, body.password)
    if person_id is None:
        # A hash: what was typed may be a password, and equal lines still show who is guessed at.
        log.warning("sign-in refused", account=sha256_of(account)[:16], place=network_of(request))
        raise WrongSignIn("wrong email or password", fix="check both, or use “Forgot password?”")
    has_second_factor = second_factors.has_second_factor(runtime.database, person_id)
    code = second_factors.ensure_code_given(body.code) if has_second_factor else None
    if code is not None:
        ensure_second_factor_allowed(request, account)
    with begin() as session:
        set_access_scope(session, AccessScope(person_id=person_id))
        if code is not None:
            second_factors.ensure_right_code(session, runtime.settings, person_id, code)
        reset_attempts(session, request, account)
        person = session.get_one(Person, person_id)
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_unsaved_router.post("/sign-out", status_code=204)
def sign_out(request: Request, response: Response, session: DbSession, _actor: Actor = allows(Audience.PERSON)) -> None:
    """Sign this browser out."""
    sign_ins.end_sign_in(session, request.cookies.get(SESSION_COOKIE, ""))
    for cookie in (SESSION_COOKIE, authentication.CSRF_COOKIE):
        response.delete_cookie(cookie, samesite="lax")
    response.headers["Clear-Site-Data"] = '"cache", "storage"'


@router.put("/demo/part/{part}", responses=problems(DemoUnavailable))
def play_demo_part(
    part: str, request: Request, response: Response, _actor: Actor = allows(Audience.PERSON)
) -> DemoPart:
    """Play another person of the demo; there is no such thing outside of it."""
    if demo_role(request) is None or part not in DEMO_PARTS:
        raise DemoUnavailable(f"no demo part {part} here")
    response.set_cookie(authentication.DEMO_COOKIE, part, httponly=True, samesite="lax")
    return DemoPart(part=part, parts=list(DEMO_PARTS))


router.include_router(_unsaved_router)
