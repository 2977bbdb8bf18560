"""OpenID Connect's demands on a provider's documents and on its answers, as plain functions."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Any
from uuid import UUID

from app.accounts.errors import BadAddress, ProviderRefused, ProviderSignInRefused
from app.accounts.rules import ensure_address

SCOPE = "openid email profile"
DISCOVERY_PATH = "/.well-known/openid-configuration"
SIGN_IN_LIFETIME = timedelta(minutes=10)  # from the button to the end of the sign-in
CLOCK_SKEW_S = 60
ALGORITHMS = ["RS256", "RS384", "RS512", "PS256", "PS384", "PS512", "ES256", "ES384", "ES512", "EdDSA"]
SECOND_FACTOR_METHODS = frozenset({"mfa", "otp", "hwk"})  # RFC 8176
MAX_NAME_CHARS = 200
MAX_URL_CHARS = 2_000
TRY_AGAIN = "begin again on the page Sign in"


@dataclass(frozen=True)
class ProviderEndpoints:
    """The addresses of a provider, as its discovery document names them."""

    authorization_endpoint: str
    token_endpoint: str
    jwks_uri: str
    is_secret_in_body: bool


@dataclass(frozen=True)
class BegunSignIn:
    """A sign-in that a browser began: what the provider's answer is held against. The browser keeps it, encrypted."""

    studio_id: UUID
    state: str
    nonce: str
    code_verifier: str
    next_path: str
    begun_at_s: int


@dataclass(frozen=True)
class ProvenPerson:
    """A person for whom a provider vouches, and whether it says that a second factor was used."""

    email: str
    name: str
    has_second_factor: bool


def endpoints_in(document: str, issuer: str) -> ProviderEndpoints:
    """Return the endpoints that a discovery document names; raise ProviderRefused where it does not fit the issuer."""
    described = json_object(document)
    if described.get("issuer") != issuer:
        raise wrong_issuer(
            f"the provider at {issuer} calls itself {described.get('issuer')!r:.200}",
            "enter the issuer exactly as the provider writes it, with or without a slash at its end",
        )
    addresses = [described.get(name) for name in ("authorization_endpoint", "token_endpoint", "jwks_uri")]
    if not all(isinstance(address, str) and len(address) <= MAX_URL_CHARS for address in addresses):
        raise wrong_issuer(f"{issuer}{DISCOVERY_PATH} lacks an endpoint", "check the issuer with the provider")
    challenges = described.get("code_challenge_methods_supported", ["S256"])
    if not isinstance(challenges, list) or "S256" not in challenges:
        raise wrong_issuer("the provider does not support PKCE with S256", "turn PKCE on, or use another provider")
    methods = described.get("token_endpoint_auth_methods_supported", ["client_secret_basic"])
    authorization_endpoint, token_endpoint, jwks_uri = map(str, addresses)
    return ProviderEndpoints(
        authorization_endpoint,
        token_endpoint,
        jwks_uri,
        is_secret_in_body=isinstance(methods, list)
        and "client_secret_post" in methods
        and "client_secret_basic" not in methods,
    )


def json_object(text: str) -> dict[str, Any]:
    """Return the JSON object in a text, empty for anything else."""
    try:
        document = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return document if isinstance(document, dict) else {}


def wrong_issuer(message: str, fix: str) -> ProviderRefused:
    """Return the refusal of an issuer that a producer entered."""
    return ProviderRefused(message, fix=fix, errors=[{"where": "issuer", "message": f"{message}: {fix}"}])


def ensure_answer_of(begun: BegunSignIn, *, state: str, issuer: str, answered_issuer: str | None, at: datetime) -> None:
    """Raise ProviderSignInRefused unless an answer is to this sign-in, by its provider and in time."""
    if state != begun.state:
        raise refused("this answer of the provider is not to a sign-in that this browser began")
    if answered_issuer is not None and answered_issuer != issuer:  # RFC 9207
        raise refused("this answer is another provider's")
    if at.timestamp() - begun.begun_at_s > SIGN_IN_LIFETIME.total_seconds():
        raise refused("the sign-in took longer than ten minutes")


def claims_in(
    id_token: str,
    jwks: Mapping[str, Any],
    *,
    issuer: str,
    client_id: str,
    nonce: str,
    access_token: str | None,
    at: datetime,
) -> dict[str, Any]:
    """Return the claims of an ID token; raise ProviderSignInRefused unless the provider signed it for this sign-in."""
    from authlib.oidc.core import CodeIDToken
    from joserfc import jwt
    from joserfc.errors import JoseError
    from joserfc.jwk import KeySet

    try:
        keys = KeySet.import_key_set({"keys": list(jwks["keys"])})
        token = jwt.decode(id_token, keys, algorithms=ALGORITHMS)
        claims = CodeIDToken(
            token.claims,
            token.header,
            options={"iss": {"essential": True, "value": issuer}, "aud": {"essential": True, "value": client_id}},
            params={"nonce": nonce, "client_id": client_id, "access_token": access_token},
        )
        claims.validate(now=int(at.timestamp()), leeway=CLOCK_SKEW_S)
    except (JoseError, ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
        raise refused("the provider's ID token is wrong", error) from error
    return dict(claims)


def person_in(claims: Mapping[str, Any]) -> ProvenPerson:
    """Return the person of an ID token; raise ProviderSignInRefused unless the provider has verified the address."""
    if claims.get("email_verified") is not True:
        raise refused("the provider does not say that it has verified your email", fix="ask who runs the provider")
    try:
        email = ensure_address(str(claims.get("email")))
    except BadAddress as error:
        raise refused("the provider names no email", error, fix="ask who runs the provider") from error
    name, methods = claims.get("name"), claims.get("amr")
    printable = "".join(letter for letter in name if letter.isprintable()).strip() if isinstance(name, str) else ""
    return ProvenPerson(
        email=email,
        name=printable[:MAX_NAME_CHARS] or email.partition("@")[0],
        has_second_factor=isinstance(methods, list)
        and any(isinstance(method, str) and method in SECOND_FACTOR_METHODS for method in methods),
    )


def domain_of(email: str) -> str:
    """Return the domain of an address."""
    return email.rpartition("@")[2].strip().lower()


def refused(message: str, cause: Exception | None = None, *, fix: str = TRY_AGAIN) -> ProviderSignInRefused:
    """Return the refusal of a sign-in by a provider."""
    reason = f" ({type(cause).__name__})" if cause is not None else ""
    return ProviderSignInRefused(f"{message}{reason}", fix=fix)
