"""Who comes in, and the endpoints of accounts."""

from collections.abc import Callable, Coroutine
from contextlib import AbstractContextManager, nullcontext
from datetime import timedelta
from functools import partial
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, BackgroundTasks, Depends, Request, Response
from fastapi.responses import JSONResponse
from sqlalchemy.orm import Session

from app.accounts import doors, people, queries, rate_limits, sign_ins
from app.accounts.doors import CSRF_HEADER, DEMO_PARTS, SESSION_COOKIE, Arrival, Visit, csrf_token, sha256_of
from app.accounts.errors import (
    CsrfMismatch,
    DemoDoorClosed,
    NotSignedIn,
    PersonNeeded,
    ScopeMissing,
    TooManyTries,
    WrongSignIn,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Policy, Scope, Sight, device_of, normalised_email
from app.accounts.schemas import DemoPart, PersonBrief, PersonRead, SessionRead, SignInAdd
from app.kit.db import Database, beyond_reach
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
    transaction,
)
from app.kit.seats import seats
from app.kit.turns import Asking, Authentication, InOneTurn, Pending
from app.settings import Settings

__all__ = [
    "CSRF_HEADER",
    "DEMO_PARTS",
    "SESSION_COOKIE",
    "LateSession",
    "PatientRoute",
    "SecretRoute",
    "allows",
    "client_address",
    "csrf_token",
    "demo_part_of",
    "ensure_may_guess",
    "ensure_may_invite_more",
    "ensure_may_mail",
    "ensure_may_try",
    "place_of",
    "policy_of",
    "router",
    "sha256_of",
    "sign_in_browser",
]

DEVICE_LASTS = timedelta(days=365)
Handler = Callable[[Request], Coroutine[Any, Any, Response]]


def _arrive(request: Request) -> Arrival:
    runtime = runtime_of(request)
    return doors.arrive(runtime.database, runtime.settings, _visit(request))


def _visit(request: Request) -> Visit:
    return Visit(request.method, request.headers, request.cookies, client_address(request))


class Allowed(Authentication):
    """The dependency that an endpoint's policy becomes."""

    def __init__(self, policy: Policy) -> None:
        self.policy = policy

    async def __call__(self, request: Request, background: BackgroundTasks) -> Asking:
        """Return what tells who asks, once the endpoint has a thread for it."""
        return Asking(request, partial(self._who, request, background))

    def authenticate(self, request: Request) -> Actor:
        """Return who asks, where the policy lets them in at all; services check the project and the role."""
        return self._admit(request).actor

    def _who(self, request: Request, background: BackgroundTasks) -> Actor:
        arrival = self._admit(request)
        if self.policy.sight is not Sight.ANYONE:
            if arrival.unnoted_sign_in_id is not None:
                background.add_task(_note_seen, database_of(request), arrival.unnoted_sign_in_id)
            if arrival.actor.token_id is not None:
                background.add_task(_note_token_use, database_of(request), arrival.actor.token_id)
        return arrival.actor

    def _admit(self, request: Request) -> Arrival:
        if self.policy.sight is Sight.ANYONE:
            doors.ensure_our_origin(runtime_of(request).settings, _visit(request))
            try:
                arrival = _arrive(request)
            except (NotSignedIn, CsrfMismatch):
                return Arrival(Actor())
            come_in(request, arrival.actor.reach)
            return arrival
        arrival = _arrive(request)
        actor = arrival.actor
        if actor.token_id is not None:
            if self.policy.build is None:
                raise PersonNeeded("a build's token cannot do this; sign in as a person")
            if self.policy.build not in actor.scopes:
                raise ScopeMissing(f"this token lacks the scope {self.policy.build}")
        come_in(request, actor.reach)
        return arrival


def _note_token_use(database: Database, token_id: UUID) -> None:
    with database.writing() as session:
        queries.note_token_use(session, token_id)


def _note_seen(database: Database, sign_in_id: UUID) -> None:
    with database.writing() as session:
        queries.note_seen(session, sign_in_id)


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


async def _late_session(request: Request) -> Pending:
    opener: Any = nullcontext(partial(transaction, request))
    return Pending(partial(seats().for_person, reads=False), lambda: opener)


# What opens the request's transaction, for endpoints that first write what stays although the request is refused.
LateSession = Annotated[Callable[[], AbstractContextManager[Session]], Depends(_late_session)]


def sign_in_browser(session: Session, settings: Settings, request: Request, response: Response, person: Person) -> None:
    """Give the answering browser a session of its own, in place of the one it had."""
    secret = sign_ins.start_sign_in(
        session,
        person.id,
        replaces=request.cookies.get(SESSION_COOKIE),
        device=device_of(request.headers.get("user-agent", "")),
        place=client_address(request),
    )
    _set_cookie(response, settings, SESSION_COOKIE, secret, lasts=sign_ins.SIGN_IN_LASTS)
    device = doors.device_cookie(settings, person.email)
    _set_cookie(response, settings, doors.DEVICE_COOKIE, device, lasts=DEVICE_LASTS)
    _give_csrf_token(response, settings, secret)


def _set_cookie(response: Response, settings: Settings, name: str, value: str, *, lasts: timedelta) -> None:
    max_age = int(lasts.total_seconds())
    response.set_cookie(name, value, max_age=max_age, httponly=True, samesite="lax", secure=settings.is_https)


def _give_csrf_token(response: Response, settings: Settings, secret: str) -> None:
    response.set_cookie(
        doors.CSRF_COOKIE, csrf_token(settings, secret), samesite="lax", secure=settings.is_https, httponly=False
    )


def client_address(request: Request) -> str:
    """Return the network address that a request comes from, behind trusted proxies the visitor's own."""
    return request.client.host if request.client else ""


def place_of(request: Request) -> str:
    """Return the place that tries are counted for."""
    return rate_limits.place_of(client_address(request))


def ensure_may_try(request: Request, *counted: tuple[rate_limits.Limit, str]) -> None:
    """Count one try against each limit; raise TooManyTries for too many. What is counted stays counted."""
    for limit, whom in counted:
        with database_of(request).writing() as session:
            rate_limits.count_try(session, limit, whom)


def ensure_may_guess(request: Request, account: str) -> None:
    """Count one guess at an account's password, or at the secret of a link; raise TooManyTries for too many."""
    ensure_may_try(request, *_guesses(request, account))


def _guesses(request: Request, account: str) -> list[tuple[rate_limits.Limit, str]]:
    settings = runtime_of(request).settings
    if (device := doors.device_for(settings, request.cookies.get(doors.DEVICE_COOKIE, ""), account)) is not None:
        return [(rate_limits.GUESSES_FROM_DEVICE, device)]  # whatever strangers do, its owner comes through
    place = place_of(request)
    return [
        (rate_limits.GUESSES_FROM_PLACE, place),
        (rate_limits.GUESSES_AT_ACCOUNT_FROM_PLACE, f"{account} {place}"),
        (rate_limits.GUESSES_AT_ACCOUNT, account),
    ]


def _forgive(session: Session, request: Request, account: str) -> None:
    with beyond_reach(session):  # the counts are the server's own
        for limit, whom in _guesses(request, account):
            if limit is not rate_limits.GUESSES_FROM_PLACE:  # who owns one account must not guess at others for ever
                rate_limits.forgive(session, limit, whom)


def ensure_may_invite_more(session: Session, actor: Actor) -> None:
    """Count one invitation; raise TooManyTries for too many."""
    with beyond_reach(session):  # the counts are the server's own
        rate_limits.count_try(session, rate_limits.INVITATIONS_BY_PERSON, str(actor.person))


def ensure_may_mail(request: Request, whom: str) -> None:
    """Count one mail about an account that anybody can ask for; raise TooManyTries for too many."""
    ensure_may_try(
        request,
        (rate_limits.MAILS_FROM_PLACE, place_of(request)),
        (rate_limits.MAILS_TO_ADDRESS, whom),
    )


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


@_secret_router.post("/sign-in", response_model=PersonRead, responses=problems(WrongSignIn, TooManyTries))
def sign_in(
    body: SignInAdd,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: LateSession,
    _actor: Actor = allows(Sight.ANYONE),
) -> Person:
    """Sign in with address and password."""
    account = normalised_email(body.email)
    ensure_may_guess(request, account)
    person_id = people.person_who_knows(runtime.database, account, body.password)
    if person_id is None:
        raise WrongSignIn("address and password do not belong together", fix="check both, or ask for a new password")
    with begin() as session:
        _forgive(session, request, account)
        person = session.get_one(Person, person_id)
        sign_in_browser(session, runtime.settings, request, response, person)
    return person


@_secret_router.post("/sign-out", status_code=204)
def sign_out(request: Request, response: Response, session: DbSession, _actor: Actor = allows(Sight.PERSON)) -> None:
    """Sign this browser out."""
    sign_ins.end_sign_in(session, request.cookies.get(SESSION_COOKIE, ""))
    for cookie in (SESSION_COOKIE, doors.CSRF_COOKIE):
        response.delete_cookie(cookie, samesite="lax")
    response.headers["Clear-Site-Data"] = '"cache", "storage"'


@router.put("/demo/part/{part}", responses=problems(DemoDoorClosed))
def play_demo_part(part: str, request: Request, response: Response, _actor: Actor = allows(Sight.PERSON)) -> DemoPart:
    """Play another person of the demo; there is no such thing outside of it."""
    if demo_part_of(request) is None or part not in DEMO_PARTS:
        raise DemoDoorClosed(f"no demo part {part} here")
    response.set_cookie(doors.DEMO_COOKIE, part, httponly=True, samesite="lax")
    return DemoPart(part=part, parts=list(DEMO_PARTS))


router.include_router(_secret_router)
