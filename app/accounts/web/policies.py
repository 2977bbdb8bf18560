"""Policies of endpoints: who is asking, and whether the declared policy admits them."""

from typing import Any
from uuid import UUID

from fastapi import BackgroundTasks, Depends, Request

from app.accounts import authentication, queries
from app.accounts.authentication import (
    DEMO_PARTS,
    AuthResult,
    RequestCredentials,
)
from app.accounts.errors import (
    CsrfMismatch,
    NotSignedIn,
    OperatorNeeded,
    PersonNeeded,
    ScopeMissing,
)
from app.accounts.rules import Actor, Audience, Policy, Scope
from app.core.db import Database
from app.core.web.http import (
    database_of,
    runtime_of,
    set_reach,
)
from app.core.web.idempotency import ensure_first


def client_address(request: Request) -> str:
    """Return the network address that a request comes from, behind trusted proxies the visitor's own."""
    return request.client.host if request.client else ""


def authenticate(request: Request, *, by_desk_token: bool = False) -> AuthResult:
    """Return the caller; raise NotSignedIn, or CsrfMismatch for a write that is not our page's."""
    runtime = runtime_of(request)
    return authentication.authenticate_request(
        runtime.database, runtime.settings, _credentials(request), by_desk_token=by_desk_token
    )


def _credentials(request: Request) -> RequestCredentials:
    return RequestCredentials(request.method, request.headers, request.cookies, client_address(request))


def caller_key(request: Request) -> str:
    """Return the key that counts a request before it is authenticated."""
    return authentication.caller_key(_credentials(request))


class PolicyDependency:
    """The dependency that an endpoint's policy becomes; services check the project and the role."""

    def __init__(self, policy: Policy) -> None:
        self.policy = policy

    def __call__(self, request: Request, background: BackgroundTasks) -> Actor:
        """Return the caller if the policy admits them; a write that was answered before is answered the same again."""
        auth = self._admit(request)
        request.state.actor = auth.actor
        ensure_first(request, auth.actor)
        if self.policy.audience is not Audience.ANYONE:
            if auth.unrecorded_sign_in_id is not None:
                background.add_task(_record_seen, database_of(request), auth.unrecorded_sign_in_id)
            if auth.actor.token_id is not None:
                background.add_task(_record_token_use, database_of(request), auth.actor.token_id)
            if auth.desk_token_id is not None:
                background.add_task(_record_desk_token_use, database_of(request), auth.desk_token_id)
        return auth.actor

    def _admit(self, request: Request) -> AuthResult:
        if self.policy.audience is Audience.ANYONE:
            authentication.ensure_same_origin(runtime_of(request).settings, _credentials(request))
            try:
                auth = authenticate(request)
            except (NotSignedIn, CsrfMismatch):
                return AuthResult(Actor())
            set_reach(request, auth.actor.reach)
            return auth
        auth = authenticate(request, by_desk_token=self.policy.desk_token)
        actor = auth.actor
        if actor.token_id is not None:
            if self.policy.build is None:
                raise PersonNeeded("a build's token cannot do this; sign in as a person")
            if self.policy.build not in actor.scopes:
                raise ScopeMissing(f"this token lacks the scope {self.policy.build}")
        authentication.ensure_second_factor(auth, request.url.path)
        if self.policy.audience is Audience.OPERATOR:
            _ensure_operator(database_of(request), actor)
        if self.policy.recent_sign_in:
            authentication.ensure_recent_sign_in(auth)
        set_reach(request, actor.reach)
        return auth


def _ensure_operator(database: Database, actor: Actor) -> None:
    with database.reading(actor.reach) as session:
        if actor.person_id is None or not queries.is_operator(session, actor.person_id):
            raise OperatorNeeded(
                "only an operator of this server can do this",
                fix="operators are named on the command line: soundlist operators add ADDRESS",
            )


def _record_token_use(database: Database, token_id: UUID) -> None:
    with database.writing() as session:
        queries.record_token_use(session, token_id)


def _record_desk_token_use(database: Database, desk_token_id: UUID) -> None:
    with database.writing() as session:
        queries.record_desk_token_use(session, desk_token_id)


def _record_seen(database: Database, sign_in_id: UUID) -> None:
    with database.writing() as session:
        queries.record_seen(session, sign_in_id)


def ensure_recent_sign_in(request: Request) -> None:
    """Raise RecentSignInNeeded for a caller who signed in long ago, where only some bodies ask for a recent one."""
    authentication.ensure_recent_sign_in(authenticate(request))


def allows(
    audience: Audience, *, build: Scope | None = None, desk_token: bool = False, recent_sign_in: bool = False
) -> Any:
    """Declare and enforce the policy of an endpoint, which receives the Actor as the default of its `actor` parameter.

    Enforced here is what needs no object: sign-in, the origin of a browser's write, a build's scope, the operator, and
    a recent sign-in where access is given to others. Who
    may see an object is part of its query and answers 404; the role in its studio or project is checked by the service,
    once the object is known to be visible. `tests/house/test_policies.py` asks every endpoint as every audience.
    """
    return Depends(PolicyDependency(Policy(audience, build, desk_token, recent_sign_in)))


def demo_role(request: Request) -> tuple[str, tuple[str, ...]] | None:
    """Return the person that a visitor of the demo acts as, and the choices; None for people who signed in."""
    try:
        part = authenticate(request).demo_part
    except (NotSignedIn, CsrfMismatch):
        return None
    return (part, DEMO_PARTS) if part else None
