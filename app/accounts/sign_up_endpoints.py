"""The endpoints by which one comes to an account, or back to it: signing up, and a forgotten password."""

from fastapi import APIRouter, Request, Response

from app.accounts import people, queries, rate_limits, service, setup_codes
from app.accounts.errors import (
    AddressTaken,
    BadAddress,
    NoMailServer,
    PasswordTooWeak,
    ResetNotFound,
    SetupCodeNeeded,
    SignUpClosed,
    SignUpNotFound,
    TooManyAttempts,
    VerificationNeeded,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Audience, normalised_email
from app.accounts.schemas import (
    NewPassword,
    PersonRead,
    ResetAdd,
    SignUpAdd,
    SignUpFinish,
    SignUpMode,
    SignUpRequest,
    SignUpShown,
)
from app.accounts.web.browser_sign_ins import sign_in_browser
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_mail_allowed,
    ensure_within_limits,
    network_of,
)
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.get("/sign-up")
def read_sign_up(runtime: CurrentRuntime, session: DbSession, _actor: Actor = allows(Audience.ANYONE)) -> SignUpMode:
    """Return whether anyone may open an account here, and whether by a mailed link."""
    settings = runtime.settings
    is_open = settings.sign_up == "open" or not queries.has_people(session)
    needs_setup_code = setup_codes.needs_setup_code(session, settings)
    return SignUpMode(open=is_open, by_mail=bool(settings.smtp_url), setup_code=needs_setup_code)


@_unsaved_router.post(
    "/sign-up",
    status_code=201,
    response_model=PersonRead,
    responses=problems(
        AddressTaken,
        BadAddress,
        VerificationNeeded,
        PasswordTooWeak,
        SetupCodeNeeded,
        SignUpClosed,
        TooManyAttempts,
    ),
)
def sign_up(
    body: SignUpAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Create an account with a new studio, and sign in; on a server without mail only."""
    ensure_within_limits(request, (rate_limits.SIGN_UPS_FROM_NETWORK, network_of(request)))
    if runtime.settings.smtp_url:
        raise VerificationNeeded("this server verifies addresses first", fix="ask for a link: POST /v1/sign-ups")
    with begin() as session:
        setup_codes.ensure_sign_up_allowed(session, runtime.settings, body.setup_code or "")
        person = service.sign_up(
            session, email=body.email, name=body.name, password=body.password, studio_name=body.studio_name
        )
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_unsaved_router.post(
    "/sign-ups",
    status_code=202,
    responses=problems(BadAddress, NoMailServer, SetupCodeNeeded, SignUpClosed, TooManyAttempts),
)
def request_sign_up(
    body: SignUpRequest,
    request: Request,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> None:
    """Mail a link that opens an account; the answer is the same for an address that has one."""
    if not runtime.settings.smtp_url:
        raise NoMailServer("this server has no mail server to send a link by", fix="sign up at once: POST /v1/sign-up")
    ensure_mail_allowed(request, normalised_email(body.email))
    with begin() as session:
        setup_codes.ensure_sign_up_allowed(session, runtime.settings, body.setup_code or "")
        service.request_sign_up(session, body.email)


@router.get("/sign-ups/{secret}", responses=problems(SignUpNotFound))
def read_sign_up_link(secret: str, session: DbSession, _actor: Actor = allows(Audience.ANYONE)) -> SignUpShown:
    """Show the holder of a mailed link the address that it opens an account for."""
    return SignUpShown(email=service.sign_up_by_secret(session, secret).email)


@_unsaved_router.post(
    "/sign-ups/{secret}",
    status_code=201,
    response_model=PersonRead,
    responses=problems(AddressTaken, PasswordTooWeak, SignUpNotFound),
)
def finish_sign_up(
    secret: str,
    body: SignUpFinish,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Create the account of a mailed link with a new studio, and sign in."""
    person = service.finish_sign_up(
        session, secret, name=body.name, password=body.password, studio_name=body.studio_name
    )
    sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_unsaved_router.post("/password-resets", status_code=202, responses=problems(TooManyAttempts))
def request_password_reset(
    body: ResetAdd, request: Request, begin: DeferredSession, _actor: Actor = allows(Audience.ANYONE)
) -> None:
    """Mail a link for a new password; the answer is the same for an unknown address."""
    ensure_mail_allowed(request, normalised_email(body.email))
    with begin() as session:
        people.request_reset(session, body.email)


@_unsaved_router.post(
    "/password-resets/{secret}", response_model=PersonRead, responses=problems(ResetNotFound, PasswordTooWeak)
)
def set_password_by_link(
    secret: str,
    body: NewPassword,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Set a new password by the mailed link, end every other sign-in, and sign in unless a second factor is asked."""
    person = people.reset_password(session, secret, body.password)
    if people.may_enter_by_link(session, person):
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


router.include_router(_unsaved_router)
