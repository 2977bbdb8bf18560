"""Authentication by secret, cookie or network. Endpoints pass in what a request carried."""

import hashlib
import hmac
import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from urllib.parse import urlsplit
from uuid import UUID

from app.accounts import queries
from app.accounts.errors import CsrfMismatch, NotSignedIn, RecentSignInNeeded, SecondFactorRequired
from app.accounts.rules import Actor, network_of
from app.core import clock
from app.core.db import Database
from app.core.lru_cache import LRUCache
from app.core.plural import day_in_words
from app.core.web.http import SAFE_METHODS
from app.settings import Settings

SESSION_COOKIE = "soundlist_session"
CSRF_COOKIE = "soundlist_csrf"
CSRF_HEADER = "x-csrf-token"
DEVICE_COOKIE = "soundlist_device"  # OWASP, device cookies: shows that this browser has signed in to an account before
DEMO_COOKIE = "soundlist_demo_part"
DEMO_PARTS = ("approver", "producer", "designer")  # the first is who comes in without choosing
DEMO_SECRET = "demo"  # noqa: S105  what the demo's CSRF token is made from: it has no session
SET_UP_SECOND_FACTOR = "set one up on the page Account, under Second factor"
# Reached without the second factor that a studio requires: setting one up begins here.
ACCOUNT_PATHS = frozenset({"/v1/me", "/v1/sign-out"})
ACCOUNT_PREFIXES = tuple(
    f"/v1/{name}"
    for name in (
        "me/email-",
        "me/mail-preferences",
        "me/passkeys",
        "me/password",
        "me/picture",
        "me/recovery-codes",
        "me/second-factors",
        "me/sign-ins",
        "me/totp",
        "email-",
    )
)
RECENT_SIGN_IN = timedelta(minutes=30)
# Holders by the hashes of their secrets; one that was dropped counts as its network until it is good again.
_KNOWN_CALLERS: LRUCache[str, str] = LRUCache(20_000)
LOOPBACK_HOSTS = frozenset({"127.0.0.1", "localhost", "[::1]"})
LOOPBACK_CLIENTS = frozenset({"127.0.0.1", "::1"})
FORWARDING_HEADERS = frozenset(
    {"forwarded", "via", "x-real-ip", "x-client-ip", "x-original-host", "true-client-ip", "cf-connecting-ip"}
)


@dataclass(frozen=True)
class RequestCredentials:
    """The credentials of a request: headers under lower-case names."""

    method: str
    headers: Mapping[str, str]
    cookies: Mapping[str, str]
    client_host: str


@dataclass(frozen=True)
class AuthResult:
    """The authenticated caller, the secret that the CSRF token is made from, and the demo's part if it was the demo."""

    actor: Actor
    secret: str | None = None
    demo_part: str | None = None
    unrecorded_sign_in_id: UUID | None = None  # of the sign-in whose use is to be noted
    signed_in_at: datetime | None = None  # of a browser's sign-in; None: a token, or the demo
    lacks_second_factor: bool = False  # which a studio of theirs requires
    desk_token_id: UUID | None = None


def caller_key(credentials: RequestCredentials) -> str:
    """Return the key that counts a request before it is authenticated: of person or project, or else of the network.

    A secret counts once it was good: anyone can send another one with each request, and a person has many.
    """
    scheme, secret = _authorization(credentials)
    if not scheme:
        secret = credentials.cookies.get(SESSION_COOKIE, "")
    known_caller = _KNOWN_CALLERS.get(sha256_of(secret)) if secret else None
    return known_caller or f"network {network_of(credentials.client_host)}"


def _remember(secret: str, auth: AuthResult) -> AuthResult:
    """Let the next request with this secret count as its holder's."""
    actor = auth.actor
    whose = f"project {actor.token_project_id}" if actor.is_build else f"person {actor.person_id}"
    _KNOWN_CALLERS.keep(sha256_of(secret), whose)
    return auth


def _authorization(credentials: RequestCredentials) -> tuple[str, str]:
    scheme, _, secret = credentials.headers.get("authorization", "").partition(" ")
    return scheme.lower(), secret.strip()


def new_secret() -> str:
    """Return a secret of 256 bits for a cookie or a link."""
    return secrets.token_urlsafe(32)


def sha256_of(secret: str) -> str:
    """Return the only form in which a secret is kept."""
    return hashlib.sha256(secret.encode("utf-8", "surrogatepass")).hexdigest()


def csrf_token(settings: Settings, secret: str) -> str:
    """Return the token that our own page must send along with a session's secret."""
    return _signed(settings, "csrf", secret)


def device_cookie(settings: Settings, account: str) -> str:
    """Return a browser's cookie, from now on, to guess apart from strangers at this account's password."""
    nonce = new_secret()
    return f"{nonce}.{_signed(settings, 'device', nonce, account)}"


def device_for(settings: Settings, cookie: str, account: str) -> str | None:
    """Return the name of a browser that has signed in to this account before, None for any other."""
    nonce, _, signature = cookie.partition(".")
    is_ours = hmac.compare_digest(
        signature.encode("utf-8", "surrogatepass"), _signed(settings, "device", nonce, account).encode()
    )
    return nonce if is_ours else None


def _signed(settings: Settings, purpose: str, *parts: str) -> str:
    key = settings.secret_key.get_secret_value().encode()
    message = f"{purpose}:{':'.join(parts)}".encode("utf-8", "surrogatepass")
    return hmac.new(key, message, hashlib.sha256).hexdigest()


def is_demo_request(settings: Settings, credentials: RequestCredentials) -> bool:
    """Whether this visit may enter the demo without signing in: from this machine, to this machine, directly."""
    if not settings.demo or credentials.client_host not in LOOPBACK_CLIENTS:
        return False
    if any(name in FORWARDING_HEADERS or name.startswith("x-forwarded") for name in credentials.headers):
        return False
    return _without_port(credentials.headers.get("host", "")) in LOOPBACK_HOSTS


def ensure_same_origin(settings: Settings, credentials: RequestCredentials) -> None:
    """Raise CsrfMismatch for a write that a browser sends from another site's page."""
    origin = credentials.headers.get("origin")
    if credentials.method in SAFE_METHODS or origin is None or origin == _origin_of(settings.base_url):
        return
    if _host_of(origin) != credentials.headers.get("host"):
        raise CsrfMismatch("this request did not come from Soundlist; open Soundlist and try again")


def authenticate_request(
    database: Database, settings: Settings, credentials: RequestCredentials, *, by_desk_token: bool = False
) -> AuthResult:
    """Return the caller, or raise NotSignedIn; CsrfMismatch where a cookie's write is not our page's.

    A desk token is known only where the endpoint admits one.
    """
    scheme, bearer = _authorization(credentials)
    if scheme:
        if by_desk_token and scheme == "bearer":
            found_desk = queries.actor_for_desk_token(database, sha256_of(bearer))
            if found_desk is not None:
                return _remember(bearer, AuthResult(found_desk[0], desk_token_id=found_desk[1]))
        actor = queries.actor_for_token(database, sha256_of(bearer)) if scheme == "bearer" else None
        if actor is None:
            _KNOWN_CALLERS.drop(sha256_of(bearer))
            raise NotSignedIn(_why_refused(database, sha256_of(bearer)))
        return _remember(bearer, AuthResult(actor))
    secret = credentials.cookies.get(SESSION_COOKIE)
    if secret and (signed_in := queries.actor_for_sign_in(database, sha256_of(secret))) is not None:
        _ensure_csrf_token(settings, credentials, secret)
        return _remember(
            secret,
            AuthResult(
                signed_in.actor,
                secret,
                unrecorded_sign_in_id=signed_in.unrecorded_id,
                signed_in_at=signed_in.signed_in_at,
                lacks_second_factor=signed_in.lacks_second_factor,
            ),
        )
    if secret:
        _KNOWN_CALLERS.drop(sha256_of(secret))
    if is_demo_request(settings, credentials):
        demo_part = credentials.cookies.get(DEMO_COOKIE, "")
        part = demo_part if demo_part in DEMO_PARTS else DEMO_PARTS[0]
        with database.reading() as session:
            actor = queries.actor_for_demo_part(session, part)
        if actor is not None:
            _ensure_csrf_token(settings, credentials, DEMO_SECRET)
            return AuthResult(actor, DEMO_SECRET, part)
    raise NotSignedIn("you are not signed in; sign in to continue")


def ensure_recent_sign_in(auth: AuthResult) -> None:
    """Raise RecentSignInNeeded where the caller's browser signed in long ago: someone else may sit at it now.

    The one rule of what asks for a password again; a further factor belongs to the sign-in, and so to this.
    The demo has no passwords.
    """
    if auth.signed_in_at is not None and auth.signed_in_at < clock.now() - RECENT_SIGN_IN:
        minutes = RECENT_SIGN_IN // timedelta(minutes=1)
        raise RecentSignInNeeded(
            f"this gives access to others or erases for good, so it asks for a sign-in of the last {minutes} minutes; "
            "nothing was done",
            fix="sign in again, then repeat it",
        )


def ensure_second_factor(auth: AuthResult, path: str) -> None:
    """Raise SecondFactorRequired where a studio of the caller requires one; their own account stays open for it."""
    if auth.lacks_second_factor and not (path in ACCOUNT_PATHS or path.startswith(ACCOUNT_PREFIXES)):
        raise SecondFactorRequired(
            "a studio of yours requires a second factor of its members, and your account has none; nothing was done",
            fix=SET_UP_SECOND_FACTOR,
        )


def _why_refused(database: Database, secret_sha256: str) -> str:
    token = queries.token_past_use(database, secret_sha256)
    if token is None:
        return "this token is unknown or was revoked; ask the producer for a new one"
    revoked_at, expires_at = token
    if revoked_at is not None and revoked_at < expires_at:
        return "this token was revoked; ask the producer for a new one"
    if expires_at > clock.now():
        return "this is a token for soundlist desk, which does not work here; ask the producer for one"
    return f"this token ended on {day_in_words(expires_at)}; make a new one"


def _ensure_csrf_token(settings: Settings, credentials: RequestCredentials, secret: str) -> None:
    if credentials.method in SAFE_METHODS:
        return
    ensure_same_origin(settings, credentials)
    sent = credentials.headers.get(CSRF_HEADER, "").encode("utf-8", "surrogatepass")
    if not hmac.compare_digest(sent, csrf_token(settings, secret).encode()):
        raise CsrfMismatch("this request did not come from our page; reload it and try again")


def _without_port(host: str) -> str:
    name, _, port = host.lower().rpartition(":")
    return name if name and port.isdecimal() else host.lower()


def _host_of(origin: str) -> str | None:
    try:
        return urlsplit(origin).netloc
    except ValueError:  # a bracket without its pair
        return None


def _origin_of(address: str) -> str:
    parts = urlsplit(address)
    return f"{parts.scheme}://{parts.netloc}"
