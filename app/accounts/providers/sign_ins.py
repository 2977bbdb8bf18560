"""Signing in by a studio's provider: the authorization code flow of OpenID Connect with PKCE."""

import json
import secrets
from base64 import b64encode, urlsafe_b64decode, urlsafe_b64encode
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any
from urllib.parse import quote, urlencode
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import people, queries
from app.accounts.addresses import verify
from app.accounts.authentication import new_secret
from app.accounts.errors import ProviderNotFound
from app.accounts.models import Person, SignInProvider
from app.accounts.providers import queries as provider_queries
from app.accounts.providers.rules import (
    SCOPE,
    SIGN_IN_LIFETIME,
    BegunSignIn,
    ProvenPerson,
    claims_in,
    domain_of,
    ensure_answer_of,
    json_object,
    person_in,
    refused,
)
from app.accounts.providers.service import JSON_ONLY, client_secret_of, redirect_uri
from app.accounts.rules import AddressProof
from app.accounts.second_factors import queries as second_factor_queries
from app.core import clock, outgoing
from app.core.access_scope import AccessScope
from app.core.db import bypass_row_policies, set_access_scope
from app.core.outgoing import AddressRefused, RequestFailed, Resolver
from app.core.server_keys import sealed, unsealed
from app.settings import Settings

COOKIE = "soundlist_provider_sign_in"
KEY_PURPOSE = "sign-ins by provider"
BEGUN, CODE_NEEDED = b"begun", b"code needed"
CODE_VERIFIER_BYTES = 48  # 64 characters (RFC 7636, 4.1)


def provider_to_sign_in(session: Session, studio_id: UUID) -> SignInProvider:
    """Return the provider of a studio, for who has not signed in yet."""
    with bypass_row_policies(session):
        provider = provider_queries.provider_of(session, studio_id)
    if provider is None:
        raise ProviderNotFound(f"no sign-in provider of a studio {studio_id}")
    return provider


def begin(settings: Settings, provider: SignInProvider, next_path: str) -> tuple[str, str]:
    """Return the provider's address to send a browser to, and the cookie by which its answer is known."""
    from authlib.oauth2.rfc6749.parameters import prepare_grant_uri
    from authlib.oauth2.rfc7636 import create_s256_code_challenge

    begun = BegunSignIn(
        studio_id=provider.studio_id,
        state=new_secret(),
        nonce=new_secret(),
        code_verifier=secrets.token_urlsafe(CODE_VERIFIER_BYTES),
        next_path=next_path,
        begun_at_s=int(clock.now().timestamp()),
    )
    url: str = prepare_grant_uri(
        provider.authorization_endpoint,
        client_id=provider.client_id,
        response_type="code",
        redirect_uri=redirect_uri(settings),
        scope=SCOPE,
        state=begun.state,
        nonce=begun.nonce,
        code_challenge=create_s256_code_challenge(begun.code_verifier),
        code_challenge_method="S256",
    )
    return url, _cookie(settings, BEGUN, {**asdict(begun), "studio_id": str(begun.studio_id)})


def begun_sign_in(settings: Settings, cookie: str) -> BegunSignIn:
    """Return the sign-in that a browser's cookie keeps, or raise ProviderSignInRefused."""
    kept = _kept(settings, BEGUN, cookie)
    return BegunSignIn(**{**kept, "studio_id": UUID(kept["studio_id"])})


def proven_person(
    settings: Settings,
    provider: SignInProvider,
    begun: BegunSignIn,
    *,
    code: str,
    state: str,
    answered_issuer: str | None,
    resolver: Resolver = outgoing.resolve,
) -> ProvenPerson:
    """Exchange a code for the person whom the provider signed in; raise ProviderSignInRefused. Needs no transaction."""
    ensure_answer_of(begun, state=state, issuer=provider.issuer, answered_issuer=answered_issuer, at=clock.now())
    fields = {
        "grant_type": "authorization_code",
        "code": code,
        "redirect_uri": redirect_uri(settings),
        "code_verifier": begun.code_verifier,
    }
    client_secret = client_secret_of(settings, provider)
    headers = {**JSON_ONLY, "Content-Type": "application/x-www-form-urlencoded"}
    if provider.is_secret_in_body:
        fields |= {"client_id": provider.client_id, "client_secret": client_secret}
    else:  # RFC 6749, 2.3.1: both are encoded before they are joined
        credentials = f"{quote(provider.client_id, safe='')}:{quote(client_secret, safe='')}"
        headers["Authorization"] = f"Basic {b64encode(credentials.encode()).decode()}"
    may_be_localhost = settings.webhook_localhost
    try:
        answer = outgoing.post(
            provider.token_endpoint,
            urlencode(fields).encode(),
            headers,
            max_bytes=outgoing.DOCUMENT_BYTES,
            resolver=resolver,
            may_be_localhost=may_be_localhost,
        )
        tokens = json_object(answer.beginning)
        if answer.status != 200 or not isinstance(tokens.get("id_token"), str):
            raise refused(f"the provider did not take the code (it answered {answer.status})")
        jwks = outgoing.get(provider.jwks_uri, JSON_ONLY, resolver=resolver, may_be_localhost=may_be_localhost)
    except (AddressRefused, RequestFailed) as error:
        raise refused("the provider can't be reached", error, fix="try again later, or ask who runs it") from error
    access_token = tokens.get("access_token")
    claims = claims_in(
        tokens["id_token"],
        json_object(jwks.beginning),
        issuer=provider.issuer,
        client_id=provider.client_id,
        nonce=begun.nonce,
        access_token=access_token if isinstance(access_token, str) else None,
        at=clock.now(),
    )
    return person_in(claims)


def account_of(session: Session, studio_id: UUID, proven: ProvenPerson) -> Person:
    """Return the account of a proven person, or a new one, which is a member of nothing.

    Raise ProviderSignInRefused for an address whose domain is not bound to the provider's studio, and for an account
    that was opened with the address without proving it.
    """
    with bypass_row_policies(session):  # the provider identifies the caller
        bound = provider_queries.domain_binding(session, domain_of(proven.email))
        if bound is None or bound.studio_id != studio_id:
            raise refused(
                f"the domain of {proven.email} is not bound to this studio",
                fix="sign in with your password; the operator of this server binds domains",
            )
        person = queries.person_by_email(session, proven.email)
        if person is not None and (person.email_verified_at is None or person.demo_part is not None):
            raise refused(
                f"{proven.email} has an account that was opened without proving the address",
                fix="sign in with its password and verify the address on the page Account",
            )
        if person is None:
            person = people.create_person(session, email=proven.email, name=proven.name)
            verify(session, person, AddressProof.PROVIDER)
    set_access_scope(session, AccessScope(person_id=person.id))
    return person


def asks_for_code(session: Session, person: Person) -> bool:
    """Whether an account has a second factor of its own, which no studio's provider stands for."""
    return second_factor_queries.has_second_factor(session, person.id)


def code_cookie(settings: Settings, person: Person, begun: BegunSignIn, *, has_second_factor: bool) -> str:
    """Return the cookie by which the person's code is known to follow this sign-in."""
    kept = {
        "person_id": str(person.id),
        "studio_id": str(begun.studio_id) if has_second_factor else None,
        "next_path": begun.next_path,
        "begun_at_s": begun.begun_at_s,
    }
    return _cookie(settings, CODE_NEEDED, kept)


def person_to_code(settings: Settings, cookie: str) -> tuple[UUID, UUID | None, str]:
    """Return the person who is to give a code, the studio whose provider saw a second factor, and the next page."""
    kept = _kept(settings, CODE_NEEDED, cookie)
    if clock.now().timestamp() - kept["begun_at_s"] > SIGN_IN_LIFETIME.total_seconds():
        raise refused("the sign-in took longer than ten minutes")
    return UUID(kept["person_id"]), UUID(kept["studio_id"]) if kept["studio_id"] else None, kept["next_path"]


def _cookie(settings: Settings, step: bytes, kept: Mapping[str, object]) -> str:
    content = sealed(settings.secret_key.get_secret_value(), KEY_PURPOSE, json.dumps(kept), context=step)
    return urlsafe_b64encode(content).decode()


def _kept(settings: Settings, step: bytes, cookie: str) -> dict[str, Any]:
    from cryptography.exceptions import InvalidTag

    try:
        content = urlsafe_b64decode(cookie.encode())
        kept = unsealed(settings.secret_key.get_secret_value(), KEY_PURPOSE, content, context=step)
    except (InvalidTag, ValueError) as error:
        raise refused("this browser began no sign-in, or it ended one already") from error
    document: dict[str, Any] = json.loads(kept)
    return document
