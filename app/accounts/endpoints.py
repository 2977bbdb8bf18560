"""Who comes in, and the endpoints of accounts."""

from collections.abc import Callable, Coroutine
from functools import partial
from typing import Any
from uuid import UUID

from fastapi import APIRouter, BackgroundTasks, Depends, Request, Response
from fastapi.responses import JSONResponse

from app.accounts import doors, people, queries, rate_limits, service
from app.accounts.doors import CSRF_HEADER, DEMO_PARTS, SESSION_COOKIE, Arrival, Visit, csrf_token, sha256_of
from app.accounts.errors import (
    AddressTaken,
    BadAddress,
    CsrfMismatch,
    DemoDoorClosed,
    NotInDemo,
    NotSignedIn,
    PasswordTooWeak,
    PersonNeeded,
    ResetNotFound,
    ScopeMissing,
    TooManyTries,
    WrongPassword,
    WrongSignIn,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Policy, Scope, Sight, normalised_email
from app.accounts.schemas import (
    DemoPart,
    NameChange,
    NewPassword,
    PasswordChange,
    PersonBrief,
    PersonRead,
    ResetAdd,
    SessionRead,
    SignInAdd,
    SignUpAdd,
)
from app.kit.db import Database
from app.kit.http import (
    PROBLEM_TYPE,
    CurrentRuntime,
    DbSession,
    Problem,
    Route,
    Router,
    come_in,
    database_of,
    problems,
    runtime_of,
)
from app.kit.turns import Asking, Authentication, InOneTurn
from app.settings import Settings

__all__ = [
    "CSRF_HEADER",
    "DEMO_PARTS",
    "SESSION_COOKIE",
    "PatientRoute",
    "SecretRoute",
    "allows",
    "csrf_token",
    "demo_part_of",
    "ensure_may_invite_more",
    "ensure_may_try_password",
    "policy_of",
    "router",
    "sha256_of",
    "sign_in_browser",
]

Handler = Callable[[Request], Coroutine[Any, Any, Response]]


def _arrive(request: Request) -> Arrival:
    runtime = runtime_of(request)
    return doors.arrive(runtime.database, runtime.settings, _visit(request))


def _visit(request: Request) -> Visit:
    return Visit(request.method, request.headers, request.cookies, _place_of(request))


def _place_of(request: Request) -> str:
    return request.client.host if request.client else ""


class Allowed(Authentication):
    """The dependency that an endpoint's policy becomes."""

    def __init__(self, policy: Policy) -> None:
        self.policy = policy

    async def __call__(self, request: Request, background: BackgroundTasks) -> Asking:
        """Return what tells who asks, once the endpoint has a thread for it."""
        return Asking(request, partial(self._who, request, background))

    def _who(self, request: Request, background: BackgroundTasks) -> Actor:
        actor = self.authenticate(request)
        if actor.token_id is not None and self.policy.sight is not Sight.ANYONE:
            background.add_task(_note_token_use, database_of(request), actor.token_id)
        return actor

    def authenticate(self, request: Request) -> Actor:
        """Return who asks, where the policy lets them in at all; services check the project and the role."""
        if self.policy.sight is Sight.ANYONE:
            doors.ensure_our_origin(runtime_of(request).settings, _visit(request))
            try:
                actor = _arrive(request).actor
            except (NotSignedIn, CsrfMismatch):
                return Actor()
            come_in(request, actor.reach)
            return actor
        actor = _arrive(request).actor
        if actor.token_id is not None:
            if self.policy.build is None:
                raise PersonNeeded("a build's token cannot do this; sign in as a person")
            if self.policy.build not in actor.scopes:
                raise ScopeMissing(f"this token lacks the scope {self.policy.build}")
        come_in(request, actor.reach)
        return actor


def _note_token_use(database: Database, token_id: UUID) -> None:
    with database.writing() as session:
        queries.note_token_use(session, token_id)


def allows(sight: Sight, *, build: Scope | None = None) -> Any:
    """Declare the policy of an endpoint, which receives the Actor as the default of its `actor` parameter."""
    return Depends(Allowed(Policy(sight, build)))


def policy_of(endpoint: Callable[..., Any], dependencies: list[Any]) -> Policy | None:
    """Return the policy that an endpoint declares, None when it forgot."""
    for dependency in dependencies:
        if isinstance(dependency.call, Allowed):
            return dependency.call.policy
        if (found := policy_of(endpoint, dependency.dependencies)) is not None:
            return found
    return None


def demo_part_of(request: Request) -> tuple[str, tuple[str, ...]] | None:
    """Return whom the demo's visitor plays and whom they could; None for everybody who signed in."""
    try:
        part = _arrive(request).demo_part
    except (NotSignedIn, CsrfMismatch):
        return None
    return (part, DEMO_PARTS) if part else None


def sign_in_browser(session: DbSession, settings: Settings, response: Response, person_id: UUID) -> None:
    """Give the answering browser a session of its own."""
    secret = people.start_sign_in(session, person_id)
    lasts_s = int(people.SIGN_IN_LASTS.total_seconds())
    response.set_cookie(
        SESSION_COOKIE, secret, max_age=lasts_s, httponly=True, samesite="lax", secure=settings.is_https
    )
    _give_csrf_token(response, settings, secret)


def _give_csrf_token(response: Response, settings: Settings, secret: str) -> None:
    response.set_cookie(
        doors.CSRF_COOKIE, csrf_token(settings, secret), samesite="lax", secure=settings.is_https, httponly=False
    )


def ensure_may_try_password(request: Request, account: str) -> None:
    """Count one guess at a password; raise TooManyTries for too many."""
    rate_limits.count_try(rate_limits.SIGN_INS_FROM_PLACE, _place_of(request))
    rate_limits.count_try(rate_limits.SIGN_INS_OF_ADDRESS, f"{account} {_place_of(request)}")


def ensure_may_invite_more(actor: Actor) -> None:
    """Count one invitation; raise TooManyTries for too many."""
    rate_limits.count_try(rate_limits.INVITATIONS_BY_PERSON, str(actor.person))


def _wait(request: Request, error: TooManyTries) -> Response:
    problem = Problem(
        title="Too many tries",
        status=error.status,
        code=error.code(),
        detail=error.message,
        request_id=getattr(request.state, "request_id", None),
    )
    headers = {"Retry-After": str(error.retry_after_s)}
    return JSONResponse(problem.model_dump(mode="json"), error.status, headers, media_type=PROBLEM_TYPE)


def _patiently(handle: Handler) -> Handler:
    async def handle_patiently(request: Request) -> Response:
        try:
            return await handle(request)
        except TooManyTries as error:
            return _wait(request, error)

    return handle_patiently


class PatientRoute(Route):
    """A route that says how long to wait after too many tries."""

    def get_route_handler(self) -> Handler:
        """Answer TooManyTries with Retry-After."""
        return _patiently(super().get_route_handler())


class SecretRoute(InOneTurn):
    """A patient route whose answer carries a secret, so none is kept to be replayed for an Idempotency-Key."""

    def get_route_handler(self) -> Handler:
        """Answer TooManyTries with Retry-After."""
        return _patiently(super().get_route_handler())


router = Router(prefix="/v1", tags=["accounts"], route_class=PatientRoute)
_secret_router = APIRouter(route_class=SecretRoute)


@router.get("/session")
def read_session(
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    actor: Actor = allows(Sight.ANYONE),
) -> SessionRead:
    """Say whether somebody is signed in, and hand our page the token that its writes must carry."""
    if actor.person_id is None:
        return SessionRead(signed_in=False, demo=False, person=None)
    arrival = _arrive(request)
    if arrival.secret:
        _give_csrf_token(response, runtime.settings, arrival.secret)
    person = session.get_one(Person, actor.person_id)
    return SessionRead(
        signed_in=True, demo=arrival.demo_part is not None, person=PersonBrief(id=person.id, name=person.name)
    )


@_secret_router.post(
    "/sign-up",
    status_code=201,
    response_model=PersonRead,
    responses=problems(AddressTaken, BadAddress, PasswordTooWeak, TooManyTries),
)
def sign_up(
    body: SignUpAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Make an account with a studio of its own, and sign in."""
    rate_limits.count_try(rate_limits.SIGN_UPS_FROM_PLACE, _place_of(request))
    person = service.sign_up(
        session, email=body.email, name=body.name, password=body.password, studio_name=body.studio_name
    )
    sign_in_browser(session, runtime.settings, response, person.id)
    return person


@_secret_router.post("/sign-in", response_model=PersonRead, responses=problems(WrongSignIn, TooManyTries))
def sign_in(
    body: SignInAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Sign in with address and password."""
    account = normalised_email(body.email)
    ensure_may_try_password(request, account)
    person_id = people.person_who_knows(runtime.database, account, body.password)
    if person_id is None:
        raise WrongSignIn("address and password do not belong together", fix="check both, or ask for a new password")
    rate_limits.forgive(rate_limits.SIGN_INS_OF_ADDRESS, f"{account} {_place_of(request)}")
    sign_in_browser(session, runtime.settings, response, person_id)
    return session.get_one(Person, person_id)


@_secret_router.post("/sign-out", status_code=204)
def sign_out(request: Request, response: Response, session: DbSession, _actor: Actor = allows(Sight.PERSON)) -> None:
    """Sign this browser out."""
    people.end_sign_in(session, request.cookies.get(SESSION_COOKIE, ""))
    for cookie in (SESSION_COOKIE, doors.CSRF_COOKIE):
        response.delete_cookie(cookie, samesite="lax")
    response.headers["Clear-Site-Data"] = '"cache", "storage"'


@_secret_router.post("/password-resets", status_code=202, responses=problems(TooManyTries))
def ask_password_reset(
    body: ResetAdd,
    request: Request,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> None:
    """Mail a link for a new password; the answer is the same for an unknown address."""
    rate_limits.count_try(rate_limits.RESETS_FROM_PLACE, _place_of(request))
    rate_limits.count_try(rate_limits.RESETS_OF_ADDRESS, normalised_email(body.email))
    people.ask_reset(session, body.email, base_url=runtime.settings.base_url)


@_secret_router.post(
    "/password-resets/{secret}", response_model=PersonRead, responses=problems(ResetNotFound, PasswordTooWeak)
)
def set_password_by_link(
    secret: str,
    body: NewPassword,
    response: Response,
    runtime: CurrentRuntime,
    session: DbSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Set a new password by the mailed link, end every other sign-in, and sign in."""
    person = people.reset_password(session, secret, body.password)
    sign_in_browser(session, runtime.settings, response, person.id)
    return person


@router.put("/me", response_model=PersonRead)
def change_my_name(body: NameChange, session: DbSession, actor: Actor = allows(Sight.PERSON)) -> Person:
    """Change the caller's name."""
    return people.rename(session, actor, body.name)


@_secret_router.put(
    "/me/password", status_code=204, responses=problems(WrongPassword, NotInDemo, PasswordTooWeak, TooManyTries)
)
def change_my_password(
    body: PasswordChange, request: Request, session: DbSession, actor: Actor = allows(Sight.PERSON)
) -> None:
    """Change the caller's password, and end their other sign-ins."""
    ensure_may_try_password(request, str(actor.person))
    kept_secret = request.cookies.get(SESSION_COOKIE)
    people.change_password(session, actor, current=body.current, new=body.new, kept_secret=kept_secret)


@router.put("/demo/part/{part}", responses=problems(DemoDoorClosed))
def play_demo_part(part: str, request: Request, response: Response, _actor: Actor = allows(Sight.PERSON)) -> DemoPart:
    """Play another person of the demo; there is no such thing outside of it."""
    if demo_part_of(request) is None or part not in DEMO_PARTS:
        raise DemoDoorClosed(f"no demo part {part} here")
    response.set_cookie(doors.DEMO_COOKIE, part, httponly=True, samesite="lax")
    return DemoPart(part=part, parts=list(DEMO_PARTS))


router.include_router(_secret_router)
