"""Who comes in, and the endpoints of accounts."""

import hashlib
import hmac
from collections.abc import Callable
from typing import Any

from fastapi import APIRouter, Depends, Request

from app.accounts import queries
from app.accounts.errors import CsrfMismatch, NotSignedIn, PersonNeeded, ScopeMissing
from app.accounts.rules import Actor, Policy, Scope, Sight
from app.kit.http import SAFE_METHODS, Route, database_of, runtime_of
from app.settings import Settings

SESSION_COOKIE = "soundlist_session"
CSRF_COOKIE = "soundlist_csrf"
CSRF_HEADER = "x-csrf-token"
DEMO_COOKIE = "soundlist_demo_part"
DEMO_PARTS = ("producer", "decider", "designer")
LOOPBACK_HOSTS = frozenset({"127.0.0.1", "localhost", "[::1]"})
FORWARDING_HEADERS = ("forwarded", "x-forwarded-for", "x-forwarded-host", "x-forwarded-proto", "x-real-ip", "via")


def sha256_of(secret: str) -> str:
    """Return the only form in which a secret is kept."""
    return hashlib.sha256(secret.encode()).hexdigest()


def csrf_token(settings: Settings, secret: str) -> str:
    """Return the token that our own page must send along with a session's secret."""
    key = settings.secret_key.get_secret_value().encode()
    return hmac.new(key, b"csrf:" + secret.encode(), hashlib.sha256).hexdigest()


def _is_demo_door(request: Request) -> bool:
    """Whether this request may enter the demo without signing in: from this machine, to this machine, directly."""
    if not runtime_of(request).settings.demo or any(name in request.headers for name in FORWARDING_HEADERS):
        return False
    host = request.headers.get("host", "").rsplit(":", 1)[0] if request.headers.get("host") != "[::1]" else "[::1]"
    client = request.client.host if request.client else ""
    return host in LOOPBACK_HOSTS and client in ("127.0.0.1", "::1")


def _ensure_our_page(request: Request, secret: str) -> None:
    if request.method in SAFE_METHODS:
        return
    sent = request.headers.get(CSRF_HEADER, "")
    if not hmac.compare_digest(sent, csrf_token(runtime_of(request).settings, secret)):
        raise CsrfMismatch("this request did not come from our page; reload it and try again")


def actor_of(request: Request) -> Actor:
    """Return who asks, or raise NotSignedIn."""
    database = database_of(request)
    scheme, _, bearer = request.headers.get("authorization", "").partition(" ")
    if scheme:
        with database.reading() as session:
            actor = queries.actor_for_token(session, sha256_of(bearer.strip())) if scheme.lower() == "bearer" else None
        if actor is None:
            raise NotSignedIn("this token is unknown or was revoked; ask the producer for a new one")
        return actor
    if secret := request.cookies.get(SESSION_COOKIE):
        with database.reading() as session:
            actor = queries.actor_for_sign_in(session, sha256_of(secret))
        if actor is not None:
            _ensure_our_page(request, secret)
            return actor
    if _is_demo_door(request):
        part = request.cookies.get(DEMO_COOKIE, DEMO_PARTS[0])
        with database.reading() as session:
            actor = queries.actor_for_demo_part(session, part if part in DEMO_PARTS else DEMO_PARTS[0])
        if actor is not None:
            _ensure_our_page(request, "demo")
            return actor
    raise NotSignedIn("sign in first")


class Allowed:
    """The dependency that an endpoint's policy becomes."""

    def __init__(self, policy: Policy) -> None:
        self.policy = policy

    def __call__(self, request: Request) -> Actor:
        """Return who asks, where the policy lets them in at all; services check the project and the role."""
        if self.policy.sight is Sight.ANYONE:
            try:
                return actor_of(request)
            except (NotSignedIn, CsrfMismatch):
                return Actor()
        actor = actor_of(request)
        if actor.is_build and self.policy.build is None:
            raise PersonNeeded("a build's token cannot do this; sign in as a person")
        if actor.is_build and self.policy.build not in actor.scopes:
            raise ScopeMissing(f"this token lacks the scope {self.policy.build}")
        return actor


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


router = APIRouter(prefix="/v1", tags=["accounts"], route_class=Route)
