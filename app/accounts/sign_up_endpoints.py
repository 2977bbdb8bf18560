"""The endpoints by which one comes to an account, or back to it: signing up, and a forgotten password."""

from fastapi import APIRouter, Request, Response

from app.accounts import people, queries, rate_limits, service
from app.accounts.endpoints import (
    LateSession,
    PatientRoute,
    SecretRoute,
    allows,
    ensure_may_mail,
    ensure_may_try,
    place_of,
    sign_in_browser,
)
from app.accounts.errors import (
    AddressTaken,
    BadAddress,
    MailFirst,
    NoMailServer,
    PasswordTooWeak,
    ResetNotFound,
    SignUpClosed,
    SignUpNotFound,
    TooManyTries,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Sight, normalised_email
from app.accounts.schemas import (
    NewPassword,
    PersonRead,
    ResetAdd,
    SignUpAdd,
    SignUpAsk,
    SignUpFinish,
    SignUpShown,
    SignUpWay,
)
from app.kit.http import CurrentRuntime, DbSession, Router, problems

router = Router(prefix="/v1", tags=["accounts"], route_class=PatientRoute)
_secret_router = APIRouter(route_class=SecretRoute)


@router.get("/sign-up")
def read_sign_up(runtime: CurrentRuntime, session: DbSession, _actor: Actor = allows(Sight.ANYONE)) -> SignUpWay:
    """Say whether anybody may open an account here, and whether by a mailed link."""
    settings = runtime.settings
    is_open = settings.sign_up == "open" or not queries.has_people(session)
    return SignUpWay(open=is_open, by_mail=bool(settings.smtp_url))


@_secret_router.post(
    "/sign-up",
    status_code=201,
    response_model=PersonRead,
    responses=problems(AddressTaken, BadAddress, MailFirst, PasswordTooWeak, SignUpClosed, TooManyTries),
)
def sign_up(
    body: SignUpAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: LateSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Make an account with a studio of its own, and sign in; on a server without mail only."""
    ensure_may_try(request, (rate_limits.SIGN_UPS_FROM_PLACE, place_of(request)))
    if runtime.settings.smtp_url:
        raise MailFirst("this server verifies addresses first", fix="ask for a link: POST /v1/sign-ups")
    with begin() as session:
        service.ensure_may_sign_up(session, runtime.settings)
        person = service.sign_up(
            session, email=body.email, name=body.name, password=body.password, studio_name=body.studio_name
        )
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_secret_router.post(
    "/sign-ups", status_code=202, responses=problems(BadAddress, NoMailServer, SignUpClosed, TooManyTries)
)
def ask_sign_up(
    body: SignUpAsk,
    request: Request,
    runtime: CurrentRuntime,
    begin: LateSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> None:
    """Mail a link that opens an account; the answer is the same for an address that has one."""
    if not runtime.settings.smtp_url:
        raise NoMailServer("this server has no mail server to send a link by", fix="sign up at once: POST /v1/sign-up")
    ensure_may_mail(request, normalised_email(body.email))
    with begin() as session:
        service.ensure_may_sign_up(session, runtime.settings)
        service.ask_sign_up(session, body.email)


@router.get("/sign-ups/{secret}", responses=problems(SignUpNotFound))
def read_sign_up_link(secret: str, session: DbSession, _actor: Actor = allows(Sight.ANYONE)) -> SignUpShown:
    """Show the holder of a mailed link the address that it opens an account for."""
    return SignUpShown(email=service.sign_up_by_secret(session, secret).email)


@_secret_router.post(
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
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Make the account that a mailed link opens, with a studio of its own, and sign in."""
    person = service.finish_sign_up(
        session, secret, name=body.name, password=body.password, studio_name=body.studio_name
    )
    sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_secret_router.post("/password-resets", status_code=202, responses=problems(TooManyTries))
def ask_password_reset(
    body: ResetAdd, request: Request, begin: LateSession, _actor: Actor = allows(Sight.ANYONE)
) -> None:
    """Mail a link for a new password; the answer is the same for an unknown address."""
    ensure_may_mail(request, normalised_email(body.email))
    with begin() as session:
        people.ask_reset(session, body.email)


@_secret_router.post(
    "/password-resets/{secret}", response_model=PersonRead, responses=problems(ResetNotFound, PasswordTooWeak)
)
def set_password_by_link(
    secret: str,
    body: NewPassword,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Set a new password by the mailed link, end every other sign-in, and sign in."""
    person = people.reset_password(session, secret, body.password)
    sign_in_browser(session, runtime.settings, request, response, person)
    return person


router.include_router(_secret_router)
